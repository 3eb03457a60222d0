// SPDX-License-Identifier: BSL-1.0
// What a step of up to four degrees of freedom seldom comes to: how it fails, and the search for the step of a Lagrangian with branches, or
// from a nearer guess. The numbers are handed over one by one and by value: as arrays, or caught where the step is made, they would have to
// be in memory for this in every step that succeeds.
#pragma once

#include <functional>

#include "hilger/newton/on_branches.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/newton/small_stop.hpp"
#include "hilger/step/small/node.hpp"
#include "hilger/step/state.hpp"

namespace hilger::detail {

/// How a step fails.
template <class S, class V, class Components>
class small_failure;
template <class S, class V, int... K>
class small_failure<S, V, std::integer_sequence<int, K...>> {
    template <int>
    using number = S;

public:
    [[noreturn, gnu::noinline, gnu::cold]] static void tell(number<K>... v, number<K>... r, number<K>... d, bool singular) {
        bool const finite = is_finite(S((v + ...))) or singular;
        S const size = largest(std::array<S, sizeof...(K)>{d...});
        give_up("the step p = -d_1 L_h(q, y)", singular, vector(v...), finite ? vector(r...) : vector(v...), size);
    }
    [[noreturn, gnu::noinline, gnu::cold]] static void tell_where(S t, S h, number<K>... q, number<K>... p, number<K>... v, number<K>... r,
                                                                  number<K>... d, bool singular) {
        saying_where(state<S, V>{t, vector(q...), vector(p...)}, h, [&] { tell(v..., r..., d..., singular); });
        __builtin_unreachable();
    }
    static V vector(number<K>... x) {
        V y;
        ((shape<V>::component(y, K) = x), ...);
        return y;
    }
};

/// The step by a search: from the iterate v on, or else from the last velocity, until the equation holds at what is returned.
template <class Problem, bool Compensated, class S, class V, class Components>
class small_search;
template <class Problem, bool Compensated, class S, class V, int... K>
class small_search<Problem, Compensated, S, V, std::integer_sequence<int, K...>> {
    template <int>
    using number = S;
    using s = shape<V>;
    static constexpr int N = sizeof...(K);
    using components_ = std::array<S, sizeof...(K)>;
    using matrix_ = std::array<S, sizeof...(K) * sizeof...(K)>;
    struct node_values {
        components_ v, g;
    };

public:
    template <bool SayWhere>
    [[gnu::noinline, gnu::cold]] static node_values root(Problem const& problem, S t, S h, S node, S w, S c, S f, number<K>... q,
                                                         number<K>... p, number<K>... v, number<K>... last, number<K>... resistance) {
        node_values found{};
        auto const search = [&] {
            found = searched(problem, node, w, c, f, {q...}, vector(p...), vector(v...), vector(last...), {resistance...});
        };
        if constexpr (SayWhere)
            saying_where(state<S, V>{t, vector(q...), vector(p...)}, h, search);
        else
            search();
        return found;
    }

private:
    static node_values searched(Problem const& problem, S const& t, S const& w, S const& c, S const& f, components_ const& q, V const& p,
                                V v, V const& last, components_ const& resistance) {
        matrix_ J{};
        components_ g{};
        // r = p + f g - dL/dv at (q + c v, v), less the resistance of a force that is affine in v
        auto const evaluate_at = [&](V const& y, V& r) {
            components_ const B{s::component(y, K)...}, A{S(q[K] + c * B[K])...};
            auto const e = evaluate<s::is_scalar, false>(problem, t, A, B, std::integer_sequence<int, K...>{});
            g = {S(e.template by_q<K>())...};
            ((s::component(r, K) = s::component(p, K) + f * g[K] - e.template by_v<K>() - resistance[K] * B[K]), ...);
            matrix_ D{};
            S sizes(0);
            auto const row = [&]<int I>(std::integral_constant<int, I>) {
                ((D[I * N + K] = c * e.template qq<I, K>() + e.template qv<I, K>(),
                  J[I * N + K] = e.template vv<I, K>() + c * e.template vq<I, K>() - f * D[I * N + K],
                  sizes = std::max(sizes, S(magnitude(S(f * e.template qq<I, K>()))))),
                 ...);
            };
            (row(std::integral_constant<int, K>{}), ...);
            ((J[K * N + K] = J[K * N + K] + resistance[K]), ...);
            return S(magnitude(p) + magnitude(f) * largest(g) + S(N) * (sizes * largest(A) + largest(J) * magnitude(y)));
        };
        auto const correct = [&](V const& r, V& d) {
            components_ x{s::component(r, K)...};
            matrix_ copy = J;
            if (not small_solve(copy, x)) return false;
            d = vector(x[K]...);
            return true;
        };
        V residual = v;
        branch_search const how = search_branches_twice(v, last, residual, std::cref(evaluate_at), std::cref(correct),
                                                        S(square_root_of_epsilon<S>() * rest_of_newton<S, Compensated>()));
        if (how != branch_search::found) give_up_on_branches("the step p = -d_1 L_h(q, y)", how, v, residual);
        node_values const found{{s::component(v, K)...}, g};
        components_ const at_p{s::component(p, K)...};
        if (S const nan = std::numeric_limits<S>::is_exact
                              ? S(0)
                              : S((overflow(S(q[K] + w * found.v[K])) + ...) + (overflow(S(at_p[K] + w * g[K])) + ...));
            not(nan == S(0)))
            give_up_on_branches("the step p = -d_1 L_h(q, y)", branch_search::not_finite, v, v);
        return found;
    }
    static V vector(number<K>... x) { return small_failure<S, V, std::integer_sequence<int, K...>>::vector(x...); }
};

} // namespace hilger::detail
