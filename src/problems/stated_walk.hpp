// SPDX-License-Identifier: BSL-1.0
// Systems in text, along the trajectories that all others have, in any scalar.
#pragma once

#include <array>
#include <string>

#include "beginning.hpp"
#include "engine/methods/lambda.hpp"
#include "engine/small_lagrangian.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/embedding.hpp"
#include "path_walk.hpp"

namespace program {

inline constexpr std::array method_names{"order-one",   "mid-point", "mid-point+", "verlet",  "blanes-moan-4", "kahan-li-8",
                                         "kahan-li-8+", "gauss-4",   "gauss-6",    "gauss-8", "gauss-16"};

/// Methods of two kinds, which are compiled apart where that takes its time: with points inside the steps, and with none.
enum class method_kind { without_inner_points, with_inner_points };

/// Calls use(flow) with the method of that name on L, where it is of that kind and the scalar has it.
template <method_kind Kind, class S, class L, class Use>
void with_method(std::string const& name, L const& l, Use const& use) {
    using namespace hilger;
    constexpr bool is_double = std::is_same_v<S, double>, many_digits = not std::is_floating_point_v<S>;
    if constexpr (Kind == method_kind::with_inner_points) {
        if constexpr (is_double) {
            if (name == "gauss-6") use(embed(l, galerkin<6, gauss>));
            if (name == "gauss-8") use(embed(l, galerkin<8, gauss>));
        }
        if constexpr (many_digits) {
            if (name == "gauss-16") use(embed(l, galerkin<16, gauss>));
        } else if (name == "gauss-4")
            use(embed(l, galerkin<4, gauss>));
    } else {
        if constexpr (not std::is_same_v<S, float100>) { // what is compiled there takes its time
            if (name == "mid-point") use(embed(l, mid_point));
        }
        if constexpr (is_double) {
            if (name == "order-one") use(embed(l, order_one));
            if (name == "mid-point+") use(embed(l, mid_point, compensated));
            if (name == "verlet") use(stoermer_verlet(l));
            if (name == "blanes-moan-4") use(compose_with_adjoint(blanes_moan<4>, embed(l, order_one)));
            if (name == "kahan-li-8+") use(compose(kahan_li<8>, stoermer_verlet(l, compensated)));
        }
        if constexpr (is_double or many_digits)
            if (name == "kahan-li-8") use(compose(kahan_li<8>, stoermer_verlet(l)));
    }
}
template <class S, class L, class Use>
void with_method(std::string const& name, L const& l, Use const& use) {
    with_method<method_kind::without_inner_points, S>(name, l, use);
    with_method<method_kind::with_inner_points, S>(name, l, use);
}

/// Calls use(flow) with the method that is chosen on what moves, L or with a force, where it has a number in it, as theta:0.3 and
/// embeddings in text have.
template <class S, class Mechanics, class Use>
void with_number(engine::problem const& of, beginning<S> const& begin, configuration const& c, Mechanics const& mechanics, Use const& use) {
    if (auto const lambda = engine::lambda_of<S>(of, c.embedding, begin.step(c.steps)))
        use(hilger::embed(mechanics, hilger::text::embedding_at(*lambda)));
}
/// The walk of a free problem of D coordinates, with states of that size, in double or, without inner points, float, by a method of that
/// kind.
template <class S, int D, method_kind Kind>
std::unique_ptr<walk> begin_small(stated_problem const& what, configuration const& c);

/// In states of any size, compiled once for each S (in_numbers.hpp); with a force, in double and 50 digits.
template <class S>
std::unique_ptr<walk> begin_in_numbers(stated_problem const& what, configuration const& c);
template <class S>
std::unique_ptr<walk> begin_with_force(stated_problem const& what, configuration const& c);

} // namespace program
