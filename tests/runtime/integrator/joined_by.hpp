// SPDX-License-Identifier: BSL-1.0
// Mid-point solutions between two ends, with all that is said of them.
#pragma once

#include <vector>

#include "hilger/hilger.hpp"

namespace hilger::testing::two_ends {

inline constexpr unknown q;
inline constexpr lagrangian catenoid{[](auto const& x, auto const& v) { return x * sqrt(1 + v * v); }};

auto middle_of(auto const& L, auto const& T) { return variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T))); }

struct found {
    std::vector<double> x;
    ends_report<double> report;
    double relative;
    [[nodiscard]] double middle() const { return x[x.size() / 2]; }
};
found joined_by(auto const& L, auto const& T, double q0, double qN, auto const& guess) {
    auto const EL = middle_of(L, T);
    ends_report<double> report;
    auto const x = solve(EL, T, boundary_values{q0, qN}, no_force{}, guess, {}, &report);
    return {{x.begin(), x.end()}, report, relative_residual(EL, x)};
}
found joined_by(auto const& L, auto const& T, double q0, double qN) { return joined_by(L, T, q0, qN, detail::straight_line{}); }

} // namespace hilger::testing::two_ends
