// SPDX-License-Identifier: BSL-1.0
// Theorems 1 and 2 of J. Cresson and R. Safi, "Mid-point embedding of Hamiltonian systems and variational integrators" (2022), section 3,
// against the definitions that they are about, and the comparison with Wendlandt and Marsden.
#include <doctest/doctest.h>

#include "slope.hpp"

namespace cresson_theorems_tests {

using namespace hilger;
using namespace hilger::papers;

namespace {

constexpr unknown q;
constexpr auto q_o = extend[q];

constexpr lagrangian pendulum{[](auto const& x, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(x);
}};
constexpr lagrangian spherical{[](auto const& x, auto const& v) {
    using std::cos, std::sin;
    return v(0) * v(0) / 2 + (2 + sin(x(0))) * v(1) * v(1) / 2 + x(0) * v(1) + cos(x(0)) + v(0) * x(1) * x(1) / 5;
}};
/// Theorem 2, (67), and its order-one form: the derivative of the action is the sum of h times the residual times the variation.
template <class V, class Action>
void is_paired_with_the_residual(Action const& action) {
    using S = scalar_of<V>;
    std::mt19937 random(67);
    for (int trial = 0; trial < 4; ++trial) {
        auto const both = pair_with_residual<V>(action, random);
        CHECK(vanishes(S(both.derivative - both.of_residual)));
        CHECK_FALSE(vanishes(both.derivative));
    }
}
template <class V, class L>
void both_embeddings_pair(L const& lagrangian) {
    using S = scalar_of<V>;
    auto const T = uniform(S(-1) / 3, S(2) / 7, 5);
    is_paired_with_the_residual<V>(integral(lagrangian(q, Delta_plus[q]), T));
    is_paired_with_the_residual<V>(integral(lagrangian(q_o, Delta_o_plus[q_o]), half(T)));
}

/// Definition 9 at what the flow makes, and at the same with one value changed.
template <class V, class Action>
void flow_is_critical(Action const& action, V const& q0, V const& v0) {
    using S = scalar_of<V>;
    std::mt19937 random(55);
    auto const& T = action.T;
    auto const x = trajectory_of(flow_of(variation(action)), T, initial_velocity<V>{q0, v0}).first;
    auto const slope = [&](auto const& at, auto const& w) { return slope_at_zero<S>([&](S const& e) { return S(action(at + e * w)); }); };
    for (int trial = 0; trial < 10; ++trial) CHECK(vanishes(slope(x, some_variation<V>(T, random))));
    for (hilger::index_type k = 1; k < T.steps(); ++k) CHECK(magnitude(slope(x + S(1) / 16 * unit<V>(T, k), unit<V>(T, k))) > S(1) / 100);
}
template <class V, class L>
void both_flows_are_critical(L const& lagrangian, V const& q0, V const& v0) {
    using S = scalar_of<V>;
    auto const T = uniform(S(0), S(1) / 5, 6);
    flow_is_critical<V>(integral(lagrangian(q, Delta_plus[q]), T), q0, v0);
    flow_is_critical<V>(integral(lagrangian(q_o, Delta_o_plus[q_o]), half(T)), q0, v0);
}

} // namespace

TEST_CASE("theorems 1 and 2: the derivative of the action along w is the pairing of the Euler-Lagrange residual with w") {
    SUBCASE("a pendulum") { both_embeddings_pair<float100>(pendulum); }
    SUBCASE("in the plane, neither separable nor polynomial") { both_embeddings_pair<plane<float100>>(spherical); }
    SUBCASE("a polynomial in the plane, exactly") { both_embeddings_pair<plane<Q>>(plane_cubic); }
}

TEST_CASE("definition 9: what a flow makes is a critical point of its action") {
    SUBCASE("neither separable nor polynomial") { both_flows_are_critical(bead, float100(1), float100(1) / 2); }
    SUBCASE("exactly, in the plane") { both_flows_are_critical(magnetic, plane<Q>(1, -1), plane<Q>(Q(1, 2), Q(1, 3))); }
}

TEST_CASE("Wendlandt and Marsden: (47) is the action of one step, and (64) is h times the mid-point equation, in the plane") {
    auto const T = uniform(Q(0), Q(1, 4), 5);
    Q const h = T.h();
    auto const action = integral(plane_cubic(q_o, Delta_o_plus[q_o]), half(T));
    auto const L_h = [&](auto const& x, auto const& y) { return plane_cubic.function((x + y) / Q(2), (y - x) / h) * h; };
    std::mt19937 random(64);
    auto const x = some_function<plane<Q>>(T, random);
    auto const term = apply_pointwise(plane_cubic.function, action.position[x], action.velocity[x]);
    Q sum(0);
    for (hilger::index_type i = 0; i < T.steps(); ++i) {
        CHECK(integral(term, T.element(i), T.element(i + 1)) == L_h(x[i], x[i + 1])); // (48)
        sum += L_h(x[i], x[i + 1]);
    }
    CHECK(action(x) == sum); // (50) to (52)
    for (hilger::index_type i = 1; i < T.steps(); ++i)
        CHECK(h * variation(action).residual(x)[i] == wendlandt_marsden(plane_cubic, x, i)); // (64)
}

TEST_CASE("the schemes are theorems about types: theta<1, 2> is mid-point, and the equations are (14) and (56)") {
    using std::is_same_v;
    static_assert(is_same_v<decltype(theta<1, 2>.position), decltype(mid_point.position)> and theta<1, 2>.velocity == mid_point.velocity);
    static_assert(not(theta<1, 3>.position == theta<2, 3>.position));
    static_assert(mid_point.velocity == on_half * Delta_o_plus * extend); // lemma 1
    constexpr auto T = uniform(0.0, 0.1, 10);
    constexpr auto right = variation(integral(pendulum(q, Delta_plus[q]), T));
    static_assert(right.force() == identity_T and right.momentum() == -Delta_minus);
    constexpr auto mid = variation(integral(pendulum(q_o, Delta_o_plus[q_o]), half(T)));
    static_assert(mid.force() == mean_h_minus and mid.momentum() == -Delta_h_minus);
    // The flow's embedding and the integral written out are one scheme.
    static_assert(mid.action().position == mid_point.position and mid.action().velocity == mid_point.velocity);
    CHECK(mid.action().T.steps() == 10);
}

} // namespace cresson_theorems_tests
