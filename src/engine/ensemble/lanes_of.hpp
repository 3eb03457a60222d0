// SPDX-License-Identifier: BSL-1.0
// The step of a problem as C that takes several members of an ensemble at once, one in each lane of the processor's registers.
#pragma once

#include <string>
#include <vector>

#include "hilger/step/tableau.hpp"
#include "hilger/text/formula.hpp"

namespace engine {

/// A step is a list of embeddings with one node, each over its share of the step. Formulas have the variables h and m[k], the
/// parameters of a member.
struct one_node_parts {
    std::vector<hilger::tableau<hilger::detail::formula_node>> kinds; ///< in h
    struct part {
        std::size_t kind;
        double share;
    };
    std::vector<part> parts;
};

/// How many numbers of each member there are in a state: q, p, and the velocities that guesses are made from. The parameters that it brings
/// are behind them.
std::size_t size_in_lanes(int dimension, one_node_parts const& of);

/// C99 with the vector types of gcc and clang: numbers are kept as lists of `width` of them, a lane for each member.
///   void begin(double t, double *x)       momenta p = dL/dv where the velocities are
///   void walk(long i, long n, const double *t, double h, double *x, long long *lost, double *kept_q, double *kept_p)
/// walks n steps from t[i], which is i steps behind the beginning; h is their length, or 0 where it is that between the times. A lane in
/// which a step fails is lost from there on: its number in `lost` is -1. Lanes are independent of each other to the last bit. Nothing where
/// a formula has branches, or domains that its derivatives do not know of, as log(1 - q) with 1/(1 - q).
/// Where `width` is 0 there is one member, all are plain numbers, functions those of the C library, masks branches, and q and p behind each
/// step go to kept_q and kept_p, where these are not null.
std::string lanes_of(hilger::detail::node_formulas const& what, one_node_parts const& of, int brought, int width);

} // namespace engine
