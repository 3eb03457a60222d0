// SPDX-License-Identifier: BSL-1.0
// The two inner loops of a history: a sum of products, and one step of all exponentials.
#pragma once

#include "hilger/error_free.hpp"
#include "hilger/simd.hpp"

namespace hilger::detail::memory {

struct product_sum_loop {
    /// sum_i x_i y_i, n a multiple of padding<S> (or any n for one number at a time).
    template <class S, int Bytes>
    HILGER_DETAIL_INLINE static S in(S const* x, S const* y, std::size_t n) {
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
};

/// state <- (1 - rate) state + x, so that rates far below epsilon count; sum <- sum + coefficient state. `low` takes the rounding error of
/// the sum (Kahan): else a state that grows for 1/rate steps would stop where its increments are below its last digit.
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
struct relax_loop {
    /// One step of all n exponentials, those from the `brief`-th on with `low`, which begins with theirs; returns sum_j coefficient_j
    /// state_j.
    template <class S, int Bytes>
    HILGER_DETAIL_INLINE static S in(S const* rate, S const* coefficient, S* state, S* low, std::size_t brief, std::size_t n, S const& x) {
        using P = typename pack<S, Bytes>::type;
        constexpr std::size_t width = pack<S, Bytes>::width;
        P even{}, odd{}, entering{};
        entering = entering + x;
        std::size_t j = 0;
        for (; j < brief; j += 2 * width) {
            relax_pack<false>(rate + j, coefficient + j, state + j, low, entering, even);
            relax_pack<false>(rate + j + width, coefficient + j + width, state + j + width, low, entering, odd);
        }
        for (; j < n; j += 2 * width, low += 2 * width) {
            relax_pack<true>(rate + j, coefficient + j, state + j, low, entering, even);
            relax_pack<true>(rate + j + width, coefficient + j + width, state + j + width, low + width, entering, odd);
        }
        return sum_of_lanes<S>(P(even + odd));
    }
};

/// The loops for this processor.
template <class S>
struct sums {
    using for_product_sum = loop_for<product_sum_loop, S, S(S const*, S const*, std::size_t)>;
    using for_relax = loop_for<relax_loop, S, S(S const*, S const*, S*, S*, std::size_t, std::size_t, S const&)>;
    typename for_product_sum::function product_sum = for_product_sum::chosen();
    typename for_relax::function relax = for_relax::chosen();
};

} // namespace hilger::detail::memory
