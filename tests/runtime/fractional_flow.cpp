// SPDX-License-Identifier: BSL-1.0
// Flows with fractional damping: they converge to the solution of the equation that they are named after, from x_0 != 0 and v_0 != 0 too;
// their equation holds step by step; only damped components of a fractional order keep a history; and bad input is refused.
#include <array>
#include <cmath>
#include <type_traits>

#include <doctest/doctest.h>

#include "fractional_series.hpp"
#include "hilger/integrator/fractional_flow.hpp"
#include "systems.hpp"

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr lagrangian spring{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
constexpr double c = 0.7, u0 = 1.0, v0 = -0.5;

template <class Order>
fractional_oscillator<double>::value reference(Order beta, initial_history history) {
    fractional_oscillator<float50> const wide{float50(c), beta.template as<float50>(),       1, float50(u0), float50(v0),
                                              0,          history == initial_history::caputo};
    auto const [u, v] = wide.at(1);
    return {static_cast<double>(u), static_cast<double>(v)};
}
/// The orders in position and momentum at t = 1.
template <generating_function G = grunwald_letnikov, class Order>
std::array<double, 2> orders(Order beta, damping_options options) {
    auto const exact = reference(beta, options.history);
    auto const flow = embed(with_fractional_damping<G>(spring, c, beta, direct{}, options), mid_point);
    std::vector<double> eq, ep;
    for (int const N : {512, 1024, 2048}) {
        state<double, double> last;
        for (auto const& x : flow.along(uniform(interval{0.0, 1.0}, N), u0, v0)) last = x; // p = v
        eq.push_back(std::abs(last.q - exact.u));
        ep.push_back(std::abs(last.p - exact.v));
    }
    return {fitted_slope(eq), fitted_slope(ep)};
}
template <class Order>
void is_of_order_one(Order beta, damping_options options) {
    auto const [q, p] = orders(beta, options);
    CHECK(std::abs(q - 1) < 0.02);
    CHECK(std::abs(p - 1) < 0.02);
}
/// All positions of a run.
template <class Flow, class Scale, class V>
std::vector<V> positions(Flow const& flow, Scale const& T, V const& q0, V const& p0) {
    std::vector<V> q;
    for (auto const& x : flow.along(T, q0, p0)) q.push_back(x.q);
    return q;
}

} // namespace

TEST_CASE("the reference is right: no damping, damping of order 1, and the table's own equation") {
    auto const free = fractional_oscillator<float50>{0, float50(1) / 2, 1, 2, 3, 0}.at(1);
    CHECK(abs(free.u - (2 * cos(float50(1)) + 3 * sin(float50(1)))) < float50("1e-47"));
    CHECK(abs(free.v - (3 * cos(float50(1)) - 2 * sin(float50(1)))) < float50("1e-47"));
    for (bool const caputo : {true, false}) { // u'' + 2 u' + u = 0, where D^1 of a jump is a kick
        auto const x = fractional_oscillator<float50>{2, 1, 1, 1, 1, 0, caputo}.at(1);
        CHECK(abs(x.u - exp(float50(-1)) * (1 + (caputo ? 2 : 0))) < float50("1e-47"));
    }
    auto const half = fractional_oscillator<float100>{1, float100(1) / 2, 1, 0, 0, 1}.at(5);
    CHECK(abs(half.u - float100("0.668914627671081225055583688085984709143740615")) < float100("1e-44"));
}

TEST_CASE("the flow of order 1/2, 1 and 3/2 has order one against Caputo's equation, x_0 and v_0 not zero") {
    for (auto const at : {damping_at::start, damping_at::end}) {
        CAPTURE(static_cast<int>(at));
        is_of_order_one(fraction<1, 2>{}, {.at = at});
        is_of_order_one(fraction<1>{}, {.at = at});
        is_of_order_one(fraction<3, 2>{}, {.at = at});
    }
}

