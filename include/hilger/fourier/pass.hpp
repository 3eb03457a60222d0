// SPDX-License-Identifier: BSL-1.0
// One pass of transform.hpp, forwards and backwards, in the widest packs that fit a block and this processor.
#pragma once

#include <cstddef>

#include "hilger/simd.hpp"

namespace hilger::detail::memory {

/// A pack of complex numbers.
template <class P, class S>
HILGER_DETAIL_INLINE void load_both(P& x, P& y, S const* re, S const* im) {
    load(x, re);
    load(y, im);
}
template <class P, class S>
HILGER_DETAIL_INLINE void store_both(P const& x, P const& y, S* re, S* im) {
    store(x, re);
    store(y, im);
}

struct split_pass {
    /// `count` neighbouring blocks of length n, the first of them number b, are split into four each.
    template <class S, class P>
    HILGER_DETAIL_INLINE static void in(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
        std::size_t const quarter = n / 4, width = sizeof(P) / sizeof(S);
        for (std::size_t k = 0; k < count; ++k, ++b, re += n, im += n) {
            S const c2 = cosine[b], s2 = sine[b], c = cosine[b / 2], s = sine[b / 2];
            S const c1 = b % 2 == 0 ? c : S(-s), s1 = b % 2 == 0 ? s : c; // the square root of the block's constant, c2 + i s2 that one's
            S const c3 = c1 * c2 - s1 * s2, s3 = c1 * s2 + s1 * c2;
            for (std::size_t j = 0; j < quarter; j += width) {
                P x0, x1, x2, x3, y0, y1, y2, y3;
                load_both(x0, y0, re + j, im + j);
                load_both(x1, y1, re + j + quarter, im + j + quarter);
                load_both(x2, y2, re + j + 2 * quarter, im + j + 2 * quarter);
                load_both(x3, y3, re + j + 3 * quarter, im + j + 3 * quarter);
                P const p2 = c1 * x2 - s1 * y2, q2 = c1 * y2 + s1 * x2;
                P const p1 = c2 * x1 - s2 * y1, q1 = c2 * y1 + s2 * x1;
                P const p3 = c3 * x3 - s3 * y3, q3 = c3 * y3 + s3 * x3;
                P const u0 = x0 + p2, v0 = y0 + q2, u2 = x0 - p2, v2 = y0 - q2;
                P const u1 = p1 + p3, v1 = q1 + q3, u3 = p1 - p3, v3 = q1 - q3;
                store_both<P>(u0 + u1, v0 + v1, re + j, im + j);
                store_both<P>(u0 - u1, v0 - v1, re + j + quarter, im + j + quarter);
                store_both<P>(u2 - v3, v2 + u3, re + j + 2 * quarter, im + j + 2 * quarter);
                store_both<P>(u2 + v3, v2 - u3, re + j + 3 * quarter, im + j + 3 * quarter);
            }
        }
    }
};
struct join_pass {
    /// The inverse, four times the polynomials.
    template <class S, class P>
    HILGER_DETAIL_INLINE static void in(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
        std::size_t const quarter = n / 4, width = sizeof(P) / sizeof(S);
        for (std::size_t k = 0; k < count; ++k, ++b, re += n, im += n) {
            S const c2 = cosine[b], s2 = sine[b], c = cosine[b / 2], s = sine[b / 2];
            S const c1 = b % 2 == 0 ? c : S(-s), s1 = b % 2 == 0 ? s : c;
            S const c3 = c1 * c2 - s1 * s2, s3 = c1 * s2 + s1 * c2;
            for (std::size_t j = 0; j < quarter; j += width) {
                P x0, x1, x2, x3, y0, y1, y2, y3;
                load_both(x0, y0, re + j, im + j);
                load_both(x1, y1, re + j + quarter, im + j + quarter);
                load_both(x2, y2, re + j + 2 * quarter, im + j + 2 * quarter);
                load_both(x3, y3, re + j + 3 * quarter, im + j + 3 * quarter);
                P const u0 = x0 + x1, v0 = y0 + y1, u1 = x0 - x1, v1 = y0 - y1;
                P const u2 = x2 + x3, v2 = y2 + y3, u3 = x2 - x3, v3 = y2 - y3;
                P const p1 = u1 + v3, q1 = v1 - u3, p3 = u1 - v3, q3 = v1 + u3, p2 = u0 - u2, q2 = v0 - v2;
                store_both<P>(u0 + u2, v0 + v2, re + j, im + j);
                store_both<P>(c2 * p1 + s2 * q1, c2 * q1 - s2 * p1, re + j + quarter, im + j + quarter);
                store_both<P>(c1 * p2 + s1 * q2, c1 * q2 - s1 * p2, re + j + 2 * quarter, im + j + 2 * quarter);
                store_both<P>(c3 * p3 + s3 * q3, c3 * q3 - s3 * p3, re + j + 3 * quarter, im + j + 3 * quarter);
            }
        }
    }
};

/// A pass in the widest packs that fit a quarter of a block.
template <class Pass>
struct in_widest {
    template <class S, int Bytes>
    HILGER_DETAIL_INLINE static void in(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
        if constexpr (Bytes >= 16 and pack<S, Bytes>::width > 1) {
            if (n / 4 >= pack<S, Bytes>::width)
                Pass::template in<S, typename pack<S, Bytes>::type>(re, im, n, count, b, cosine, sine);
            else
                in<S, Bytes / 2>(re, im, n, count, b, cosine, sine);
        } else
            Pass::template in<S, S>(re, im, n, count, b, cosine, sine);
    }
};

/// The passes for this processor.
template <class S>
struct fourier_passes {
    template <class Pass>
    using pass_for = loop_for<in_widest<Pass>, S, void(S*, S*, std::size_t, std::size_t, std::size_t, S const*, S const*)>;
    typename pass_for<split_pass>::function split = pass_for<split_pass>::chosen();
    typename pass_for<join_pass>::function join = pass_for<join_pass>::chosen();
};

} // namespace hilger::detail::memory
