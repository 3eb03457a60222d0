// SPDX-License-Identifier: BSL-1.0
// Section 3.4 of L. Bourdin, J. Cresson, I. Greff, P. Inizan (2013): the exact solution of the Dirichlet example, the errors (21), and the
// slopes.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "../table.hpp"
#include "hilger/boundary/solve.hpp"

namespace hilger::papers {

/// 2F1(a, 1; c; z) = sum_n (a)_n / (c)_n z^n for 0 <= z <= 1/2 and positive terms.
template <class S>
S hypergeometric(S const& a, S const& c, S const& z) {
    S sum(1), term(1);
    for (int n = 0; epsilon<S>() * sum < term * S(8); ++n) {
        term = term * (a + S(n)) / (c + S(n)) * z;
        sum = sum + term;
    }
    return sum;
}

/// The solution of D_+^alpha D_-^alpha q = 0, q(0) = 0, q(1) = 1, (19) in closed form: (2 alpha - 1)/alpha t^alpha 2F1(1 - alpha, 1;
/// 1 + alpha; t); beyond 1/2 by the transformation z -> 1 - z, whose second function is a power.
template <class S>
S dirichlet_solution(S const& alpha, S const& t) {
    using std::pow, std::tgamma;
    if (t == S(0) or t == S(1) or alpha == S(1)) return t;
    S const one(1), a = one - alpha;
    if (S(2) * t <= one) return (S(2) * alpha - one) / alpha * pow(t, alpha) * hypergeometric(a, S(one + alpha), t);
    return pow(t, alpha) * hypergeometric(a, S(S(2) * a), S(one - t)) +
           (S(2) * alpha - one) * tgamma(alpha) * tgamma(S(one - S(2) * alpha)) / tgamma(a) * pow(S(one - t), S(S(2) * alpha - one));
}

inline constexpr auto dirichlet = [](auto const&, auto const& v) { return v * v / 2; };

/// Its (EL_h^alpha).
template <class S, class Root>
auto dirichlet_equation(S const& alpha, Root const& T) {
    constexpr unknown q;
    return variation(nabla_integral(lagrangian{dirichlet}(q, Delta_minus(alpha)[q]), T));
}

/// Of one size of step, in both norms.
struct errors {
    double largest, mean_square;
};
/// (21) for N steps.
inline errors dirichlet_errors(double alpha, index_type N) {
    auto const T = uniform(interval{0.0, 1.0}, N);
    auto const solution = solve(dirichlet_equation(alpha, T), T, {.q0 = 0, .qN = 1});
    errors e{0, 0};
    for (index_type k = 0; k <= N; ++k) {
        double const difference = std::abs(solution[k] - dirichlet_solution(alpha, T.point(k)));
        e.largest = std::max(e.largest, difference);
        e.mean_square += T.h() * difference * difference;
    }
    e.mean_square = std::sqrt(e.mean_square);
    return e;
}

/// log2 of what half of the step leaves of the errors.
struct slopes {
    double of_largest, of_mean_square;
    [[nodiscard]] double mean() const { return (of_largest + of_mean_square) / 2; }
};
inline slopes slopes_between(errors const& coarse, errors const& fine) {
    return {std::log2(coarse.largest / fine.largest), std::log2(coarse.mean_square / fine.mean_square)};
}
/// What the table of errors, of rows alpha, N, ell^infinity, ell^2, gives as it was printed, between N = 2000 and 4000.
inline slopes slopes_of_table(std::vector<row> const& rows, std::string const& alpha) {
    auto const at = [&](char const* N) {
        auto const found = std::find_if(rows.begin(), rows.end(), [&](row const& r) { return r[0] == alpha and r[1] == N; });
        if (found == rows.end()) error::raise<error::invalid_parameter>("the table of errors has no row alpha = ", alpha, ", N = ", N);
        return errors{number<double>((*found)[2]), number<double>((*found)[3])};
    };
    return slopes_between(at("2000"), at("4000"));
}
/// Two digits after the point, what follows left out.
inline double cut_off(double slope) { return std::floor(100 * slope) / 100; }

} // namespace hilger::papers
