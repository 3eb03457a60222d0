// SPDX-License-Identifier: BSL-1.0
// Arithmetic of traced numbers, with constants too, and how its operations are differentiated. Operations on numbers that are constant are
// done and not written down.
#pragma once

#include "hilger/differentiation/traced/traced.hpp"

namespace hilger {

namespace detail {

struct plus_traced {
    static constexpr char const* name = "+";
    static constexpr bool commutes = true;
    template <class S>
    static S value(S const& x, S const& y) {
        return S(x + y);
    }
    template <class T>
    static std::pair<T, T> pull_back(T const&, T const&, T const&, T const& adjoint) {
        return {adjoint, adjoint};
    }
};
struct minus_traced {
    static constexpr char const* name = "-";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const& y) {
        return S(x - y);
    }
    template <class T>
    static std::pair<T, T> pull_back(T const&, T const&, T const&, T const& adjoint) {
        return {adjoint, -adjoint};
    }
};
struct times_traced {
    static constexpr char const* name = "*";
    static constexpr bool commutes = true;
    template <class S>
    static S value(S const& x, S const& y) {
        return S(x * y);
    }
    template <class T>
    static std::pair<T, T> pull_back(T const& x, T const& y, T const&, T const& adjoint) {
        return {adjoint * y, adjoint * x};
    }
};
struct over_traced {
    static constexpr char const* name = "/";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const& y) {
        return S(x / y);
    }
    template <class T>
    static std::pair<T, T> pull_back(T const&, T const& y, T const& result, T const& adjoint) {
        T const by_x = adjoint / y;
        return {by_x, -(by_x * result)};
    }
};
struct minus_of_traced {
    static constexpr char const* name = "-x";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const&) {
        return S(-x);
    }
    template <class T>
    static std::pair<T, T> pull_back(T const&, T const&, T const&, T const& adjoint) {
        return {-adjoint, T(0)};
    }
};

/// c and x where `from` is c x or -x while derivatives are made: there constants are gathered, which a formula as it was written is
/// spared, for that rounds differently.
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

template <class S, constant_beside<S> K>
traced<S> operator+(traced<S> const& x, K const& c) {
    return x + traced<S>(c);
}
template <class S, constant_beside<S> K>
traced<S> operator+(K const& c, traced<S> const& x) {
    return traced<S>(c) + x;
}
template <class S, constant_beside<S> K>
traced<S> operator-(traced<S> const& x, K const& c) {
    return x - traced<S>(c);
}
template <class S, constant_beside<S> K>
traced<S> operator-(K const& c, traced<S> const& x) {
    return traced<S>(c) - x;
}
template <class S, constant_beside<S> K>
traced<S> operator*(traced<S> const& x, K const& c) {
    return x * traced<S>(c);
}
template <class S, constant_beside<S> K>
traced<S> operator*(K const& c, traced<S> const& x) {
    return traced<S>(c) * x;
}
template <class S, constant_beside<S> K>
traced<S> operator/(traced<S> const& x, K const& c) {
    return x / traced<S>(c);
}
template <class S, constant_beside<S> K>
traced<S> operator/(K const& c, traced<S> const& x) {
    return traced<S>(c) / x;
}

} // namespace hilger
