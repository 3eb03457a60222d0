// SPDX-License-Identifier: BSL-1.0
// Points inside steps are a scale, nodes of a quadrature are one, and what Galerkin embeddings read there are operators as all others:
// their integration by parts is exact, on uneven T too, and known embeddings are among them.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/embedding/radau.hpp"

namespace polynomial_tests {

using namespace hilger;
using testing::own_radau;

namespace {

auto const uneven = time_scale(std::vector{Q(-1), Q(-1, 3), Q(0), Q(5, 7), Q(2)});

template <class Op, class F, class G>
void adds_up(Op const& A, F const& f, G const& g) {
    auto const parts = by_parts(A, f, g);
    CHECK(parts.left == parts.interior + parts.boundary);
    CHECK(parts.left != 0);
    CHECK(parts.boundary != 0);
}
template <int Degree, class Quadrature, int Count>
void is_integrated_by_parts() {
    CAPTURE(Degree);
    auto const f = function_on(subdivide<Degree>(uneven), [](Q const& t) { return Q(t * t * t * t * t - 3 * t + 2); });
    auto const g = function_on(at_nodes<Quadrature, Count>(uneven), [](Q const& t) { return Q(1 / (t + 5) + t); });
    adds_up(polynomial_value<Degree, Quadrature, Count>{}, f, g);
    adds_up(polynomial_slope<Degree, Quadrature, Count>{}, f, g);
    // the adjoint is an operator as well, and its adjoint is the first one
    auto const spread = adjoint(polynomial_slope<Degree, Quadrature, Count>{});
    adds_up(spread, g, f);
    static_assert(std::same_as<std::remove_const_t<decltype(adjoint(spread))>, polynomial_slope<Degree, Quadrature, Count>>);
}
/// The value and the slope of t^n at the nodes, where polynomials of this degree are read exactly.
template <int Degree, class Quadrature, int Count>
bool reads_powers(int n) {
    auto const power = [](Q const& t, int k) {
        Q x(1);
        for (int j = 0; j < k; ++j) x *= t;
        return x;
    };
    auto const f = function_on(subdivide<Degree>(uneven), [&](Q const& t) { return power(t, n); });
    auto const values = polynomial_value<Degree, Quadrature, Count>{}[f];
    auto const slopes = polynomial_slope<Degree, Quadrature, Count>{}[f];
    auto const nodes = at_nodes<Quadrature, Count>(uneven);
    bool all = true;
    for (auto i = values.first(); i <= values.last(); ++i) {
        Q const t = nodes.element(i);
        all = all and values.get(i) == power(t, n) and slopes.get(i) == (n == 0 ? Q(0) : Q(n * power(t, n - 1)));
    }
    return all;
}

} // namespace

TEST_CASE("T/d divides each step into d, T/1 is T and T/2 is T_o") {
    static_assert(std::same_as<subdivided<1>, nodes> and std::same_as<subdivided<2>, joined<fraction<1, 2>>>);
    auto const third = subdivide<3>(uneven);
    CHECK(third.size() == 13);
    CHECK(third.element(0) == -1);
    CHECK(third.element(1) == Q(-7, 9));
    CHECK(third.element(3) == Q(-1, 3));
    CHECK(third.element(11) == Q(5, 7) + Q(2, 3) * Q(9, 7));
    CHECK(third.element(12) == 2);
    CHECK(third.mu(Q(5, 7)) == Q(3, 7));
    CHECK(third.number_of(Q(5, 7)) == 9);
    // shifts and differences are there as on every family
    auto const square = function_on(third, [](Q const& t) { return Q(t * t); });
    CHECK(derivative<subdivided<3>, side::plus>{}[square].get(1) == Q(-7, 9) + Q(-5, 9));
    CHECK(shift<subdivided<3>, side::plus>{}[square].get(2) == Q(1, 9));
}

TEST_CASE("over the nodes of a quadrature it is the quadrature that integrates") {
    static_assert(std::same_as<quadrature_nodes<gauss, 1>, between<fraction<1, 2>>>);
    auto const cube = [](Q const& t) { return Q(4 * t * t * t + 1); };
    auto const there = at_nodes<lobatto, 3>(uneven); // Simpson's rule
    CHECK(there.size() == 12);
    CHECK(integral(function_on(there, cube), there) == Q(16 - 1 + 3));
    auto const one_sided = at_nodes<own_radau, 2>(uneven);
    CHECK(one_sided.element(3) == 0);
    CHECK(one_sided.element(2) == Q(-1, 3) + Q(1, 9));
    CHECK(integral(function_on(one_sided, [](Q const& t) { return Q(3 * t * t); }), one_sided) == 9);
    CHECK(integral(function_on(one_sided, cube), one_sided) != 18);
    auto const too_many = at_nodes<own_radau, 3>(uneven);
    CHECK_THROWS_WITH_AS(static_cast<void>(too_many.element(0)),
                         "the quadrature Radau was asked for 3 nodes and weights, and gives 2 and 2", error::mismatch const&);
    // between points of T, in either order
    CHECK(integral(function_on(there, cube), Q(0), Q(2)) == 18);
    CHECK(integral(function_on(there, cube), Q(2), Q(0)) == -18);
    CHECK(integral(function_on(there, cube), Q(-1), Q(0)) == 0);
}

TEST_CASE("integration by parts is exact, with the end terms, on uneven steps") {
    is_integrated_by_parts<1, gauss, 1>();
    is_integrated_by_parts<1, lobatto, 2>();
    is_integrated_by_parts<2, lobatto, 3>();
    is_integrated_by_parts<2, own_radau, 2>();
    is_integrated_by_parts<3, own_radau, 2>();
    is_integrated_by_parts<4, lobatto, 3>();
}

TEST_CASE("polynomials of their degree are read exactly, and no others") {
    for (int n = 0; n <= 3; ++n) {
        CHECK(reads_powers<3, own_radau, 2>(n));
        CHECK(reads_powers<2, lobatto, 3>(n) == (n <= 2));
    }
    CHECK_FALSE(reads_powers<3, own_radau, 2>(4));
    CHECK(reads_powers<1, lobatto, 2>(1));
}

TEST_CASE("nothing is written for them: one Gauss node is mid-point, two Lobatto nodes are the trapezoid rule") {
    static_assert(galerkin<1, gauss>.position == mid_point.position);
    static_assert(galerkin<1, gauss>.velocity == mid_point.velocity);
    static_assert(uniformly(adjoint(galerkin<1, gauss>.velocity)) == -Delta_minus * pi_half);
    static_assert(facts_of<decltype(galerkin<1, gauss>)>.one_node);
    auto const a = tableau_of(galerkin<1, gauss>, Q(1, 5)), b = tableau_of(mid_point, Q(1, 5));
    CHECK((a.position == b.position and a.velocity == b.velocity and a.weight == b.weight));
    auto const trapezoid = tableau_of(galerkin<2, lobatto>, Q(1, 5));
    CHECK(trapezoid.position == std::vector<Q>{1, 0, 0, 1});
    CHECK(trapezoid.velocity == std::vector<Q>{-5, 5, -5, 5});
    CHECK(trapezoid.weight == std::vector<Q>{Q(1, 10), Q(1, 10)});
    // Simpson's rule, with the middle of the step as a third control value
    auto const simpson = tableau_of(galerkin<3, lobatto>, Q(1));
    CHECK(simpson.controls == 3);
    CHECK(simpson.position == std::vector<Q>{1, 0, 0, 0, 1, 0, 0, 0, 1});
    CHECK(simpson.velocity == std::vector<Q>{-3, 4, -1, -1, 0, 1, 1, -4, 3});
    CHECK(simpson.weight == std::vector<Q>{Q(1, 6), Q(2, 3), Q(1, 6)});
    CHECK(simpson.time(1, Q(7), Q(1)) == Q(15, 2));
}

TEST_CASE("what an equation with inner points reads is known by its type") {
    auto const T = uniform(0.0, 0.1, 10);
    lagrangian const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    constexpr auto G = galerkin<3, gauss>;
    constexpr unknown<"q", subdivided<3>> q;
    auto const EL = variation(integral(L(G.position[q], G.velocity[q]), at_nodes<gauss, 3>(T)));
    using equation = std::remove_const_t<decltype(EL)>;
    static_assert(equation::reads.is_local() and equation::reads.steps() == 2);
    static_assert(detail::reads_one_step<decltype(G.position), decltype(G.velocity)>);
    CHECK(EL.residual(function_on(subdivide<3>(T), [](double t) { return t; })).size() == 29);
}

} // namespace polynomial_tests
