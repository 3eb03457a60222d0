// SPDX-License-Identifier: BSL-1.0
// The two loops a history spends its time in: a sum of products, and one step of all exponentials.
#pragma once

#include <type_traits>

#include "hilger/history/simd.hpp"

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

/// State_j <- (1 - rate_j) state_j + x, so that rates far below epsilon count. With `low` it takes what each sum rounds away (Kahan): else
/// a state that grows for 1/rate steps would stop where its increments are below its last digit. Returns sum_j coefficient_j state_j.
template <class S, int Bytes, bool Compensated>
HILGER_DETAIL_INLINE S relax_in(S const* rate, S const* coefficient, S* state, [[maybe_unused]] S* low, std::size_t n, S const& x) {
    using P = pack<S, Bytes>;
    typename P::type sum[2]{}, in = sum[0];
    in = in + x;
    for (std::size_t i = 0; i < n; i += 2 * P::width)
        for (std::size_t k = 0; k < 2; ++k) {
            std::size_t const j = i + k * P::width;
            typename P::type r, s, c;
            load(r, rate + j);
            load(s, state + j);
            load(c, coefficient + j);
            typename P::type change = in - r * s;
            if constexpr (Compensated) {
                typename P::type l;
                load(l, low + j);
                change = change + l;
            }
            typename P::type const next = s + change;
            store(next, state + j);
            if constexpr (Compensated) store(typename P::type(change - (next - s)), low + j);
            sum[k] = sum[k] + c * next;
        }
    return sum_of_lanes<S>(typename P::type(sum[0] + sum[1]));
}

template <class S>
S product_sum_baseline(S const* x, S const* y, std::size_t n) {
    return product_sum_in<S, 16>(x, y, n);
}
template <class S>
S relax_baseline(S const* rate, S const* coefficient, S* state, std::size_t n, S const& x) {
    return relax_in<S, 16, false>(rate, coefficient, state, nullptr, n, x);
}
template <class S>
S relax_compensated_baseline(S const* rate, S const* coefficient, S* state, S* low, std::size_t n, S const& x) {
    return relax_in<S, 16, true>(rate, coefficient, state, low, n, x);
}
#ifdef HILGER_DETAIL_X86
template <class S>
HILGER_DETAIL_AVX2 S product_sum_avx2(S const* x, S const* y, std::size_t n) {
    return product_sum_in<S, 32>(x, y, n);
}
template <class S>
HILGER_DETAIL_AVX2 S relax_avx2(S const* rate, S const* coefficient, S* state, std::size_t n, S const& x) {
    return relax_in<S, 32, false>(rate, coefficient, state, nullptr, n, x);
}
template <class S>
HILGER_DETAIL_AVX2 S relax_compensated_avx2(S const* rate, S const* coefficient, S* state, S* low, std::size_t n, S const& x) {
    return relax_in<S, 32, true>(rate, coefficient, state, low, n, x);
}
#endif

/// The loops for this processor.
template <class S>
struct sums {
    S (*product_sum)(S const*, S const*, std::size_t) = product_sum_baseline<S>;
    S (*relax)(S const*, S const*, S*, std::size_t, S const&) = relax_baseline<S>;
    S (*relax_compensated)(S const*, S const*, S*, S*, std::size_t, S const&) = relax_compensated_baseline<S>;

    sums() {
#ifdef HILGER_DETAIL_X86
        if constexpr (std::is_same_v<S, double> or std::is_same_v<S, float>) {
            if (available_instructions() == instructions::avx2) {
                product_sum = product_sum_avx2<S>;
                relax = relax_avx2<S>;
                relax_compensated = relax_compensated_avx2<S>;
            }
        }
#endif
    }
};

} // namespace hilger::detail::memory
