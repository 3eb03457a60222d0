// SPDX-License-Identifier: BSL-1.0
// What a step of a method needs for one scene: how often it evaluates forces and which second derivatives it reads, what it iterates,
// solves and factorizes, how many operations are left when nothing superfluous is made, and how many numbers are kept from step to step.
// The trajectory is walked with numbers that count (hilger/trajectory/counted.hpp), so that nothing is estimated.
//   write_heading(std::cout) << requirements_row{"mid-point", requirements_of(embed(L, mid_point).along(T, q0, p0))};
#pragma once

#include <iomanip>
#include <optional>
#include <ostream>
#include <string>

#include "hilger/trajectory/counted.hpp"
#include "hilger/trajectory/trajectory.hpp"

namespace hilger {

/// All per step, averaged, but for what is kept: bytes when numbers are doubles.
struct requirements {
    double forces = 0;             ///< dL/dq at one point (all of its components)
    double second_derivatives = 0; ///< of L, those that are read and are no constants; symmetric ones once
    double newton_rounds = 0;      ///< none where the equation of a step says what it is solved by
    double solves = 0;             ///< linear systems, of any size but with constant coefficients
    double factorizations = 0;
    double arithmetic = 0;      ///< + - * / on which the states depend, each once
    double functions = 0;       ///< sqrt, sin, ... likewise
    index_type state_bytes = 0; ///< t, q, p
    index_type memory_bytes =
        0;                    ///< every number that the method keeps beside them: first guesses, coefficients, room for vectors, histories
    index_type histories = 0; ///< components with a history
    index_type history_bytes = 0;      ///< of memory_bytes, in engines of histories
    double growth_in_bytes = 0;        ///< of memory_bytes
    std::optional<double> allocations; ///< where somebody counts them
};

namespace detail {

/// As many steps as are wanted, from the beginning of T, in numbers made by `made`.
template <class To, class Scale, class Made>
auto scale_in(Scale const& T, index_type steps, Made const& made) {
    if constexpr (Scale::root_type::is_uniform and has_equal_steps<typename Scale::domain_type::base_type>) {
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
    using s = shape<V>;
    using result = typename s::template with<To>;
    result y = shape<result>::zero(s::dimension(x));
    for (int k = 0; k < s::dimension(x); ++k) shape<result>::component(y, k) = made(s::component(x, k));
    return y;
}
/// The same method from the same state, in other numbers.
template <class To, class Path, class Made>
auto path_in(Path const& path, index_type steps, Made const& made) {
    auto const start = *path.begin();
    auto const walk = [&](auto const& method) {
        return method.along(scale_in<To>(path.scale(), steps, made), state_in<To>(start.q, made), state_in<To>(start.p, made));
    };
    if constexpr (requires { path.method().template in_numbers<To>(); })
        return walk(path.method().template in_numbers<To>());
    else
        return walk(path.method());
}

inline constexpr index_type steps_before_counting = 12; ///< until first guesses are made from as many steps as they ever are
inline constexpr index_type steps_after_counting = 10;  ///< until what is remembered of the counted steps has been used

} // namespace detail

/// What `steps` steps of the trajectory need on average, once the method has found its pace; from where it starts, with its step. It is
/// walked for 22 steps more than these, beyond its end if T is uniform, and a history has to be made for as many. The callables of the
/// method (Lagrangian, forces, loads) have to take any scalar; doubles in them are constants. `allocations` is a callable that returns how
/// often memory was asked for until now.
/// @throws error::invalid_parameter when T has too few steps; what walking throws
template <class Path, class Allocations = std::nullptr_t>
requirements requirements_of(Path const& path, index_type steps = 16, Allocations const& allocations = nullptr) {
    using namespace detail;
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
        auto const d = shape<std::remove_cvref_t<decltype(at->q)>>::dimension(at->q);
        for (int k = 0; k < d; ++k) {
            shape<std::remove_cvref_t<decltype(at->q)>>::component(at->q, k).need();
            shape<std::remove_cvref_t<decltype(at->q)>>::component(at->p, k).need();
        }
        at->t.need();
        counts n = record.end();
        r.forces = per_step(n.of(work::force));
        r.newton_rounds = per_step(n.of(work::newton_round));
        r.solves = per_step(n.of(work::solve));
        r.factorizations = per_step(n.of(work::factorization));
        r.second_derivatives = per_step(n.second_derivatives);
        r.arithmetic = per_step(n.arithmetic);
        r.functions = per_step(n.functions);
        constexpr index_type size = sizeof(double);
        if constexpr (requires { at.remembered().histories(); }) {
            r.histories = at.remembered().histories();
            r.history_bytes = size * static_cast<index_type>(at.remembered().history_bytes() / sizeof(counted));
        }
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

/// A table of requirements, one method a row.
struct requirements_row {
    std::string name;
    requirements needs;
};
inline std::ostream& write_heading(std::ostream& out) {
    return out << std::left << std::setw(22) << "a step of" << std::right << " forces  second  rounds  solves  factor.     +-*/  functions"
               << "  state  memory  histories (bytes)  allocations\n";
}
inline std::ostream& operator<<(std::ostream& out, requirements_row const& row) {
    auto const& [name, r] = row;
    auto const number = [&](int width, double x) { out << std::setw(width) << std::round(x * 10) / 10; };
    out << std::left << std::setw(22) << name << std::right;
    number(7, r.forces);
    number(8, r.second_derivatives);
    number(8, r.newton_rounds);
    number(8, r.solves);
    number(9, r.factorizations);
    number(9, r.arithmetic);
    number(11, r.functions);
    out << std::setw(7) << r.state_bytes << std::setw(8) << r.memory_bytes << std::setw(11) << r.histories << std::setw(8)
        << r.history_bytes;
    if (r.allocations)
        number(13, *r.allocations);
    else
        out << std::setw(13) << '-';
    return out << '\n';
}

} // namespace hilger
