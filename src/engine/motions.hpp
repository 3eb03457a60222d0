// SPDX-License-Identifier: BSL-1.0
// The motion of one flow on one kind of scale, behind the common interface.
#pragma once

#include "engine/any_scale.hpp"
#include "engine/path_cursor.hpp"

namespace engine {

using free_problem = hilger::problem<hilger::text::stated_lagrangian, hilger::no_force>;
using forced_problem = hilger::problem<hilger::text::stated_lagrangian, hilger::text::stated_force>;

/// Whether the flow has an equation in the positions at the points of T.
template <class Flow, class T>
concept has_equation = requires(Flow const& f, T const& scale) {
    equation_of(f, scale);
};
template <class Flow>
concept has_memory = requires(Flow const& f) {
    f.undamped();
};

/// Whether its steps have nodes, or parts with nodes.
template <class Flow, class S>
concept has_nodes = requires(Flow const& f, S const& h, vector<S> const& like) {
    hilger::detail::timed_part<Flow, S, vector<S>>(f, h, like);
};

/// Whether its memory is of stages, on any T.
template <class Flow>
concept has_stages = requires(Flow const& f) {
    f.damping().template grading<double>();
};

/// Whether positions and momenta at the points of T determine the residual.
template <class Flow, class S, class Scale>
concept is_judged_by_states = requires(Flow const& f, hilger::recording<S, vector<S>, Scale> const& run) {
    largest_residual(f, run);
};

template <class S, class Scale>
std::vector<S> elements_of(Scale const& T) {
    std::vector<S> all;
    for (hilger::index_type i = T.first(); i <= T.last(); ++i) all.push_back(T.element(i));
    return all;
}

/// Whether two positions determine the momentum between them.
template <class Flow>
inline constexpr bool starts_from_two_positions = false;
template <class F, class Force, class E, hilger::sums Sums>
inline constexpr bool starts_from_two_positions<hilger::flow<F, Force, E, Sums>> = hilger::controls_of<E> == 2;

/// A faster cursor from the same initial values; nothing when it does not support them.
template <class S>
using beginning_by = std::function<std::unique_ptr<cursor<S>>(initial<S> const&)>;

/// Functions of a single state. The formula is traced once.
template <class S, class Mechanics>
class motion_of_mechanics : public motion<S> {
public:
    explicit motion_of_mechanics(Mechanics const& what)
        : dimension_(what.lagrangian.formula().words().dimension()), energy_(hilger::energy(what.lagrangian)) {}
    [[nodiscard]] S energy(state<S> const& x, vector<S> const& near) const override {
        return energy_(hilger::state<S, vector<S>>{x.t, x.q, x.p}, near);
    }

protected:
    void require_coordinates(vector<S> const& x) const {
        if (x.size() != dimension_)
            hilger::error::raise<hilger::error::mismatch>("L has ", dimension_, " coordinates, and a state has ", x.size());
    }

private:
    int dimension_;
    decltype(hilger::energy(std::declval<Mechanics const&>().lagrangian)) energy_;
};

template <class Flow>
auto const& mechanics_of(Flow const& flow) {
    if constexpr (has_memory<Flow>)
        return flow.undamped().mechanics();
    else
        return flow.mechanics();
}
template <class S, class Flow>
using motion_of_mechanics_of = motion_of_mechanics<S, std::remove_cvref_t<decltype(mechanics_of(std::declval<Flow const&>()))>>;

template <class S, class Flow, class Scale>
class motion_of : public motion_of_mechanics_of<S, Flow> {
public:
    motion_of(Flow flow, Scale T, std::string name, beginning_by<S> faster = {})
        : motion_of_mechanics_of<S, Flow>(mechanics_of(flow)), flow_(std::move(flow)), T_(std::move(T)), name_(std::move(name)),
          faster_(std::move(faster)) {}

