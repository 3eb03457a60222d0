// SPDX-License-Identifier: BSL-1.0
// Fractional differences. Delta_-^alpha is the power alpha of the difference (f - f^rho) / nu, for f that is 0 before t_0, on any T
// continued to the left by its first step: nu(t_0) = nu(t_1) (operator/power_weights.hpp). Delta_+^alpha is its adjoint in the sums with
// the weights nu, the same power of (f - f^sigma) / nu. On a uniform T, with the weights w_n of a generating function
// (operator/weights.hpp),
//   Delta_-^alpha[f](t_k) = h^-alpha sum_{n=0..k} w_n f(t_{k-n}),   Delta_+^alpha[f](t_k) = h^-alpha sum_{n=0..N-k} w_n f(t_{k+n})
// on all of T (Bourdin et al. (7), (8); the row k = 0 belongs to it: without it Delta_-^alpha Delta_-^beta = Delta_-^{alpha+beta} is
// false); the power has those of Gruenwald and Letnikov, and the other generating functions need a uniform T.
//   Delta_minus_alpha<1, 2>      order 1/2 in the type          Delta_minus(alpha)        order known at run time
//   minus_alpha<bdf<2>, 1, 2>    another generating function    caputo_minus_alpha<1, 2>  of f - f(a)
//   Delta_minus_alpha<-1, 2>     the inverse, a sum
//   minus_Delta_plus_alpha<1, 2> (-Delta_+)^(1/2), the mirror image of Delta_-^(1/2), with the graininess mu: Delta_+^(1/2) on a uniform T
// Orders of one generating function, side and graininess add up in the type; a whole order is a local difference. The adjoint is between
// the sums of nu over T^- and T^+, on a uniform T the nabla and the Delta sum (Bourdin et al., lemma 2; here with its boundary form).
#pragma once

#include <map>

#include "hilger/operator/power.hpp"

namespace hilger {

namespace detail {

/// The number of weights of a whole order where they end, else 0.
template <generating_function G, class Order>
inline constexpr index_type weights_end = 0;
template <generating_function G, int P>
inline constexpr index_type
    weights_end<G, fraction<P>> = std::tuple_size_v<decltype(G::template denominator<double>())> == 1 and P >= 0
                                      ? P* static_cast<index_type>(std::tuple_size_v<decltype(G::template numerator<double>())> - 1) + 1
                                      : 0;

/// w_0, ..., w_{count-1}, computed once for each order and kept.
template <generating_function G, class S>
std::vector<S> const& kept_weights(S const& alpha, index_type count) {
    thread_local std::map<S, std::pair<weight_sequence<G, S>, std::vector<S>>> kept;
    auto& [sequence, w] = kept.try_emplace(alpha, weight_sequence<G, S>(alpha), std::vector<S>{}).first->second;
    while (static_cast<index_type>(w.size()) < count) w.push_back(sequence.next());
    return w;
}

/// omega(0)^alpha h^-alpha. The generic scale that operators are compared on has its own. @throws error::invalid_parameter for exact
/// scalars where it is no rational number.
template <generating_function G, class Order, class Root>
constexpr auto leading_factor(Root const& T, Order const& order) {
    using S = typename Root::scalar_type;
    if constexpr (requires { T.template leading_factor<G>(order); })
        return T.template leading_factor<G>(order);
    else if constexpr (not ordered_scalar<S>) { // a finite field has whole powers only
        static_assert(Order::denominator == 1 and Order::numerator >= 0);
        S const once = G::template numerator<S>()[0] / G::template denominator<S>()[0] / T.step(0);
        S factor(1);
        for (int k = 0; k < Order::numerator; ++k) factor = factor * once;
        return factor;
    } else {
        S const alpha = order.template as<S>(), h = T.step(0);
        if constexpr (not std::numeric_limits<S>::is_exact) {
            using std::pow;
            return S(leading_weight<G>(alpha) * pow(h, S(-alpha)));
        } else
            return S(leading_weight<G>(alpha) / power_or(h, alpha, [&] {
                         error::raise<error::invalid_parameter>("in an exact scalar a fractional difference of order ", alpha,
                                                                " takes steps of length 1, and this one is ", h);
                     }));
    }
}

template <class Order>
struct order_name {
    static constexpr auto name() { return fixed_text("alpha"); }
};
template <int P, int Q>
struct order_name<fraction<P, Q>> {
    static constexpr auto name() {
        if constexpr (P < 0)
            return "-" + order_name<fraction<-P, Q>>::name();
        else
            return digits<P>() + "/" + digits<Q>();
    }
};

template <class A, class Domain>
constexpr void sums_from_the_first() {
    does_not_compile<A::name() + " sums from the first point on, and this function lives on " + Domain::name()>{};
}
template <class A, class Domain>
constexpr void sums_to_the_last() {
    does_not_compile<A::name() + " sums up to the last point, and this function lives on " + Domain::name()>{};
}

} // namespace detail

/// Delta_-^alpha or Delta_+^alpha with the weights of G (Bourdin et al. (7), (8)), on an uneven T the power of the difference to that side
/// with the graininess of W: nu for nabla_weight, mu for delta_weight.
template <generating_function G, class Order, side Side, class W = nabla_weight>
struct fractional_difference : linear_operator<fractional_difference<G, Order, Side, W>> {
    static constexpr bool is_own =
        std::same_as<W, nabla_weight> == (Side == side::minus); ///< the graininess of the difference to that side
    using from = nodes;
    using to = nodes;
    using from_weight = std::conditional_t<is_own, continued_weight<W>, W>;
    using to_weight = std::conditional_t<is_own, W, continued_weight<W>>;
    static constexpr bool needs_uniform = not std::same_as<G, grunwald_letnikov>;
    static constexpr reach reads =
        [] {
            index_type const end = detail::weights_end<G, Order>;
            if (Side == side::minus) return end > 0 ? reach::local(static_cast<double>(end - 1), 0) : reach::causal();
            return end > 0 ? reach::local(0, static_cast<double>(end - 1)) : reach::anticausal();
        }()
            .template at<nodes>();
    [[no_unique_address]] Order order{};