TEST_CASE("half of the damping at each end, with weights of order two, has order two") {
    auto const is_of_order_two = [](auto beta) {
        for (double const slope : orders<bdf<2>>(beta, {.at = damping_at::both})) CHECK(std::abs(slope - 2) < 0.02);
    };
    is_of_order_two(fraction<1, 2>{});
    is_of_order_two(fraction<1>{});
    is_of_order_two(fraction<3, 2>{});
    for (double const slope : orders(fraction<1, 2>{}, {.at = damping_at::both})) CHECK(std::abs(slope - 1) < 0.02);
}

TEST_CASE("and against Riemann and Liouville's, whose x jumps from zero at t_0, where the jump is in a step") {
    is_of_order_one(fraction<1, 2>{}, {.at = damping_at::start, .history = initial_history::riemann_liouville});
    // At the end of steps the impulse h^{1 - beta} x_0 at t_0 is in none: what is left out has the order 1 - beta.
    auto const [q, p] = orders(fraction<1, 2>{}, {.at = damping_at::end, .history = initial_history::riemann_liouville});
    CHECK(std::abs(q - 0.5) < 0.02);
    CHECK(std::abs(p - 0.5) < 0.05);
    // The two equations differ by more than either is wrong.
    double const apart = std::abs(reference(fraction<1, 2>{}, initial_history::caputo).u -
                                  reference(fraction<1, 2>{}, initial_history::riemann_liouville).u);
    CHECK(apart > 0.1);
}

TEST_CASE("orders 1 and none are what they should be, to the bit") {
    auto const T = uniform(0.0, 0.1, 50);
    auto const q = positions(embed(with_fractional_damping(pendulum, 0.3, fraction<1>{}), mid_point), T, 1.0, 0.5);
    CHECK(q == positions(embed(with_fractional_damping(pendulum, 0.3, 1.0), mid_point), T, 1.0, 0.5));
    CHECK(q == positions(embed(with_fractional_damping(pendulum, 0.3, fraction<2, 2>{}), mid_point), T, 1.0, 0.5));
    CHECK(positions(embed(with_fractional_damping(pendulum, 0, 0.5), mid_point), T, 1.0, 0.5) ==
          positions(embed(pendulum, mid_point), T, 1.0, 0.5));
    auto const half = positions(embed(with_fractional_damping(pendulum, 0.3, fraction<1, 2>{}), mid_point), T, 1.0, 0.5);
    CHECK(half == positions(embed(with_fractional_damping(pendulum, 0.3, 0.5), mid_point), T, 1.0, 0.5));
    CHECK(half != q);
    // Both integrators have the positions of (20): from the same first two they are the same curve.
    auto const late = embed(with_fractional_damping(pendulum, 0.3, fraction<1, 2>{}, direct{}, {.at = damping_at::end}), mid_point);
    auto const at_end = positions(late, T, 1.0, 0.5);
    for (std::size_t k = 0; k < half.size(); ++k) CHECK(std::abs(half[k] - at_end[k]) < 256 * epsilon<double>());
}

TEST_CASE("a constant is not damped by Caputo's derivative, nor is uniform motion for an order above 1; Riemann and Liouville damp both") {
    constexpr lagrangian free{[](auto const& x, auto const& v) { return v * v / 2 + 0 * x; }};
    auto const T = uniform(0.0, 0.1, 40);
    auto const last = [&](auto beta, initial_history history, double p0) {
        return positions(embed(with_fractional_damping(free, 1.0, beta, direct{}, {.history = history}), mid_point), T, 1.0, p0).back();
    };
    CHECK(last(0.5, initial_history::caputo, 0.0) == 1.0);
    CHECK(last(1.0, initial_history::caputo, 0.0) == 1.0);
    CHECK(last(1.5, initial_history::caputo, 0.25) == 2.0);
    CHECK(last(0.5, initial_history::riemann_liouville, 0.0) < 0.5);
    CHECK(last(1.5, initial_history::riemann_liouville, 0.25) < 1.5);
    CHECK(last(0.5, initial_history::caputo, 0.25) < 1.8);
}

