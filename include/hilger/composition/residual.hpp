// SPDX-License-Identifier: BSL-1.0
// The equation is the judge of compositions and adjoints too. A composition of steps of length c_k h with discrete Lagrangians L_k is the
// motion of their sum over one step (Marsden-West 2001, section 2.5), and its equations are balances of momenta, at each point of T and at
// each position U_k between its parts:
//   d_2 L_k(U_{k-1}, U_k) + d_1 L_{k+1}(U_k, U_{k+1}) = 0
// A trajectory has no U_k. They are found part by part from its momentum at the beginning of the step; the last part has to lead to its
// next point, and to the momentum there. What the momenta before and after that part are off by is the residual.
//   largest_residual(stoermer_verlet(L).along(T, q0, p0))
//   largest_residual(stoermer_verlet(L), record(path))      states that were kept, or are another program's
#pragma once

#include <optional>
#include <vector>

#include "hilger/composition/composition.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "hilger/trajectory/recording.hpp"

namespace hilger {

namespace detail {

/// One part of a step, or a step that is none.
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
    /// x, with the momentum that it has arrived with, to the end of the part: *end, or where a step leads. `off` becomes at least the
    /// distance of that momentum from the one that the part begins with. `near` is a velocity near those of the step.
    void go(of const& f, state<S, V>& x, S const& h, V const& near, V const* end, S& off) {
        state<S, V> y = x;
        if (end != nullptr)
            y.q = *end;
        else {
            memory_.start_with(f, x, near);
            memory_.advance(f, y, h);
        }
        auto [before, after] = momenta_of_step(derivatives_, tableau_of(f.embedding(), h), x.t, h, x.q, y.q);
        off = larger(off, S(magnitude(V(x.p - before))));
        x = {S(x.t + h), std::move(y.q), std::move(after)};
    }

private:
    typename of::template memory<S, V> memory_;
    decltype(derivatives_at_nodes(std::declval<problem<F, Force> const&>())) derivatives_;
};

template <class Parts, class... Flows, class S, class V>
class judged_part<composed_flow<Parts, Flows...>, S, V> {
    using of = composed_flow<Parts, Flows...>;
    static constexpr std::size_t turns = Parts::size / sizeof...(Flows);
    using all = std::index_sequence_for<Flows...>;

public:
    judged_part(of const& f, S const& h, V const& like) : lengths_(whole<S>(f.parts())) {
        for (std::size_t turn = 0; turn < turns; ++turn) add(f, turn, h, like, all{});
    }
    void go(of const& f, state<S, V>& x, S const& h, V const& near, V const* end, S& off) {
        for (std::size_t turn = 0; turn < turns; ++turn) take(f, turn, x, h, near, end, off, all{});
    }

private:
    template <std::size_t... J>
    void add(of const& f, std::size_t turn, S const& h, V const& like, std::index_sequence<J...>) {
        (std::get<J>(parts_).emplace_back(std::get<J>(f.flows()), S(lengths_[turn * sizeof...(Flows) + J] * h), like), ...);
    }
    template <std::size_t... J>
    void take(of const& f, std::size_t turn, state<S, V>& x, S const& h, V const& near, V const* end, S& off, std::index_sequence<J...>) {
        auto const one = [&](std::size_t k, auto const& flow, auto& part) {
            part.go(flow, x, S(lengths_[k] * h), near, k + 1 == Parts::size ? end : nullptr, off);
        };
        (one(turn * sizeof...(Flows) + J, std::get<J>(f.flows()), std::get<J>(parts_)[turn]), ...);
    }
    std::array<S, Parts::size> lengths_;
    std::tuple<std::vector<judged_part<Flows, S, V>>...> parts_;
};

/// Of states at the points of T, one after the other, and the flow that should have walked them.
template <class Flow, class Scale, class States>
auto largest_residual_of_parts(Flow const& method, Scale const& T, States const& states) {
    auto at = std::begin(states);
    auto from = *at;
    using V = decltype(from.q);
    using S = decltype(from.t);
    std::optional<judged_part<Flow, S, V>> part;
    S worst(0);
    for (index_type i = T.first(); i < T.last(); ++i) {
        S const h = T.domain().base.step(T.root(), i);
        ++at;
        if (not part) part.emplace(method, h, from.q);
        S off(0);
        part->go(method, from, h, mean_velocity(from, *at), &at->q, off);
        worst = larger(worst, S(larger(off, S(magnitude(V(from.p - at->p)))) / magnitude(h)));
        from = *at;
    }
    return worst;
}
template <class Flow, class S, class V, class Scale>
auto largest_residual_of_parts(Flow const& method, recording<S, V, Scale> const& run) {
    require_complete(run);
    return largest_residual_of_parts(method, run.scale, run.states);
}

} // namespace detail

/// The largest component of what a trajectory leaves of the equations of a composition's parts, forces included, divided by the step: of
/// the size of the residual of one step (integrator/residual.hpp). @throws what walking does
template <class Parts, class... Flows, class Scale, class V>
auto largest_residual(trajectory<composed_flow<Parts, Flows...>, Scale, V> const& path) {
    return detail::largest_residual_of_parts(path.method(), path.scale(), path);
}
/// The same of an embedding that is read from the end of each step (composition/reversed.hpp).
template <class F, class Force, class E, sums Sums, class Scale, class V>
auto largest_residual(trajectory<flow<F, Force, reversed<E>, Sums>, Scale, V> const& path) {
    return detail::largest_residual_of_parts(path.method(), path.scale(), path);
}
/// The same of states that were kept, wherever they come from. @throws error::mismatch where there is not one at each point of their scale
template <class Parts, class... Flows, class S, class V, class Scale>
auto largest_residual(composed_flow<Parts, Flows...> const& method, recording<S, V, Scale> const& run) {
    return detail::largest_residual_of_parts(method, run);
}
template <class F, class Force, class E, sums Sums, class S, class V, class Scale>
auto largest_residual(flow<F, Force, reversed<E>, Sums> const& method, recording<S, V, Scale> const& run) {
    return detail::largest_residual_of_parts(method, run);
}

} // namespace hilger
