// SPDX-License-Identifier: BSL-1.0
// hilger: time-scale calculus as a language. This file is the table of contents.
#pragma once

#include "hilger/version.hpp"

// Scales, functions on them, operators between those, adjoints and equality of operators
#include "hilger/calculus.hpp"

// How a Lagrangian is read on a scale: order one, mid-point, theta, Galerkin, your own
#include "hilger/embedding/embedding.hpp"
#include "hilger/embedding/galerkin.hpp"

// From a Lagrangian to its discrete Euler-Lagrange equation and Hamiltonian system, and how they are written
#include "hilger/mechanics/action.hpp"
#include "hilger/mechanics/lagrangian.hpp"
#include "hilger/mechanics/legendre.hpp"
#include "hilger/mechanics/legendre_transform.hpp"
#include "hilger/mechanics/mechanical.hpp"
#include "hilger/mechanics/print.hpp"
#include "hilger/mechanics/restricted.hpp"
#include "hilger/mechanics/variation.hpp"

// Flows and solutions
#include "hilger/integrator/accuracy.hpp"
#include "hilger/integrator/composition_methods.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/solve.hpp"

// Memory of all that was, at almost no cost; what is damped by it, and problems with values at both ends
#include "hilger/history/history.hpp"
#include "hilger/integrator/boundary.hpp"
#include "hilger/integrator/boundary_extrapolation.hpp"
#include "hilger/integrator/fractional_flow.hpp"
#include "hilger/integrator/fractional_newmark.hpp"
#include "hilger/integrator/fractional_zener.hpp"
#include "hilger/integrator/of_variation.hpp"
#include "hilger/mechanics/beam.hpp"
#include "hilger/mechanics/fractional_noether.hpp"

// Trajectories kept, interpolated, stopped at events, written down and resumed, and judged
#include "hilger/integrator/checkpoint.hpp"
#include "hilger/integrator/dense_output.hpp"
#include "hilger/integrator/diagnostics.hpp"
#include "hilger/integrator/events.hpp"
#include "hilger/integrator/fractional_residual.hpp"
#include "hilger/integrator/recording.hpp"
#include "hilger/integrator/requirements.hpp"
#include "hilger/integrator/residual.hpp"

// Identities as checks, for your own scales and operators too
#include "hilger/identity/registry.hpp"
#include "hilger/identity/trial.hpp"
