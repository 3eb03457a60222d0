// SPDX-License-Identifier: BSL-1.0
// Elementary functions of traced numbers, and their derivatives.
#pragma once

#include <cmath>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "hilger/differentiation/functions.hpp"
#include "hilger/differentiation/traced/choices.hpp"

namespace hilger {

namespace detail {
/// x/y, and 0 for y = 0 unless x is infinite: an adjoint behind a norm, whose slope at 0 is set to 0 as for jets.
template <class S>
traced<S> over_norm(traced<S> const& x, traced<S> const& y);
HILGER_OPERATION(over_norm, "over_norm", false, y == S(0) ? S(x * y) : S(x / y), over_norm(a, y), -(over_norm(a, y) * r))
template <class S>
traced<S> over_norm(traced<S> const& x, traced<S> const& y) {
    if (traced<S>::is_written_out() and not x.is_constant())
        if (multiple_of<S> const m(x); m.rest.node != x.node) return traced<S>(m.factor) * over_norm(m.rest, y);
    return make_traced<over_norm_traced>(x, y);
}
/// Whether x is never negative by its form: its slope is then 0 where x is.
template <class S>
bool is_never_negative(traced<S> const& x) {
    if (x.is_constant()) return false;
    auto const& g = *formula_graph<S>::of_this_thread();
    auto const is_multiple_of = [](int k, int base) { // of itself, too
        multiple_of<S> const m(traced<S>::at(k, S(0)));
        return m.rest.node == base and S(0) <= m.factor;
    };
    std::vector<int> open{x.node};
    std::unordered_set<int> seen; // shared operands are visited once
    while (not open.empty()) {
        int const k = open.back();
        open.pop_back();
        if (not seen.insert(k).second) continue;
        auto const& n = g[k];
        if (n.what == nullptr) {
            if (not g.is_number(k) or g.number(k) < S(0)) return false;
            continue;
        }
        std::string_view const name = n.what->name;
        bool const is_product = n.what == &operation_object<times_traced, S>;
        bool const is_square = is_product and (is_multiple_of(n.a, n.b) or is_multiple_of(n.b, n.a));
        if (is_square or name == "sqrt" or name == "hypot") continue;
        if (is_product or n.what == &operation_object<plus_traced, S> or n.what == &operation_object<over_traced, S>) {
            open.push_back(n.a);
            open.push_back(n.b);
        } else if (name == "pow" and g.is_number(n.b))
            open.push_back(n.a);
        else
            return false;
    }
    return true;
}
template <class T>
T slope_of_root(T const& x, T const& root, T const& adjoint) {
    T const half = T(1) / T(2);
    return half * (is_never_negative(x) ? over_norm(adjoint, root) : adjoint / root);
}
HILGER_OPERATION(sqrt, "sqrt", false, sqrt(x), slope_of_root(x, r, a), 0)
HILGER_OPERATION(slope_of_log, "slope_of_log", false, slope_of_log(x), -(a*(r* r)), 0)
template <class S>
traced<S> slope_of_log(traced<S> const& x) {
    return make_traced<slope_of_log_traced>(x);
}
/// A function of the table.
template <class F>
struct function_traced {
    static constexpr bool commutes = false;
    static constexpr char const* name = F::name;
    template <class S>
    static S value(S const& x, S const&) {
        return F::value(x);
    }
    template <class T>
    static std::pair<T, T> pull_back(T const& x, T const&, T const& y, T const& adjoint) {
        return {adjoint * F::slope(x, y), T(0)};
    }
};
} // namespace detail
#define HILGER_TRACED_FUNCTION(function)                                                                                                   \
    template <class S>                                                                                                                     \
    traced<S> function(traced<S> const& x) {                                                                                               \
        return detail::make_traced<detail::function_traced<detail::function##_function>>(x);                                               \
    }
HILGER_FOR_EACH_FUNCTION(HILGER_TRACED_FUNCTION)
#undef HILGER_TRACED_FUNCTION
template <class S>
traced<S> sqrt(traced<S> const& x) {
    return detail::make_traced<detail::sqrt_traced>(x);
}

namespace detail {
HILGER_OPERATION(hypot, "hypot", true, hypot(x, y), over_norm(a, r) * x, over_norm(a, r) * y)
/// x / (x x + y y), also if the squares overflow.
template <class T>
T over_square(T const& x, T const& y, T const& adjoint) {
    T const r = make_traced<hypot_traced>(x, y);
    return adjoint / r * (x / r);
}
/// In the order (y, x) of C: the ordinate is x here.
HILGER_OPERATION(atan2, "atan2", false, atan2(x, y), over_square(y, x, a), -over_square(x, y, a))
/// x^c with a number c.
struct power_traced {
    static constexpr char const* name = "pow";
    static constexpr bool commutes = false;
    template <class S>
    static S value(S const& x, S const& c) {
        using std::pow;
        return S(pow(x, c));
    }
    template <class T>
    static std::pair<T, T> pull_back(T const& x, T const& c, T const& result, T const& adjoint) {
        if (c.is(0)) return {T(0), T(0)};
        if (c.value < typename T::scalar_type(1) and is_never_negative(x)) return {c * over_norm(adjoint * result, x), T(0)};
        T const less(typename T::scalar_type(c.value - typename T::scalar_type(1)));
        return {adjoint * (c * (less.is(0) ? T(1) : make_traced<power_traced>(x, less))), T(0)};
    }
};
template <class T>
T log_of_number(T const& c) {
    using std::log;
    return T(typename T::scalar_type(log(c.value)));
}
/// x^y with a number x.
HILGER_OPERATION(exponential, "pow", false, pow(x, y), 0, a*(log_of_number(x) * r))
} // namespace detail

template <class X, class Y>
    requires is_traced<detail::pair_of<X, Y>> detail::pair_of<X, Y> hypot(X const& x, Y const& y) {
        using T = detail::pair_of<X, Y>;
        return detail::make_traced<detail::hypot_traced>(T(x), T(y));
    }
template <class Y, class X>
    requires is_traced<detail::pair_of<Y, X>> detail::pair_of<Y, X> atan2(Y const& y, X const& x) {
        using T = detail::pair_of<Y, X>;
        return detail::make_traced<detail::atan2_traced>(T(y), T(x));
    }
/// x^n with a whole n is exact for every x; other powers need x > 0.
template <class S, constant_for<S> K>
traced<S> pow(traced<S> const& x, K const& exponent) {
    if constexpr (std::is_integral_v<K>) {
        traced<S> y(1), square = x;
        auto n = static_cast<unsigned long long>(exponent < K(0) ? -static_cast<long long>(exponent) : static_cast<long long>(exponent));
        for (; n > 0; n >>= 1U) {
            if (n & 1U) y = y * square;
            if (n > 1) square = square * square;
        }
        return exponent < K(0) ? S(1) / y : y;
    } else
        return detail::make_traced<detail::power_traced>(x, traced<S>(exponent));
}
template <class S>
traced<S> pow(traced<S> const& x, traced<S> const& y) {
    return y.is_constant() ? detail::make_traced<detail::power_traced>(x, y) : exp(y * log(x));
}
template <class S, constant_for<S> K>
traced<S> pow(K const& base, traced<S> const& x) {
    traced<S> const b(base);
    return b.is(0) ? b : detail::make_traced<detail::exponential_traced>(b, x); // 0^x is 0 for all x > 0
}

#undef HILGER_OPERATION

} // namespace hilger
