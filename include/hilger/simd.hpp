// SPDX-License-Identifier: BSL-1.0
// Packs of processor floats, so that the loops of a history run in all lanes whatever the compiler's options are, and the choice between
// the instruction sets of x86-64 at run time. Every other scalar, compiler or processor takes the same loops one number at a time.
#pragma once

#include <cstddef>
#include <cstring>
#include <memory>
#include <new>
#include <vector>

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

/// So many numbers of type S at once: one, unless S is a processor float.
template <class S, int Bytes>
struct pack {
    using type = S;
    static constexpr std::size_t width = 1;
};
#if defined(__GNUC__)
template <>
struct pack<double, 16> {
    typedef double type __attribute__((vector_size(16)));
    static constexpr std::size_t width = 2;
};
template <>
struct pack<float, 16> {
    typedef float type __attribute__((vector_size(16)));
    static constexpr std::size_t width = 4;
};
template <>
struct pack<double, 32> {
    typedef double type __attribute__((vector_size(32)));
    static constexpr std::size_t width = 4;
};
template <>
struct pack<float, 32> {
    typedef float type __attribute__((vector_size(32)));
    static constexpr std::size_t width = 8;
};
#endif

/// The arrays that loops run over are padded to a multiple of this, so that no loop has a remainder.
template <class S>
inline constexpr std::size_t padding = 2 * pack<S, 32>::width;
template <class S>
constexpr std::size_t padded(std::size_t n) {
    return (n + padding<S> - 1) / padding<S> * padding<S>;
}

/// Arrays that begin on a line of the cache.
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
        S sum = p[0] + p[width / 2]; // by subscripts, so that the lanes do not pass through the memory
        for (std::size_t i = 1; i < width / 2; ++i) sum += p[i] + p[i + width / 2];
        return sum;
    }
}

/// AVX-512 is left out: its loops are faster alone, and the scheme around them slower.
enum class instructions { baseline, avx2 };

/// What this processor has, asked once.
inline instructions available_instructions() {
#ifdef HILGER_DETAIL_X86
    static instructions const found = [] {
        __builtin_cpu_init();
        return __builtin_cpu_supports("avx2") and __builtin_cpu_supports("fma") ? instructions::avx2 : instructions::baseline;
    }();
    return found;
#else
    return instructions::baseline;
#endif
}

} // namespace hilger::detail::memory
