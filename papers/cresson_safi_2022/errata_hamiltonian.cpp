// SPDX-License-Identifier: BSL-1.0
// Misprints of J. Cresson and R. Safi, "Mid-point embedding of Hamiltonian systems and variational integrators" (2022), section 4: each
// printed form is false and the corrected one true, in exact rationals. The table is papers/errata.md.
#include <doctest/doctest.h>

#include "slope.hpp"

namespace cresson_errata_hamiltonian_tests {

using namespace hilger;
using namespace hilger::papers;

namespace {

hilger::index_type const N = 4;
Q const h(1, 5);
auto const T = uniform(Q(0), h, N);
constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v + v * x / 3 - x * x / 2; }};
hamiltonian const H(L);
auto const made = trajectory_of(embed(L, mid_point), T, initial_velocity<Q>{Q(1), Q(1, 2)});
auto const& q = made.first;
auto const& p = made.second;

template <class X>
auto mid(X const& x) { // x_o on T_half
    return on_half[extend[x]];
}
template <class X>
auto velocity(X const& x) { // Delta_o_plus[x_o] on T_half
    return on_half[Delta_o_plus[extend[x]]];
}
auto const by_q = [](auto const& x, auto const& v) { return gradient_first(L, x, v); };
auto const by_v = [](auto const& x, auto const& v) { return gradient_second(L, x, v); };

/// (94), left-hand side minus right-hand side.
template <class P, class X>
auto first_line(P const& p, X const& q) {
    return Delta_h_minus[mid(p)] +
           mean_h_minus[apply_pointwise([](Q const& y, Q const& x) { return H.by_position(y, x); }, mid(p), mid(q))];
}
template <class P, class X>
auto second_line(P const& p, X const& q) {
    return velocity(q) - apply_pointwise([](Q const& y, Q const& x) { return H.by_momentum(y, x); }, mid(p), mid(q));
}
/// The derivative of (97) at (p, q), p moving along w and q along v.
template <class P, class X, class W, class Z>
Q slope(P const& p, X const& q, W const& w, Z const& v) {
    auto const action = [](auto const& y, auto const& x) {
        return integral(mid(y) * velocity(x) - apply_pointwise(H, mid(y), mid(x)), half(T));
    };
    return slope_at_zero<Q>([&](Q const& e) { return Q(action(p + e * w, q + e * v)); });
}
auto const none = function_on(T, [](Q) { return Q(0); });
template <class P, class X>
bool is_critical(P const& p, X const& q) {
    bool all = true;
    for (hilger::index_type k = 0; k <= N; ++k) all = all and slope(p, q, unit<Q>(T, k), none) == 0;
    for (hilger::index_type k = 1; k < N; ++k) all = all and slope(p, q, none, unit<Q>(T, k)) == 0;
    return all;
}
template <class F, class Scale>
bool is_zero_on(F const& f, Scale const& scale) {
    for (hilger::index_type i = scale.first(); i <= scale.last(); ++i)
        if (f[i] != 0) return false;
    return true;
}

} // namespace

TEST_CASE("definitions 11, 12 and 16: p is needed at t_N, which is neither in T^+ nor in T^+-") {
    auto const p_o = mid(p);
    auto const printed = mid(restrict_to(p, without_last(T)));
    CHECK(printed.size() == N - 1);
    CHECK_THROWS_AS((void)printed[N - 1], error::outside_domain); // p_o at the last point of T_half
    auto const Lq = apply_pointwise(by_q, mid(q), velocity(q));
    auto const Lv = apply_pointwise(by_v, mid(q), velocity(q));
    for (hilger::index_type i = 0; i < N; ++i) CHECK(p_o[i] == Lv[i]);                        // (82) on all of T_half
    for (hilger::index_type i = 1; i <= N; ++i) CHECK(p[i] == Lv[i - 1] + h / 2 * Lq[i - 1]); // (89) on T^-
    // Theorem 4 varies p at t_N too, and that equation is one of (117).
    CHECK(slope(p, q, unit<Q>(T, N), none) == 0);
    CHECK(slope(p, q + unit<Q>(T, N), unit<Q>(T, N), none) != 0);
}

