// SPDX-License-Identifier: BSL-1.0
// A composition makes the steps that it says, is symplectic, has its order, and leaves the state alone when one of its flows fails.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/composition/composition.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/step/exact_steps.hpp"
#include "support/orders.hpp"

namespace composition_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto damping_in_time = [](auto const& t, auto const& x, auto const& v) { return x * t / 3 - v * v / 5; };
constexpr problem<decltype(pendulum.function), decltype(damping_in_time)> damped_pendulum{pendulum.function, damping_in_time};

/// det M - 1 for the derivative M of (q, p) -> (q', p'), by central differences whose error is far below the tolerance.
template <class Flow>
float50 area_error(Flow const& flow) {
    float50 const e("1e-15"), step_length = float50(1) / 10;
    auto const step = [&](float50 const& q, float50 const& p) { return flow.step(state<float50, float50>{0, q, p}, step_length); };
    float50 const q0(1), p0 = float50(1) / 2;
    auto const a = step(q0 + e, p0), b = step(q0 - e, p0), c = step(q0, p0 + e), d = step(q0, p0 - e);
    float50 const det = (a.q - b.q) * (c.p - d.p) - (c.q - d.q) * (a.p - b.p);
    return abs(det / (4 * e * e) - 1);
}

constexpr shares<fraction<1, 3>, fraction<1, 2>, fraction<1, 6>> uneven{};

} // namespace

TEST_CASE("a composition makes the steps of its flows, in turn") {
    auto const f = embed(driven, order_one);
    auto const g = embed(driven, theta<1, 3>);
    auto const both = compose(shares<fraction<1, 3>, fraction<2, 3>>{}, f, g);
    CHECK(both.step(start, h) == g.step(f.step(start, Q(1, 15)), Q(2, 15)));
    auto const four = compose(shares<fraction<1, 2>, fraction<1, 3>, fraction<1, 2>, fraction<-1, 3>>{}, f, g);
    CHECK(four.step(start, h) == g.step(f.step(g.step(f.step(start, Q(1, 10)), Q(1, 15)), Q(1, 10)), Q(-1, 15)));
    CHECK(undoes(both));
    CHECK(undoes(four));
    CHECK(undoes(compose(halves, both, four))); // compositions compose
    // Steps of changing length.
    time_scale<Q> const T{Q(1, 7), Q(1, 3), Q(1, 2), Q(3, 5)};
    state<Q, Q> x = start;
    hilger::index_type i = 0;
    for (auto const& at : both.along(T, x.q, x.p)) {
        CHECK(at == x);
        if (i < 3) x = both.step(x, T.step(i++));
    }
    CHECK(i == 3);
}

TEST_CASE("order one and its adjoint over half a step each are Stoermer-Verlet") {
    auto const force = [](Q const& q) { return Q(-q * q * q - q); };
    lagrangian const quartic{[](auto const& x, auto const& v) { return v * v / 2 - x * x * x * x / 4 - x * x / 2; }};
    auto const velocity_form = stoermer_verlet(quartic).step(start, h);
    Q const p_half = start.p + h / 2 * force(start.q);
    Q const q = start.q + h * p_half;
    CHECK(velocity_form == state<Q, Q>{start.t + h, q, p_half + h / 2 * force(q)});
    Q const q_half = start.q + h / 2 * start.p;
    Q const p = start.p + h * force(q_half);
    CHECK(position_verlet(quartic).step(start, h) == state<Q, Q>{start.t + h, q_half + h / 2 * p, p});
    CHECK(steps_as(adjoint(stoermer_verlet(driven)), stoermer_verlet(driven)));
    CHECK(steps_as(adjoint(position_verlet(driven)), position_verlet(driven)));
    // p0 = dL/dv(q0, v0)
    for (auto const& at : stoermer_verlet(driven).along(uniform(Q(1), h, 1), initial_velocity<Q>{Q(1), Q(1, 2)})) {
        CHECK(at.p == Q(1, 2) + Q(1, 3));
        break;
    }
}

