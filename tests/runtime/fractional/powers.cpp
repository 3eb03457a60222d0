// SPDX-License-Identifier: BSL-1.0
// Powers of the difference on uneven T, exactly: steps whose roots are rational, equal ones among them.
#include <doctest/doctest.h>

#include "hilger/calculus.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/values.hpp"

namespace powers_tests {

using namespace hilger;
using testing::values;

namespace {

/// T from 1 on with steps that are the n-th powers of these numbers.
time_scale<Q> with_steps(std::vector<Q> const& roots, int n) {
    std::vector<Q> points{1};
    for (Q const& r : roots) {
        Q step(1);
        for (int i = 0; i < n; ++i) step *= r;
        points.push_back(points.back() + step);
    }
    return time_scale<Q>(points);
}
std::vector<Q> const roots{Q(1), Q(2), Q(1, 3), Q(2), Q(2), Q(5, 2), Q(1)};
auto const squares = with_steps(roots, 2), fourth_powers = with_steps(roots, 4);

template <class Root>
auto some_f(Root const& T) {
    return function_on(T, [](Q const& t) { return Q(t * t / 4 - 3 * t + 5); });
}
template <class Root>
auto some_g(Root const& T) {
    return function_on(T, [](Q const& t) { return Q(5 / (t + 2) - t); });
}
/// A[B[f]] = AB[f], with both sums carried out.
template <class A, class B, class F>
void check_semigroup(A const& a, B const& b, F const& f) {
    CHECK(values(a[tabulate(b[f])]) == values((a * b)[f]));
}
template <class Op, class Root>
void check_by_parts(Op const& op, Root const& T) {
    INFO(std::string(Op::name().text().view()));
    auto const parts = by_parts(op, some_f(T), some_g(T));
    CHECK(parts.left == parts.interior + parts.boundary);
    CHECK_FALSE(parts.left == parts.interior);
}

} // namespace

TEST_CASE("the rows of a root, by hand") {
    auto const T = with_steps({1, 2}, 2); // graininess 1, 1, 4
    auto const unit = [&](hilger::index_type j) { return function_on(T, [j, &T](Q const& t) { return Q(T.number_of(t) == j); }); };
    CHECK(values(Delta_minus_alpha<1, 2>[unit(0)]) == "T: 1, -1/2, -1/18");
    CHECK(values(Delta_minus_alpha<1, 2>[unit(1)]) == "T: 0, 1, -1/6");
    CHECK(values(Delta_minus_alpha<1, 2>[unit(2)]) == "T: 0, 0, 1/2");
    CHECK(values(Delta_plus_alpha<1, 2>[unit(2)]) == "T: -2/9, -2/3, 1/2");    // nu_2/nu_k times the entries of the transpose
    CHECK(values(minus_Delta_plus_alpha<1, 2>[unit(1)]) == "T: -2/3, 1/2, 0"); // graininess 1, 4, 4
    CHECK(values(adjoint(minus_Delta_plus_alpha<1, 2>)[unit(0)]) == "T: 1, -1/6, -1/36");
}

TEST_CASE("orders add up, to the local differences") {
    auto const f = some_f(squares);
    auto const g = some_f(fourth_powers);
    check_semigroup(Delta_minus_alpha<1, 2>, Delta_minus_alpha<1, 2>, f);
    check_semigroup(Delta_plus_alpha<1, 2>, Delta_plus_alpha<1, 2>, f);
    check_semigroup(minus_Delta_plus_alpha<1, 2>, minus_Delta_plus_alpha<1, 2>, f);
    check_semigroup(Delta_minus_alpha<1, 2>, Delta_minus_alpha<1, 1>, f);
    check_semigroup(Delta_minus_alpha<1, 1>, Delta_minus_alpha<1, 2>, f);
    check_semigroup(Delta_minus_alpha<1, 1>, Delta_minus_alpha<1, 1>, f);
    check_semigroup(Delta_minus_alpha<1, 4>, Delta_minus_alpha<1, 2>, g);
    check_semigroup(Delta_minus_alpha<3, 4>, Delta_minus_alpha<3, 4>, g);
    check_semigroup(Delta_minus_alpha<3, 4>, Delta_minus(Q(1, 4)), g);
    CHECK(values(Delta_minus(Q(1, 2))[f]) == values(Delta_minus_alpha<1, 2>[f]));
    CHECK(values((Delta_minus(Q(3, 4)) * Delta_minus(Q(1, 2)))[g]) == values((Delta_minus_alpha<3, 4> * Delta_minus_alpha<1, 2>)[g]));
    auto const first = Delta_minus_alpha<1, 1>[f];
    auto const second = (Delta_minus_alpha<1, 1> * Delta_minus_alpha<1, 1>)[f];
    auto const ahead = minus_Delta_plus_alpha<1, 1>[f];
    auto const back = Delta_minus[f];
    auto const twice = Delta_minus[Delta_minus[f]];
    auto const next = Delta_plus[f];
    CHECK(first[0] == f[0]); // nu(t_0) = nu(t_1) = 1
    for (hilger::index_type k = 1; k <= 7; ++k) CHECK(first[k] == back[k]);
    for (hilger::index_type k = 2; k <= 7; ++k) CHECK(second[k] == twice[k]);
    for (hilger::index_type k = 0; k < 7; ++k) CHECK(ahead[k] == -next[k]);
}

TEST_CASE("orders above 2 and below 0") {
    auto const f = some_f(squares);
    auto const g = some_f(fourth_powers);
    check_semigroup(Delta_minus_alpha<1, 2>, Delta_minus_alpha<-1, 2>, f);
    check_semigroup(Delta_plus_alpha<-1, 2>, Delta_plus_alpha<5, 2>, f);
    check_semigroup(Delta_minus_alpha<-3, 2>, Delta_minus_alpha<-1, 1>, f);
    check_semigroup(minus_Delta_plus_alpha<-3, 4>, minus_Delta_plus_alpha<11, 4>, g);
    check_semigroup(Delta_minus(Q(-3, 4)), Delta_minus(Q(11, 4)), g);
    CHECK(values((Delta_minus_alpha<1, 2> * Delta_minus_alpha<-1, 2>)[f]) == values(f));
    CHECK(values(Delta_minus_alpha<3, 1>[f]) == values(Delta_minus_alpha<1, 1>[Delta_minus_alpha<2, 1>[f]]));
    auto const sums = Delta_minus_alpha<-1, 1>[f];
    auto const integral = antiderivative_nabla[f];
    CHECK(sums[0] == f[0]);
    for (hilger::index_type k = 0; k <= 7; ++k) CHECK(sums[k] - sums[0] == integral[k]);
    check_by_parts(Delta_minus_alpha<-1, 2>, squares);
    check_by_parts(minus_Delta_plus_alpha<5, 2>, squares);
    time_scale<Q> const given(uniform(Q(0), Q(1), 6));
    CHECK(values(Delta_minus_alpha<-2, 5>[some_f(given)]) == values(Delta_minus_alpha<-2, 5>[some_f(uniform(Q(0), Q(1), 6))]));
}

TEST_CASE("equal steps have the weights of Gruenwald and Letnikov") {
    auto const T = uniform(Q(0), Q(1), 6);
    time_scale<Q> const given(T);
    CHECK(values(Delta_minus_alpha<1, 3>[some_f(given)]) == values(Delta_minus_alpha<1, 3>[some_f(T)]));
    CHECK(values(Delta_plus_alpha<2, 5>[some_f(given)]) == values(Delta_plus_alpha<2, 5>[some_f(T)]));
    CHECK(values(minus_Delta_plus_alpha<2, 5>[some_f(given)]) == values(minus_Delta_plus_alpha<2, 5>[some_f(T)]));
    auto const three_halves = Delta_minus_alpha<1, 1> * Delta_minus_alpha<1, 2>;
    CHECK(values(three_halves[some_f(given)]) == values(three_halves[some_f(T)]));
    CHECK(values(caputo_minus_alpha<1, 2>[some_f(given)]) == values(caputo_minus_alpha<1, 2>[some_f(T)]));
    auto const constant = caputo_minus_alpha<1, 2>[function_on(squares, [](Q const&) { return Q(7); })];
    for (hilger::index_type k = 0; k <= 7; ++k) CHECK(constant[k] == 0);
}

TEST_CASE("the mirror image has the graininess of the other side") {
    std::vector<Q> points;
    for (hilger::index_type k = 7; k >= 0; --k) points.push_back(-squares.point(k));
    time_scale<Q> const mirrored(points);
    auto const left = Delta_minus_alpha<1, 2>[some_f(squares)];
    auto const right = minus_Delta_plus_alpha<1, 2>[function_on(mirrored, [](Q const& t) { return some_f(squares)(-t); })];
    for (hilger::index_type k = 0; k <= 7; ++k) CHECK(left[k] == right[7 - k]);
}

TEST_CASE("integration by parts") {
    check_by_parts(Delta_minus_alpha<1, 2>, squares);
    check_by_parts(Delta_plus_alpha<1, 2>, squares);
    check_by_parts(minus_Delta_plus_alpha<1, 2>, squares);
    check_by_parts(adjoint(minus_Delta_plus_alpha<1, 2>), squares);
    check_by_parts(Delta_minus_alpha<1, 1> * Delta_minus_alpha<1, 2>, squares);
    check_by_parts(Delta_minus_alpha<3, 4>, fourth_powers);
    check_by_parts(Q(3, 5) * Delta_plus_alpha<1, 2> * Delta_minus_alpha<1, 2>, squares);
    check_by_parts(Delta_minus_alpha<1, 2> - fraction<1, 4>{} * Delta_minus, squares);
    check_by_parts(caputo_minus_alpha<1, 2>, squares);
    auto const f = some_f(squares);
    auto const g = some_g(squares);
    CHECK(boundary_form(Delta_minus_alpha<1, 2>, f, g) == f[7] * g[7] - f[0] * g[0]); // both end steps are 1
}

TEST_CASE("a variation on an uneven T is the derivative of its sum") {
    constexpr unknown q;
    lagrangian const quadratic{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 3 + x * v; }};
    auto const S = nabla_integral(quadratic(q, Delta_minus_alpha<1, 2>[q]), squares);
    auto const EL = variation(S);
    std::vector<Q> const x{2, -1, 3, 0, 5, -2, 1, 4};
    auto const residual = EL.residual(function_on(squares, x));
    CHECK(residual.first() == 1);
    CHECK(residual.last() == 6);
    for (std::size_t k = 1; k < 7; ++k) {
        auto more = x, less = x;
        more[k] += 1;
        less[k] -= 1;
        auto const i = static_cast<hilger::index_type>(k);
        CHECK(residual[i] * squares.step(i) == (S(function_on(squares, more)) - S(function_on(squares, less))) / 2);
    }
}

