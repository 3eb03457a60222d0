// SPDX-License-Identifier: BSL-1.0
// Numbers from 1e-300 to 1e300. A power of two as a factor of L, or as the unit of length, changes the exponents and no other bit; overflow
// is an error.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;
using plane = Eigen::Vector2d;
using space = Eigen::Vector3d;

/// Whether two runs agree to the last bit, after dividing `unit` out of the first one's positions and `mass` out of its momenta.
template <class Path>
auto end_of(Path const& path, double unit, double mass) {
    auto x = last_of(path);
    x.q = x.q / unit;
    x.p = x.p / mass;
    return x;
}
template <class Run>
row same(std::string const& what, Run const& run, double unit, double mass) {
    auto const expected = run(1.0, 1.0);
    try {
        auto const x = run(unit, mass);
        bool const equal = x.q == expected.q and x.p == expected.p;
        return holds(what, "the same bits", equal, equal ? "the same bits" : "other bits");
    } catch (error::exception const& e) {
        return {what, "the same bits", e.what(), false, "an error"};
    }
}
constexpr int N = 50;
constexpr double h = 0.0625;

/// L = m (v.v / 2 - |q|^4 / (4 u^2)) in units u: x = q / u.
template <class E, class V>
auto quartic(E const& how, V const& start, double unit, double mass) {
    auto const L = [=](auto const& q, auto const& v) {
        auto const square = [](auto const& x) {
            if constexpr (requires { x.dot(x); })
                return x.dot(x);
            else
                return x * x;
        };
        auto const r = square(evaluated(q * (1 / unit)));
        return mass * (square(v) / 2) - (mass * unit) * (r * r) * unit / 4;
    };
    V const q = start * unit, p = start * (unit * mass / 2);
    return end_of(embed(L, how).along(uniform(0.0, h, N), q, p), unit, unit * mass);
}
template <class E, class V>
void quartics(rows& all, std::string const& name, E const& how, V const& start) {
    auto const run = [&](double unit, double mass) { return quartic(how, start, unit, mass); };
    all.push_back(same(name + ", L times 2^1000", run, 1, 0x1p1000));
    all.push_back(same(name + ", L times 2^-1000", run, 1, 0x1p-1000));
    all.push_back(same(name + ", positions times 2^500", run, 0x1p500, 1));
    all.push_back(same(name + ", positions times 2^-500", run, 0x1p-500, 1));
}
void chains(rows& all) {
    auto const run = [](double unit, double mass) {
        Eigen::VectorXd q(6), p = Eigen::VectorXd::Zero(6);
        q << 0.5, -0.25, 1, 0.75, 0.125, -1;
        auto const L = mechanical(mass, chain([=](index_type, auto const& r) {
                                      auto const x = evaluated(r * (1 / unit));
                                      return (mass * unit) * (x * x / 2 + x * x * x * x) * unit;
                                  }));
        return end_of(embed(L, mid_point).along(uniform(0.0, h, N), Eigen::VectorXd(q * unit), p), unit, unit * mass);
    };
    all.push_back(same("chain of 6, mid-point, masses and stiffness times 2^1000", run, 1, 0x1p1000));
    all.push_back(same("chain of 6, mid-point, masses and stiffness times 2^-1000", run, 1, 0x1p-1000));
    all.push_back(same("chain of 6, mid-point, positions times 2^500", run, 0x1p500, 1));
    all.push_back(same("chain of 6, mid-point, positions times 2^-500", run, 0x1p-500, 1));
}
void linear(rows& all) {
    auto const run = [](double unit, double mass) {
        auto const L = [mass](auto const& q, auto const& v) { return mass * (v * v) / 2 - mass * (q * q) / 2; };
        auto const damped = with_fractional_damping(L, 0.25 * mass, fraction<1, 2>{}, exponentials{});
        return end_of(embed(damped, mid_point).along(uniform(0.0, h, N), 0.75 * unit, 0.5 * (unit * mass)), unit, unit * mass);
    };
    all.push_back(same("fractional oscillator, positions times 2^1000", run, 0x1p1000, 1));
    all.push_back(same("fractional oscillator, positions times 2^-950", run, 0x1p-950, 1));
    all.push_back(same("fractional oscillator, masses and stiffness times 2^-950", run, 1, 0x1p-950));
    auto const zener = [](double unit, double mass) {
        fractional_structure const on{mass, 0.25 * mass, 3 * mass, 1.0, fraction<1, 2>{}};
        return end_of(newmark<bdf<2>>(on, [](double) { return 0.0; }).along(uniform(0.0, h, N), 0.75 * unit, 0.5 * (unit * mass)), unit,
                      unit * mass);
    };
    all.push_back(same("Newmark, displacements times 2^1000", zener, 0x1p1000, 1));
    all.push_back(same("Newmark, mass, damping and stiffness times 2^1000", zener, 1, 0x1p1000));
    all.push_back(same("Newmark, mass, damping and stiffness times 2^-950", zener, 1, 0x1p-950));
}
void boundary_values(rows& all) {
    auto const run = [](double unit, double mass) {
        auto const L = [=](auto const& x, auto const& v) {
            auto const y = evaluated(x * (1 / unit));
            return mass * (v * v) / 2 + (mass * unit) * (y * y * y * y / 4) * unit;
        };
        constexpr unknown q;
        auto const T = uniform(0.0, h, 64);
        auto const EL = variation(nabla_integral(lagrangian{L}(q, Delta_minus_alpha<3, 4>[q]), T));
        auto const s = solve(EL, T, {.q0 = 0.0, .qN = unit}, boundary_options{});
        struct {
            std::vector<double> q;
            int p;
        } end{{}, s.iterations};
        for (double const x : s.q) end.q.push_back(x / unit);
        return end;
    };
    all.push_back(same("two-sided problem with Newton, L times 2^900", run, 1, 0x1p900));
    all.push_back(same("two-sided problem with Newton, L times 2^-900", run, 1, 0x1p-900));
    all.push_back(same("two-sided problem with Newton, values times 2^500", run, 0x1p500, 1));
    all.push_back(same("two-sided problem with Newton, values times 2^-500", run, 0x1p-500, 1));
}
void beyond(rows& all) {
    auto const free = [](auto const&, auto const& v) { return v * v / 2; };
    auto const walk = [](auto const& flow, auto q, auto p, double step) {
        for (auto const& x : flow.along(uniform(0.0, step, 3), q, p))
            if (not is_finite(x.q) or not is_finite(x.p)) return; // a state with an overflow, and no error
    };
    all.push_back(refused<error::not_finite>(
        "a position that overflows, mid-point", [&] { walk(embed(free, mid_point), 1e308, 1e308, 10); }, "the step from t = 0"));
    all.push_back(refused<error::not_finite>(
        "a position that overflows, order one", [&] { walk(embed(free, order_one), 1e308, 1e308, 10); }, "the step from t = 0"));
    all.push_back(refused<error::not_finite>(
        "a position that overflows, Galerkin", [&] { walk(embed(free, galerkin<2, gauss>), 1e308, 1e308, 10); }, "the step from t = 0"));
    auto const row = mechanical(1.0, chain([](index_type, auto const& r) { return r * r / 2; }));
    all.push_back(refused<error::not_finite>(
        "a position that overflows, chain",
        [&] {
            walk(embed(row, order_one), Eigen::VectorXd(Eigen::VectorXd::Zero(3)), Eigen::VectorXd(Eigen::VectorXd::Constant(3, 1e308)),
                 10);
        },
        "the step from t = 0"));
    auto const push = [](auto const& q, auto const& v) { return v * v * 1e10 / 2 + 1e308 * q; };
    all.push_back(refused<error::not_finite>(
        "a momentum that overflows, mid-point", [&] { walk(embed(push, mid_point), 0.0, 1.5e308, 1); }, "the step from t = 0"));
    // The sum of the components overflows; no single component does.
    auto const still = embed([](auto const&, auto const& v) { return v.dot(v) / 2; }, mid_point);
    auto const y = still.step(state<double, plane>{0, plane(1.5e308, 1.5e308), plane(1, 1)}, 1.0);
    all.push_back(holds("components of 1.5e308, whose sum overflows", "(1.5e308, 1.5e308)", y.q == plane(1.5e308, 1.5e308)));
}

} // namespace

rows sizes(scope) {
    rows all;
    quartics(all, "quartic, order one", order_one, 0.75);
    quartics(all, "quartic, mid-point", mid_point, 0.75);
    quartics(all, "quartic in the plane, mid-point", mid_point, plane(0.75, -0.5));
    quartics(all, "quartic in space, mid-point", mid_point, space(0.75, -0.5, 0.25));
    quartics(all, "quartic, Galerkin of 2 nodes", galerkin<2, gauss>, 0.75);
    chains(all);
    linear(all);
    boundary_values(all);
    beyond(all);
    return all;
}

} // namespace extremes
