// SPDX-License-Identifier: BSL-1.0
// Theorems 4 and 5 of L. Bourdin, J. Cresson, I. Greff, P. Inizan, "Variational integrator for fractional Euler-Lagrange equations"
// (2013), section 4: what holds along solutions of Lagrangians with a symmetry, and of those without it does not.
#include <doctest/doctest.h>

#include "hilger/boundary/solve.hpp"
#include "hilger/multiprecision.hpp"
#include "noether.hpp"
#include "support/two_sided.hpp"

namespace bourdin_noether_tests {

using namespace hilger;
using papers::fractional_noether_residual;
using papers::noether_constant;
using testing::two_sided;

namespace {

template <class S>
using plane = Eigen::Matrix<S, 2, 1>;

/// One type for all the Lagrangians of this file keeps its compile time down: coefficients in quarters.
struct plane_lagrangian {
    int harmonic = 0, mass = 0, gyroscopic = 0, quartic = 0, difference = 0, first = 0, hyperbolic = 0;

    auto operator()(auto const& x, auto const& v) const {
        auto const square = x.dot(x), product = x(0) * x(1);
        return (v.dot(v) * ((hyperbolic == 0 ? 4 : 0) + mass * square) / 2 + gyroscopic * (x(0) * v(1) - x(1) * v(0)) +
                harmonic * square / 2 + quartic * square * square + difference * (x(0) - x(1)) * (x(0) - x(1)) / 2 + first * x(0) * x(0) +
                hyperbolic * (v(0) * v(1) * (2 + product) + product / 3 + x(0) * v(1) / 5)) /
               4;
    }
};
/// (31)
constexpr plane_lagrangian oscillator{.harmonic = 4};
/// Invariant under rotations, not quadratic, with a gyroscopic term and a mass that depends on |x|.
constexpr plane_lagrangian central{.mass = 2, .gyroscopic = 1, .quartic = 1};
/// Invariant under (x_0, x_1) -> (e^s x_0, e^-s x_1); d^2 L / dv dv is indefinite.
constexpr plane_lagrangian hyperbolic{.hyperbolic = 4};
/// Invariant under rotations but for one term; depends on x_0 - x_1 only.
constexpr plane_lagrangian flattened{.harmonic = 4, .first = 1}, pair{.difference = 4};

constexpr auto rotation = [](auto const& x) { return plane<scalar_of<std::remove_cvref_t<decltype(x)>>>(-x(1), x(0)); };
constexpr auto squeeze = [](auto const& x) { return plane<scalar_of<std::remove_cvref_t<decltype(x)>>>(x(0), -x(1)); };
constexpr auto translation = [](auto const& x) {
    return plane<scalar_of<std::remove_cvref_t<decltype(x)>>>(x(0) - x(0) + 1, x(1) - x(1) + 1);
};

template <class F>
auto largest(F const& f) {
    auto result = magnitude(f[f.first()]);
    for (auto const& value : f) result = std::max(result, decltype(result)(magnitude(value)));
    return result;
}
/// What rounding makes of (26). Each of its values is a sum of products xi.Delta_+^alpha p and (Delta_-^alpha xi).p; the differences have
/// condition h^-alpha sum |alpha_r| <= 2 h^-alpha, p comes from such a difference of Q, the transforms add log N: epsilon times
/// 2 h^-alpha |xi| (2 h^-alpha |dp/dv| |Q|), 16 log N of them.
template <class S, class X>
S rounding(S const& alpha, X const& x) {
    using std::pow;
    S const steep = S(2) * pow(x.root().h(), S(-alpha));
    return S(16) * S(static_cast<int>(std::bit_width(static_cast<std::size_t>(x.size())))) * epsilon<S>() * steep * steep * largest(x) *
           std::max(S(1), S(largest(x)));
}

template <class S, class L, class Generator>
void is_conserved(L const& lagrangian, Generator const& xi, S const& alpha) {
    plane<S> const from(S(1), S(1) / 2), to(S(-1) / 3, S(1));
    auto const T = uniform(interval{S(0), S(1)}, std::same_as<S, double> ? 120 : 60);
    auto const EL = two_sided(lagrangian, alpha, T);
    auto const solution = solve(EL, T, boundary_values{from, to});
    S const bound = rounding(alpha, solution);
    CHECK(largest(fractional_noether_residual(EL, xi, solution)) <= bound);
    // The two terms themselves are larger, were one missing it would be seen; but not where dL/dx alone is invariant.
    if (lagrangian.harmonic != 0) return;
    auto const p = EL.action().at_nodes(
        solution, [&](S const&, plane<S> const& q, plane<S> const& v) { return plane<S>(gradient_second(lagrangian, q, v)); });
    auto const change = Delta_plus(alpha)[p];
    S single(0);
    for (hilger::index_type k = 1; k < T.steps(); ++k) single = std::max(single, S(magnitude(S(xi(solution[k]).dot(change[k])))));
    CHECK(single > S(1000) * bound);
}

} // namespace

TEST_CASE_TEMPLATE("theorem 4, (26): along solutions of symmetric Lagrangians, for any alpha", S, double, float50) {
    for (S const& alpha : {S(1), S(3) / 4, S(3) / 10}) {
        is_conserved<S>(oscillator, rotation, alpha);
        is_conserved<S>(central, rotation, alpha);
        is_conserved<S>(hyperbolic, squeeze, alpha);
    }
}

TEST_CASE("theorem 4 is about symmetries: what is none is seen, at every point") {
    plane<double> const from(1.0, 0.5), to(-0.3, 1.0);
    auto const T = uniform(interval{0.0, 1.0}, 120);
    auto const differs = [&](auto const& lagrangian, auto const& xi, double alpha) {
        auto const EL = two_sided(lagrangian, alpha, T);
        auto const x = solve(EL, T, boundary_values{from, to});
        double const bound = rounding(alpha, x);
        for (double const r : fractional_noether_residual(EL, xi, x)) CHECK(std::abs(r) > 1e3 * bound);
    };
    differs(oscillator, squeeze, 0.75);
    differs(flattened, rotation, 0.75);
    // A translation of an L that depends on x_0 - x_1 and v: a symmetry for alpha = 1 only. The fractional difference of a constant is
    // h^-alpha (1 + alpha_1 + ... + alpha_k).
    differs(pair, translation, 0.75);
}

TEST_CASE("theorem 5, (29), (34): for alpha = 1 the constant is xi(Q_k).p_{k+1}") {
    auto const T = uniform(interval{0.0, 1.0}, 100);
    plane<double> const from(1.0, 0.5), to(-0.3, 1.0);
    auto const spread = [&](auto const& lagrangian, auto const& xi) {
        auto const EL = two_sided(lagrangian, fraction<1>{}, T);
        auto const constant = noether_constant(EL, xi, solve(EL, T, boundary_values{from, to}));
        auto const [least, most] = std::minmax_element(constant.begin(), constant.end());
        return std::pair(*most - *least, std::abs(constant[0]));
    };
    // N steps of (26), each with h times its rounding.
    auto const rotated = spread(oscillator, rotation), turned = spread(central, rotation);
    auto const moved = spread([](auto const& x, auto const& v) { return v.dot(v) / 2 + (x(0) - x(1)) * (x(0) - x(1)) / 2; },
                              translation); // total momentum
    for (auto const& [difference, value] : std::vector{rotated, turned, moved}) {
        CHECK(difference <= 64 * 100 * epsilon<double>() * std::max(1.0, value));
        CHECK(value > 0.1);
    }
    CHECK(spread(oscillator, translation).first > 0.1);
    CHECK_THROWS_AS(
        (void)noether_constant(two_sided(oscillator, 0.75, T), rotation, function_on(T, [](double) { return plane<double>(1, 1); })),
        error::invalid_parameter);
}

} // namespace bourdin_noether_tests
