// SPDX-License-Identifier: BSL-1.0
// What a step of a method needs for one scene: the operations that are left when nothing superfluous is made, and the numbers that are kept
// from step to step. The trajectory is walked with numbers that count (support/counted.hpp), so that nothing is estimated. Of a Lagrangian
// with cos(q) a force makes one sine and a second derivative one cosine: they count the evaluations.
#pragma once

#include <optional>

#include "hilger/trajectory/trajectory.hpp"
#include "support/counted.hpp"

namespace hilger::testing {

/// All per step, averaged, but for numbers that are kept: bytes when these are doubles.
struct requirements {
    double arithmetic = 0; ///< + - * / on which the states depend, each once
    double divisions = 0;  ///< of these
    double functions = 0;  ///< sqrt, sin, ... likewise
    double sines = 0, cosines = 0;
    index_type state_bytes = 0;        ///< t, q, p
    index_type memory_bytes = 0;       ///< every number beside them: first guesses, coefficients, room for vectors, histories
    double growth_in_bytes = 0;        ///< of memory_bytes
    std::optional<double> allocations; ///< where somebody counts them
};

/// As many steps as are wanted, from the beginning of T, in numbers made by `made`.
template <class To, class Scale, class Made>
auto scale_in(Scale const& T, index_type steps, Made const& made) {
    if constexpr (Scale::root_type::is_uniform and detail::has_equal_steps<typename Scale::domain_type::base_type>) {
        auto const h = T.domain().base.step(T.root(), T.first());
        return uniform(To(made(T.min())), To(made(h)), steps);
    } else {
        if (T.last() - T.first() < steps)
            error::raise<error::invalid_parameter>("the requirements of a step are counted along ", steps,
                                                   " steps, and this time scale has ", T.last() - T.first());
        std::vector<To> points;
        for (auto const& t : T) points.push_back(made(t));
        return time_scale<To>(std::move(points));
    }
}
template <class To, class V, class Made>
auto state_in(V const& x, Made const& made) {
    using s = detail::shape<V>;
    using result = typename s::template with<To>;
    result y = detail::shape<result>::zero(s::dimension(x));
    for (int k = 0; k < s::dimension(x); ++k) detail::shape<result>::component(y, k) = made(s::component(x, k));
    return y;
}
/// The same method from the same state, in other numbers.
template <class To, class Path, class Made>
auto path_in(Path const& path, index_type steps, Made const& made) {
    auto const start = *path.begin();
    return path.method().along(scale_in<To>(path.scale(), steps, made), state_in<To>(start.q, made), state_in<To>(start.p, made));
}

inline constexpr index_type steps_before_counting = 12; ///< until first guesses are made from as many steps as they ever are
inline constexpr index_type steps_after_counting = 10;  ///< until what is remembered of the counted steps has been used

/// What `steps` steps of the trajectory need on average, once the method has found its pace; from where it starts, with its step. It is
/// walked for 22 steps more than these, beyond its end if T is uniform, and a history has to be made for as many. The callables of the
/// method (Lagrangian, forces, loads) have to take any scalar; doubles in them are constants. `allocations` is a callable that returns how
/// often memory was asked for until now.
/// @throws error::invalid_parameter when T has too few steps; what walking throws
template <class Path, class Allocations = std::nullptr_t>
requirements requirements_of(Path const& path, index_type steps = 16, Allocations const& allocations = nullptr) {
    using S = typename std::remove_cvref_t<decltype(path.scale())>::root_type::scalar_type;
    if (steps < 1) error::raise<error::invalid_parameter>("the requirements of a step are counted along one step or more, not ", steps);
    auto const in_all = steps_before_counting + steps + steps_after_counting;
    auto const per_step = [&](auto n) { return static_cast<double>(n) / static_cast<double>(steps); };
    requirements r;
    {
        auto const counting = path_in<counted>(path, in_all, [](S const& x) { return counted::variable(static_cast<double>(x)); });
        auto& record = record_of_operations::of_this_thread();
        long long const others = record.numbers;
        auto at = counting.begin();
        auto const walk = [&](index_type n) {
            for (index_type i = 0; i < n; ++i) {
                record.next_step();
                ++at;
            }
        };
        walk(steps_before_counting);
        long long const before = record.numbers;
        record.begin();
        walk(steps);
        long long const after = record.numbers;
        record.stop_counting();
        walk(steps_after_counting);
        using s = detail::shape<std::remove_cvref_t<decltype(at->q)>>;
        auto const d = s::dimension(at->q);
        for (int k = 0; k < d; ++k) {
            s::component(at->q, k).need();
            s::component(at->p, k).need();
        }
        at->t.need();
        counts const n = record.end();
        r.arithmetic = per_step(n.arithmetic);
        r.divisions = per_step(n.divisions);
        r.functions = per_step(n.functions);
        r.sines = per_step(n.sines);
        r.cosines = per_step(n.cosines);
        constexpr index_type size = sizeof(double);
        r.state_bytes = size * (1 + 2 * d);
        r.memory_bytes = size * static_cast<index_type>(after - others) - r.state_bytes;
        r.growth_in_bytes = per_step(size * (after - before));
    }
    if constexpr (not std::same_as<Allocations, std::nullptr_t>) {
        auto const plain = path_in<S>(path, in_all, [](S const& x) { return x; });
        auto at = plain.begin();
        for (index_type i = 0; i < steps_before_counting; ++i) ++at;
        auto const before = allocations();
        for (index_type i = 0; i < steps; ++i) ++at;
        r.allocations = per_step(allocations() - before);
    }
    return r;
}

} // namespace hilger::testing
