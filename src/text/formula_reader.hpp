// SPDX-License-Identifier: BSL-1.0
// What is read of a formula without a number type: what its names mean, whole numbers, and what is wrong.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "hilger/error.hpp"
#include "hilger/text/vocabulary.hpp"

namespace hilger::text::detail {

/// What the indices of the sums around a place are there.
using indices = std::map<std::string, long long>;
/// A whole number that does not depend on the state, where n is one: digits, indices, parameters and what is made of them.
std::optional<long long> whole_constant(node const& n, vocabulary const& words, indices const& known);

/// @throws error::unreadable with the place of what is wrong
class formula_reader {
protected:
    formula_reader(vocabulary const& words, std::string const& source) : words_(words), source_(source) {}
    /// Of a vector.
    [[nodiscard]] meaning const& meaning_of(node const& n) const;
    void require_component(node const& n, meaning const& m, long long k) const;
    [[nodiscard]] long long whole(node const& n) const;
    /// Whether a condition compares whole numbers that the state has no part in, as i == 0 in a sum.
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