TEST_CASE("(82), (83): the equations hold on T_half; at t_i both sides exist and differ") {
    auto const p_o = extend[p];
    auto const q_o = extend[q];
    auto const v = Delta_o_plus[extend[q]];
    for (hilger::index_type j = 0; j < 2 * N; ++j) { // t_i for even j, t_{i+1/2} for odd j
        CHECK((p_o[j] == by_v(q_o[j], v[j])) == (j % 2 == 1));
        CHECK((v[j] == H.by_momentum(p_o[j], q_o[j])) == (j % 2 == 1));
    }
}

TEST_CASE("(91): p(t_{i+1}) is dL_h/dy(q_i, q_{i+1}), and L_h takes two positions") {
    auto const L_h = [](auto const& x, auto const& y) { return h * L((x + y) / 2, (y - x) / h); };
    for (hilger::index_type i = 0; i < N; ++i) {
        CHECK(p[i] == -gradient_first(L_h, q[i], q[i + 1]));
        CHECK(p[i + 1] == gradient_second(L_h, q[i], q[i + 1]));                           // corrected
        if (i > 0) CHECK(p[i + 1] != gradient_second(L_h, q[i - 1], q[i]));                // as printed: that is p(t_i)
        CHECK(p[i + 1] != gradient_second(L_h, Q((q[i] + q[i + 1]) / 2), velocity(q)[i])); // at star, as printed
        if (i + 2 <= N) CHECK(p[i + 1] == -gradient_first(L_h, q[i + 1], q[i + 2]));       // (92)
    }
}

TEST_CASE("definition 14, (94), (116): the first line holds on T_half^-, the second on T_half, and not both on T_half^+- only") {
    CHECK(is_zero_on(first_line(p, q), without_first(half(T))));
    CHECK(is_zero_on(second_line(p, q), half(T)));
    CHECK(is_critical(p, q));
    // The last position is in no equation on T_half^+-, and moving it leaves a solution of the printed system that is not critical.
    auto const moved = q + unit<Q>(T, N);
    CHECK(is_zero_on(first_line(p, moved), interior(half(T))));
    CHECK(is_zero_on(second_line(p, moved), interior(half(T))));
    CHECK_FALSE(is_critical(p, moved));
    // Nor is it enough to correct one of the two.
    CHECK_FALSE(is_zero_on(second_line(p, moved), half(T)));
    auto const kicked = p + unit<Q>(T, N);
    CHECK(is_zero_on(first_line(kicked, q), interior(half(T))));
    CHECK_FALSE(is_zero_on(first_line(kicked, q), without_first(half(T))));
}

TEST_CASE("(98): v varies q and w varies p, so that the direction of (p, q) is (w, v)") {
    auto const v = function_on(T, [](Q t) { return t == T.min() or t == T.max() ? Q(0) : Q(1 + t); }); // in V
    auto const w = function_on(T, [](Q t) { return Q(2 - t * t); });                                   // in C(T)
    CHECK(slope(p, q, w, v) == 0);                                                                     // corrected
    CHECK(slope(p, q, v, w) != 0);                                                                     // as printed: q moves at a and b
}

TEST_CASE("theorem 4: critical points have the p of definition 12 up to c (-1)^i only, and p_o does not see the difference") {
    auto const alternating = function_on(T, [](Q t) { return Q(T.number_of(t) % 2 == 0 ? 3 : -3); });
    auto const other = p + alternating;
    for (hilger::index_type i = 0; i < N; ++i) CHECK(mid(other)[i] == mid(p)[i]);
    CHECK(is_critical(other, q));
    CHECK(is_zero_on(first_line(other, q), without_first(half(T))));
    CHECK(is_zero_on(second_line(other, q), half(T)));
    Q const by_90 = by_v(mid(q)[0], velocity(q)[0]) - h / 2 * by_q(mid(q)[0], velocity(q)[0]);
    CHECK(p[0] == by_90);
    CHECK(other[0] != by_90); // as printed, definition 14 asks for (89) and (90)
}

