// SPDX-License-Identifier: BSL-1.0
// The elementary functions of one argument: value y = f(x), slope s = f'(x) and bend f''(x), in numbers and in traced numbers. Jets, traced
// numbers and formulas in text take them from this table.
#pragma once

#include <cmath>
#include <type_traits>

#include "hilger/inlining.hpp"

/// Calls use(name) for each function that jets and traced numbers take from this table; sqrt has a rule of its own.
#define HILGER_FOR_EACH_FUNCTION(use)                                                                                                      \
    use(sin) use(cos) use(tan) use(exp) use(log) use(sinh) use(cosh) use(tanh) use(asin) use(acos) use(atan) use(asinh) use(acosh)         \
        use(atanh) use(cbrt) use(expm1) use(log1p) use(erf)

namespace hilger::detail {

/// 1/x where log(x) is defined, else log(x) itself: only derivatives enter a step, and 1/x alone would continue it.
template <class S>
HILGER_ALWAYS_INLINE inline S slope_of_log(S const& x) {
    using std::log;
    return x < S(0) ? S(log(x)) : S(S(1) / x);
}
/// 2 / sqrt(pi), a constant also of numbers with derivatives.
template <class S>
S two_over_root_of_pi() {
    if constexpr (std::is_floating_point_v<S>)
        return S(1.1283791670955125738961589031215451717L);
    else if constexpr (requires { typename S::scalar_type; })
        return S(two_over_root_of_pi<typename S::scalar_type>());
    else {
        using std::atan, std::sqrt;
        static S const value = S(1) / S(sqrt(S(atan(S(1)))));
        return value;
    }
}
#define HILGER_FUNCTION(function, slope_at, bend_at)                                                                                       \
    struct function##_function {                                                                                                           \
        static constexpr char const* name = #function;                                                                                     \
        template <class T>                                                                                                                 \
        HILGER_ALWAYS_INLINE static T value(T const& x) {                                                                                  \
            using std::function;                                                                                                           \
            return T(function(x));                                                                                                         \
        }                                                                                                                                  \
        template <class T>                                                                                                                 \
        HILGER_ALWAYS_INLINE static T slope([[maybe_unused]] T const& x, [[maybe_unused]] T const& y) {                                    \
            using std::cos, std::cosh, std::exp, std::sin, std::sinh, std::sqrt;                                                           \
            return T(slope_at);                                                                                                            \
        }                                                                                                                                  \
        template <class T>                                                                                                                 \
        HILGER_ALWAYS_INLINE static T bend([[maybe_unused]] T const& x, [[maybe_unused]] T const& y, [[maybe_unused]] T const& s) {        \
            return T(bend_at);                                                                                                             \
        }                                                                                                                                  \
    };
HILGER_FUNCTION(sin, cos(x), -y)
HILGER_FUNCTION(cos, -sin(x), -y)
HILGER_FUNCTION(tan, T(1) + y * y, (y + y) * s)
HILGER_FUNCTION(exp, y, y)
HILGER_FUNCTION(log, slope_of_log(x), -s* s)
HILGER_FUNCTION(sinh, cosh(x), y)
HILGER_FUNCTION(cosh, sinh(x), y)
HILGER_FUNCTION(tanh, T(1) - y * y, -(y + y) * s)
HILGER_FUNCTION(asin, T(1) / T(sqrt(T(T(1) - x * x))), x* s* s* s)
HILGER_FUNCTION(acos, T(-1) / T(sqrt(T(T(1) - x * x))), x* s* s* s)
HILGER_FUNCTION(atan, T(1) / T(T(1) + x * x), -(x + x) * s * s)
HILGER_FUNCTION(asinh, T(1) / T(sqrt(T(x * x + T(1)))), -x* s* s* s)
// NaN if acosh is NaN
HILGER_FUNCTION(acosh, T(1) / T(T(sqrt(T(x - T(1)))) * T(sqrt(T(x + T(1))))), -x* s* s* s)
HILGER_FUNCTION(atanh, (slope_of_log(T(T(1) + x)) + slope_of_log(T(T(1) - x))) / T(2), (x + x) * s * s)
HILGER_FUNCTION(cbrt, T(1) / T(T(3) * T(y * y)), T(-2) * s * s / y)
HILGER_FUNCTION(expm1, exp(x), s)
HILGER_FUNCTION(log1p, slope_of_log(T(T(1) + x)), -s* s)
HILGER_FUNCTION(erf, two_over_root_of_pi<T>() * T(exp(T(-x * x))), -(x + x) * s)
#undef HILGER_FUNCTION

} // namespace hilger::detail
