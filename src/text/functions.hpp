// SPDX-License-Identifier: BSL-1.0
// The functions that formulas in text may call, in any number type.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <string>
#include <string_view>
#include <utility>

#include "hilger/differentiation/branches.hpp"
#include "hilger/differentiation/traced/functions.hpp"
#include "hilger/text/vocabulary.hpp"

namespace hilger::text {

/// The number type for the constants of T.
template <class T>
T number_of(T const&);
template <class S>
S number_of(traced<S> const&);

/// The names of all functions, for error messages.
inline std::string names_of_functions() {
    std::string list;
    for (auto const name : functions_of_one) list += std::string(name) + ", ";
    return list + "atan2, hypot, pow, min, max, dot, norm, sum and if";
}

/// The outcome of a comparison. Traced numbers record it themselves; for plain numbers it is recorded here, as for jets without variables:
/// the step checks which branches were taken (differentiation/branches.hpp).
template <class T>
bool compared(bool outcome) {
    return is_traced<T> ? outcome : hilger::detail::compared(outcome, false);
}

template <class T>
T elementary(std::string_view name, T const& x) {
#define HILGER_CALL(function)                                                                                                              \
    if (name == #function) return hilger::detail::function##_function::value(x);
    HILGER_FOR_EACH_FUNCTION(HILGER_CALL)
#undef HILGER_CALL
    using std::sqrt;
    return T(sqrt(x));
}
template <class T>
T elementary(std::string_view name, T const& x, T const& y) {
    using std::atan2, std::hypot;
    return name == "atan2" ? T(atan2(x, y)) : T(hypot(x, y));
}
/// The power for a whole n: a scalar need not have a power function.
template <class T>
T whole_power(T const& x, long long n) {
    T y(1), square = x;
    bool begun = false;
    for (auto k = static_cast<unsigned long long>(n < 0 ? -n : n); k > 0; k /= 2) {
        if (k % 2 == 1) y = std::exchange(begun, true) ? T(y * square) : square;
        if (k > 1) square = T(square * square);
    }
    return n < 0 ? T(T(1) / y) : y;
}
template <class T>
T absolute(T const& x) {
    if constexpr (is_traced<T>)
        return abs(x);
    else
        return compared<T>(x < T(0)) ? T(-x) : x;
}
// Tracing records min, max and abs as operations (differentiation/traced/choices.hpp).
/// NaN when either operand is NaN: max(0, sqrt(q)) has no value where sqrt(q) has none.
template <class T>
T least_of(T const& x, T const& y) {
    if constexpr (is_traced<T>)
        if (T::is_written_out()) return min(x, y);
    return compared<T>(x <= y) ? x : compared<T>(y < x) ? y : T(x + y);
}
template <class T>
T most_of(T const& x, T const& y) {
    if constexpr (is_traced<T>)
        if (T::is_written_out()) return max(x, y);
    return compared<T>(y <= x) ? x : compared<T>(x < y) ? y : T(x + y);
}

} // namespace hilger::text