TEST_CASE("kicks and drifts are the steps of the flows in turns, where the problem is one, and the position the last one") {
    auto const spring = [](Q const& k) { return lagrangian{[k](auto const& x, auto const& v) { return v * v - v / 3 - k * x * x / 2; }}; };
    auto const chain_of = [](Q const& k) {
        return mechanical(Q(3), chain([k](hilger::index_type, auto const& r) { return k * r * r / 2; }));
    };
    using Q2 = Eigen::Matrix<Q, 2, 1>;
    state<Q, Q2> const start_2{Q(1, 7), Q2(Q(1, 3), Q(2, 5)), Q2(Q(-1, 2), Q(3))};
    /// Steps of f, part after part, and the same by single steps: each begins where the last one ended, but for one that somebody moves.
    auto const same = [](auto const& f, auto const& by_hand, auto const& from) {
        typename std::remove_cvref_t<decltype(f)>::template memory<Q, std::remove_cvref_t<decltype(from.q)>> memory(f, h, from.q);
        auto x = from;
        for (Q const& length : {h, h, Q(h / 3), h, h}) {
            auto const expected = by_hand(x, length);
            memory.advance(f, x, length);
            CHECK(x.t == expected.t);
            CHECK(x.q == expected.q);
            CHECK(x.p == expected.p);
            if (length != h) x.q = from.q;
        }
    };
    auto const check = [&](auto const& one, auto const& other, auto const& from) {
        auto const a = embed(one, order_one);
        auto const a_star = adjoint(a);
        auto const b = embed(other, order_one);
        same(
            symmetrized(a), [&](auto const& x, Q const& l) { return a_star.step(a.step(x, l / 2), l / 2); }, from);
        same(
            symmetrized(a_star), [&](auto const& x, Q const& l) { return a.step(a_star.step(x, l / 2), l / 2); }, from);
        same(
            compose(uneven, symmetrized(a)),
            [&](auto x, Q const& l) {
                for (Q const& part : uneven.values<Q>()) x = a_star.step(a.step(x, part * l / 2), part * l / 2);
                return x;
            },
            from);
        same(
            compose(uneven, a),
            [&](auto x, Q const& l) {
                for (Q const& part : uneven.values<Q>()) x = a.step(x, part * l);
                return x;
            },
            from);
        same(
            compose_with_adjoint(shares<fraction<1, 5>, fraction<4, 5>>{}, a),
            [&](auto const& x, Q const& l) { return a.step(a_star.step(x, l / 5), 4 * l / 5); }, from);
        same(
            adjoint(compose_with_adjoint(shares<fraction<1, 5>, fraction<4, 5>>{}, a)),
            [&](auto const& x, Q const& l) { return a.step(a_star.step(x, 4 * l / 5), l / 5); }, from);
        // Two of one type whose numbers differ.
        same(
            compose(halves, a_star, b), [&](auto const& x, Q const& l) { return b.step(a_star.step(x, l / 2), l / 2); }, from);
    };
    check(spring(Q(2)), spring(Q(3)), start);
    check(chain_of(Q(2)), chain_of(Q(3)), start_2);
    // Formulas that are traced: masses that couple two velocities, and five that do not.
    auto const coupled = [](Q const& k) {
        return lagrangian{[k](auto const& x, auto const& v) {
            return v(0) * v(0) + v(0) * v(1) / 2 + v(1) * v(1) - v(0) / 3 - k * x(0) * x(1) / 2 - x(1) * x(1) / 5;
        }};
    };
    auto const apart = [](Q const& k) {
        return lagrangian{[k](auto const& x, auto const& v) {
            return v.dot(v) / 2 + v(2) * v(2) * 2 + v(4) / 7 - k * x(0) * x(1) - x(2) * x(3) - x(3) * x(4);
        }};
    };
    using Qn = Eigen::Matrix<Q, Eigen::Dynamic, 1>;
    using Q5 = Eigen::Matrix<Q, 5, 1>;
    check(coupled(Q(2)), coupled(Q(3)), state<Q, Qn>{Q(1, 7), start_2.q, start_2.p});
    Q5 q = Q5::Constant(Q(1, 4)), p = Q5::Constant(Q(2, 3));
    q(3) = Q(-1);
    p(2) = Q(0);
    check(apart(Q(2)), apart(Q(3)), state<Q, Q5>{Q(1, 7), q, p});
}

