// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string>
#include <vector>

#include "problems/scene.hpp"

namespace program {

/// What another library makes of a scene's equations.
struct peer_run {
    std::string method;
    double parameter; ///< tolerance, or number of steps where it is above 1
    double seconds;   ///< the fastest of several runs
    std::vector<double> position;
};
/// Boost.odeint's Runge-Kutta methods of orders 4, 5 and 8, its Bulirsch-Stoer method and its symplectic one of order 4, and GSL's where it
/// is installed, each over a range of steps or tolerances, of the formula that is stepped here too, where it is of L = v.Mv/2 - U(q); and,
/// for memory, the predictor-corrector of Diethelm, Ford and Freed. Empty where a scene has no peer.
std::vector<peer_run> run_peers(scene const& what);

} // namespace program