TEST_CASE("components without a coefficient move as if nothing were damped, and keep nothing") {
    constexpr lagrangian two{[](auto const& x, auto const& v) { return v.dot(v) / 2 + cos(x(0)) - x(1) * x(1); }};
    constexpr lagrangian second{[](auto const& x, auto const& v) { return v * v / 2 - x * x; }};
    auto const T = uniform(0.0, 0.1, 30);
    Eigen::Vector2d const q0(1, -1), p0(0.5, 0.25);
    auto const damped = with_fractional_damping(two, Eigen::Vector2d(0, 0.5), fraction<1, 2>{});
    auto const both = positions(embed(damped, mid_point), T, q0, p0);
    auto const first = positions(embed(pendulum, mid_point), T, 1.0, 0.5);
    auto const other = positions(embed(with_fractional_damping(second, 0.5, fraction<1, 2>{}), mid_point), T, -1.0, 0.25);
    for (std::size_t k = 0; k < both.size(); ++k) {
        CHECK(std::abs(both[k](0) - first[k]) < 64 * epsilon<double>());
        CHECK(std::abs(both[k](1) - other[k]) < 64 * epsilon<double>());
    }
    // The same for vectors whose dimension is known at run time only.
    auto const dynamic =
        positions(embed(with_fractional_damping(two, Eigen::VectorXd(Eigen::Vector2d(0, 0.5)), fraction<1, 2>{}), mid_point), T,
                  Eigen::VectorXd(q0), Eigen::VectorXd(p0));
    for (std::size_t k = 0; k < both.size(); ++k) CHECK((dynamic[k] - both[k]).norm() < 256 * epsilon<double>());

    auto const kept_after_20 = [&](auto const& flow, auto const& q, auto const& p) {
        using V = std::remove_cvref_t<decltype(q)>;
        typename std::remove_cvref_t<decltype(flow)>::template memory<double, V> memory(flow, 0.1, q);
        state<double, V> x{0.0, q, p};
        for (int k = 0; k < 20; ++k) memory.advance(flow, x, 0.1);
        return std::array{memory.damped_components(), memory.values_kept()};
    };
    using counts = std::array<hilger::index_type, 2>;
    CHECK(kept_after_20(embed(damped, mid_point), q0, p0) == counts{1, 21});
    CHECK(kept_after_20(embed(with_fractional_damping(two, 0.5, 0.5), mid_point), q0, p0) == counts{2, 21});
    CHECK(kept_after_20(embed(with_fractional_damping(two, 0.5, 1.0), mid_point), q0, p0) == counts{2, 1});
    CHECK(kept_after_20(embed(with_fractional_damping<bdf<2>>(two, 0.5, fraction<1>{}), mid_point), q0, p0) == counts{2, 2});
    CHECK(kept_after_20(embed(with_fractional_damping(two, 0.0, 0.5), mid_point), q0, p0) == counts{0, 0});
    // Where the order is 1 by its type there is not even room for an engine.
    auto const local = embed(with_fractional_damping(pendulum, 0.5, fraction<1>{}), mid_point);
    auto const whole = embed(with_fractional_damping(pendulum, 0.5, fraction<1, 2>{}), mid_point);
    static_assert(sizeof(decltype(local)::memory<double, double>) + sizeof(decltype(make_history<grunwald_letnikov>(direct{}, 0.5, 1.0))) <=
                  sizeof(decltype(whole)::memory<double, double>));
}

