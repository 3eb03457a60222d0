// SPDX-License-Identifier: BSL-1.0
// Galerkin steps of one number: far beyond the period, exact in the rationals, and those that cannot be made.
#include <doctest/doctest.h>

#include <complex>

#include "support/systems.hpp"

namespace galerkin_ways_tests {

using namespace hilger;

namespace {

enum class kind { oscillator, cubic, degenerate, root };
/// One type for all keeps the number of instantiations down.
constexpr auto lagrangian_of_kind(kind which) {
    return [which](auto const& x, auto const& v) {
        if (which == kind::oscillator) return v * v / 2 - 2500 * x * x / 2;
        if (which == kind::cubic) return v * v / 2 + 10 * x * x * x / 3;
        if (which == kind::degenerate) return 2 * v - x * x;
        return v * v / 2 + sqrt(x);
    };
}

/// What a step of length h from q with p = 1 throws: nothing, no convergence, singular, not finite; ! where it changes the state.
char failure_of(kind which, double q, double h) {
    auto const flow = embed(lagrangian_of_kind(which), galerkin<2, gauss>);
    state<double, double> x{0, q, 1};
    state<double, double> const before = x;
    decltype(flow)::memory<double, double> memory(flow, h, q);
    char what = '-';
    try {
        memory.advance(flow, x, h);
        return what;
    } catch (error::no_convergence const&) {
        what = 'c';
    } catch (error::singular const&) {
        what = 's';
    } catch (error::not_finite const&) {
        what = 'f';
    }
    return x == before ? what : '!';
}

} // namespace

// Gauss methods have the diagonal Pade approximants of exp as stability functions: of two nodes (1 + z/2 + z^2/12) / (1 - z/2 + z^2/12),
// and q + i p / 50 is multiplied by its value at z = -50 i h.
TEST_CASE("a step far beyond the period of an oscillator is Newton's, and right") {
    state<double, double> x{0, 1, 0};
    auto const path = embed(lagrangian_of_kind(kind::oscillator), galerkin<2, gauss>).along(uniform(0.0, 1.0, 100), x.q, x.p);
    for (auto const& y : path) x = y;
    std::complex<double> const z(0, -50), all = std::pow((1.0 + z / 2.0 + z * z / 12.0) / (1.0 - z / 2.0 + z * z / 12.0), 100);
    // A hundred steps, each solved with numbers of the size of |z|^2 = 2500.
    double const rounding = 100 * 2500 * epsilon<double>();
    CHECK(std::abs(x.q - all.real()) <= rounding);
    CHECK(std::abs(x.p / 50 - all.imag()) <= rounding);
}
TEST_CASE("a step that cannot be made says why, and leaves the state") {
    CHECK(failure_of(kind::oscillator, 1, 0.01) == '-');
    CHECK(failure_of(kind::cubic, 1, 1) == 'c'); // like y - 1 = 5 ((1 + y)/2)^2 of mid-point it has no solution
    CHECK(failure_of(kind::degenerate, 1, 0.1) == 's');
    CHECK(failure_of(kind::root, -1, 0.1) == 'f');
}
TEST_CASE("two Lobatto nodes are Stoermer-Verlet, one Gauss node is mid-point, exactly in the rationals") {
    auto const spring = [](auto const& x, auto const& v) { return v * v / 3 - x * x / 2; };
    state<Q, Q> const start{Q(0), Q(1), Q(1, 2)};
    Q const h(1, 5);
    CHECK(embed(spring, galerkin<2, lobatto>).step(start, h) == stoermer_verlet(spring).step(start, h));
    CHECK(embed(spring, galerkin<1, gauss>).step(start, h) == embed(spring, mid_point).step(start, h));
}
TEST_CASE("three Lobatto nodes are exact in the rationals, and undo themselves") {
    state<Q, Q> const start{Q(0), Q(1), Q(1, 2)};
    auto const simpson = embed(testing::oscillator, galerkin<3, lobatto>);
    auto const there = simpson.step(start, Q(1, 5));
    CHECK_FALSE(there.q == start.q);
    CHECK(adjoint(simpson).step(there, Q(-1, 5)) == start);
}

} // namespace galerkin_ways_tests
