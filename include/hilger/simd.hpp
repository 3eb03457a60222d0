// SPDX-License-Identifier: BSL-1.0
// Packs of processor floats, so that the loops of a history use all lanes whatever the compiler's options, and the choice between the
// instruction sets of x86-64 at run time. Other scalars, compilers and processors run the same loops one number at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <memory>
#include <new>
#include <string_view>
#include <type_traits>
#include <vector>

#include "hilger/error.hpp"

#if defined(__GNUC__) && defined(__x86_64__)
#define HILGER_DETAIL_X86 1
#define HILGER_DETAIL_AVX2 __attribute__((target("avx2,fma")))
#endif
#if defined(__GNUC__)
#define HILGER_DETAIL_INLINE inline __attribute__((always_inline))
#else
#define HILGER_DETAIL_INLINE inline
#endif

namespace hilger::detail::memory {

/// The number of S in a pack of so many bytes: one, unless S is a processor float.
template <class S, int Bytes>
struct pack {
    using type = S;
    static constexpr std::size_t width = 1;
};
#if defined(__GNUC__)
template <class S, int Bytes>
    requires(std::is_same_v<S, double> or std::is_same_v<S, float>)
struct pack<S, Bytes> {
    typedef S type __attribute__((vector_size(Bytes)));
    static constexpr std::size_t width = Bytes / sizeof(S);
};
#endif

/// Arrays are padded to a multiple of this, so that no loop has a remainder.
template <class S>
inline constexpr std::size_t padding = 2 * pack<S, 32>::width;
template <class S>
constexpr std::size_t padded(std::size_t n) {
    return (n + padding<S> - 1) / padding<S> * padding<S>;
}

/// Arrays aligned to a cache line.
template <class S>
struct line_allocator {
    using value_type = S;
    line_allocator() = default;
    template <class T>
    line_allocator(line_allocator<T> const&) {}
    S* allocate(std::size_t n) { return static_cast<S*>(::operator new(n * sizeof(S), alignment)); }
    void deallocate(S* p, std::size_t) { ::operator delete(p, alignment); }
    friend bool operator==(line_allocator, line_allocator) { return true; }
    static constexpr std::align_val_t alignment{alignof(S) > 64 ? alignof(S) : 64};
};
template <class S>
using line_vector = std::vector<S, line_allocator<S>>;

/// The addresses need not be aligned.
template <class P, class S>
HILGER_DETAIL_INLINE void load(P& p, S const* from) {
    if constexpr (sizeof(P) == sizeof(S))
        p = *from;
    else
        std::memcpy(&p, from, sizeof(P));
}
template <class P, class S>
HILGER_DETAIL_INLINE void store(P const& p, S* to) {
    if constexpr (sizeof(P) == sizeof(S))
        *to = p;
    else
        std::memcpy(to, &p, sizeof(P));
}
template <class S, class P>
HILGER_DETAIL_INLINE S sum_of_lanes(P const& p) {
    if constexpr (sizeof(P) == sizeof(S))
        return p;
    else {
        constexpr std::size_t width = sizeof(P) / sizeof(S);
        S sum = p[0] + p[width / 2]; // by subscripts, so that the lanes stay in registers
        for (std::size_t i = 1; i < width / 2; ++i) sum += p[i] + p[i + width / 2];
        return sum;
    }
}

/// Sets of instructions: the baseline of every x86-64; AVX2 and fused products; AVX-512 (F and DQ) beside these.
enum class instructions { baseline, avx2, avx512 };

/// The instruction set of this processor, determined once: for the loops of histories and transforms here (without AVX-512, whose loops are
/// faster alone and slow down the scheme around them), formulas in machine code, and lanes. HILGER_INSTRUCTIONS=baseline or avx2 in the
/// environment limits it.
/// @throws error::invalid_parameter where the variable has none of the names above
inline instructions available_instructions() {
    static instructions const found = [] {
        auto most = instructions::baseline;
#ifdef HILGER_DETAIL_X86
        __builtin_cpu_init();
        if (__builtin_cpu_supports("avx2") and __builtin_cpu_supports("fma"))
            most = __builtin_cpu_supports("avx512f") and __builtin_cpu_supports("avx512dq") ? instructions::avx512 : instructions::avx2;
#endif
        constexpr std::string_view names[] = {"baseline", "avx2", "avx512"};
        char const* const said = std::getenv("HILGER_INSTRUCTIONS");
        if (said == nullptr or *said == '\0') return most;
        auto const named = std::find(std::begin(names), std::end(names), said);
        if (named == std::end(names))
            error::raise<error::invalid_parameter>("HILGER_INSTRUCTIONS is baseline, avx2 or avx512, and was '", said, "'");
        return std::min(most, static_cast<instructions>(named - std::begin(names)));
    }();
    return found;
}

/// Loop::in<S, Bytes>(x...), a loop in packs of so many bytes, compiled for the baseline and for AVX2.
template <class Loop, class S, class Signature>
struct loop_for;
template <class Loop, class S, class R, class... X>
struct loop_for<Loop, S, R(X...)> {
    using function = R (*)(X...);
    static R baseline(X... x) { return Loop::template in<S, 16>(x...); }
#ifdef HILGER_DETAIL_X86
    HILGER_DETAIL_AVX2 static R avx2(X... x) { return Loop::template in<S, 32>(x...); }
#endif
    /// The one for this processor.
    static function chosen() {
#ifdef HILGER_DETAIL_X86
        if constexpr (pack<S, 32>::width > 1)
            if (available_instructions() >= instructions::avx2) return avx2;
#endif
        return baseline;
    }
};

} // namespace hilger::detail::memory
