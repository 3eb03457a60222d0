// SPDX-License-Identifier: BSL-1.0
// The passes of transform.hpp in the widest packs that fit a block and this processor.
#pragma once

#include "hilger/fourier/pass.hpp"

namespace hilger::detail::memory {

template <class S, int Bytes>
HILGER_DETAIL_INLINE void split_widest(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    if constexpr (Bytes >= 16 and pack<S, Bytes>::width > 1) {
        if (n / 4 >= pack<S, Bytes>::width)
            split_in<S, typename pack<S, Bytes>::type>(re, im, n, count, b, cosine, sine);
        else
            split_widest<S, Bytes / 2>(re, im, n, count, b, cosine, sine);
    } else
        split_in<S, S>(re, im, n, count, b, cosine, sine);
}
template <class S, int Bytes>
HILGER_DETAIL_INLINE void join_widest(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    if constexpr (Bytes >= 16 and pack<S, Bytes>::width > 1) {
        if (n / 4 >= pack<S, Bytes>::width)
            join_in<S, typename pack<S, Bytes>::type>(re, im, n, count, b, cosine, sine);
        else
            join_widest<S, Bytes / 2>(re, im, n, count, b, cosine, sine);
    } else
        join_in<S, S>(re, im, n, count, b, cosine, sine);
}

template <class S>
using fourier_pass = void (*)(S*, S*, std::size_t, std::size_t, std::size_t, S const*, S const*);

template <class S>
void split_baseline(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    split_widest<S, 16>(re, im, n, count, b, cosine, sine);
}
template <class S>
void join_baseline(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    join_widest<S, 16>(re, im, n, count, b, cosine, sine);
}
#ifdef HILGER_DETAIL_X86
template <class S>
HILGER_DETAIL_AVX2 void split_avx2(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    split_widest<S, 32>(re, im, n, count, b, cosine, sine);
}
template <class S>
HILGER_DETAIL_AVX2 void join_avx2(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    join_widest<S, 32>(re, im, n, count, b, cosine, sine);
}
#endif

/// The passes for this processor.
template <class S>
struct fourier_passes {
    fourier_pass<S> split = split_baseline<S>, join = join_baseline<S>;

    fourier_passes() {
#ifdef HILGER_DETAIL_X86
        if constexpr (std::is_same_v<S, double> or std::is_same_v<S, float>) {
            if (available_instructions() >= instructions::avx2) split = split_avx2<S>, join = join_avx2<S>;
        }
#endif
    }
};

} // namespace hilger::detail::memory