    static constexpr auto name() {
        auto const rest = "_alpha<" + detail::order_name<Order>::name() + ">";
        if constexpr (std::same_as<W, delta_weight> and Side == side::minus)
            return "adjoint(minus_" + G::name() + "_plus" + rest + ")";
        else if constexpr (std::same_as<W, delta_weight>)
            return "minus_" + G::name() + "_plus" + rest;
        else if constexpr (Side == side::plus)
            return G::name() + "_plus" + rest;
        else
            return G::name() + "_minus" + rest;
    }
    /// Sums from the first point (to the last one), so f must be known there.
    template <int F, int B>
    constexpr auto image(domain<nodes, F, B> const&) const {
        if constexpr (Side == side::minus) {
            if constexpr (F > 0) detail::sums_from_the_first<fractional_difference, domain<nodes, F, B>>();
            return domain<nodes, 0, B>{};
        } else {
            if constexpr (B > 0) detail::sums_to_the_last<fractional_difference, domain<nodes, F, B>>();
            return domain<nodes, F, 0>{};
        }
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type k) const {
        using root = typename F::root_type;
        if constexpr (root::is_uniform)
            return on_equal_steps(f, k);
        else if constexpr (needs_uniform)
            return detail::needs_one_step<fractional_difference, root>();
        else {
            using powers = detail::powers_of_difference<W, Side>;
            if constexpr (ordered_scalar<typename root::scalar_type>)
                return powers::value(order, f, k);
            else
                return powers::generic_value(order, f, k);
        }
    }
    constexpr auto adjoint() const { return fractional_difference<G, Order, opposite<Side>, W>{{}, order}; }

private:
    /// By the sum itself, O(k) at point k; for all points at once see toeplitz_triangle (history/convolution.hpp).
    template <class F>
    constexpr auto on_equal_steps(F const& f, index_type k) const {
        using S = typename F::root_type::scalar_type;
        index_type const last = Side == side::minus ? k - f.domain().first(f.root()) : f.domain().last(f.root()) - k;
        index_type const count = std::min(last + 1, ends > 0 ? ends : last + 1);
        auto const at = [&](index_type n) { return f.get(Side == side::minus ? k - n : k + n); };
        auto sum = evaluated(at(0));
        if constexpr (ends > 0 or not ordered_scalar<S>) {
            weight_sequence<G, S> w(order.template as<S>());
            (void)w.next();
            for (index_type n = 1; n < count; ++n) sum = evaluated(sum + at(n) * w.next());
        } else {
            auto const& w = detail::kept_weights<G>(order.template as<S>(), count);
            for (index_type n = 1; n < count; ++n) sum = evaluated(sum + at(n) * w[static_cast<std::size_t>(n)]);
        }
        return evaluated(sum * detail::leading_factor<G>(f.root(), order));
    }
    static constexpr index_type ends = detail::weights_end<G, Order>;
};

namespace detail {

/// @throws error::invalid_parameter beyond 100, where powers of steps are hardly numbers
template <class S>
constexpr void require_order_of_difference(S const& alpha) {
    if (not(S(-100) <= alpha and alpha <= S(100)))
        error::raise<error::invalid_parameter>("the order of a fractional difference lies in [-100, 100], and this one is ", alpha);
}

/// The sum of two orders. @throws error::invalid_parameter beyond 100
template <int P, int Q, int R, int T>
constexpr auto sum_of_orders(fraction<P, Q>, fraction<R, T>) {
    constexpr long long above = static_cast<long long>(P) * T + static_cast<long long>(R) * Q, below = static_cast<long long>(Q) * T;
    constexpr long long divisor = std::gcd(above, below), p = above / divisor, q = below / divisor;
    static_assert(q <= std::numeric_limits<int>::max() and (p < 0 ? -p : p) <= std::numeric_limits<int>::max(),
                  "the sum of these two orders of fractional differences has a denominator beyond the range of int; take orders with a "
                  "common denominator, or the order as a number, Delta_minus(alpha)");
    static_assert(-100 * q <= p and p <= 100 * q, "the order of a fractional difference lies in [-100, 100]");
    return fraction<static_cast<int>(p), static_cast<int>(q)>{};
}
template <class O, class R>
constexpr auto sum_of_orders(O const& x, R const& y) {
    auto const add = [](auto const& a, auto const& b) {
        require_order_of_difference(b + a);
        return run_time<std::remove_cvref_t<decltype(a + b)>>{a + b};
    };
    if constexpr (requires { x.value; })
        return add(x.value, y.template as<std::remove_cvref_t<decltype(x.value)>>());
    else
        return add(x.template as<std::remove_cvref_t<decltype(y.value)>>(), y.value);
}

} // namespace detail

/// Delta^alpha Delta^beta = Delta^{alpha + beta}; order zero is the identity.
template <generating_function G, class O, class R, side Side, class W>
constexpr auto operator*(fractional_difference<G, O, Side, W> const& a, fractional_difference<G, R, Side, W> const& b) {
    auto const order = detail::sum_of_orders(a.order, b.order);
    return fractional_difference<G, std::remove_const_t<decltype(order)>, Side, W>{{}, order};
}
template <linear_map A, generating_function G, class O, class R, side Side, class W>
constexpr auto operator*(composition<A, fractional_difference<G, O, Side, W>> const& a, fractional_difference<G, R, Side, W> const& b) {
    return a.a * (a.b * b);
}
template <generating_function G, class O, class R, side Side, class W, linear_map B>
constexpr auto operator*(fractional_difference<G, O, Side, W> const& a, composition<fractional_difference<G, R, Side, W>, B> const& b) {
    return (a * b.a) * b.b;
}

/// f - f(a) on the points of Base, the argument of a Caputo derivative of order below 1. Its adjoint is the identity up to the first point.
template <class Base, class W>
struct from_start_on : linear_operator<from_start_on<Base, W>> {
    using from = Base;
    using to = Base;
    using from_weight = W;
    using to_weight = W;
    static constexpr reach reads = reach::causal().at<Base>();
    static constexpr auto name() { return fixed_text("from_start"); }
    template <int F, int B>
    constexpr auto image(domain<Base, F, B> const& d) const {
        if constexpr (F > 0)
            does_not_compile<"from_start subtracts the value at the first point, and this function lives on " +
                             domain<Base, F, B>::name()>{};
        return d;
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        return evaluated(f.get(i) - f.get(f.domain().first(f.root())));
    }
    constexpr auto adjoint() const { return identity_on<Base, W>{}; }
};
using from_start = from_start_on<nodes, continued_weight<nabla_weight>>; ///< with the weights of Delta_-^alpha
inline constexpr from_start minus_start{};
/// The same on T with points inside its steps, for the position of a Galerkin embedding.
template <int Parts>
inline constexpr from_start_on<subdivided<Parts>, natural_weight_t<fraction<1, 2>>> minus_start_inside{};

namespace detail {
template <int P, int Q>
struct order_of_difference {
    static constexpr bool valid = Q > 0 and -100LL * Q <= P and P <= 100LL * Q;
    static_assert(valid, "the order P/Q of a fractional difference has a positive denominator and lies in [-100, 100]");
    using type = reduced<valid ? P : 1, valid ? Q : 1>;
};
template <int P, int Q>
using order_in_type = typename order_of_difference<P, Q>::type;
template <int P, int Q>
struct order_of_caputo : order_of_difference<P, Q> {
    static_assert(0 < P and P <= Q, "the order P/Q of a Caputo difference lies in ]0, 1]: it is of f - f(a), without a derivative at a");
};
} // namespace detail

/// Delta_-^alpha and Delta_+^alpha (Gruenwald-Letnikov; of Riemann and Liouville's kind), alpha = P/Q; sums of order -alpha for alpha < 0.
template <int P, int Q>
inline constexpr fractional_difference<grunwald_letnikov, detail::order_in_type<P, Q>, side::minus> Delta_minus_alpha{};
template <int P, int Q>
inline constexpr fractional_difference<grunwald_letnikov, detail::order_in_type<P, Q>, side::plus> Delta_plus_alpha{};
/// (-Delta_+)^alpha, the power with the graininess mu.
template <int P, int Q>
inline constexpr fractional_difference<grunwald_letnikov, detail::order_in_type<P, Q>, side::plus, delta_weight> minus_Delta_plus_alpha{};
/// Delta_-^alpha with the weights of G: minus_alpha<bdf<2>, 1, 2> is the G^alpha of Galucio, Deue, Dubois (2).
template <generating_function G, int P, int Q>
inline constexpr fractional_difference<G, detail::order_in_type<P, Q>, side::minus> minus_alpha{};
/// Delta_-^alpha[f - f(a)], of Caputo's kind: zero for constants.
template <int P, int Q>
inline constexpr auto caputo_minus_alpha =
    fractional_difference<grunwald_letnikov, typename detail::order_of_caputo<P, Q>::type, side::minus>{} * minus_start;

/// The order known at run time: Delta_minus(alpha); the integer 1 is exact in every scalar. @throws error::invalid_parameter when it is
/// outside [-100, 100].
template <class Base, side Side>
template <scalar S>
constexpr auto derivative<Base, Side>::operator()(S alpha) const {
    static_assert(std::same_as<Base, nodes>, "fractional differences act on functions on T");
    detail::require_order_of_difference(alpha);
    return fractional_difference<grunwald_letnikov, run_time<S>, Side>{{}, {std::move(alpha)}};
}
template <class Base, side Side>
constexpr auto derivative<Base, Side>::operator()(int alpha) const {
    static_assert(std::same_as<Base, nodes>, "fractional differences act on functions on T");
    if (alpha != 1)
        error::raise<error::invalid_parameter>("a whole order of a fractional difference that is not 1 is in the type, as "
                                               "Delta_minus_alpha<2, 1>, or a number of the scalar, and this one is ",
                                               alpha);
    return fractional_difference<grunwald_letnikov, fraction<1>, Side>{};
}

} // namespace hilger
