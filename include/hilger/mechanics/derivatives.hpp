// SPDX-License-Identifier: BSL-1.0
// Exact first and second derivatives of a generic function of two arguments x and y, scalars or Eigen vectors of size d (fixed or dynamic),
// by jets. Gradients are columns like x; blocks are d x d, entry (j, k) = second derivative by component j of the first and k of the second
// named argument. For scalars all of them are scalars.
//
// Up to d = 4 one evaluation gives everything. Beyond, the Hessian is put together from evaluations with eight variables at a time:
// right for any d, and as slow as d^2; a system of that size has a structure that its author knows (hilger/mechanics/mechanical.hpp).
#pragma once

#include "hilger/inlining.hpp"
#include "hilger/mechanics/jet_functions.hpp"
#include "hilger/mechanics/shape.hpp"

namespace hilger {

/// The expansion of f(q, v) to second order.
template <class V>
struct expansion {
    V by_q, by_v;
    block_of<V> qq, qv, vv;
    dependence on{dependence::no_polynomial, dependence::no_polynomial, true};
};

namespace detail {

inline constexpr int one_evaluation = 4; ///< the largest d for which one evaluation has all second derivatives
inline constexpr int chunk = 4;

/// What a formula returns when given jets; plain numbers are constants.
template <class Jet, class R>
HILGER_ALWAYS_INLINE constexpr Jet as_jet(R const& r) {
    static_assert(std::constructible_from<Jet, plain_t<R>>,
                  "a Lagrangian or Hamiltonian returns a number, and this one returns something else");
    return Jet(r);
}

template <bool Callable>
constexpr void require_callable() {
    static_assert(Callable, "a Lagrangian or Hamiltonian takes two states of any number type, as [](auto const& q, auto const& v) does, "
                            "or the time before them: derivatives pass through it");
}
template <class F, class X, class Y>
HILGER_ALWAYS_INLINE constexpr auto call(F const& f, X const& x, Y const& y) {
    require_callable<std::invocable<F const&, X const&, Y const&>>();
    return value_from(f, x, y);
}

template <class S, int N, int Order = 2>
using q_jet = jet<S, 0, N, Order>;
template <class S, int N, int Order = 2>
using v_jet = jet<S, N, N, Order>;
template <class S, int N, int Order = 2>
using qv_jet = jet<S, 0, 2 * N, Order>;

/// f(q, v), or f(t, q, v), and all its derivatives by q and v up to the order 1 or 2, d = N small. For the processor's own numbers this is
/// flattened: the body of f is inlined here before anything is optimised, and then most derivatives of a formula turn out to be zeros and
/// cost nothing. That takes f being called from here on variables made here, and its result being built in place: with the variables made
/// by a function of their own a step takes several times as long. A wide number's arithmetic is too long to be flattened.
template <int Order, bool Scalar, class F, class S, std::size_t Size, int... K, class... Time>
HILGER_FLATTEN inline qv_jet<S, static_cast<int>(Size), Order>
flat_jets_of(F const& f, std::array<S, Size> const& q, std::array<S, Size> const& v, std::integer_sequence<int, K...>, Time const&... t) {
    constexpr int N = static_cast<int>(Size);
    using J = qv_jet<S, N, Order>;
    if constexpr (Scalar) {
        auto const x = q_jet<S, N, Order>::variable(q[0], 0, {1, 0});
        auto const y = v_jet<S, N, Order>::variable(v[0], N, {0, 1});
        if constexpr (std::same_as<decltype(f(t..., x, y)), J>)
            return f(t..., x, y);
        else
            return as_jet<J>(f(t..., x, y));
    } else {
        Eigen::Matrix<q_jet<S, N, Order>, N, 1> x;
        Eigen::Matrix<v_jet<S, N, Order>, N, 1> y;
        ((x(K) = q_jet<S, N, Order>::variable(q[K], K, {1, 0}), y(K) = v_jet<S, N, Order>::variable(v[K], N + K, {0, 1})), ...);
        if constexpr (std::same_as<decltype(f(t..., x, y)), J>)
            return f(t..., x, y);
        else
            return as_jet<J>(f(t..., x, y));
    }
}
/// The same as a function of its own.
template <int Order, bool Scalar, class F, class S, std::size_t Size, int... K, class... Time>
qv_jet<S, static_cast<int>(Size), Order> plain_jets_of(F const& f, std::array<S, Size> const& q, std::array<S, Size> const& v,
                                                       std::integer_sequence<int, K...>, Time const&... t) {
    constexpr int N = static_cast<int>(Size);
    using J = qv_jet<S, N, Order>;
    if constexpr (Scalar)
        return as_jet<J>(f(t..., q_jet<S, N, Order>::variable(q[0], 0, {1, 0}), v_jet<S, N, Order>::variable(v[0], N, {0, 1})));
    else {
        Eigen::Matrix<q_jet<S, N, Order>, N, 1> x;
        Eigen::Matrix<v_jet<S, N, Order>, N, 1> y;
        ((x(K) = q_jet<S, N, Order>::variable(q[K], K, {1, 0}), y(K) = v_jet<S, N, Order>::variable(v[K], N + K, {0, 1})), ...);
        return as_jet<J>(f(t..., x, y));
    }
}
template <int Order, bool Scalar, class F, class S, std::size_t Size, int... K, class... Time>
qv_jet<S, static_cast<int>(Size), Order> jets_of(F const& f, std::array<S, Size> const& q, std::array<S, Size> const& v,
                                                 std::integer_sequence<int, K...> all, Time const&... t) {
    if constexpr (std::is_floating_point_v<S>)
        return flat_jets_of<Order, Scalar>(f, q, v, all, t...);
    else
        return plain_jets_of<Order, Scalar>(f, q, v, all, t...);
}

/// The vector x in jets of any kind: components first ... first + C - 1 are the variables number at ... at + C - 1.
template <class Jet, int C, class V>
auto with_variables(V const& x, int first, int at, dependence on) {
    using s = shape<V>;
    typename s::template with<Jet> y;
    if constexpr (s::size == Eigen::Dynamic) y.resize(s::dimension(x));
    for (int k = 0; k < s::dimension(x); ++k)
        s::component(y, k) = k >= first and k < first + C ? Jet::variable(s::component(x, k), at + k - first, on) : Jet(s::component(x, k));
    return y;
}

/// The vector x in jets without variables. Callables are given these where numbers would do: max(q(0), 0.0) is found for them, and what
/// they compare is written down.
template <class V>
auto in_constants(V const& x) {
    return with_variables<jet<scalar_of<V>, 0, 1, 1>, 1>(x, shape<V>::dimension(x), 0, {});
}
/// f(x, y), a number; plain numbers are what a callable with its own derivatives takes.
template <class F, class V, class W>
scalar_of<V> number_from(F const& f, V const& x, W const& y) {
    if constexpr (requires { f.expand(x, y); })
        return scalar_of<V>(f(x, y));
    else
        return as_jet<jet<scalar_of<V>, 0, 1, 1>>(call(f, in_constants(x), in_constants(y))).value;
}

/// The gradient of f by the variables that `make` puts into its arguments.
template <class V, class Evaluate>
V gradient_by(V const& x, Evaluate const& evaluate) {
    using s = shape<V>;
    constexpr int C = s::size == Eigen::Dynamic or s::size > 8 ? 8 : s::size;
    using J = jet<scalar_of<V>, 0, C, 1>;
    V g = s::zero(s::dimension(x));
    for (int first = 0; first < s::dimension(x); first += C) {
        J const value = as_jet<J>(evaluate(with_variables<J, C>(x, first, 0, {})));
        [&]<int... K>(std::integer_sequence<int, K...>) {
            ((first + K < s::dimension(x) ? void(s::component(g, first + K) = value.template by<K>()) : void()), ...);
        }
        (std::make_integer_sequence<int, C>{});
    }
    return g;
}

/// Second derivatives by components j ... of the one argument and k ... of the other, in blocks of chunk x chunk. Evaluate takes the two
/// numbers of the first components (-1: none) and returns a jet in 2 * chunk variables.
template <class Jet, class Block>
void copy_block(Jet const& value, Block& to, int j, int k, int d) {
    for (int a = 0; a < chunk and j + a < d; ++a)
        for (int b = 0; b < chunk and k + b < d; ++b) to(j + a, k + b) = value.derivative(chunk + b, a);
}
template <class F, class V>
expansion<V> expand_in_chunks(F const& f, V const& q, V const& v) {
    using s = shape<V>;
    using J = jet<scalar_of<V>, 0, 2 * chunk, 2>;
    int const d = s::dimension(q);
    expansion<V> e{s::zero(d), s::zero(d), s::zero_block(d), s::zero_block(d), s::zero_block(d), {}};
    dependence const of_q{1, 0}, of_v{0, 1};
    auto const gradient = [&](J const& value, int j, V& to) {
        for (int a = 0; a < chunk and j + a < d; ++a) to(j + a) = value.derivative(a);
    };
    // Two different chunks of variables at a time; on the diagonal the second copy is taken from a shifted evaluation.
    for (int j = 0; j < d; j += chunk) {
        for (int k = 0; k < d; k += chunk) {
            auto y = with_variables<J, chunk>(v, k, chunk, of_v);
            auto const value = as_jet<J>(call(f, with_variables<J, chunk>(q, j, 0, of_q), y));
            copy_block(value, e.qv, j, k, d);
            e.on = e.on + value.on;
            if (k == 0) gradient(value, j, e.by_q);
        }
        for (int k = j; k < d; k += chunk) {
            auto const both = [&](V const& z, dependence on) {
                auto y = with_variables<J, chunk>(z, j, 0, on);
                for (int b = 0; b < chunk and k + b < d; ++b)
                    if (k != j) y(k + b) = J::variable(z(k + b), chunk + b, on);
                return y;
            };
            auto const in_q = as_jet<J>(call(f, both(q, of_q), with_variables<J, chunk>(v, d, 0, {})));
            auto const in_v = as_jet<J>(call(f, with_variables<J, chunk>(q, d, 0, {}), both(v, of_v)));
            e.on = e.on + in_q.on + in_v.on;
            if (k == j) {
                gradient(in_v, j, e.by_v);
                for (int a = 0; a < chunk and j + a < d; ++a)
                    for (int b = 0; b <= a; ++b) {
                        e.qq(j + a, j + b) = e.qq(j + b, j + a) = in_q.derivative(a, b);
                        e.vv(j + a, j + b) = e.vv(j + b, j + a) = in_v.derivative(a, b);
                    }
            } else {
                copy_block(in_q, e.qq, j, k, d);
                copy_block(in_v, e.vv, j, k, d);
                for (int a = 0; a < chunk and j + a < d; ++a)
                    for (int b = 0; b < chunk and k + b < d; ++b) {
                        e.qq(k + b, j + a) = e.qq(j + a, k + b);
                        e.vv(k + b, j + a) = e.vv(j + a, k + b);
                    }
            }
        }
    }
    return e;
}

/// by_v and vv alone, a third of the evaluations.
template <class F, class V>
expansion<V> expand_second_in_chunks(F const& f, V const& q, V const& v) {
    using s = shape<V>;
    using J = jet<scalar_of<V>, 0, 2 * chunk, 2>;
    int const d = s::dimension(q);
    expansion<V> e{{}, s::zero(d), {}, {}, s::zero_block(d), {}};
    dependence const of_v{0, 1};
    auto const x = with_variables<J, chunk>(q, d, 0, {});
    for (int j = 0; j < d; j += chunk)
        for (int k = j; k < d; k += chunk) {
            auto y = with_variables<J, chunk>(v, j, 0, of_v);
            for (int b = 0; b < chunk and k + b < d; ++b)
                if (k != j) y(k + b) = J::variable(v(k + b), chunk + b, of_v);
            auto const value = as_jet<J>(call(f, x, y));
            e.on = e.on + value.on;
            if (k != j)
                copy_block(value, e.vv, j, k, d);
            else
                for (int a = 0; a < chunk and j + a < d; ++a) {
                    e.by_v(j + a) = value.derivative(a);
                    for (int b = 0; b < chunk and j + b < d; ++b) e.vv(j + a, j + b) = value.derivative(std::max(a, b), std::min(a, b));
                }
        }
    for (int j = 0; j < d; ++j)
        for (int k = 0; k < j; ++k) e.vv(j, k) = e.vv(k, j);
    return e;
}

template <class V, class Jet, int... K>
expansion<V> unpacked(Jet const& z, std::integer_sequence<int, K...>) {
    using s = shape<V>;
    constexpr int N = s::size;
    expansion<V> e;
    e.on = z.on;
    auto const row = [&]<int J>(std::integral_constant<int, J>) {
        s::component(e.by_q, J) = z.template by<J>();
        s::component(e.by_v, J) = z.template by<N + J>();
        ((s::entry(e.qq, J, K) = z.template by<std::max(J, K), std::min(J, K)>(), s::entry(e.qv, J, K) = z.template by<N + K, J>(),
          s::entry(e.vv, J, K) = z.template by<N + std::max(J, K), N + std::min(J, K)>()),
         ...);
    };
    (row(std::integral_constant<int, K>{}), ...);
    return e;
}
template <class V, int... K>
auto components(V const& x, std::integer_sequence<int, K...>) {
    return std::array<scalar_of<V>, sizeof...(K)>{shape<V>::component(x, K)...};
}

} // namespace detail

/// df/dx (x, y)
template <class F, class V, class W>
V gradient_first(F const& f, V const& x, W const& y) {
    if constexpr (requires { f.expand(x, y); })
        return f.expand(x, y).by_q;
    else
        return detail::gradient_by(x, [&, constant = detail::in_constants(y)](auto const& z) { return detail::call(f, z, constant); });
}
/// df/dy (x, y)
template <class F, class V, class W>
W gradient_second(F const& f, V const& x, W const& y) {
    if constexpr (requires { f.expand(x, y); })
        return f.expand(x, y).by_v;
    else
        return detail::gradient_by(y, [&, constant = detail::in_constants(x)](auto const& z) { return detail::call(f, constant, z); });
}

/// All first and second derivatives of f at (q, v): the user's own when f has a member expand(q, v), else by jets. A member of one's own
/// is one formula: jets write down what they are compared with (mechanics/branches.hpp), numbers do not.
template <class F, class V>
expansion<V> expand(F const& f, V const& q, V const& v) {
    using s = detail::shape<V>;
    if constexpr (requires { f.expand(q, v); })
        return f.expand(q, v);
    else if constexpr (s::size == Eigen::Dynamic or s::size > detail::one_evaluation)
        return detail::expand_in_chunks(f, q, v);
    else {
        constexpr std::make_integer_sequence<int, s::size> all;
        return detail::unpacked<V>(detail::jets_of<2, s::is_scalar>(f, detail::components(q, all), detail::components(v, all), all), all);
    }
}

/// Of the second argument alone, at least: by_v and vv.
template <class F, class V>
expansion<V> expand_second(F const& f, V const& q, V const& v) {
    using s = detail::shape<V>;
    if constexpr (requires { f.expand(q, v); } or not(s::size == Eigen::Dynamic or s::size > detail::one_evaluation))
        return expand(f, q, v);
    else
        return detail::expand_second_in_chunks(f, q, v);
}

} // namespace hilger
