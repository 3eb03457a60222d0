// SPDX-License-Identifier: BSL-1.0
// Exact first and second derivatives of a generic function of two arguments x and y, scalars or Eigen vectors of size d (fixed or dynamic).
// Gradients are columns like x; blocks are d x d, entry (j, k) = second derivative by component j of the first and k of the second named
// argument. For scalars all of them are scalars.
//
// Up to d = 4 by one evaluation with jets, in registers. Beyond, the function is traced into a graph, for the nonzero derivatives only.
#pragma once

#include "hilger/differentiation/jet/functions.hpp"
#include "hilger/differentiation/jet/vector.hpp"
#include "hilger/differentiation/traced/trace.hpp"
#include "hilger/inlining.hpp"
#include "hilger/shape.hpp"

namespace hilger {

/// The derivatives of f(q, v) to second order, and its degrees in q and v.
template <class V>
struct expansion {
    V by_q, by_v;
    block_of<V> qq, qv, vv;
    dependence on{dependence::no_polynomial, dependence::no_polynomial, true};
};

namespace detail {

inline constexpr int one_evaluation = 4; ///< the largest d for which one evaluation has all second derivatives

/// States whose Lagrangian is traced instead of evaluated with jets.
template <class V>
inline constexpr bool is_traced_state = shape<V>::size == Eigen::Dynamic or shape<V>::size > one_evaluation;

/// The value of a formula as a jet; plain numbers are constants.
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

/// f(q, v), or f(t, q, v), with all derivatives by q and v up to the order 1 or 2, d = N small. Flattened for built-in floating-point
/// types: the body of f is inlined before optimisation, and most derivatives turn out to be zeros and cost nothing. This requires f to be
/// called here on variables made here, and its result to be built in place: with a function that makes the variables a step takes several
/// times as long. The arithmetic of wide numbers is too long to be flattened.
#define HILGER_JETS_OF(name, inlined)                                                                                                      \
    template <int Order, bool Scalar, class F, class S, std::size_t Size, int... K, class... Time>                                         \
    inlined inline qv_jet<S, static_cast<int>(Size), Order> name(F const& f, std::array<S, Size> const& q, std::array<S, Size> const& v,   \
                                                                 std::integer_sequence<int, K...>, Time const&... t) {                     \
        constexpr int N = static_cast<int>(Size);                                                                                          \
        using J = qv_jet<S, N, Order>;                                                                                                     \
        if constexpr (Scalar) {                                                                                                            \
            auto const x = q_jet<S, N, Order>::variable(q[0], 0, {1, 0});                                                                  \
            auto const y = v_jet<S, N, Order>::variable(v[0], N, {0, 1});                                                                  \
            if constexpr (std::same_as<decltype(f(t..., x, y)), J>)                                                                        \
                return f(t..., x, y);                                                                                                      \
            else                                                                                                                           \
                return as_jet<J>(f(t..., x, y));                                                                                           \
        } else {                                                                                                                           \
            jet_vector<q_jet<S, N, Order>, N> x;                                                                                           \
            jet_vector<v_jet<S, N, Order>, N> y;                                                                                           \
            ((x(K) = q_jet<S, N, Order>::variable(q[K], K, {1, 0}), y(K) = v_jet<S, N, Order>::variable(v[K], N + K, {0, 1})), ...);       \
            if constexpr (std::same_as<decltype(f(t..., x, y)), J>)                                                                        \
                return f(t..., x, y);                                                                                                      \
            else                                                                                                                           \
                return as_jet<J>(f(t..., x, y));                                                                                           \
        }                                                                                                                                  \
    }
HILGER_JETS_OF(flat_jets_of, HILGER_FLATTEN)
HILGER_JETS_OF(plain_jets_of, )
#undef HILGER_JETS_OF
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

/// The vector x in jets without variables. Callables get these instead of numbers: max(q(0), 0.0) is found, and comparisons are recorded.
template <class V>
auto in_constants(V const& x) {
    return with_variables<jet<scalar_of<V>, 0, 1, 1>, 1>(x, shape<V>::dimension(x), 0, {});
}
/// f(x, y), a number; a callable with its own derivatives takes plain numbers.
template <class F, class V, class W>
scalar_of<V> number_from(F const& f, V const& x, W const& y) {
    if constexpr (requires { f.expand(x, y); })
        return scalar_of<V>(f(x, y));
    else
        return as_jet<jet<scalar_of<V>, 0, 1, 1>>(call(f, in_constants(x), in_constants(y))).value;
}

/// The gradient at x of `evaluate`, a function of vectors of jets.
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

/// Derivatives by a graph, in any dimension; second derivatives by the arguments in `seconds_by`.
template <class F, class V>
traced_there<V> trace_there(F const& f, V const& q, V const& v, std::uint8_t seconds_by) {
    using T = traced<scalar_of<V>>;
    return {q, v, seconds_by, [&](auto const& x, auto const& y, std::vector<T>&) { return as_jet<T>(call(f, x, y)); }};
}
template <class F, class V>
expansion<V> expand_traced(F const& f, V const& q, V const& v) {
    using s = shape<V>;
    auto const there = trace_there(f, q, v, on_position | on_velocity);
    auto const& at = there.formula.places;
    auto const block = [&](block_number number) {
        block_of<V> made = s::zero_block(s::dimension(q));
        there.for_each_in(number, [&](int row, int column, auto const& x) { s::entry(made, row, column) = x; });
        return made;
    };
    dependence const on{at.degree(block_qq), at.degree(block_vv), not at.entries[block_vq].empty()};
    return {there.by_q, there.by_v, block(block_qq), block(block_qv), block(block_vv), on};
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
    else if constexpr (detail::is_traced_state<V> and std::same_as<V, W>)
        return detail::trace_there(f, x, y, detail::on_nothing).by_q;
    else
        return detail::gradient_by(x, [&, constant = detail::in_constants(y)](auto const& z) { return detail::call(f, z, constant); });
}
/// df/dy (x, y)
template <class F, class V, class W>
W gradient_second(F const& f, V const& x, W const& y) {
    if constexpr (requires { f.expand(x, y); })
        return f.expand(x, y).by_v;
    else if constexpr (detail::is_traced_state<V> and std::same_as<V, W>)
        return detail::trace_there(f, x, y, detail::on_nothing).by_v;
    else
        return detail::gradient_by(y, [&, constant = detail::in_constants(x)](auto const& z) { return detail::call(f, constant, z); });
}

/// All first and second derivatives of f at (q, v): by a member expand(q, v) of f if there is one, else by jets or a graph. Such a member
/// is one formula: numbers do not record comparisons (differentiation/branches.hpp).
template <class F, class V>
expansion<V> expand(F const& f, V const& q, V const& v) {
    using s = detail::shape<V>;
    if constexpr (requires { f.expand(q, v); })
        return f.expand(q, v);
    else if constexpr (detail::is_traced_state<V>)
        return detail::expand_traced(f, q, v);
    else {
        constexpr std::make_integer_sequence<int, s::size> all;
        return detail::unpacked<V>(detail::jets_of<2, s::is_scalar>(f, detail::components(q, all), detail::components(v, all), all), all);
    }
}

} // namespace hilger
