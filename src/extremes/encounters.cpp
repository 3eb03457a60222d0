// SPDX-License-Identifier: BSL-1.0
// Kepler's ellipse of eccentricity 0.99, bodies that nearly meet, and bodies that do.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;
template <class S>
using plane = Eigen::Matrix<S, 2, 1>;

constexpr auto kepler = [](auto const& q, auto const& v) {
    using std::sqrt;
    return v.dot(v) / 2 + 1 / sqrt(q.dot(q));
};

/// The reference has more digits than double.
using wide = long double;

/// The state after so many steps from the pericentre, 1/128 from the centre, on an ellipse of eccentricity 0.990 and period 4.5.
template <class S, class E>
state<S, plane<S>> ellipse(E const& how, index_type steps, S const& moved) {
    plane<S> const q(S(S(1) / 128 + moved), S(0)), p(S(0), S(S(4086) / 256));
    return last_of(embed(kepler, how).along(uniform(S(0), S(S(1) / 8192), steps), q, p));
}
template <class S>
wide distance(state<S, plane<S>> const& x, state<wide, plane<wide>> const& y) {
    wide largest = 0;
    for (int c = 0; c < 2; ++c) largest = std::max({largest, std::abs(x.q(c) - y.q(c)), std::abs(x.p(c) - y.p(c))});
    return largest;
}
template <class E>
void kepler_rows(rows& all, std::string const& name, E const& how, index_type steps, double of_momentum) {
    auto const x = ellipse<double>(how, steps, 0.0);
    auto const exact = ellipse<wide>(how, steps, 0.0L);
    // Every scalar loses as many digits as the orbit magnifies a change of its start.
    wide const change = std::ldexp(1.0L, -40);
    wide const magnified = distance(ellipse<wide>(how, steps, change), exact) / change;
    std::string const n = std::to_string(steps) + " steps";
    all.push_back(kept("Kepler, e = 0.99, " + name + ", " + n + ", of what it magnifies",
                       static_cast<double>(distance(x, exact) / magnified / epsilon<double>()), 4));
    wide const momentum = wide(4086) / 256 / 128, kept_momentum = wide(x.q(0)) * x.p(1) - wide(x.q(1)) * x.p(0);
    wide const size = x.q.cwiseAbs().maxCoeff() * x.p.cwiseAbs().maxCoeff();
    all.push_back(kept("    its angular momentum, of |q| |p|",
                       static_cast<double>(std::abs(kept_momentum - momentum) / size / epsilon<double>()), of_momentum));
}

/// Two bodies and a third in space, which pass at a distance `miss`.
auto bodies() {
    return pairs<3>(all_pairs(3), [](index_type, auto const& r) {
        using std::sqrt;
        return -1 / sqrt(r.dot(r));
    });
}
using nine = Eigen::Matrix<double, 9, 1>;
nine three(double miss) {
    nine q = nine::Zero();
    q << -1, miss, 0, 1, 0, 0, 0, 50, 0;
    return q;
}
nine towards() {
    nine p = nine::Zero();
    p << 1, 0, 0, -1, 0, 0, 0, 0, 0;
    return p;
}
/// The largest component of the total momentum along a run, in epsilons of the largest momentum and the number of steps; or the error.
template <class Flow>
row passage(std::string const& what, Flow const& flow, double miss, double bound) {
    index_type const steps = 4096;
    try {
        nine p = towards();
        double largest = 1;
        for (auto const& x : flow.along(uniform(0.0, 1.0 / 1024, steps), three(miss), p)) {
            p = x.p;
            largest = std::max(largest, p.cwiseAbs().maxCoeff());
            if (not is_finite(x.q) or not is_finite(x.p)) return holds(what, "finite, or an error", false, "NaN delivered");
        }
        double total = 0;
        for (int c = 0; c < 3; ++c) total = std::max(total, std::abs(p(c) + p(3 + c) + p(6 + c)));
        return kept(what + ": total momentum", total / largest / epsilon<double>(), bound);
    } catch (error::no_convergence const& e) {
        bool const said = std::string(e.what()).find("the step from t = ") == 0;
        return {what, "finite, or an error", "error::no_convergence", said, "typed error"};
    }
}
template <class L>
void collision(rows& all, std::string const& name, L const& l) {
    nine q = three(0);
    q.segment<3>(3) = q.head<3>();
    all.push_back(refused<error::not_finite>(
        name + ", two bodies at one point, order one", [&] { walk(embed(l, order_one).along(uniform(0.0, 0.1, 2), q, towards())); },
        "the step from t = 0"));
    // They arrive at one point in the first step: the force there is infinite.
    nine p = towards() * 16;
    all.push_back(refused<error::not_finite>(
        name + ", two bodies that meet in a point, order one, left",
        [&] { walk(embed(l, order_one_left).along(uniform(0.0, 0.0625, 2), three(0), p)); }, "the step from t = 0"));
}

} // namespace

rows encounters(scope how) {
    rows all;
    index_type const steps = how == scope::report ? 400'000 : 40'000;
    // Rounding as a random walk; an explicit step changes p along q, with almost no rounding.
    double const by_chance = std::sqrt(static_cast<double>(steps)) / 2;
    kepler_rows(all, "order one", order_one, steps, 8);
    kepler_rows(all, "mid-point", mid_point, steps, by_chance);
    kepler_rows(all, "Galerkin", galerkin<2, gauss>, steps / 4, by_chance / 2);
    auto const system = mechanical(1.0, bodies());
    auto const generic = [u = bodies()](auto const& q, auto const& v) { return v.dot(v) / 2 - u(q); };
    // The nearer they pass, the larger is the momentum that sets the unit.
    for (auto const& [miss, bound] : {std::pair{1e-2, 256.0}, {1e-6, 256.0}, {1e-12, 8.0}}) {
        std::string const at = "bodies that pass at " + few_digits(miss);
        all.push_back(passage(at + ", order one", embed(system, order_one), miss, bound));
        all.push_back(passage(at + ", mid-point", embed(system, mid_point), miss, bound));
    }
    all.push_back(passage("bodies that collide head on, order one", embed(system, order_one), 0, 4));
    all.push_back(passage("bodies that collide head on, mid-point", embed(system, mid_point), 0, 4));
    collision(all, "pairs", system);
    collision(all, "any L", generic);
    return all;
}

} // namespace extremes
