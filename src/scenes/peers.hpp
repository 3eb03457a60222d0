// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "problems/scene.hpp"

namespace program {

/// The result of another library for a scene's equations.
struct peer_run {
    std::string method;
    double parameter; ///< tolerance, or number of steps when above 1
    double seconds;   ///< the fastest of several runs
    std::vector<double> position;
};
/// Boost.odeint's Runge-Kutta methods of orders 4, 5 and 8, its Bulirsch-Stoer method and its symplectic one of order 4, and GSL's if
/// installed, each over a range of steps or tolerances, on the same formula as hilger's, if it has the form L = v.Mv/2 - U(q); and, for
/// memory, the predictor-corrector of Diethelm, Ford and Freed. Empty for a scene without a peer, as one in a transformed time: peers
/// integrate in t.
std::vector<peer_run> run_peers(scene const& what);

} // namespace program
