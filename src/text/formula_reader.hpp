// SPDX-License-Identifier: BSL-1.0
// Properties of a formula in every number type: the meanings of its names, whole numbers, errors.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "hilger/error.hpp"
#include "hilger/text/vocabulary.hpp"

namespace hilger::text::detail {

/// The values of the indices of the enclosing sums.
using indices = std::map<std::string, long long>;
/// The value of n when it is a whole number independent of the state: digits, indices, parameters and arithmetic of these.
std::optional<long long> whole_constant(node const& n, vocabulary const& words, indices const& known);

/// @throws error::unreadable with the place of the error
class formula_reader {
protected:
    formula_reader(vocabulary const& words, std::string const& source) : words_(words), source_(source) {}
    /// The meaning of a vector's name.
    [[nodiscard]] meaning const& meaning_of(node const& n) const;
    void require_component(node const& n, meaning const& m, long long k) const;
    [[nodiscard]] long long whole(node const& n) const;
    /// Whether a condition compares whole numbers independent of the state, as i == 0 in a sum.
    [[nodiscard]] bool is_of_indices(node const& n) const;
    void require_arguments(node const& n, std::size_t count) const;
    [[noreturn]] void refuse_function(node const& n) const;
    [[noreturn]] void refuse_name(node const& n) const;
    [[noreturn]] void refuse(node const& n, std::string const& why) const;

    vocabulary const& words_;
    std::string const& source_;
    indices indices_;
};

} // namespace hilger::text::detail
