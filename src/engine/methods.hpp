// SPDX-License-Identifier: BSL-1.0
// The list of methods: files, the command line and Python use the same names.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace engine {

/// The problems that a method is for.
enum class method_kind {
    embedding,   ///< without a memory; also between two ends
    composition, ///< without a memory
    memory,      ///< with fractional damping
    structure,   ///< linear structures with a memory
    two_ends     ///< an equation between two ends
};
enum class scalar_kind { machine, digits, rationals };

struct method_entry {
    std::string name; ///< with an example of its number, as theta:0.3
    int order;
    method_kind kind;
    std::vector<scalar_kind> scalars;
    std::string what; ///< a description in one sentence
    [[nodiscard]] bool is_in(scalar_kind kind_of_numbers) const;
    /// Whether this is the method of that name, possibly with another number.
    [[nodiscard]] bool is_called(std::string const& method) const;
};
std::vector<method_entry> const& all_methods();
/// Prints a line for each method.
void list_methods(std::ostream& out);

template <class S>
inline constexpr scalar_kind kind_of_scalar = std::numeric_limits<S>::is_exact ? scalar_kind::rationals
                                              : std::is_floating_point_v<S>    ? scalar_kind::machine
                                                                               : scalar_kind::digits;
/// The names of the methods for a problem, between two ends or from initial values.
std::vector<std::string> method_names(problem const& what, scalar_kind numbers, bool between_ends);
/// @throws hilger::error::invalid_parameter with the names available in these numbers; `scalar` names the numbers
[[noreturn]] void refuse_method(std::string const& method, scalar_kind numbers, std::string const& scalar);

} // namespace engine
