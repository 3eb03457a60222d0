// SPDX-License-Identifier: BSL-1.0
// The meaning of the names in a formula: the time, coordinates and their velocities, parameters with their values. Numbers are kept as they
// were written, and become exact in rationals.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hilger/text/expression.hpp"

namespace hilger::text {

/// The number spelled by digits, 12, -0.5, 1e-3, 1/3; none if they spell none, or none that the scalar has. It is exact in exact scalars,
/// else the nearest, for quotients rounded once more.
template <class S>
std::optional<S> number_in(std::string_view digits);

/// Whether a formula is the number 0, as it was written.
bool is_zero(expression const& e);

/// The functions of one argument that formulas may call.
inline constexpr std::array<std::string_view, 20> functions_of_one{"sin",   "cos",  "tan",   "exp",   "log",  "sqrt",  "sinh",
                                                                   "cosh",  "tanh", "asin",  "acos",  "atan", "asinh", "acosh",
                                                                   "atanh", "cbrt", "expm1", "log1p", "erf",  "abs"};

/// A coordinate, or a vector of them under one name.
struct coordinate {
    std::string position, velocity;
    int size = 0; ///< 0 for one that is a number and takes no index
};

/// The meaning of a name.
struct meaning {
    enum class role { time, position, velocity, parameter } is = role::time;
    int first = 0; ///< of its components, in the state or in the numbers of all parameters
    int size = 0;  ///< 0 for a number
};

/// The names that formulas may use, with their meanings.
class vocabulary {
public:
    explicit vocabulary(std::vector<coordinate> const& coordinates, std::string const& time = "t");
    /// A parameter that is a number, and one that is a list of numbers. @throws error::invalid_parameter if the name is taken or none, a
    /// list is empty, or a value is no number
    void set(std::string const& name, std::string const& digits) { add_parameter(name, {digits}, 0); }
    void set(std::string const& name, std::vector<std::string> const& digits);

    /// Makes a parameter part of each state, behind the coordinates of its position, as components dimension() and on: for members of an
    /// ensemble that differ in it. @throws error::invalid_parameter if there is no such parameter
    void bring_with_states(std::string const& name);
    /// Number of components of these parameters.
    [[nodiscard]] int brought() const { return brought_; }
    /// The same words with these numbers as the values of those. @throws error::not_finite
    [[nodiscard]] vocabulary with(std::vector<double> const& numbers) const;

    [[nodiscard]] int dimension() const { return dimension_; }
    /// The meaning of a name; null if it is unknown.
    [[nodiscard]] meaning const* find(std::string const& name) const;
    [[nodiscard]] std::string const& digits(int k) const { return digits_[static_cast<std::size_t>(k)]; }
    /// All names, for errors.
    [[nodiscard]] std::string known() const;

private:
    void add(std::string const& name, meaning is);
    void add_parameter(std::string const& name, std::vector<std::string> const& digits, int size);
    int dimension_ = 0, brought_ = 0;
    std::map<std::string, meaning> meanings_;
    std::vector<std::string> digits_;
};

/// The vocabulary of formulas without names.
std::shared_ptr<vocabulary const> no_words();

} // namespace hilger::text
