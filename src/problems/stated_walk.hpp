// SPDX-License-Identifier: BSL-1.0
// Systems in text, along the trajectories that all others have, in any scalar.
#pragma once

#include <array>
#include <string>

#include "engine/methods/own.hpp"
#include "engine/small_lagrangian.hpp"
#include "from_file.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "path_walk.hpp"

namespace program {

inline constexpr std::array method_names{"order-one",   "mid-point", "mid-point+", "verlet",  "blanes-moan-4", "kahan-li-8",
                                         "kahan-li-8+", "gauss-4",   "gauss-6",    "gauss-8", "gauss-16"};

/// Calls use(flow) with the method of that name on L, where the scalar has it.
template <class S, class L, class Use>
void with_method(std::string const& name, L const& l, Use const& use) {
    using namespace hilger;
    constexpr bool is_double = std::is_same_v<S, double>, many_digits = not std::is_floating_point_v<S>;
    if constexpr (not std::is_same_v<S, float100>) { // what is compiled there takes its time
        if (name == "mid-point") use(embed(l, mid_point));
    }
    if constexpr (is_double) {
        if (name == "order-one") use(embed(l, order_one));
        if (name == "mid-point+") use(embed(l, mid_point, compensated));
        if (name == "verlet") use(stoermer_verlet(l));
        if (name == "blanes-moan-4") use(compose_with_adjoint(blanes_moan<4>, embed(l, order_one)));
        if (name == "kahan-li-8+") use(compose(kahan_li<8>, stoermer_verlet(l, compensated)));
        if (name == "gauss-6") use(embed(l, galerkin<6, gauss>));
        if (name == "gauss-8") use(embed(l, galerkin<8, gauss>));
    }
    if constexpr (is_double or many_digits) {
        if (name == "kahan-li-8") use(compose(kahan_li<8>, stoermer_verlet(l)));
    }
    if constexpr (not many_digits) {
        if (name == "gauss-4") use(embed(l, galerkin<4, gauss>));
    } else {
        if (name == "gauss-16") use(embed(l, galerkin<16, gauss>));
    }
}

using forced = hilger::problem<hilger::text::stated_lagrangian, hilger::text::stated_force>;

/// How far what is constant is from what it was, and what else is looked at.
template <class S>
class observed {
public:
    explicit observed(stated_problem what)
        : what_(std::move(what)), derivatives_({what_.of.lagrangian, {}}), energy_(hilger::energy(what_.of.lagrangian)) {}
    template <class State>
    std::vector<S> operator()(State const& of) const {
        any_size const x = of_any_size(of);
        std::vector<S> all;
        if (what_.conserves_energy()) all.push_back(energy_(x));
        evaluate(what_.conserved, x, all);
        return all;
    }
    template <class State>
    std::vector<S> shown(State const& x) const {
        std::vector<S> all;
        evaluate(what_.observed, of_any_size(x), all);
        return all;
    }

private:
    using any_size = hilger::state<S, engine::vector<S>>;
    template <class State>
    static any_size of_any_size(State const& x) {
        return {x.t, engine::as_vector<S>(x.q), engine::as_vector<S>(x.p)};
    }
    void evaluate(std::vector<named_formula> const& formulas, any_size const& x, std::vector<S>& to) const {
        if (formulas.empty()) return;
        auto const v = hilger::detail::velocity_by(derivatives_, x.t, x.q, x.p);
        for (auto const& f : formulas) to.push_back(f.of.value(x.t, x.q, v));
    }
    stated_problem what_;
    hilger::detail::kept_derivatives<hilger::problem<hilger::text::stated_lagrangian>> derivatives_;
    decltype(hilger::energy(std::declval<hilger::text::stated_lagrangian const&>())) energy_;
};
/// Calls use(flow) with the method that is chosen on what moves, L or with a force, where it has a number in it, as theta:0.3 and
/// embeddings in text have.
template <class S, class Mechanics, class Use>
void with_number(engine::problem const& of, configuration const& c, Mechanics const& mechanics, Use const& use) {
    if (auto const lambda = engine::lambda_of<S>(of, c.embedding)) use(hilger::embed(mechanics, hilger::text::embedding_at(*lambda)));
}
/// Calls use(flow) with the one that is chosen, where there is one in numbers S, for what does not remember.
template <class S, class Use>
void with_flow(engine::problem const& of, configuration const& c, Use const& use) {
    constexpr bool is_double = std::same_as<S, double>;
    if (of.force) {
        forced const mechanics{of.lagrangian, *of.force};
        with_number<S>(of, c, mechanics, use);
        if constexpr (not std::same_as<S, hilger::float100>) {
            if (c.embedding == "mid-point") use(hilger::embed(mechanics, hilger::mid_point));
        }
        if constexpr (is_double) {
            if (c.embedding == "order-one") use(hilger::embed(mechanics, hilger::order_one));
            if (c.embedding == "gauss-4") use(hilger::embed(mechanics, hilger::galerkin<4, hilger::gauss>));
        }
    } else {
        with_number<S>(of, c, of.lagrangian, use);
        with_method<S>(c.embedding, of.lagrangian, use);
    }
}
/// The walk of a free problem of D coordinates, with states of that size, in double or float.
template <class S, int D>
std::unique_ptr<walk> begin_small(stated_problem const& what, configuration const& c);

/// What make() makes for the first walk, for all of them.
template <class T, class Make>
T const& known_to(stated_problem const& what, Make const& make) {
    auto& kept = what.known[typeid(T)];
    if (not kept) kept = std::make_shared<T>(make());
    return *static_cast<T const*>(kept.get());
}
/// What all walks in numbers S begin with.
template <class S>
struct beginning {
    S start, end;
    engine::vector<S> q, p;
    observed<S> seen;
    [[nodiscard]] auto scale(hilger::index_type steps) const { return hilger::uniform(hilger::interval<S>{start, end}, steps); }
};
template <class S>
beginning<S> const& beginning_of(stated_problem const& what) {
    return known_to<beginning<S>>(what, [&] {
        auto const number = [](std::string const& digits) { return *hilger::text::number_in<S>(digits); };
        S const start = number(what.start);
        auto const q = numbers_of<S>(what.q);
        auto const p = hilger::momentum_of(hilger::detail::at_time{what.of.lagrangian, start}, q, numbers_of<S>(what.v));
        return beginning<S>{start, number(what.end), q, p, observed<S>(what)};
    });
}
template <class S>
std::unique_ptr<walk> begin_in_numbers(stated_problem const& what, configuration const& c) {
    std::unique_ptr<walk> made;
    auto const& begin = beginning_of<S>(what);
    with_flow<S>(what.of, c, [&](auto const& flow) { made = walk_along(flow.along(begin.scale(c.steps), begin.q, begin.p), begin.seen); });
    return made;
}

} // namespace program

/// In numbers S, compiled in a file of its own.
#define PROGRAM_IN_NUMBERS(keyword, S)                                                                                                     \
    keyword template std::unique_ptr<program::walk> program::begin_in_numbers<S>(program::stated_problem const&,                           \
                                                                                 program::configuration const&);
