// SPDX-License-Identifier: BSL-1.0
// The search for a step of up to four degrees of freedom, for a Lagrangian with branches or from a nearer guess; seldom needed. The numbers
// are passed one by one and by value: as arrays or captures they would be kept in memory in every step that succeeds.
#pragma once

#include <algorithm>
#include <array>

#include "hilger/newton/newton.hpp"
#include "hilger/newton/small_solve.hpp"
#include "hilger/step/small/node.hpp"
#include "hilger/step/state.hpp"

namespace hilger::detail {

/// Derivatives at one node, as node_jet has them, in arrays.
template <class S, std::size_t N>
struct small_table {
    std::array<S, N> by_q, by_v;
    std::array<S, N * N> qq, qv, vq, vv;
};

/// The step by a search (newton/newton.hpp, root_of_step). With branches: from the guess v, or else by continuation from the last velocity.
/// Without: by continuation from the last velocity; exact scalars search from there.
template <bool Compensated, class S, class V, class Components>
class small_search;
template <bool Compensated, class S, class V, int... K>
class small_search<Compensated, S, V, std::integer_sequence<int, K...>> {
    template <int>
    using number = S;
    using s = shape<V>;
    static constexpr std::size_t N = sizeof...(K);
    using components_ = std::array<S, N>;
    using matrix_ = std::array<S, N * N>;
    using table_ = small_table<S, N>;
    using derivatives_ = function_view<void(components_ const& q, components_ const& v, table_& to)>;
    struct node_values {
        components_ v, g;
    };

public:
    template <class Problem>
    [[gnu::noinline, gnu::cold]] static node_values root(Problem const& problem, bool has_branches, S t, S h, S to_node, S w, S c, S f,
                                                         number<K>... q, number<K>... p, number<K>... v, number<K>... last,
                                                         number<K>... resistance) {
        auto const derivatives = [&](components_ const& A, components_ const& B, table_& to) {
            auto const e = evaluate<s::is_scalar, false>(problem, S(t + to_node), A, B, std::integer_sequence<int, K...>{});
            [&]<int... M>(std::integer_sequence<int, M...>) {
                constexpr int n = static_cast<int>(N);
                to = {{S(e.template by_q<K>())...},          {S(e.template by_v<K>())...},          {S(e.template qq<M / n, M % n>())...},
                      {S(e.template qv<M / n, M % n>())...}, {S(e.template vq<M / n, M % n>())...}, {S(e.template vv<M / n, M % n>())...}};
            }
            (std::make_integer_sequence<int, static_cast<int>(N * N)>{});
        };
        return saying_where(state<S, V>{t, vector(q...), vector(p...)}, h, [&] {
            return searched(derivatives, has_branches, w, c, f, {q...}, {p...}, vector(v...), vector(last...), {resistance...});
        });
    }

private:
    static node_values searched(derivatives_ const& derivatives, bool has_branches, S const& w, S const& c, S const& f,
                                components_ const& q, components_ const& p, V v, V const& last, components_ const& resistance) {
        table_ e{};
        matrix_ J{};
        components_ A{}, B{};
        S share(1);
        // r = p + f g - dL/dv at (q + c v, v), less the resistance of a force that is affine in v; c and f of `share` times the step
        auto const evaluate_at = [&](V const& y, V& r) {
            S const to_node = share * c, by_force = share * f;
            for (std::size_t k = 0; k < N; ++k) {
                B[k] = s::component(y, static_cast<int>(k));
                A[k] = q[k] + to_node * B[k];
            }
            derivatives(A, B, e);
            // A non-finite slope of a force, as that of |q|^1.5 at 0, counts as 0 in a correction from there, which still leads on.
            for (auto* const slopes : {&e.qq, &e.qv, &e.vq})
                for (S& slope : *slopes)
                    if (not is_finite(slope)) slope = S(0);
            S sizes(0);
            for (std::size_t j = 0; j < N; ++j) {
                s::component(r, static_cast<int>(j)) = p[j] + by_force * e.by_q[j] - e.by_v[j] - share * resistance[j] * B[j];
                for (std::size_t jk = j * N; jk < j * N + N; ++jk) {
                    J[jk] = e.vv[jk] + to_node * e.vq[jk] - by_force * (to_node * e.qq[jk] + e.qv[jk]);
                    sizes = std::max(sizes, S(magnitude(S(by_force * e.qq[jk]))));
                }
                J[j * N + j] = J[j * N + j] + share * resistance[j];
            }
            return S(largest(p) + magnitude(by_force) * largest(e.by_q) +
                     S(static_cast<int>(N)) * (sizes * largest(A) + largest(J) * largest(B)));
        };
        matrix_ of_round{};
        auto const solve = [&](components_ r, V& d) {
            bool const regular = small_solve(of_round, r);
            d = vector(r[K]...);
            return regular;
        };
        V residual = v, none = v;
        auto const linearize = [&] {
            of_round = J;
            return solve({}, none);
        };
        auto const correct = [&](V const& r, V& d) { (void)solve({s::component(r, K)...}, d); };
        auto const set_share = [&](S const& of_step) { share = of_step; };
        newton_outcome const how = root_of_step<V>(has_branches, {evaluate_at, linearize, correct}, v, last, residual, set_share);
        if (how != newton_outcome::found) throw_newton_failure("the step p = -d_1 L_h(q, y)", how, v, residual);
        node_values const found{{s::component(v, K)...}, e.by_q};
        if (S const nan = std::numeric_limits<S>::is_exact
                              ? S(0)
                              : S((overflow(S(q[K] + w * found.v[K])) + ...) + (overflow(S(p[K] + w * found.g[K])) + ...));
            not(nan == S(0)))
            throw_newton_failure("the step p = -d_1 L_h(q, y)", newton_outcome::not_finite, v, v);
        return found;
    }
    static V vector(number<K>... x) {
        V y;
        ((s::component(y, K) = x), ...);
        return y;
    }
};

} // namespace hilger::detail
