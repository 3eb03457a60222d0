// SPDX-License-Identifier: BSL-1.0
// Whole numbers in formulas: indices of components, limits of sums, exponents. They do not depend on the state.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "hilger/text/vocabulary.hpp"

namespace hilger::text::detail {

/// What the indices of the sums around a place are there.
using indices = std::map<std::string, long long>;

/// A whole number that does not depend on the state, where n is one: digits, indices, parameters and what is made of them.
std::optional<long long> whole_constant(node const& n, vocabulary const& words, indices const& known);

} // namespace hilger::text::detail
