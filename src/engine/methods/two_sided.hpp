// SPDX-License-Identifier: BSL-1.0
// The two-sided fractional equation dL/dq + Delta_plus^alpha[dL/dv] = 0, with v = Delta_minus^alpha[q] (Bourdin et al. (EL_h^alpha)).
#pragma once

#include "engine/engine.hpp"
#include "hilger/hilger.hpp"

namespace engine {

inline bool is_two_sided(std::string const& method) { return method.starts_with("two-sided:"); }
/// @throws hilger::error::invalid_parameter
inline double order_of_two_sides(std::string const& method) {
    if (auto const alpha = hilger::text::number_in<double>(method.substr(10))) {
        hilger::detail::require_two_sided_order(*alpha);
        return *alpha;
    }
    hilger::error::raise<hilger::error::invalid_parameter>("an order is a number, as in two-sided:0.75, and not '", method, "'");
}
inline auto two_sided_equation(hilger::text::stated_lagrangian const& L, double alpha, hilger::uniform_scale<double> const& T) {
    constexpr hilger::unknown q;
    return variation(nabla_integral(hilger::lagrangian{L}(q, hilger::Delta_minus(alpha)[q]), T));
}

} // namespace engine
