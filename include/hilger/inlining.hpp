// SPDX-License-Identifier: BSL-1.0
// A step at hand-written speed is one function, and so are the derivatives in it: inlining is forced where compilers do not choose it. In
// debug builds (-O0, or HILGER_DEBUG) it is not, which halves the compile time.
#pragma once

#if defined(__GNUC__) && !defined(__NO_INLINE__) && !defined(HILGER_DEBUG)
#define HILGER_ALWAYS_INLINE __attribute__((always_inline))
#define HILGER_FLATTEN __attribute__((flatten))
#else
#define HILGER_ALWAYS_INLINE
#define HILGER_FLATTEN
#endif

namespace hilger::detail {
/// Whether __builtin_constant_p may be true: without optimization it never is.
#ifdef __NO_INLINE__
inline constexpr bool numbers_are_known = false;
#else
inline constexpr bool numbers_are_known = true;
#endif
} // namespace hilger::detail