TEST_CASE("what is not made of kicks and drifts is stepped in turns") {
    auto const rolling = [](auto const& x, auto const& v) { return v * v * (1 + x * x) / 2 - cos(x); }; // the mass moves
    auto const magnetic = [](auto const& x, auto const& v) { return v.dot(v) / 2 + x(0) * v(1) - x.dot(x) / 2; };
    auto const check = [](auto const& L, auto const& q, auto const& p) {
        auto const a = embed(L, order_one);
        state<double, std::remove_cvref_t<decltype(q)>> const from{0, q, p};
        auto const x = symmetrized(a).step(from, 0.25), y = adjoint(a).step(a.step(from, 0.125), 0.125);
        CHECK(x.q == y.q);
        CHECK(x.p == y.p);
    };
    check(rolling, 1.0, 0.5);
    check(magnetic, Eigen::Vector2d(1, 0.5), Eigen::Vector2d(0.25, -1));
    // The same of formulas that are traced: with a product of position and velocity, a mass that moves, the time, branches, no mass.
    Eigen::VectorXd const q = Eigen::Vector2d(1, 0.5), p = Eigen::Vector2d(0.25, -1);
    check(magnetic, q, p);
    check([](auto const& x, auto const& v) { return v.dot(v) * (1 + v(0) * v(0)) / 2 - x.dot(x) / 2; }, q, p);
    check([](auto const& t, auto const& x, auto const& v) { return v.dot(v) / 2 - (1 + t) * x.dot(x) / 2; }, q, p);
    check([](auto const& x, auto const& v) { return v.dot(v) / 2 - abs(x(0)) - x(1) * x(1); }, q, p);
    check([](auto const& x, auto const& v) { return v(0) * v(1) - x(0) * x(1); }, q, p);
    auto const massless = embed([](auto const& x, auto const& v) { return v(0) * v(0) / 2 - x(0) * x(1); }, order_one);
    CHECK_THROWS_AS(symmetrized(massless).step(state<double, Eigen::VectorXd>{0, q, p}, 0.25), error::exception);
    // By hand, a mass without a diagonal and a term linear in v: v = (p_1, p_0 - 1/4), and half of the kick before and behind the drift.
    auto const crossed = [](auto const& x, auto const& v) { return v(0) * v(1) + v(0) / 4 - x(0) * x(1); };
    auto const x = symmetrized(embed(crossed, order_one)).step(state<double, Eigen::VectorXd>{0, q, p}, 0.25);
    CHECK((x.q - Eigen::Vector2d(0.71875, 0.484375)).cwiseAbs().maxCoeff() <= 4 * epsilon<double>());
    CHECK((x.p - Eigen::Vector2d(0.126953125, -1.21484375)).cwiseAbs().maxCoeff() <= 4 * epsilon<double>());
}

TEST_CASE("kicks and drifts that meet what is no number say so, and leave the state") {
    auto const fall = [](auto const& x, auto const& v) { return v * v / 2 + 1 / (x * x); };
    auto const row = mechanical(1.0, chain([](hilger::index_type, auto const& r) { return 1 / (r * r); }));
    state<double, double> x{0, 1e-200, 0};
    state<double, Eigen::Vector2d> y{0, {1e-200, 0.5}, {0, 0}};
    auto const check = [](auto const& f, auto const& from) {
        using V = std::remove_cvref_t<decltype(from.q)>;
        typename std::remove_cvref_t<decltype(f)>::template memory<double, V> memory(f, 0.5, from.q);
        auto at = from;
        CHECK_THROWS_AS(memory.advance(f, at, 0.5), error::not_finite);
        CHECK(at == from);
        at.q = at.q * 1e200;
        CHECK_NOTHROW(memory.advance(f, at, 0.5));
        CHECK(at != from);
    };
    check(stoermer_verlet(fall), x);
    check(stoermer_verlet(row), y);
    CHECK_THROWS_AS(stoermer_verlet(mechanical(Eigen::VectorXd(Eigen::Vector3d(1, 2, 3)), row.potential()))
                        .step(state<double, Eigen::VectorXd>{0, y.q, y.p}, 0.5),
                    error::mismatch);
}

TEST_CASE("with their adjoints, flows of order one have order 2") {
    CHECK(fitted_order(stoermer_verlet(pendulum), 100, extrapolated_at_one(embed(pendulum, mid_point), 400)) ==
          doctest::Approx(2).epsilon(0.01));
    CHECK(fitted_order(position_verlet(bead), 100, extrapolated_at_one(embed(bead, mid_point), 400)) == doctest::Approx(2).epsilon(0.01));
    CHECK(fitted_order(symmetrized(embed(damped_pendulum, theta<1, 3>)), 100,
                       extrapolated_at_one(embed(damped_pendulum, mid_point), 400)) == doctest::Approx(2).epsilon(0.01));
}

TEST_CASE("compositions preserve area") {
    float50 const tolerance("1e-27"); // the differences' own error is 1e-30
    CHECK(area_error(stoermer_verlet(pendulum)) < tolerance);
    CHECK(area_error(position_verlet(bead)) < tolerance);
}

TEST_CASE("states whose size is known at run time") {
    lagrangian const plane{[](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2; }};
    Eigen::VectorXd const q = Eigen::Vector2d(1, 0.5), p = Eigen::Vector2d(0, -1);
    double const step = 0.25; // exact in double, as its square is
    auto const end = stoermer_verlet(plane).step(state<double, Eigen::VectorXd>{0, q, p}, step);
    Eigen::VectorXd const q1 = q + step * p - step * step / 2 * q, p1 = p - step / 2 * (q + q1);
    CHECK((end.q - q1).norm() + (end.p - p1).norm() <= 8 * epsilon<double>());
}

