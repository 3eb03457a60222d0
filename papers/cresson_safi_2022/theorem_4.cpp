// SPDX-License-Identifier: BSL-1.0
// Theorem 4 of J. Cresson and R. Safi, "Mid-point embedding of Hamiltonian systems and variational integrators" (2022), section 4: the
// critical points (p, q) of the action (97), for variations of p that are free and of q that vanish at a and b, are the solutions of the
// discrete Hamiltonian system (94). And definition 12, the momentum that the flows carry.
#include <doctest/doctest.h>

#include "hamiltonian_action.hpp"

namespace cresson_theorem_4_tests {

using namespace hilger;
using namespace hilger::papers;

namespace {

/// Theorem 4 at what the mid-point flow makes, and at the same with one value of p or of q changed.
template <class V, class L>
void flow_is_critical(L const& lagrangian, V const& q0, V const& v0) {
    using S = scalar_of<V>;
    auto const T = uniform(S(0), S(1) / 5, 4);
    hamiltonian const H(lagrangian);
    auto const made = trajectory_of(embed(lagrangian, mid_point), T, initial_velocity<V>{q0, v0});
    auto const& x = made.first;
    auto const& p = made.second;
    CHECK(vanishes(largest(all_slopes<V>(H, p, x))));
    for (auto const& r : first_line(H, p, x)) CHECK(vanishes(magnitude(r)));
    for (auto const& r : second_line(H, p, x)) CHECK(vanishes(magnitude(r)));
    auto const none = unit<V>(T, 0) - unit<V>(T, 0);
    for (hilger::index_type k = 0; k <= T.last(); ++k) {
        auto const moved = S(1) / 8 * unit<V>(T, k);
        CHECK(magnitude(slope_along<V>(H, p + moved, x, unit<V>(T, k), none)) > S(1) / 10000);
        CHECK(magnitude(slope_along<V>(H, p, x + moved, unit<V>(T, k == 0 ? 1 : k - 1), none)) > S(1) / 10000);
        if (k != 0 and k != T.last()) CHECK(magnitude(slope_along<V>(H, p + moved, x, none, unit<V>(T, k))) > S(1) / 10000);
        if (k != 0 and k != T.last()) CHECK(magnitude(slope_along<V>(H, p, x + moved, none, unit<V>(T, k))) > S(1) / 10000);
    }
}

/// Definition 12 and (82), at what the mid-point flow makes; both sides of == or within the tolerance.
template <class V, class L, class Near>
void is_the_discrete_momentum(L const& lagrangian, V const& q0, V const& v0, Near const& near) {
    using S = scalar_of<V>;
    int const N = 6;
    auto const T = uniform(S(0), S(1) / 5, N);
    S const h = T.h();
    auto const made = trajectory_of(embed(lagrangian, mid_point), T, initial_velocity<V>{q0, v0});
    auto const& p = made.second;
    auto const at = tabulate(on_half[extend[made.first]]);
    auto const v = tabulate(on_half[Delta_o_plus[extend[made.first]]]);
    auto const p_o = on_half[extend[p]];
    auto const by_q = [&](hilger::index_type i) { return gradient_first(lagrangian, at[i], v[i]); };
    auto const by_v = [&](hilger::index_type i) { return gradient_second(lagrangian, at[i], v[i]); };
    for (hilger::index_type i = 0; i < N; ++i) {
        CHECK(near(p_o[i], by_v(i)));                           // (82)
        CHECK(near(p[i + 1], V(by_v(i) + by_q(i) * S(h / 2)))); // (89), at t_N too
        CHECK(near(p[i], V(by_v(i) - by_q(i) * S(h / 2))));     // (84); (90) for i = 0
        CHECK(near(V(p[i + 1] - p[i]), V(by_q(i) * h)));        // (95)
        CHECK_FALSE(near(p_o[i], v[i]));                        // the magnetic term and the mass are seen
    }
}

} // namespace

TEST_CASE("theorem 4: what the mid-point flow makes is critical for (97) and solves (94), and nothing near it is critical") {
    SUBCASE("neither separable nor polynomial") { flow_is_critical(bead, float100(1), float100(1) / 2); }
    SUBCASE("quadratic with a magnetic term in the plane, exactly") {
        flow_is_critical(magnetic, plane<Q>(1, -1), plane<Q>(Q(1, 2), Q(1, 3)));
    }
}

TEST_CASE("theorem 4, both ways: for a quadratic H the critical points of (97) and the solutions of (94) are one linear space") {
    int const N = 4;
    auto const T = uniform(Q(0), Q(2, 7), N);
    lagrangian const L{[](auto const& x, auto const& v) { return v * v / 2 + v * x / 3 - x * x / 2; }};
    // N + 1 equations by p, N - 1 by q, of which one follows from the others: (117) holds at both ends.
    auto const ranks = ranks_of_theorem_4(hamiltonian(L), T);
    CHECK(ranks.critical == 2 * N - 1);
    CHECK(ranks.system == 2 * N - 1);
    CHECK(ranks.both == 2 * N - 1);
}

TEST_CASE("definition 12: the momentum of the mid-point flow is (89), (90), and p_o = dL/dv(q_o, Delta_o_plus[q_o]), (82)") {
    SUBCASE("with a magnetic term in the plane, exactly") {
        is_the_discrete_momentum(magnetic, plane<Q>(1, -1), plane<Q>(Q(1, 2), Q(1, 3)),
                                 [](auto const& x, auto const& y) { return x == y; });
    }
    SUBCASE("neither separable nor polynomial, in 100 digits") {
        float100 const tolerance = 1000 * epsilon<float100>();
        is_the_discrete_momentum(bead, float100(1), float100(1) / 2,
                                 [&](auto const& x, auto const& y) { return magnitude(float100(x - y)) <= tolerance; });
    }
}

} // namespace cresson_theorem_4_tests
