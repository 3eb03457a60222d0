// SPDX-License-Identifier: BSL-1.0
// What is there once for each kind of numbers: what walks begin with, and walks in states of any size.
#pragma once

#include "engine/motions.hpp"
#include "stated_walk.hpp"

namespace program {

template <class S>
class observation_of final : public observation<S> {
    using typename observation<S>::state;

public:
    explicit observation_of(stated_problem const& what)
        : of_(what), derivatives_({of_.of.lagrangian, {}}), energy_(hilger::energy(of_.of.lagrangian)) {
        of_.known.clear();
    }
    [[nodiscard]] std::vector<S> constants(state const& x, engine::vector<S> const& near) const override {
        std::vector<S> all;
        if (of_.conserves_energy()) all.push_back(energy_(x, near));
        evaluate(of_.conserved, x, near, all);
        return all;
    }
    [[nodiscard]] std::vector<S> shown(state const& x, engine::vector<S> const& near) const override {
        std::vector<S> all;
        evaluate(of_.observed, x, near, all);
        return all;
    }

private:
    void evaluate(std::vector<named_formula> const& formulas, state const& x, engine::vector<S> const& near, std::vector<S>& to) const {
        if (formulas.empty()) return;
        auto const v = hilger::detail::velocity_by(derivatives_, x.t, x.q, x.p, near);
        for (auto const& f : formulas) to.push_back(f.of.value(x.t, x.q, v));
    }
    stated_problem of_;
    hilger::detail::kept_derivatives<hilger::problem<hilger::text::stated_lagrangian>> derivatives_;
    decltype(hilger::energy(std::declval<hilger::text::stated_lagrangian const&>())) energy_;
};
template <class S>
beginning<S> beginning_from(stated_problem const& what, engine::vector<S> const& q, engine::vector<S> const& v) {
    S const start = number_of<S>(what.start);
    auto const p = hilger::momentum_of(hilger::detail::at_time{what.of.lagrangian, start}, q, v);
    return {start, number_of<S>(what.end), q, v, p, observed<S>(std::make_shared<observation_of<S> const>(what))};
}

template <class S, class WithFlow>
std::unique_ptr<walk> begin_in_any_size(stated_problem const& what, configuration const& c, WithFlow const& with_flow) {
    std::unique_ptr<walk> made;
    auto const& begin = beginning_of<S>(what);
    with_flow([&](auto const& flow) { made = walk_along(flow.along(begin.scale(c.steps), begin.from()), begin.seen); });
    return made;
}
template <class S>
std::unique_ptr<walk> begin_in_numbers(stated_problem const& what, configuration const& c) {
    return begin_in_any_size<S>(what, c, [&](auto const& use) {
        with_number<S>(what.of, beginning_of<S>(what), c, what.of.lagrangian, use);
        with_method<S>(c.embedding, what.of.lagrangian, use);
    });
}
template <class S>
std::unique_ptr<walk> begin_with_force(stated_problem const& what, configuration const& c) {
    return begin_in_any_size<S>(what, c, [&](auto const& use) {
        engine::forced_problem const mechanics{what.of.lagrangian, *what.of.force};
        with_number<S>(what.of, beginning_of<S>(what), c, mechanics, use);
        if (c.embedding == "mid-point") use(hilger::embed(mechanics, hilger::mid_point));
        if constexpr (std::same_as<S, double>) {
            if (c.embedding == "order-one") use(hilger::embed(mechanics, hilger::order_one));
            if (c.embedding == "gauss-4") use(hilger::embed(mechanics, hilger::galerkin<4, hilger::gauss>));
        }
    });
}

} // namespace program

#define PROGRAM_IN_NUMBERS(S)                                                                                                              \
    template program::beginning<S> program::beginning_from(program::stated_problem const&, engine::vector<S> const&,                       \
                                                           engine::vector<S> const&);                                                      \
    template std::unique_ptr<program::walk> program::begin_in_numbers<S>(program::stated_problem const&, program::configuration const&);
#define PROGRAM_WITH_FORCE(S)                                                                                                              \
    template std::unique_ptr<program::walk> program::begin_with_force<S>(program::stated_problem const&, program::configuration const&);
