// SPDX-License-Identifier: BSL-1.0
// A linear, a nonlinear and a non-separable problem (the mass depends on the position) on which orders are fitted. One type for the three
// of them keeps the number of instantiations down.
#pragma once

#include "hilger/variational/lagrangian.hpp"

namespace hilger::testing {

enum class problem_kind { linear, nonlinear, non_separable };
inline constexpr problem_kind three_problems[] = {problem_kind::linear, problem_kind::nonlinear, problem_kind::non_separable};

inline auto problem_of(problem_kind kind) {
    return lagrangian{[kind](auto const& x, auto const& v) {
        if (kind == problem_kind::linear) return v * v / 2 - x * x / 2;
        if (kind == problem_kind::nonlinear) return v * v / 2 + cos(x);
        return v * v * (1 + x * x) / 2 - x * x / 2;
    }};
}

} // namespace hilger::testing
