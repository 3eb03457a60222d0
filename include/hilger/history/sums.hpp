// SPDX-License-Identifier: BSL-1.0
// The two loops a history spends its time in: a sum of products, and one step of all exponentials.
#pragma once

#include <type_traits>

#include "hilger/error_free.hpp"
#include "hilger/simd.hpp"

namespace hilger::detail::memory {

/// sum_i x_i y_i, n a multiple of padding<S> (or any n for one number at a time).
template <class S, int Bytes>
HILGER_DETAIL_INLINE S product_sum_in(S const* x, S const* y, std::size_t n) {
    using P = pack<S, Bytes>;
    typename P::type sum[2]{};
    sum[0] = sum[0] - sum[0];
    sum[1] = sum[0];
    std::size_t i = 0;
    for (; i + 2 * P::width <= n; i += 2 * P::width) {
        typename P::type a, b, c, d;
        load(a, x + i);
        load(b, y + i);
        load(c, x + i + P::width);
        load(d, y + i + P::width);
        sum[0] = sum[0] + a * b;
        sum[1] = sum[1] + c * d;
    }
    S total = sum_of_lanes<S>(typename P::type(sum[0] + sum[1]));
    for (; i < n; ++i) total = total + x[i] * y[i];
    return total;
}

/// state <- (1 - rate) state + x, so that rates far below epsilon count; sum <- sum + coefficient state. With `low` it takes what the sum
/// rounds away (Kahan): else a state that grows for 1/rate steps would stop where its increments are below its last digit.
template <bool Compensated, class P, class S>
HILGER_DETAIL_INLINE void relax_pack(S const* rate, S const* coefficient, S* state, [[maybe_unused]] S* low, P const& x, P& sum) {
    P r, s, c;
    load(r, rate);
    load(s, state);
    load(c, coefficient);
    P change = x - r * s;
    if constexpr (Compensated) {
        P l;
        load(l, low);
        change = change + l;
    }
    if constexpr (Compensated) {
        fast_two_sum(s, change, s, change);
        store(change, low);
    } else
        s = s + change;
    store(s, state);
    sum = sum + c * s;
}
/// One step of all n exponentials, those from the `brief`-th on with `low`, which begins with theirs; returns sum_j coefficient_j state_j.
template <class S, int Bytes>
HILGER_DETAIL_INLINE S relax_in(S const* rate, S const* coefficient, S* state, S* low, std::size_t brief, std::size_t n, S const& x) {
    using P = typename pack<S, Bytes>::type;
    constexpr std::size_t width = pack<S, Bytes>::width;
    P even{}, odd{}, in{};
    in = in + x;
    std::size_t j = 0;
    for (; j < brief; j += 2 * width) {
        relax_pack<false>(rate + j, coefficient + j, state + j, low, in, even);
        relax_pack<false>(rate + j + width, coefficient + j + width, state + j + width, low, in, odd);
    }
    for (; j < n; j += 2 * width, low += 2 * width) {
        relax_pack<true>(rate + j, coefficient + j, state + j, low, in, even);
        relax_pack<true>(rate + j + width, coefficient + j + width, state + j + width, low + width, in, odd);
    }
    return sum_of_lanes<S>(P(even + odd));
}

template <class S>
S product_sum_baseline(S const* x, S const* y, std::size_t n) {
    return product_sum_in<S, 16>(x, y, n);
}
template <class S>
S relax_baseline(S const* rate, S const* coefficient, S* state, S* low, std::size_t brief, std::size_t n, S const& x) {
    return relax_in<S, 16>(rate, coefficient, state, low, brief, n, x);
}
#ifdef HILGER_DETAIL_X86
template <class S>
HILGER_DETAIL_AVX2 S product_sum_avx2(S const* x, S const* y, std::size_t n) {
    return product_sum_in<S, 32>(x, y, n);
}
template <class S>
HILGER_DETAIL_AVX2 S relax_avx2(S const* rate, S const* coefficient, S* state, S* low, std::size_t brief, std::size_t n, S const& x) {
    return relax_in<S, 32>(rate, coefficient, state, low, brief, n, x);
}
#endif

/// The loops for this processor.
template <class S>
struct sums {
    S (*product_sum)(S const*, S const*, std::size_t) = product_sum_baseline<S>;
    S (*relax)(S const*, S const*, S*, S*, std::size_t, std::size_t, S const&) = relax_baseline<S>;

    sums() {
#ifdef HILGER_DETAIL_X86
        if constexpr (std::is_same_v<S, double> or std::is_same_v<S, float>) {
            if (available_instructions() >= instructions::avx2) {
                product_sum = product_sum_avx2<S>;
                relax = relax_avx2<S>;
            }
        }
#endif
    }
};

} // namespace hilger::detail::memory
