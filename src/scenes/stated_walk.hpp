// SPDX-License-Identifier: BSL-1.0
// Systems in text, along the trajectories that all others have, in any scalar.
#pragma once

#include "from_file.hpp"
#include "histories.hpp"
#include "methods.hpp"
#include "path_walk.hpp"

namespace program {

using forced = hilger::problem<hilger::text::stated_lagrangian, hilger::text::stated_force>;

/// How far what is constant is from what it was, and what else is looked at.
template <class S>
class observed {
public:
    explicit observed(stated_problem what)
        : what_(std::move(what)), derivatives_({what_.of.lagrangian, {}}), energy_(hilger::energy(what_.of.lagrangian)) {}
    template <class State>
    std::vector<S> operator()(State const& x) const {
        std::vector<S> all;
        if (what_.conserves_energy()) all.push_back(energy_(x));
        evaluate(what_.conserved, x, all);
        return all;
    }
    template <class State>
    std::vector<S> shown(State const& x) const {
        std::vector<S> all;
        evaluate(what_.observed, x, all);
        return all;
    }

private:
    template <class State>
    void evaluate(std::vector<named_formula> const& formulas, State const& x, std::vector<S>& to) const {
        if (formulas.empty()) return;
        auto const v = hilger::detail::velocity_by(derivatives_, x.t, x.q, x.p);
        for (auto const& f : formulas) to.push_back(f.of.value(x.t, x.q, v));
    }
    stated_problem what_;
    hilger::detail::kept_derivatives<hilger::problem<hilger::text::stated_lagrangian>> derivatives_;
    decltype(hilger::energy(std::declval<hilger::text::stated_lagrangian const&>())) energy_;
};
/// What is damped or driven may be both.
inline forced with_any_force(engine::problem const& of) {
    if (of.force) return {of.lagrangian, *of.force};
    auto const words = std::make_shared<hilger::text::vocabulary>(of.lagrangian.formula().words());
    std::vector<hilger::text::stated> const none(static_cast<std::size_t>(words->dimension()),
                                                 hilger::text::stated(hilger::text::expression(), words, "the force"));
    return {of.lagrangian, hilger::text::stated_force(none)};
}

/// Calls use(flow) with the one that is chosen, where there is one in numbers S.
template <class S, class Use>
void with_flow(engine::problem const& of, configuration const& c, Use const& use) {
    constexpr bool is_double = std::same_as<S, double>;
    if (not of.damping.empty()) {
        if constexpr (is_double) {
            std::vector<hilger::fractional_term<double>> terms;
            for (auto const& [rho, alpha] : of.damping) terms.push_back({rho, alpha});
            with_history(c.history, c.steps, [&]<class Policy>(Policy const& policy) {
                if constexpr (not std::same_as<Policy, hilger::window>)
                    use(hilger::embed(hilger::with_fractional_damping(with_any_force(of), terms, policy), hilger::mid_point));
            });
        }
    } else if (of.force) {
        forced const mechanics{of.lagrangian, *of.force};
        if constexpr (not std::same_as<S, hilger::float100>) {
            if (c.embedding == "mid-point") use(hilger::embed(mechanics, hilger::mid_point));
        }
        if constexpr (is_double) {
            if (c.embedding == "order-one") use(hilger::embed(mechanics, hilger::order_one));
            if (c.embedding == "gauss-4") use(hilger::embed(mechanics, hilger::galerkin<4, hilger::gauss>));
        }
    } else
        with_method<S, in_many_digits::composition>(c.embedding, of.lagrangian, use);
}

template <class S>
std::unique_ptr<walk> begin_in_numbers(stated_problem const& what, configuration const& c) {
    std::unique_ptr<walk> made;
    auto const end = [](std::string const& digits) { return *hilger::text::number_in<S>(digits); };
    auto const T = hilger::uniform(hilger::interval<S>{end(what.start), end(what.end)}, c.steps);
    with_flow<S>(what.of, c, [&](auto const& flow) {
        hilger::initial_velocity<engine::vector<S>> const from{numbers_of<S>(what.q), numbers_of<S>(what.v)};
        made = walk_along(flow.along(T, from), observed<S>(what));
    });
    return made;
}

} // namespace program
