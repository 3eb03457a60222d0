// SPDX-License-Identifier: BSL-1.0
// The residual of compositions and adjoints. A composition of steps of length c_k h with discrete Lagrangians L_k is the motion of their
// sum over one step (Marsden-West 2001, section 2.5), and its equations are balances of momenta, at each point of T and at each position
// U_k between its parts:
//   d_2 L_k(U_{k-1}, U_k) + d_1 L_{k+1}(U_k, U_{k+1}) = 0
// A trajectory has no U_k. They are computed part by part from its momentum at the beginning of the step; the last part must lead to its
// next point, with the momentum there. The residual is the error of the momenta before and after that part.
//   largest_residual(stoermer_verlet(L).along(T, q0, p0))
//   largest_residual(stoermer_verlet(L), record(path))      states that were kept, or are another program's
#pragma once

#include <concepts>
#include <optional>
#include <utility>
#include <vector>

#include "hilger/composition/composition.hpp"
#include "hilger/integrator/residual.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "hilger/trajectory/recording.hpp"

namespace hilger {

namespace detail {

/// The largest difference of momenta between the parts of a step, or the largest in roundings of its own terms.
template <class Judge, class S>
struct differences_of_momenta {
    static constexpr bool relative = std::same_as<Judge, by_rounding>;
    S largest{0};
    template <class V>
    void add(V const& difference, V const& size, S const& h) {
        largest = larger(largest, relative ? S(largest_in_roundings(difference, size)) : S(magnitude(difference) / magnitude(h)));
    }
};
/// The sums of the sizes of the terms of momenta_of_step, and of their changes by the rounding of q0 and q1.
template <class Derivatives, class S, class V>
std::pair<V, V> sizes_of_momenta(Derivatives const& derivatives, tableau<S> const& b, S const& t, S const& h, V const& q0, V const& q1) {
    V before = zero_like(q0), after = before;
    for (int k = 0; k < b.nodes; ++k) {
        auto const sum = [&](S const& first, S const& last) { return V(sizes(q0) * S(magnitude(first)) + sizes(q1) * S(magnitude(last))); };
        V const of_q = sum(b.a(k, 0), b.a(k, 1)), of_v = sum(b.b(k, 0), b.b(k, 1));
        auto const at =
            derivatives.expand(b.part_of(k), b.time(k, t, h), V(q0 * b.a(k, 0) + q1 * b.a(k, 1)), V(q0 * b.b(k, 0) + q1 * b.b(k, 1)));
        V force = sizes(V(at.e.by_q)), momentum = sizes(V(at.e.by_v));
        add_sizes(force, at.e.qq, of_q);
        add_sizes(force, at.e.qv, of_v);
        add_sizes(momentum, at.vq_, of_q);
        add_sizes(momentum, at.e.vv, of_v);
        auto const add = [&](V& to, int end) {
            to = to + force * S(magnitude(S(b.w(k) * b.a(k, end)))) + momentum * S(magnitude(S(b.w(k) * b.b(k, end))));
        };
        add(before, 0);
        add(after, 1);
    }
    return {std::move(before), std::move(after)};
}

/// One part of a step, or a step without parts.
template <class Flow, class S, class V>
class judged_part;

template <class F, class Force, class E, sums Sums, class S, class V>
class judged_part<flow<F, Force, E, Sums>, S, V> {
    static_assert(controls_of<E> == 2,
                  "parts of a step with positions inside, as Galerkin's, have equations in positions that a trajectory "
                  "does not have: judge them alone");
    using of = flow<F, Force, E, Sums>;

public:
    judged_part(of const& f, S const& h, V const& like) : memory_(f, h, like), derivatives_(derivatives_at_nodes(f.mechanics())) {}
    /// Advances x, with the momentum from the part before and the size of its terms, to the end of this part: *end, or the result of a
    /// step. `off` receives the distance of that momentum from the one at the start of this part. `near` is a velocity near those of the
    /// step of length `whole`.
    template <class Differences>
    void go(of const& f, state<S, V>& x, V& size, S const& h, V const& near, V const* end, S const& whole, Differences& off) {
        state<S, V> y = x;
        if (end != nullptr)
            y.q = *end;
        else {
            memory_.start_with(f, x, near);
            memory_.advance(f, y, h);
        }
        auto const b = tableau_of(f.embedding(), h);
        auto [before, after] = momenta_of_step(derivatives_, b, x.t, h, x.q, y.q);
        auto of_terms = std::pair{size, size}; // nobody asks for them
        if constexpr (Differences::relative) of_terms = sizes_of_momenta(derivatives_, b, x.t, h, x.q, y.q);
        off.add(V(x.p - before), V(size + of_terms.first), whole);
        size = std::move(of_terms.second);
        x = {S(x.t + h), std::move(y.q), std::move(after)};
    }

private:
    typename of::template memory<S, V> memory_;
    decltype(derivatives_at_nodes(std::declval<problem<F, Force> const&>())) derivatives_;
};

template <class Parts, class... Flows, class S, class V>
class judged_part<composed_flow<Parts, Flows...>, S, V> {
    using of = composed_flow<Parts, Flows...>;

public:
    judged_part(of const& f, S const& h, V const& like) : lengths_(whole<S>(f.parts())) {
        for_each_part(f, parts_, [&](std::size_t k, auto const& flow, auto& list) { list.emplace_back(flow, S(lengths_[k] * h), like); });
    }
    template <class Differences>
    void go(of const& f, state<S, V>& x, V& size, S const& h, V const& near, V const* end, S const& whole, Differences& off) {
        for_each_part(f, parts_, [&](std::size_t k, auto const& flow, auto& list) {
            V const* const end_of_part = k + 1 == Parts::size ? end : nullptr;
            list[k / sizeof...(Flows)].go(flow, x, size, S(lengths_[k] * h), near, end_of_part, whole, off);
        });
    }

private:
    std::array<S, Parts::size> lengths_;
    std::tuple<std::vector<judged_part<Flows, S, V>>...> parts_;
};

/// The residual of consecutive states at the points of T under a flow.
template <class Judge, class Flow, class Scale, class States>
auto judged_parts(Judge const&, Flow const& method, Scale const& T, States const& states) {
    auto at = std::begin(states);
    auto from = *at;
    using V = decltype(from.q);
    using S = decltype(from.t);
    std::optional<judged_part<Flow, S, V>> part;
    differences_of_momenta<Judge, S> off;
    for (index_type i = T.first(); i < T.last(); ++i) {
        S const h = T.domain().base.step(T.root(), i);
        ++at;
        if (not part) part.emplace(method, h, from.q);
        V size = sizes(from.p);
        part->go(method, from, size, h, mean_velocity(from, *at), &at->q, h, off);
        off.add(V(from.p - at->p), V(size + sizes(at->p)), h);
        from = *at;
    }
    return off.largest;
}

/// Compositions, and embeddings that are read from the end of each step (composition/reversed.hpp).
template <class Flow>
inline constexpr bool is_judged_by_parts = false;
template <class Parts, class... Flows>
inline constexpr bool is_judged_by_parts<composed_flow<Parts, Flows...>> = true;
template <class F, class Force, class E, sums Sums>
inline constexpr bool is_judged_by_parts<flow<F, Force, reversed<E>, Sums>> = true;

/// The residual of a trajectory in the equations of the parts, forces included, divided by the step: of the size of that of one step
/// (integrator/residual.hpp).
template <class Judge, class Flow, class Scale, class V>
    requires is_judged_by_parts<Flow>
auto judged(Judge const& judge, trajectory<Flow, Scale, V> const& path) { return judged_parts(judge, path.method(), path.scale(), path); }
/// The same for recorded states, of any origin.
template <class Judge, class Flow, class S, class V, class Scale>
    requires is_judged_by_parts<Flow>
auto judged(Judge const& judge, Flow const& method, recording<S, V, Scale> const& run) {
    require_complete(run);
    return judged_parts(judge, method, run.scale, run.states);
}

} // namespace detail
} // namespace hilger
