// SPDX-License-Identifier: BSL-1.0
// The methods that scenes of a Lagrangian can be run with, by name.
#pragma once

#include <array>
#include <string>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

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

} // namespace program