    [[nodiscard]] std::unique_ptr<cursor<S>> begin(initial<S> const& from) const override {
        if (faster_)
            if (auto made = faster_(from)) return made;
        std::unique_ptr<cursor<S>> made;
        along(from, [&](auto path) { made = cursor_along<S>(std::move(path)); });
        return made;
    }
    [[nodiscard]] std::vector<S> times() const override { return elements_of<S>(T_); }
    [[nodiscard]] joined<S> between(vector<S> const& first, vector<S> const& last, std::vector<vector<S>> const& guess,
                                    std::stop_token const& stop) const override {
        if constexpr (has_equation<Flow, Scale> and not has_memory<Flow>) {
            hilger::ends_report<S> report;
            hilger::boundary_values<vector<S>> const ends{first, last};
            auto const EL = equation_of(flow_, T_);
            auto const& force = flow_.mechanics().force;
            auto const x = guess.empty() ? solve(EL, T_, ends, force, hilger::detail::straight_line{}, stop, &report)
                                         : solve(EL, T_, ends, force, hilger::function_on(T_, guess), stop, &report);
            return {values_on_T(x), values_on_T(momenta_of(flow_, x)), report.warning};
        } else
            refuse(has_memory<Flow> ? "is solved from initial values where there is fractional damping"
                                    : "is solved from initial values: what joins two ends is found for embeddings");
    }
    [[nodiscard]] S residual(initial<S> const& from, std::vector<vector<S>> const& positions, std::vector<vector<S>> const& momenta,
                             bool absolute) const override {
        for (auto const* all : {&positions, &momenta})
            for (vector<S> const& x : *all) this->require_coordinates(x);
        if constexpr (is_judged_by_states<Flow, S, Scale>) {
            hilger::recording<S, vector<S>, Scale> run{{}, {}, T_};
            for (std::size_t i = 0; i < positions.size(); ++i)
                run.states.push_back({T_.element(T_.first() + static_cast<hilger::index_type>(i)), positions[i], momenta.at(i)});
            return absolute ? largest_residual(flow_, run) : relative_residual(flow_, run);
        } else if constexpr (has_memory<Flow> and not has_stages<Flow>) {
            S worst(0);
            along(from, [&](auto const& path) { worst = absolute ? largest_residual(path) : relative_residual(path); });
            return worst;
        } else
            refuse("has no equation in the positions at the points of T alone");
    }
    [[nodiscard]] state<S> between_states(state<S> const& x, state<S> const& y, S const& t) const override {
        if constexpr (has_memory<Flow>)
            refuse("has a memory, which is no part of a state: there is nothing between the points of T");
        else {
            for (vector<S> const* z : {&x.q, &x.p, &y.q, &y.p}) this->require_coordinates(*z);
            hilger::state<S, vector<S>> const from{x.t, x.q, x.p}, to{y.t, y.q, y.p};
            if (t == y.t) return y;
            auto const z = hilger::state_at(flow_, from, t, hilger::detail::mean_velocity(from, to));
            return {z.t, z.q, z.p};
        }
    }
    [[nodiscard]] step_integral<S> integral_of(std::function<S(vector<S> const&)> g) const override {
        if constexpr (has_nodes<Flow, S>) {
            using part_type = hilger::detail::timed_part<Flow, S, vector<S>>;
            return [g = std::move(g), flow = flow_, T = T_, part = std::shared_ptr<part_type>()](hilger::index_type i, state<S> const& x,
                                                                                                 state<S> const& y) mutable {
                S const h = T.step(i);
                if (not part) part = std::make_shared<part_type>(flow, h, x.q);
                hilger::state<S, vector<S>> at{x.t, x.q, x.p};
                return part->over(flow, at, h, vector<S>((y.q - x.q) / h), &y.q, g);
            };
        } else
            return motion<S>::integral_of(std::move(g));
    }

private:
    template <class Use>
    void along(initial<S> const& from, Use const& use) const {
        if (from.is == second_datum::momentum)
            use(flow_.along(T_, from.q0, from.other));
        else if (from.is == second_datum::velocity)
            use(flow_.along(T_, hilger::initial_velocity<vector<S>>{from.q0, from.other}));
        else if constexpr (starts_from_two_positions<Flow>)
            use(flow_.along(T_, hilger::initial_positions<vector<S>>{from.q0, from.other}));
        else
            refuse(has_memory<Flow> ? "starts from q0 and v0 or p0 where there is fractional damping, and not from two positions"
                                    : "starts from q0 and v0 or p0, and not from two positions");
    }
    [[noreturn]] void refuse(char const* why) const {
        hilger::error::raise<hilger::error::invalid_parameter>("the method ", name_, " ", why);
    }

protected:
    /// The values at the points of T, without those inside the steps.
    template <class X>
    [[nodiscard]] std::vector<vector<S>> values_on_T(X const& x) const {
        std::vector<vector<S>> values;
        hilger::index_type const parts = (x.size() - 1) / T_.steps();
        for (hilger::index_type i = 0; i < x.size(); i += parts) values.push_back(x[i]);
        return values;
    }
    Flow flow_;
    Scale T_;

private:
    std::string name_;
    beginning_by<S> faster_;
};

template <class S, class Flow>
std::unique_ptr<motion<S>> motion_by(Flow const& flow, points<S> const& T, std::string const& name, beginning_by<S> faster = {}) {
    if constexpr (has_memory<Flow> and not has_stages<Flow>) {
        if (not T.is_uniform()) hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is for uniform scales");
        return std::make_unique<motion_of<S, Flow, hilger::uniform_scale<S>>>(flow, uniform_scale_of(T), name, std::move(faster));
    } else
        return std::make_unique<motion_of<S, Flow, any_scale<S>>>(flow, any_scale<S>(T), name, std::move(faster));
}

/// Calls use(mechanics) with the Lagrangian, or with the Lagrangian and the force.
template <class Use>
auto with_mechanics(problem const& what, Use const& use) {
    if (what.force) return use(forced_problem{what.lagrangian, *what.force});
    return use(free_problem{what.lagrangian, {}});
}

/// Motions by the methods of one kind, each compiled in a file of its own; nothing for a method of another kind.
using made = std::unique_ptr<motion<double>>;
made embedded_in_one_step(problem const& what, std::string const& method, points<double> const& T);
made embedded_with_inner_points(problem const& what, std::string const& method, points<double> const& T);
made between_two_ends(problem const& what, std::string const& method, points<double> const& T);
made composed(problem const& what, std::string const& method, points<double> const& T);
made damped(problem const& what, std::string const& method, points<double> const& T);
template <class S>
std::unique_ptr<motion<S>> by_newmark(problem const& what, std::string const& method, points<S> const& T);
extern template std::unique_ptr<motion<double>> by_newmark(problem const&, std::string const&, points<double> const&);
extern template std::unique_ptr<motion<hilger::float50>> by_newmark(problem const&, std::string const&, points<hilger::float50> const&);

} // namespace engine