TEST_CASE("compensated flows stay compensated: 5000 steps of Verlet to the rounding of one") {
    auto const last = [](auto const& f, auto const& one) {
        using S = std::remove_cvref_t<decltype(one)>;
        S q(0);
        for (auto const& at : f.along(uniform(S(0), S(1) / 64, 5000), one, one / 2)) q = at.q;
        return q;
    };
    float50 const exact = last(stoermer_verlet(pendulum), float50(1));
    auto const error = [&](auto const& f) { return static_cast<double>(abs(float50(last(f, 1.0)) - exact)); };
    CHECK(error(stoermer_verlet(pendulum, compensated)) <= 2 * epsilon<double>());
    CHECK(error(stoermer_verlet(pendulum)) > 8 * epsilon<double>());
}

TEST_CASE("a flow that fails in the second half leaves the state as it was") {
    lagrangian const falling{[](auto const& x, auto const& v) {
        using std::sqrt;
        return v * v / 2 - sqrt(x);
    }};
    auto const half_way = embed(falling, mid_point);
    auto const f = compose(halves, half_way);
    state<double, double> const before{3, 0.06, -1}, away{0, 1, 0};
    CHECK(half_way.step(before, 0.05).q < 0.01);
    auto x = before;
    decltype(f)::memory<double, double> memory(f, 0.1, x.q);
    CHECK_THROWS_AS(memory.advance(f, x, 0.1), error::not_finite);
    CHECK(x == before);
    // The same memory goes on from a state that has a step.
    x = away;
    memory.advance(f, x, 0.1);
    CHECK(x.q == doctest::Approx(f.step(away, 0.1).q).epsilon(1e-14));
    try {
        for (auto const& at : f.along(uniform(3.0, 0.1, 5), before.q, before.p)) (void)at;
        FAIL("a flow that fails must be reported");
    } catch (interrupted<double, double> const& stopped) {
        CHECK(stopped.last == before);
    }
}

TEST_CASE("what belongs to one Lagrangian is asked of compositions of one, down to its numbers") {
    auto const spring = [](double m, double k) { return [m, k](auto const& x, auto const& v) { return m * v * v / 2 - k * x * x / 2; }; };
    auto const T = uniform(0.0, 0.125, 10);
    auto const of_two = compose(halves, embed(spring(1, 1), mid_point), embed(spring(4, 1), mid_point));
    auto const of_one = compose(halves, embed(spring(1, 8), mid_point), embed(spring(1, 8), theta<1, 3>));
    CHECK_THROWS_AS((void)of_two.along(T, {.q0 = 0.0, .v0 = 1.0}), error::mismatch);
    CHECK_NOTHROW((void)of_one.along(T, {.q0 = 0.0, .v0 = 1.0}));
}

TEST_CASE("between its points a composition is a shorter step of itself, of several Lagrangians too") {
    auto const spring = [](double k) { return [k](auto const& x, auto const& v) { return v * v / 2 - k * x * x / 2; }; };
    auto const T = uniform(0.0, 0.125, 10);
    auto const check = [&](auto const& flow) {
        auto const path = flow.along(T, 1.0, 0.25);
        auto const x = dense_output(path)(0.1875), y = flow.step(dense_output(path)(0.125), 0.0625);
        CHECK(x.t == y.t);
        CHECK(std::abs(x.q - y.q) <= 4 * epsilon<double>());
        CHECK(std::abs(x.p - y.p) <= 8 * epsilon<double>());
        auto const halves = events(path, [](auto const& z) { return z.q - 0.5; });
        auto const z = *halves.begin();
        CHECK(std::abs(z.q - 0.5) <= 2 * epsilon<double>());
        CHECK(std::abs(dense_output(path)(z.t).p - z.p) <= 16 * epsilon<double>());
    };
    check(symmetrized(compose(halves, embed(spring(0), mid_point), embed(spring(8), mid_point))));
    check(compose(halves, embed(spring(8), mid_point), embed(spring(8), theta<1, 3>)));
    check(symmetrized(embed(spring(8), theta<1, 3>)));
}

TEST_CASE("parts that do not make up the step are refused") {
    auto const f = embed(pendulum, mid_point);
    auto const most = compose(shares<fraction<1, 2>, fraction<1, 4>>{}, f, f);
    CHECK_THROWS_WITH_AS((void)most.step(state<double, double>{0, 1, 0}, 0.1),
                         "the parts of a composed step add up to 1, and these add up to 0.75", error::invalid_parameter);
}

TEST_CASE("a step of h ends at t + h, whatever its parts round to") {
    auto const f = embed(pendulum, mid_point);
    auto const thirds = compose(shares<fraction<1, 3>, fraction<1, 3>, fraction<1, 3>>{}, f);
    for (double const h : {0.1, 0.3, 0.7}) CHECK(thirds.step(state<double, double>{1, 1, 0}, h).t == 1 + h);
}

} // namespace composition_tests
