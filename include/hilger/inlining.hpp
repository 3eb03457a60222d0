// SPDX-License-Identifier: BSL-1.0
// A step at hand-written speed is one function, and so are the derivatives in it: compilers are told to make it so where their own
// judgement falls short. In programs that are built to be looked into (-O0, or HILGER_DEBUG) functions stay functions; they
// compile in half the time.
#pragma once

#if defined(__GNUC__) && !defined(__NO_INLINE__) && !defined(HILGER_DEBUG)
#define HILGER_ALWAYS_INLINE __attribute__((always_inline))
#define HILGER_FLATTEN __attribute__((flatten))
#else
#define HILGER_ALWAYS_INLINE
#define HILGER_FLATTEN
#endif

namespace hilger::detail {
/// Whether __builtin_constant_p says of any number that it is known: a compiler that does not optimise knows none.
#ifdef __NO_INLINE__
inline constexpr bool numbers_are_known = false;
#else
inline constexpr bool numbers_are_known = true;
#endif
} // namespace hilger::detail
