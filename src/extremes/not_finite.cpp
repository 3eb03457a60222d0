// SPDX-License-Identifier: BSL-1.0
// NaN and infinity at every entry: states, momenta, steps, masses, coefficients, orders, histories, boundary values, points, files.
#include <limits>
#include <sstream>

#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;
using plane = Eigen::Vector2d;

using bad = error::not_finite;

void flows(rows& all, std::string const& name, double x) {
    auto const T = uniform(0.0, 0.125, 4);
    auto const flow = embed(oscillator, mid_point);
    all.push_back(refused<bad>(name + " as a position", [&] { (void)flow.along(T, x, 0.0); }));
    all.push_back(refused<bad>(name + " as a momentum", [&] { (void)flow.along(T, 0.0, x); }));
    all.push_back(refused<bad>(name + " as an initial velocity", [&] { (void)flow.along(T, initial_velocity<double>{0.0, x}); }));
    all.push_back(refused<bad>(name + " as a second position", [&] { (void)flow.along(T, initial_positions<double>{0.0, x}); }));
    all.push_back(refused<bad>(name + " in one step, mid-point", [&] { (void)flow.step(state<double, double>{0, x, 0}, 0.125); }));
    all.push_back(refused<bad>(name + " in one step, order one", [&] {
        (void)embed(oscillator, order_one).step(state<double, double>{0, 1, x}, 0.125);
    }));
    all.push_back(refused<bad>(name + " as the length of one step", [&] {
        (void)embed(oscillator, order_one).step(state<double, double>{0, 1, 0}, x);
    }));
    all.push_back(refused<bad>(name + " in a composition", [&] { (void)compose(kahan_li<6>, flow).along(T, x, 0.0); }));
    all.push_back(refused<bad>(
        name + " in L",
        [&] { walk(embed([x](auto const& q, auto const& v) { return v * v / 2 - x * q * q; }, mid_point).along(T, 1.0, 0.0)); },
        "the step from t = 0"));
    all.push_back(refused<bad>(
        name + " as a force",
        [&] { walk(embed(with_force(oscillator, [x](auto const& q, auto const&) { return q * 0 + x; }), mid_point).along(T, 1.0, 0.0)); },
        "the step from t = 0"));
    all.push_back(refused<bad>(
        name + " in a Galerkin step",
        [&] { walk(embed([x](auto const& q, auto const& v) { return v * v / 2 - x * q * q; }, galerkin<2, gauss>).along(T, 1.0, 0.0)); },
        "the step from t = 0"));
    auto const row = chain([](index_type, auto const& r) { return r * r / 2; });
    all.push_back(refused<bad>(name + " as a mass", [&] { (void)mechanical(x, row); }));
    all.push_back(refused<bad>(name + " among masses", [&] { (void)mechanical(plane(1, x), row); }));
    all.push_back(refused<bad>(name + " in a mass matrix", [&] { (void)mechanical(Eigen::Matrix2d{{1, 0}, {0, x}}, row); }));
    all.push_back(
        refused<bad>(name + " as the zero of an event", [&] { walk(events(flow.along(T, 1.0, 0.0), [x](auto const&) { return x; })); }));
    all.push_back(refused<error::exception>(name + " under the Legendre map", [&] { (void)velocity_of(oscillator, 0.0, x); }));
}
void with_memory(rows& all, std::string const& name, double x) {
    auto const T = uniform(0.0, 0.125, 4);
    all.push_back(refused<bad>(name + " in a flow with memory", [&] {
        walk(embed(with_fractional_damping(oscillator, 0.5, fraction<1, 2>{}), mid_point).along(T, x, 0.0));
    }));
    all.push_back(
        refused<error::invalid_parameter>(name + " as a damping", [&] { (void)with_fractional_damping(oscillator, x, fraction<1, 2>{}); }));
    all.push_back(refused<error::invalid_parameter>(name + " as an order", [&] { (void)with_fractional_damping(oscillator, 0.5, x); }));
    all.push_back(
        refused<error::invalid_parameter>(name + " as the order of a history", [&] { (void)make_history<bdf<2>>(direct{}, x, 0.0); }));
    auto const push = [&](auto const& policy) {
        auto history = make_history<bdf<2>>(policy, 0.5, 0.0);
        history.push(1.0);
        history.push(x);
    };
    all.push_back(refused<bad>(
        name + " in a history, direct", [&] { push(direct{}); }, "value 1"));
    all.push_back(refused<bad>(
        name + " in a history, blocks", [&] { push(blocks{}); }, "value 1"));
    all.push_back(refused<bad>(
        name + " in a history, exponentials", [&] { push(exponentials{}); }, "value 1"));
    fractional_structure const beam{1.0, 0.5, 1.0, 1.0, fraction<1, 2>{}};
    all.push_back(refused<bad>(name + " as a displacement of Newmark's",
                               [&] { walk(newmark<bdf<2>>(beam, [](double) { return 0.0; }).along(T, x, 0.0)); }));
    all.push_back(
        refused<bad>(name + " as a load of Newmark's", [&] { walk(newmark<bdf<2>>(beam, [x](double) { return x; }).along(T, 1.0, 0.0)); }));
    all.push_back(refused<bad>(name + " as a stiffness", [&] {
        (void)newmark<bdf<2>>(fractional_structure{1.0, 0.5, x, 1.0, fraction<1, 2>{}}, [](double) { return 0.0; });
    }));
    constexpr unknown q;
    auto const between = [&](auto const& L, double last) {
        (void)solve(variation(nabla_integral(lagrangian{L}(q, Delta_minus_alpha<3, 4>[q]), T)), T, {.q0 = 0.0, .qN = last});
    };
    all.push_back(refused<bad>(name + " as a boundary value", [&] { between(oscillator, x); }));
    all.push_back(refused<bad>(name + " in the L of a two-sided problem",
                               [&] { between([x](auto const& y, auto const& v) { return v * v / 2 + x * y; }, 1.0); }));
}
void read(rows& all, std::string const& name, double x) {
    all.push_back(refused<error::invalid_scale>(name + " as a step", [&] { (void)uniform(0.0, x, 4); }));
    all.push_back(refused<error::invalid_scale>(name + " as an end", [&] { (void)uniform(interval{0.0, x}, 4); }));
    all.push_back(refused<error::invalid_scale>(name + " among points", [&] { (void)time_scale<double>{0.0, 1.0, x}; }));
    all.push_back(refused<bad>(name + " in a table", [&] { (void)function_on(uniform(0.0, 1.0, 1), std::vector<double>{1, x}); }));
    auto const path = embed(oscillator, mid_point).along(uniform(0.0, 0.125, 4), 1.0, 0.0);
    std::ostringstream out;
    write_checkpoint(out, path, path.begin().checkpoint());
    std::string text = out.str();
    auto const at = text.find("position ") + 9;
    text.replace(at, text.find('\n', at) - at, few_digits(x));
    all.push_back(refused<error::unreadable>(
        name + " in a checkpoint",
        [&] {
            std::istringstream in(text);
            (void)read_checkpoint(in, path);
        },
        "'position' and a number"));
    all.push_back(refused<error::outside_domain>(name + " as a point", [&] { (void)uniform(0.0, 1.0, 4).sigma(x); }));
}

} // namespace

rows not_finite(scope) {
    rows all;
    for (auto const& [name, x] : {std::pair{"NaN", std::nan("")}, std::pair{"infinity", std::numeric_limits<double>::infinity()}}) {
        flows(all, name, x);
        with_memory(all, name, x);
        read(all, name, x);
    }
    return all;
}

} // namespace extremes
