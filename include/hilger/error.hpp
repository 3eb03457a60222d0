// SPDX-License-Identifier: BSL-1.0
// The exceptions of hilger, one type for each remedy that a caller has; what() is one sentence that names the fault and what is accepted.
#pragma once

#include <charconv>
#include <cstddef>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace hilger {
/// The shortest digits that are read back as x: 0.1, and not 0.10000000000000001.
template <class X>
std::string round_trip(X x) {
    static_assert(std::is_floating_point_v<X>);
    char digits[64];
    return {digits, std::to_chars(digits, digits + sizeof digits, x).ptr};
}
} // namespace hilger

namespace hilger::error {

/// The root of all of hilger's exceptions.
struct exception : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Points that do not make a time scale: h <= 0, no steps, unsorted, repeated or non-finite points.
struct invalid_scale : exception {
    using exception::exception;
};
/// A point or an index that is not in the domain it was used with; sigma of the last point, rho of the first.
struct outside_domain : exception {
    using exception::exception;
};
/// Two things that must fit and do not: functions on different scales, a table with the wrong number of values.
struct mismatch : exception {
    using exception::exception;
};
/// A parameter outside its range: lambda outside [0, 1[, a coefficient that is not regressive.
struct invalid_parameter : exception {
    using exception::exception;
};
/// NaN or infinity in data or in a state.
struct not_finite : exception {
    using exception::exception;
};
/// A file that cannot be opened, or a line of it that cannot be understood.
struct unreadable : exception {
    using exception::exception;
};
/// The second derivative that a Legendre map or a step must invert is singular.
struct singular : exception {
    using exception::exception;
};
/// Ends that determine the values between them to less than half of the digits, as half a period of an oscillator apart.
struct ill_conditioned : exception {
    using exception::exception;
};
/// A callable that is no single formula in its arguments: it compares them, has a constant that is not a finite double, or is too deep.
struct no_formula : exception {
    using exception::exception;
};
/// A Newton iteration that stopped before its residual reached the rounding floor.
struct no_convergence : exception {
    using exception::exception;
};
/// An equation with branches that has no solution on any of them: where a Lagrangian compares its arguments, its derivatives jump.
struct no_branch : no_convergence {
    using no_convergence::no_convergence;
};

namespace detail {
template <class Part>
void show(std::ostringstream& message, Part const& part) {
    if constexpr (std::is_floating_point_v<Part>)
        message << round_trip(part);
    else
        message << part;
}
} // namespace detail

/// Throws Error with the arguments streamed into its message.
template <class Error, class... Parts>
[[noreturn]] void raise(Parts const&... parts) {
    std::ostringstream message;
    message.precision(17);
    (detail::show(message, parts), ...);
    throw Error(message.str());
}

} // namespace hilger::error
