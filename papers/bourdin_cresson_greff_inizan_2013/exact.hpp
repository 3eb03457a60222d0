// SPDX-License-Identifier: BSL-1.0
// What the tests of this paper share: its tables, the exact solution of its Dirichlet example, and the errors (21).
#pragma once

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "hilger/integrator/boundary.hpp"

namespace hilger::testing {

/// The rows of a table in this folder as texts, comments and the heading left out.
inline std::vector<std::vector<std::string>> table(std::string const& name) {
    std::string here = __FILE__;
    std::ifstream file(here.substr(0, here.rfind('/') + 1) + name);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.empty() or line[0] < '0' or line[0] > '9') continue;
        std::vector<std::string> row;
        std::istringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        rows.push_back(row);
    }
    return rows;
}

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

struct errors {
    double largest, mean_square;
};
/// (21) for N steps.
inline errors dirichlet_errors(double alpha, index N) {
    auto const T = uniform(interval{0.0, 1.0}, N);
    auto const solution = solve_boundary(fractional_problem(dirichlet, alpha), T, 0, 1);
    errors e{0, 0};
    for (index k = 0; k <= N; ++k) {
        double const difference = std::abs(solution.q[k] - dirichlet_solution(alpha, T.point(k)));
        e.largest = std::max(e.largest, difference);
        e.mean_square += T.h() * difference * difference;
    }
    e.mean_square = std::sqrt(e.mean_square);
    return e;
}

} // namespace hilger::testing
