// SPDX-License-Identifier: BSL-1.0
// The times of a motion in a transformed time, dt = g(q) dtau, under a composition: the sum of g over the nodes of its parts. A trajectory
// has no positions inside a step. They are computed again, part by part, from its state at the beginning.
//   auto const path = compose(suzuki<4>, embed(transform_time(L, g, E), mid_point)).along(T, q0, p0);
//   auto const t = times_of(path);
#pragma once

#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "hilger/composition/residual.hpp"
#include "hilger/integrator/times.hpp"

namespace hilger {

namespace detail {

/// The integral of g over a part of a step, or over a step without parts. `rate` is a callable of positions with values in S.
template <class Flow, class S, class V>
class timed_part;

template <class F, class Force, class E, sums Sums, class S, class V>
class timed_part<flow<F, Force, E, Sums>, S, V> {
    using of = flow<F, Force, E, Sums>;
    static constexpr bool has_inner_points = controls_of<E> > 2;

public:
    timed_part(of const& f, S const& h, V const& like) : memory_(f, h, like) {}
    /// That over the length h from x, which becomes its end: at *end, or by a step. `near` is a velocity near that of the step.
    template <class G>
    S over(of const& f, state<S, V>& x, S const& h, V const& near, V const* end, G const& rate) {
        state<S, V> const from = x;
        if (end == nullptr or has_inner_points) {
            memory_.start_with(f, x, near);
            memory_.advance(f, x, h);
        }
        if (end != nullptr) x.q = *end;
        auto const b = tableau_of(f.embedding(), h);
        S sum(0);
        for (int k = 0; k < b.nodes; ++k) {
            V at = from.q * b.a(k, 0) + x.q * b.a(k, b.controls - 1);
            if constexpr (has_inner_points)
                for (int m = 1; m < b.controls - 1; ++m) at = at + V(from.q + memory_.inside(m)) * b.a(k, m);
            sum = sum + b.w(k) * positive_rate(S(rate(at)), from.t);
        }
        return sum;
    }

private:
    typename of::template memory<S, V> memory_;
};

template <class Parts, class... Flows, class S, class V>
class timed_part<composed_flow<Parts, Flows...>, S, V> {
    using of = composed_flow<Parts, Flows...>;

public:
    timed_part(of const& f, S const& h, V const& like) : lengths_(whole<S>(f.parts())) {
        for_each_part(f, parts_, [&](std::size_t k, auto const& flow, auto& list) { list.emplace_back(flow, S(lengths_[k] * h), like); });
    }
    template <class G>
    S over(of const& f, state<S, V>& x, S const& h, V const& near, V const* end, G const& rate) {
        S sum(0);
        for_each_part(f, parts_, [&](std::size_t k, auto const& flow, auto& list) {
            V const* const end_of_part = k + 1 == Parts::size ? end : nullptr;
            sum = sum + list[k / sizeof...(Flows)].over(flow, x, S(lengths_[k] * h), near, end_of_part, rate);
        });
        return sum;
    }

private:
    std::array<S, Parts::size> lengths_;
    std::tuple<std::vector<timed_part<Flows, S, V>>...> parts_;
};

/// The times of consecutive states at the points of T under a flow.
template <class Flow, class Scale, class States>
auto times_by_parts(Flow const& method, Scale const& T, States const& states) {
    auto at = std::begin(states);
    auto from = *at;
    using V = decltype(from.q);
    using S = decltype(from.t);
    auto const rate = [&](V const& q) { return rate_at(method.mechanics().lagrangian.rate, q); };
    std::optional<timed_part<Flow, S, V>> part;
    running_sum<S, S> t(S(0));
    t.add(from.t);
    std::vector<S> times{t.value()};
    for (index_type i = T.first(); i < T.last(); ++i) {
        S const h = T.domain().base.step(T.root(), i);
        ++at;
        if (not part) part.emplace(method, h, from.q);
        t.add(part->over(method, from, h, mean_velocity(from, *at), &at->q, rate));
        times.push_back(t.value());
        from = *at;
    }
    return function_on(scale_of_steps(T), std::move(times));
}

/// times_of(path) and times_of(method, recording), for compositions. @throws error::invalid_parameter where g is not positive; the errors
/// of the steps
template <class Flow, class Scale, class V>
    requires is_judged_by_parts<Flow>
auto judged(to_times const&, trajectory<Flow, Scale, V> const& path) { return times_by_parts(path.method(), path.scale(), path); }
template <class Flow, class S, class V, class Scale>
    requires is_judged_by_parts<Flow>
auto judged(to_times const&, Flow const& method, recording<S, V, Scale> const& run) {
    require_complete(run);
    return times_by_parts(method, run.scale, run.states);
}

} // namespace detail
} // namespace hilger
