// SPDX-License-Identifier: BSL-1.0
// Definitions and remarks of L. Bourdin, J. Cresson, I. Greff, P. Inizan, "Variational integrator for fractional Euler-Lagrange equations"
// (2013), in exact rationals.
#include <doctest/doctest.h>

#include "hilger/calculus.hpp"
#include "oscillator.hpp"
#include "support/two_sided.hpp"

namespace bourdin_definitions_tests {

using namespace hilger;
using namespace hilger::papers;

TEST_CASE("(9), (10): for alpha = 1 the differences are the backward one and minus the forward one") {
    auto const T = uniform(Q(-1), Q(2, 7), 6);
    auto const f = function_on(T, [](Q t) { return Q((2 - t) / (5 + t)); });
    auto const left = Delta_minus(Q(1))[f];
    auto const right = Delta_plus(Q(1))[f];
    for (hilger::index_type k = 1; k <= 6; ++k) CHECK(left[k] == (f[k] - f[k - 1]) / T.h());
    for (hilger::index_type k = 1; k < 6; ++k) CHECK(right[k] == (f[k] - f[k + 1]) / T.h());
}

TEST_CASE("remark 1: (11), the fractional derivatives replaced one by one, is the Euler-Lagrange equation of (12)") {
    auto const T = uniform(Q(0), Q(1), 6);
    auto const lagrangian = [](auto const& x, auto const& v) { return v * v * (1 + x) / 2 - x * x * x; };
    auto const x = function_on(T, [](Q t) { return Q((1 + t * t) / (2 + t)); });
    Q const alpha(2, 3);
    auto const a = first_weights<grunwald_letnikov>(alpha, 7);
    std::vector<Q> v(7, Q(0)), p(7, Q(0));
    for (std::size_t k = 1; k <= 6; ++k) {
        for (std::size_t r = 0; r <= k; ++r) v[k] += a[r] * x[static_cast<hilger::index_type>(k - r)];
        p[k] = v[k] * (1 + x[static_cast<hilger::index_type>(k)]); // dL/dv
    }
    auto const residual = testing::two_sided(lagrangian, alpha, T).residual(x);
    for (std::size_t k = 1; k < 6; ++k) {
        Q const at = x[static_cast<hilger::index_type>(k)];
        Q direct = v[k] * v[k] / 2 - 3 * at * at; // dL/dx
        for (std::size_t r = 0; k + r <= 6; ++r) direct += a[r] * p[k + r];
        CHECK(residual[static_cast<hilger::index_type>(k)] == direct);
    }
}

TEST_CASE("definitions 1 and 3, (25), (32): rotations are a group, and (31) is what it was along solutions that they move") {
    auto const turned = [](Q const& c, Q const& s, rational_plane const& x) {
        return rational_plane(c * x(0) - s * x(1), s * x(0) + c * x(1));
    };
    Q const c(3, 5), s(4, 5), d(5, 13), e(-12, 13); // cosines and sines
    rational_plane const some(Q(2, 3), Q(-7));
    CHECK(turned(Q(1), Q(0), some) == some);
    CHECK(turned(c, s, turned(d, e, some)) == turned(Q(c * d - s * e), Q(s * d + c * e), some));
    Q const alpha(3, 4);
    auto const solution = rational_solution(alpha);
    auto const moved = function_on(solution.scale(), [&](Q const& t) { return turned(c, s, solution(t)); });
    auto const v = Delta_minus(alpha)[solution];
    auto const w = Delta_minus(alpha)[moved];
    for (hilger::index_type k = 1; k <= 8; ++k) {
        CHECK(harmonic_oscillator(moved[k], w[k]) == harmonic_oscillator(solution[k], v[k]));
        CHECK(moved[k] != solution[k]);
    }
    auto const r = oscillator_equation(alpha).residual(moved); // and the moved one is a solution too
    for (hilger::index_type k = 1; k < 8; ++k) CHECK(r[k] == rational_plane(Q(0), Q(0)));
}

TEST_CASE("section 4.3: the equation of (31) is Q + Delta_+^alpha Delta_-^alpha Q = 0, and -Delta_+ Delta_- Q = Q for alpha = 1") {
    for (Q const& alpha : {Q(1), Q(3, 4)}) {
        auto const x = rational_solution(alpha);
        auto const second = Delta_plus(alpha)[Delta_minus(alpha)[x]];
        for (hilger::index_type k = 1; k < 8; ++k) {
            CHECK(x[k] + second[k] == rational_plane(Q(0), Q(0)));
            if (alpha == 1) CHECK((x[k + 1] - 2 * x[k] + x[k - 1]) == x[k]); // h = 1
        }
    }
}

} // namespace bourdin_definitions_tests