TEST_CASE("any embedding, forces and compensated sums can be damped; a checkpoint takes the history with it") {
    auto const T = uniform(0.0, 0.05, 100);
    auto const friction = [](auto const& x, auto const& v) { return -v / 10 + 0 * x; };
    auto const end = [&](auto const& flow) { return positions(flow, T, 1.0, 0.5).back(); };
    auto const damp = [](auto const& L) { return with_fractional_damping(L, 0.3, fraction<1, 2>{}); };
    double const expected = end(embed(damp(pendulum), mid_point));
    CHECK(end(embed(damp(pendulum), mid_point, compensated)) == doctest::Approx(expected).epsilon(1e-13));
    CHECK(end(embed(damp(pendulum), order_one)) == doctest::Approx(expected).epsilon(0.05));
    CHECK(end(embed(damp(pendulum), galerkin<2, gauss>)) == doctest::Approx(expected).epsilon(0.01));
    auto const bob = mechanical(1.0, [](auto const& x) {
        using std::cos;
        return -cos(x(0));
    });
    Eigen::VectorXd const one = Eigen::VectorXd::Ones(1);
    CHECK(positions(embed(damp(bob), mid_point), T, one, Eigen::VectorXd(one / 2)).back()(0) == doctest::Approx(expected).epsilon(1e-12));
    CHECK(positions(embed(with_fractional_damping(bob, 0.3, 1.0), mid_point), T, one, Eigen::VectorXd(one / 2)).back()(0) ==
          doctest::Approx(end(embed(with_fractional_damping(pendulum, 0.3, 1.0), mid_point))).epsilon(1e-12));
    // Friction by force and by a damping of order 1 differ by O(h) only.
    CHECK(std::abs(end(embed(damp(with_force(pendulum, friction)), mid_point)) - expected) > 0.001);
    CHECK(end(embed(with_force(pendulum, friction), mid_point)) ==
          doctest::Approx(end(embed(with_fractional_damping(pendulum, 0.1, 1.0), mid_point))).epsilon(0.01));

    auto const path = embed(damp(pendulum), mid_point).along(T, 1.0, 0.5);
    auto at = path.begin();
    for (int k = 0; k < 40; ++k) ++at;
    double resumed = 0;
    for (auto const& x : path.resume(at.checkpoint())) resumed = x.q;
    CHECK(resumed == expected);
}

TEST_CASE("what is no damping is refused in one sentence, and a failed step leaves the state as it was") {
    double const nan = std::nan("");
    for (double const beta : {0.0, 2.0, -0.5, 2.5, nan})
        CHECK_THROWS_AS((void)with_fractional_damping(pendulum, 0.1, beta), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)with_fractional_damping(pendulum, 0.1, 2.0),
                         "the order of a fractional damping lies in ]0, 2[, and this one is 2", error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)with_fractional_damping(pendulum, nan, 0.5), "the coefficient of a fractional damping is a finite number",
                         error::invalid_parameter);
    CHECK_THROWS_AS((void)with_fractional_damping(kepler, Eigen::Vector2d(0.1, nan), 0.5), error::invalid_parameter);

    auto const T = uniform(0.0, 0.1, 10);
    auto const plane = embed(with_fractional_damping(kepler, Eigen::VectorXd(Eigen::VectorXd::Ones(3)), 0.5), mid_point);
    CHECK_THROWS_WITH_AS((void)plane.along(T, Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1)),
                         "a fractional damping has one coefficient for each component, and here are 3 for 2", error::mismatch);
    auto const flow = embed(with_fractional_damping(pendulum, 0.1, 0.5), mid_point);
    CHECK_THROWS_AS((void)flow.along(T, nan, 0.0), error::not_finite);
    decltype(flow)::memory<double, double> memory(flow, 0.1, 1.0);
    state<double, double> x{0, 1, 0};
    CHECK_THROWS_WITH_AS(memory.advance(flow, x, 0.2),
                         "fractional damping remembers steps of one length, 0.10000000000000001, and this step has 0.20000000000000001",
                         error::mismatch);
    // h^{1/2} is no rational number, h is.
    auto const exact = embed(with_fractional_damping(oscillator, Q(1, 3), fraction<1, 2>{}), mid_point);
    auto const walk = [](auto const& path) {
        for (auto const& at : path) (void)at;
    };
    CHECK_THROWS_AS(walk(exact.along(uniform(Q(0), Q(1, 4), 3), Q(1), Q(0))), error::invalid_parameter);

    // y - 1 = 5 ((1 + y)/2)^2 has no real solution; the momentum of the last good state has not been damped for the step that failed.
    try {
        walk(embed(with_fractional_damping(cubic, 0.1, fraction<1>{}), mid_point).along(uniform(0.0, 1.0, 3), 1.0, 0.125));
        FAIL("an equation without a solution must be reported");
    } catch (error::no_convergence const& e) {
        auto const& last = dynamic_cast<interrupted<double, double> const&>(e).last;
        CHECK(last == state<double, double>{0.0, 1.0, 0.125});
    }
}
