// SPDX-License-Identifier: BSL-1.0
// One pass of transform.hpp, forwards and backwards.
#pragma once

#include <cstddef>
#include <type_traits>

#include "hilger/simd.hpp"

namespace hilger::detail::memory {

/// `count` neighbouring blocks of length n, the first of them number b, are split into four each.
template <class S, class P>
HILGER_DETAIL_INLINE void split_in(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    std::size_t const quarter = n / 4, width = sizeof(P) / sizeof(S);
    for (std::size_t k = 0; k < count; ++k, ++b, re += n, im += n) {
        S const c2 = cosine[b], s2 = sine[b], c = cosine[b / 2], s = sine[b / 2];
        S const c1 = b % 2 == 0 ? c : S(-s), s1 = b % 2 == 0 ? s : c; // the square root of the block's constant, c2 + i s2 that one's
        S const c3 = c1 * c2 - s1 * s2, s3 = c1 * s2 + s1 * c2;
        for (std::size_t j = 0; j < quarter; j += width) {
            P x0, x1, x2, x3, y0, y1, y2, y3;
            load(x0, re + j);
            load(y0, im + j);
            load(x1, re + j + quarter);
            load(y1, im + j + quarter);
            load(x2, re + j + 2 * quarter);
            load(y2, im + j + 2 * quarter);
            load(x3, re + j + 3 * quarter);
            load(y3, im + j + 3 * quarter);
            P const p2 = c1 * x2 - s1 * y2, q2 = c1 * y2 + s1 * x2;
            P const p1 = c2 * x1 - s2 * y1, q1 = c2 * y1 + s2 * x1;
            P const p3 = c3 * x3 - s3 * y3, q3 = c3 * y3 + s3 * x3;
            P const u0 = x0 + p2, v0 = y0 + q2, u2 = x0 - p2, v2 = y0 - q2;
            P const u1 = p1 + p3, v1 = q1 + q3, u3 = p1 - p3, v3 = q1 - q3;
            store(P(u0 + u1), re + j);
            store(P(v0 + v1), im + j);
            store(P(u0 - u1), re + j + quarter);
            store(P(v0 - v1), im + j + quarter);
            store(P(u2 - v3), re + j + 2 * quarter);
            store(P(v2 + u3), im + j + 2 * quarter);
            store(P(u2 + v3), re + j + 3 * quarter);
            store(P(v2 - u3), im + j + 3 * quarter);
        }
    }
}
/// The inverse, four times the polynomials.
template <class S, class P>
HILGER_DETAIL_INLINE void join_in(S* re, S* im, std::size_t n, std::size_t count, std::size_t b, S const* cosine, S const* sine) {
    std::size_t const quarter = n / 4, width = sizeof(P) / sizeof(S);
    for (std::size_t k = 0; k < count; ++k, ++b, re += n, im += n) {
        S const c2 = cosine[b], s2 = sine[b], c = cosine[b / 2], s = sine[b / 2];
        S const c1 = b % 2 == 0 ? c : S(-s), s1 = b % 2 == 0 ? s : c;
        S const c3 = c1 * c2 - s1 * s2, s3 = c1 * s2 + s1 * c2;
        for (std::size_t j = 0; j < quarter; j += width) {
            P x0, x1, x2, x3, y0, y1, y2, y3;
            load(x0, re + j);
            load(y0, im + j);
            load(x1, re + j + quarter);
            load(y1, im + j + quarter);
            load(x2, re + j + 2 * quarter);
            load(y2, im + j + 2 * quarter);
            load(x3, re + j + 3 * quarter);
            load(y3, im + j + 3 * quarter);
            P const u0 = x0 + x1, v0 = y0 + y1, u1 = x0 - x1, v1 = y0 - y1;
            P const u2 = x2 + x3, v2 = y2 + y3, u3 = x2 - x3, v3 = y2 - y3;
            P const p1 = u1 + v3, q1 = v1 - u3, p3 = u1 - v3, q3 = v1 + u3, p2 = u0 - u2, q2 = v0 - v2;
            store(P(u0 + u2), re + j);
            store(P(v0 + v2), im + j);
            store(P(c2 * p1 + s2 * q1), re + j + quarter);
            store(P(c2 * q1 - s2 * p1), im + j + quarter);
            store(P(c1 * p2 + s1 * q2), re + j + 2 * quarter);
            store(P(c1 * q2 - s1 * p2), im + j + 2 * quarter);
            store(P(c3 * p3 + s3 * q3), re + j + 3 * quarter);
            store(P(c3 * q3 - s3 * p3), im + j + 3 * quarter);
        }
    }
}

} // namespace hilger::detail::memory