TEST_CASE("(112): the end terms by dL/dp carry h/2, and those of t_N are at t_{N-1/2}") {
    // Depends on w, the velocity of p, as (110) does not: there the end terms by dL/dw are zero whatever they are.
    auto const LL = [](Q const& y, Q const& x, Q const& w, Q const& v) {
        return Q(y * v - y * y / 2 - y * x / 3 - x * x + w * w / 2 + w * x / 4 + w * y * y / 5);
    };
    auto const P = function_on(T, [](Q t) { return Q(1 + t - 3 * t * t); });
    auto const X = function_on(T, [](Q t) { return Q((2 - t) / (5 + t)); });
    auto const w = function_on(T, [](Q t) { return Q(2 - t + t * t * t); });
    auto const z = function_on(T, [](Q t) { return t == T.min() or t == T.max() ? Q(0) : Q(1 + t * t); });
    auto const action = [&](auto const& y, auto const& x) {
        return integral(apply_pointwise(LL, mid(y), mid(x), velocity(y), velocity(x)), half(T));
    };
    Q const derivative = slope_at_zero<Q>([&](Q const& e) { return Q(action(P + e * w, X + e * z)); });

    auto const Lp = apply_pointwise([](Q const& y, Q const& x, Q const& u, Q const& v) { return Q(v - y - x / 3 + 2 * u * y / 5); }, mid(P),
                                    mid(X), velocity(P), velocity(X));
    auto const Lq =
        apply_pointwise([](Q const& y, Q const& x, Q const& u) { return Q(-y / 3 - 2 * x + u / 4); }, mid(P), mid(X), velocity(P));
    auto const Lw =
        apply_pointwise([](Q const& y, Q const& x, Q const& u) { return Q(u + x / 4 + y * y / 5); }, mid(P), mid(X), velocity(P));
    auto const Lv = mid(P);
    Q const inner = weighted_sum<delta_weight>(pi_half[mean_h_minus[Lq] - Delta_h_minus[Lv]] * z) +
                    weighted_sum<delta_weight>(pi_half[mean_h_minus[Lp] - Delta_h_minus[Lw]] * w);
    CHECK(derivative != inner + Lw[0] * w[N] - Lw[0] * w[0] + Lp[0] * w[N] + Lp[0] * w[0]);                   // as printed
    CHECK(derivative != inner + Lw[N - 1] * w[N] - Lw[0] * w[0] + Lp[N - 1] * w[N] + Lp[0] * w[0]);           // without h/2
    CHECK(derivative != inner + Lw[0] * w[N] - Lw[0] * w[0] + h / 2 * (Lp[0] * w[N] + Lp[0] * w[0]));         // all at t_half
    CHECK(derivative == inner + Lw[N - 1] * w[N] - Lw[0] * w[0] + h / 2 * (Lp[N - 1] * w[N] + Lp[0] * w[0])); // corrected
}

TEST_CASE("(114): h/2 dL/dp + dL/dw = 0 at t_{N-1/2} and h/2 dL/dp - dL/dw = 0 at t_{1/2}") {
    // L = w^2/2 + p q has dL/dp = q and dL/dw = w. On two steps p = t, q = (4, 0, -4)/h is critical for all variations of p.
    auto const two = uniform(Q(0), h, 2);
    auto const P = function_on(two, [](Q t) { return t; });
    auto const X = function_on(two, [](Q t) { return Q(4 / h * (1 - t / h)); });
    auto const action = [&](auto const& y) { return integral(velocity(y) * velocity(y) / 2 + mid(y) * mid(X), half(two)); };
    for (hilger::index_type k = 0; k <= 2; ++k)
        CHECK(slope_at_zero<Q>([&](Q const& e) { return Q(action(P + e * unit<Q>(two, k))); }) == 0);
    Q const first = mid(X)[0], last = mid(X)[1], w = velocity(P)[0];
    REQUIRE(velocity(P)[1] == w);
    CHECK(h / 2 * last + w == 0); // corrected
    CHECK(h / 2 * first - w == 0);
    CHECK(last + w != 0); // as printed
    CHECK(first - w != 0);
}

TEST_CASE("(117): dH/dp is taken at (p_o, q_o), as in (94) and (118)") {
    for (hilger::index_type const i : {hilger::index_type(0), hilger::index_type(N - 1)}) {
        CHECK(velocity(q)[i] == H.by_momentum(mid(p)[i], mid(q)[i]));
        CHECK(velocity(q)[i] != H.by_momentum(mid(q)[i], mid(p)[i])); // as printed
    }
}

} // namespace cresson_errata_hamiltonian_tests
