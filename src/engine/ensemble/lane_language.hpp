// SPDX-License-Identifier: BSL-1.0
// The vocabulary of generated steps: vectors with a lane for each of several members, or plain numbers for one member.
#pragma once

#include "text/c_statements.hpp"

namespace engine {

namespace lane_language {

inline constexpr char const* several = R"(#include <math.h>
#include <string.h>

enum { width = $width };
typedef double lanes __attribute__((vector_size(8 * width)));
typedef long long mask __attribute__((vector_size(8 * width)));

#define none(m) (~(m))
#define lane_of(x, k) (x)[k]
static inline lanes all(double x) { return x - (lanes){0}; }
static inline lanes either(mask m, lanes a, lanes b) { return (lanes)((m & (mask)a) | (~m & (mask)b)); }
static inline lanes size_of(lanes x) { return (lanes)((mask)x & 0x7fffffffffffffffLL); }
static inline int are_all(mask m)
{
    long long all_of_them = -1;
    for (int k = 0; k < width; ++k) all_of_them &= m[k];
    return all_of_them != 0;
}
)";
inline constexpr char const* one_alone = R"(#include <math.h>
#include <string.h>

enum { width = 1 };
typedef double lanes;
typedef long long mask;

#define none(m) (!(m))
#define lane_of(x, k) (x)
#define all(x) (x)
#define either(m, a, b) ((m) ? (a) : (b))
#define size_of(x) fabs(x)
#define are_all(m) (m)
)";
inline constexpr char const* of_both = R"(static inline lanes larger(lanes a, lanes b) { return either(a > b, a, b); }
static inline lanes smaller(lanes a, lanes b) { return either(a < b, a, b); }
static inline lanes divided_by_norm(lanes a, lanes b) { return either(b == all(0.0), a * b, a / b); }
#define over_norm(a, b) divided_by_norm((lanes){0} + (a), b)
)";
// Functions of the lanes; one member uses those of the C library.
inline constexpr char const* functions_in_lanes = R"(#define EACH(f)                                        \
    static inline lanes lanes_##f(lanes x)             \
    {                                                  \
        double in[width], out[width];                  \
        memcpy(in, &x, sizeof x);                      \
        for (int k = 0; k < width; ++k) out[k] = f(in[k]); \
        memcpy(&x, out, sizeof x);                     \
        return x;                                      \
    }
EACH(sqrt)
EACH(tan)
EACH(sinh)
EACH(cosh)
EACH(tanh)
EACH(atan)
EACH(asinh)
EACH(cbrt)
EACH(expm1)
EACH(erf)
#if defined(__AVX2__) && defined(__GLIBC__)
// Those of the C library for 4 and for 8 numbers have the same bits, those for 1 and for 2 have others.
#if defined(__AVX512F__) && $width == 8
typedef double full __attribute__((vector_size(64)));
#define OF_FULL(f) _ZGVeN8v_##f
#else
typedef double full __attribute__((vector_size(32)));
#define OF_FULL(f) _ZGVdN4v_##f
#endif
#define FULL(f)                                                               \
    extern full OF_FULL(f)(full);                                             \
    static inline lanes lanes_##f(lanes x)                                    \
    {                                                                         \
        enum { count = (sizeof(lanes) + sizeof(full) - 1) / sizeof(full) };   \
        full all_of_it[count] = {{0}};                                        \
        memcpy(all_of_it, &x, sizeof x);                                      \
        for (int k = 0; k < count; ++k) all_of_it[k] = OF_FULL(f)(all_of_it[k]); \
        memcpy(&x, all_of_it, sizeof x);                                      \
        return x;                                                             \
    }
#else
#define FULL EACH
#endif
FULL(sin)
FULL(cos)
FULL(exp)
static inline lanes lanes_pow(lanes x, double n)
{
    double in[width], out[width];
    memcpy(in, &x, sizeof x);
    for (int k = 0; k < width; ++k) out[k] = pow(in[k], n);
    memcpy(&x, out, sizeof x);
    return x;
}
static inline lanes lanes_hypot(lanes x, lanes y)
{
    double a[width], b[width];
    memcpy(a, &x, sizeof x);
    memcpy(b, &y, sizeof y);
    for (int k = 0; k < width; ++k) a[k] = hypot(a[k], b[k]);
    memcpy(&x, a, sizeof x);
    return x;
}
#define sqrt lanes_sqrt
#define tan lanes_tan
#define sinh lanes_sinh
#define cosh lanes_cosh
#define tanh lanes_tanh
#define atan lanes_atan
#define asinh lanes_asinh
#define cbrt lanes_cbrt
#define expm1 lanes_expm1
#define erf lanes_erf
#define sin lanes_sin
#define cos lanes_cos
#define exp lanes_exp
#define pow lanes_pow
#define hypot(a, b) lanes_hypot((lanes){0} + (a), (lanes){0} + (b))
)";

} // namespace lane_language

inline std::string language_of(int width) {
    using namespace lane_language;
    using hilger::detail::filled;
    if (width == 0) return std::string(one_alone) + of_both;
    return filled(std::string(several) + of_both + functions_in_lanes, {{"$width", std::to_string(width)}});
}

} // namespace engine