TEST_CASE("steps and orders without an exact root are refused") {
    auto const f = some_f(time_scale<Q>{Q(0), Q(1), Q(3)});
    CHECK((Delta_minus_alpha<1, 2>[f][1]) == f[1] - f[0] / 2); // up to the step of length 2
    CHECK_THROWS_WITH_AS((void)(Delta_minus_alpha<1, 2>[f][2]),
                         "in an exact scalar a fractional difference of order 1/2 takes steps that are powers of rational numbers with the "
                         "exponent 2, and this one is 2",
                         error::invalid_parameter);
    CHECK_THROWS_AS((void)(Delta_minus_alpha<1, 4>[some_f(squares)][2]), error::invalid_parameter);
    CHECK_THROWS_WITH_AS(
        (void)(Delta_minus(Q(1, 1001))[f][1]),
        "in an exact scalar the order of a fractional difference on uneven steps has a denominator up to 1000, and this one is 1001",
        error::invalid_parameter);
    CHECK((Delta_minus_alpha<1, 1>[f][2]) == (f[2] - f[1]) / 2);
}

TEST_CASE("how they are printed") {
    CHECK(testing::printed(minus_Delta_plus_alpha<1, 2>) == "(−Δ₊)^(1/2)[f]");
    CHECK(testing::printed(adjoint(minus_Delta_plus_alpha<1, 2>)) == "((−Δ₊)^(1/2))*[f]");
    CHECK(latex(minus_Delta_plus_alpha<1, 2>) == "(-\\Delta_{+})^{1/2}\\left[f\\right]");
    CHECK(testing::printed(Delta_minus_alpha<1, 2>) == "Δ₋^(1/2)[f]");
}

} // namespace powers_tests
