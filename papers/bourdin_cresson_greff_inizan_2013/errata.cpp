// SPDX-License-Identifier: BSL-1.0
// Misprints of L. Bourdin, J. Cresson, I. Greff, P. Inizan, "Variational integrator for fractional Euler-Lagrange equations" (2013): each
// printed form is false and the corrected one true, in exact rationals: the weights of a rational alpha are rational, and h = 1. The table
// is papers/errata.md; the slopes of section 3.4 are in dirichlet.cpp.
#include <doctest/doctest.h>

#include "hilger/boundary/solve.hpp"
#include "hilger/multiprecision.hpp"
#include "noether.hpp"
#include "support/two_sided.hpp"

namespace bourdin_errata_tests {

using namespace hilger;
using papers::fractional_noether_residual;
using papers::noether_constant;
using testing::two_sided;

namespace {

constexpr hilger::index_type N = 7;
auto const T = uniform(Q(-1, 3), Q(1), N);
auto const some = function_on(T, [](Q t) { return Q((2 - t) / (5 + t)); });
auto const other = function_on(T, [](Q t) { return Q(1 + t + 3 * t * t * t); });
using row = std::vector<Q>;

row weights(Q const& alpha) { return first_weights<grunwald_letnikov>(alpha, N + 1); }
row values(auto const& f) { return row(f.begin(), f.end()); }
std::size_t at(hilger::index_type k) { return static_cast<std::size_t>(k); }
/// Delta_-^alpha for k = first..N with Q_k for k = first..N.
row left(row const& x, Q const& alpha) {
    row y(x.size(), Q(0));
    for (std::size_t k = 0; k < x.size(); ++k)
        for (std::size_t r = 0; r <= k; ++r) y[k] += weights(alpha)[r] * x[k - r];
    return y;
}

} // namespace

TEST_CASE("(7): without its row k = 0 the operator has no semigroup, where x_0 is not zero") {
    row const x = values(some);
    Q const half(1, 2);
    REQUIRE(x[0] != 0);
    row const all = left(left(x, half), half), local = left(x, Q(1));
    CHECK(all == local);
    // As printed: Delta_-^{1/2} x is known for k = 1..N, and the second half derivative starts there.
    row cut = left(x, half);
    cut.erase(cut.begin());
    row const twice = left(cut, half);
    for (hilger::index_type k = 1; k <= N; ++k) CHECK(twice[at(k - 1)] != local[at(k)]);
    // The difference is what the lost row would have contributed.
    for (hilger::index_type k = 1; k <= N; ++k) CHECK(local[at(k)] - twice[at(k - 1)] == weights(half)[at(k)] * x[0]);
    // With x_0 = 0 nothing is lost.
    row zero = x;
    zero[0] = 0;
    cut = left(zero, half);
    cut.erase(cut.begin());
    for (hilger::index_type k = 1; k <= N; ++k) CHECK(left(cut, half)[at(k - 1)] == left(zero, Q(1))[at(k)]);
}

TEST_CASE("lemma 2: discrete fractional integration by parts, boundary values included") {
    for (Q const& alpha : {Q(1), Q(3, 4), Q(1, 2), Q(2, 7)}) {
        row const q = values(some), w = values(other), a = weights(alpha);
        auto const minus_w = Delta_minus(alpha)[other];
        auto const plus_q = Delta_plus(alpha)[some];
        Q by_left(0), inner(0), last_row(0);
        for (hilger::index_type k = 1; k <= N; ++k) by_left += q[at(k)] * minus_w[k];
        for (hilger::index_type k = 1; k < N; ++k) inner += plus_q[k] * w[at(k)];
        for (hilger::index_type r = 1; r <= N; ++r) last_row += a[at(r)] * q[at(r)];
        Q const ends = q[at(N)] * w[at(N)] + last_row * w[0]; // of w_0: (Delta_+^alpha q)_0 without its own term
        CHECK(by_left == inner + ends);
        CHECK(by_left != inner);
        if (alpha == 1) CHECK(ends == q[at(N)] * w[at(N)] - q[1] * w[0]);
        // With w zero at both ends it is (DFIBP).
        auto const zero_ends = function_on(T, [](Q t) { return t == T.min() or t == T.max() ? Q(0) : Q(1 + t); });
        Q printed(0);
        for (hilger::index_type k = 1; k <= N; ++k) printed += q[at(k)] * Delta_minus(alpha)[zero_ends][k];
        for (hilger::index_type k = 1; k < N; ++k) printed -= plus_q[k] * zero_ends[k];
        CHECK(printed == 0);
    }
}

TEST_CASE("(14): the inner sums run over r = 0..N-k; the printed ranges leave T, and miss terms when Q is zero beyond it") {
    row const q = values(some), a = weights(Q(3, 4));
    auto const w = function_on(T, [](Q t) { return t == T.min() or t == T.max() ? Q(0) : Q(1 + t * t); });
    auto const beyond = [&](hilger::index_type k) { return k <= N ? q[at(k)] : Q(0); };
    Q before(0), corrected(0), printed(0), second(0);
    bool leaves_T = false;
    for (hilger::index_type k = 0; k <= N; ++k) {
        for (hilger::index_type r = 0; r <= k; ++r) before += a[at(r)] * q[at(k)] * w[k - r]; // the first line
        for (hilger::index_type r = 0; r <= N - k; ++r) corrected += a[at(r)] * q[at(k + r)] * w[k];
        for (hilger::index_type r = 0; r <= k; ++r) {
            leaves_T = leaves_T or k + r > N;
            printed += a[at(r)] * beyond(k + r) * w[k];
        }
        for (hilger::index_type r = 0; r <= N - 1; ++r) second += a[at(r)] * beyond(k + r) * w[k];
    }
    CHECK(leaves_T);
    CHECK(before == corrected);
    CHECK(before != printed);
    CHECK(before == second); // the next range is right with zeros beyond T, as w_0 = 0
}

TEST_CASE("(12): the quadrature is the sum of right end points, exact for constants only, and no formula of Gauss") {
    auto const time = two_sided([](auto const& t, auto const&, auto const& v) { return t + 0 * v; }, Q(1), T).action();
    auto const one = two_sided([](auto const&, auto const& v) { return 1 + 0 * v; }, Q(1), T).action();
    Q const a = T.min(), b = T.max();
    CHECK(one(some) == b - a);
    CHECK(time(some) != (b * b - a * a) / 2); // Gauss's formula with one node, the mid-point rule, is exact here
    CHECK(time(some) == (b * b - a * a) / 2 + (b - a) / 2);
}

TEST_CASE("(22), (25): not every quadratic Lagrangian is invariant under rotations, and Dirichlet's is under no translation") {
    using plane = Eigen::Matrix<Q, 2, 1>;
    auto const rotation = [](auto const& x) { return plane(-x(1), x(0)); };
    plane const from(Q(1), Q(2)), to(Q(-1), Q(3));
    boundary_values const ends{from, to};
    auto const isotropic = two_sided([](auto const& x, auto const& v) { return (x.dot(x) + v.dot(v)) / 2; }, Q(2, 3), T);
    for (Q const& r : fractional_noether_residual(isotropic, rotation, solve(isotropic, T, ends))) CHECK(r == 0);
    auto const quadratic = two_sided([](auto const& x, auto const& v) { return (x(0) * x(0) + v.dot(v)) / 2; }, Q(2, 3), T);
    auto const solution = solve(quadratic, T, ends, boundary_options{});
    CHECK(solution.residual == 0);
    for (Q const& r : fractional_noether_residual(quadratic, rotation, solution.q)) CHECK(r != 0);
    // d = 1: there are no rotations, and the fractional difference of a constant is not zero.
    auto const translation = [](auto const&) { return Q(1); };
    auto const v_only = [](auto const&, auto const& v) { return v * v / 2; };
    auto const fractional = two_sided(v_only, Q(2, 3), T), local = two_sided(v_only, Q(1), T);
    for (Q const& r : fractional_noether_residual(fractional, translation, solve(fractional, T, {.q0 = 0, .qN = 1}))) CHECK(r != 0);
    for (Q const& r : fractional_noether_residual(local, translation, solve(local, T, {.q0 = 0, .qN = 1}))) CHECK(r == 0);
}

TEST_CASE("(29), (30): the constant has values for k = 0..N-1, sigma of dL/dv ends there") {
    using plane = Eigen::Matrix<Q, 2, 1>;
    auto const EL = two_sided([](auto const& x, auto const& v) { return (x.dot(x) + v.dot(v)) / 2; }, Q(1), T);
    auto const solution = solve(EL, T, boundary_values{plane(Q(1), Q(2)), plane(Q(-1), Q(3))});
    auto const constant = noether_constant(
        EL, [](auto const& x) { return plane(-x(1), x(0)); }, solution);
    CHECK(constant.first() == 0);
    CHECK(constant.last() == N - 1);
    CHECK(constant[0] != 0);
    for (Q const& c : constant) CHECK(c == constant[0]);
    CHECK_THROWS_AS((void)constant[N], error::outside_domain);
}

} // namespace bourdin_errata_tests
