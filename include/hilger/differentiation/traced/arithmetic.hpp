// SPDX-License-Identifier: BSL-1.0
// Arithmetic of traced numbers and constants, and its derivatives. Operations on constants are evaluated and not recorded.
#pragma once

#include "hilger/differentiation/traced/traced.hpp"

namespace hilger {

namespace detail {

/// An operation on x and y with the result r, and its pull-back of an adjoint a: a dr/dx and a dr/dy. Unary operations have y = x.
#define HILGER_OPERATION(operation, symbol, is_symmetric, value_at, by_x, by_y)                                                            \
    struct operation##_traced {                                                                                                            \
        static constexpr char const* name = symbol;                                                                                        \
        static constexpr bool commutes = is_symmetric;                                                                                     \
        template <class S>                                                                                                                 \
        static S value([[maybe_unused]] S const& x, [[maybe_unused]] S const& y) {                                                         \
            using std::atan2, std::hypot, std::pow, std::sqrt;                                                                             \
            return S(value_at);                                                                                                            \
        }                                                                                                                                  \
        template <class T>                                                                                                                 \
        static std::pair<T, T> pull_back([[maybe_unused]] T const& x, [[maybe_unused]] T const& y, [[maybe_unused]] T const& r,            \
                                         [[maybe_unused]] T const& a) {                                                                    \
            return {T(by_x), T(by_y)};                                                                                                     \
        }                                                                                                                                  \
    };
HILGER_OPERATION(plus, "+", true, x + y, a, a)
HILGER_OPERATION(minus, "-", false, x - y, a, -a)
HILGER_OPERATION(times, "*", true, x* y, a* y, a* x)
HILGER_OPERATION(over, "/", false, x / y, a / y, -(a / y * r))
HILGER_OPERATION(minus_of, "-x", false, -x, -a, 0)

/// The factor c and the rest x of `from` = c x or -x while derivatives are made, which collects constants. A formula stays as it was
/// written: collected constants round differently.
template <class S>
struct multiple_of {
    S factor{1};
    traced<S> rest;
    explicit multiple_of(traced<S> const& from) : rest(from) {
        auto const* g = formula_graph<S>::of_this_thread();
        if (from.is_constant() or g->has_values) return;
        auto const& n = (*g)[from.node];
        if (n.what == &operation_object<minus_of_traced, S>) {
            factor = S(-1);
            rest = traced<S>::at(n.a, S(0));
        } else if (n.what == &operation_object<times_traced, S>) {
            for (auto const& [c, x] : {std::pair{n.a, n.b}, std::pair{n.b, n.a}})
                if (g->is_number(c)) {
                    factor = g->number(c);
                    rest = traced<S>::at(x, S(0));
                    return;
                }
        }
    }
};

} // namespace detail

template <class S>
traced<S> operator-(traced<S> const& x) {
    if (not x.is_constant() and traced<S>::is_written_out())
        if (detail::multiple_of<S> const m(x); m.rest.node != x.node) return traced<S>(S(-m.factor)) * m.rest;
    return detail::make_traced<detail::minus_of_traced>(x);
}
template <class S>
traced<S> operator+(traced<S> const& x) {
    return x;
}
template <class S>
traced<S> operator*(traced<S> const& x, traced<S> const& y) {
    if (x.is(1)) return y;
    if (y.is(1)) return x;
    if (x.is(-1) and not y.is_constant()) return -y;
    if (y.is(-1) and not x.is_constant()) return -x;
    if (traced<S>::is_written_out()) {
        if (x.is(0) or y.is(0)) return traced<S>(S(0));
        detail::multiple_of<S> const l(x), r(y);
        if (l.rest.node != x.node and not y.is_constant()) return traced<S>(l.factor) * (l.rest * y);
        if (r.rest.node != y.node and not x.is_constant()) return traced<S>(r.factor) * (x * r.rest);
        if (x.is_constant() and r.rest.node != y.node) return traced<S>(S(x.value * r.factor)) * r.rest;
        if (y.is_constant() and l.rest.node != x.node) return traced<S>(S(y.value * l.factor)) * l.rest;
    }
    return detail::make_traced<detail::times_traced>(x, y);
}
template <class S>
traced<S> operator/(traced<S> const& x, traced<S> const& y) {
    if (y.is(1)) return x;
    if (traced<S>::is_written_out()) {
        if (x.is(0)) return x;
        if (detail::multiple_of<S> const m(x); not x.is_constant() and m.rest.node != x.node) return traced<S>(m.factor) * (m.rest / y);
    }
    return detail::make_traced<detail::over_traced>(x, y);
}
template <class S>
traced<S> operator-(traced<S> const& x, traced<S> const& y);
template <class S>
traced<S> operator+(traced<S> const& x, traced<S> const& y) {
    if (x.is(0)) return y;
    if (y.is(0)) return x;
    if (traced<S>::is_written_out() and not x.is_constant() and not y.is_constant()) {
        detail::multiple_of<S> const l(x), r(y);
        if (l.rest.node == r.rest.node) return traced<S>(S(l.factor + r.factor)) * l.rest;
        if (not(l.factor == S(1)) and l.factor == r.factor) return traced<S>(l.factor) * (l.rest + r.rest);
        if (r.rest.node != y.node and r.factor == S(-1)) return detail::make_traced<detail::minus_traced>(x, r.rest);
        if (l.rest.node != x.node and l.factor == S(-1)) return detail::make_traced<detail::minus_traced>(y, l.rest);
    }
    return detail::make_traced<detail::plus_traced>(x, y);
}
template <class S>
traced<S> operator-(traced<S> const& x, traced<S> const& y) {
    if (y.is(0)) return x;
    if (x.is(0) and not y.is_constant()) return -y;
    if (traced<S>::is_written_out() and not y.is_constant()) return x + -y;
    return detail::make_traced<detail::minus_traced>(x, y);
}

#define HILGER_WITH_CONSTANTS(operation)                                                                                                   \
    template <class S, constant_for<S> K>                                                                                                  \
    traced<S> operator operation(traced<S> const& x, K const& c) {                                                                         \
        return x operation traced<S>(c);                                                                                                   \
    }                                                                                                                                      \
    template <class S, constant_for<S> K>                                                                                                  \
    traced<S> operator operation(K const& c, traced<S> const& x) {                                                                         \
        return traced<S>(c) operation x;                                                                                                   \
    }
HILGER_WITH_CONSTANTS(+)
HILGER_WITH_CONSTANTS(-)
HILGER_WITH_CONSTANTS(*)
HILGER_WITH_CONSTANTS(/)
#undef HILGER_WITH_CONSTANTS

} // namespace hilger
