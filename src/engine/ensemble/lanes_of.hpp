// SPDX-License-Identifier: BSL-1.0
// The step of a problem as C for several members of an ensemble, one in each lane of the processor's registers.
#pragma once

#include <string>
#include <vector>

#include "hilger/step/tableau.hpp"
#include "hilger/text/formula.hpp"

namespace engine {

/// A step is a list of embeddings with one node, each over its share of the step. Formulas have the variables h and m[k], the parameters of
/// a member.
struct one_node_parts {
    std::vector<hilger::tableau<hilger::detail::formula_node>> kinds; ///< as functions of h
    struct part {
        std::size_t kind;
        double share;
    };
    std::vector<part> parts;
};

/// The numbers of each member in a state: q, p, and the velocities for the guesses. Its own parameters follow them.
std::size_t size_in_lanes(int dimension, one_node_parts const& of);

/// C99 with the vector types of gcc and clang: states are lists of vectors with `width` lanes, one for each member.
///   void begin(double t, double *x, long long *lost)    sets momenta p = dL/dv from the velocities
///   void walk(long i, long n, const double *t, double h, double *x, long long *lost, double *kept_q, double *kept_p)
/// walks n steps from t[0], point i of the scale; h is their length, or 0 for the differences of the times. A lane is lost from its first
/// failing step on: its number in `lost` is -1. Lanes are independent of each other to the last bit. Nothing when a formula has branches,
/// or a domain that its derivatives do not share, as log(1 - q) with 1/(1 - q). `width` 0 means one member in plain numbers, with functions
/// of the C library and branches instead of masks; q and p after each step go to kept_q and kept_p, unless these are null.
std::string lanes_of(hilger::detail::node_formulas const& what, one_node_parts const& of, int brought, int width);

} // namespace engine
