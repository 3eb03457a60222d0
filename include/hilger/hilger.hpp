// SPDX-License-Identifier: BSL-1.0
// hilger: time-scale calculus as a language. This file is the table of contents. Each folder knows those before it only:
//   scale, function, operator, adjoint, printing      the calculus
//   history, embedding                                histories of fractional differences; embeddings of a Lagrangian
//   linear, differentiation, newton                   linear algebra, derivatives, Newton's method
//   models, variational                               Lagrangians; actions, their variations, Legendre maps
//   step, trajectory, integrator, composition         one step of an equation, trajectories, flows, flows of flows
//   fractional, boundary                              damping with a memory; problems with values at both ends
//   text                                              Lagrangians known at run time only, formulas written out, C: hilger::text
#pragma once

#include "hilger/version.hpp"

// Scales, functions on them, operators between those, adjoints and equality of operators
#include "hilger/calculus.hpp"

// Embeddings of a Lagrangian on a scale: order one, mid-point, theta, Galerkin, your own
#include "hilger/embedding/collocation.hpp"
#include "hilger/embedding/embedding.hpp"
#include "hilger/embedding/galerkin.hpp"
#include "hilger/embedding/stage_difference.hpp"

// From a Lagrangian to its discrete Euler-Lagrange equation and Hamiltonian system, and their notation
#include "hilger/variational/action.hpp"
#include "hilger/variational/lagrangian.hpp"
#include "hilger/variational/legendre.hpp"
#include "hilger/variational/legendre_transform.hpp"
#include "hilger/variational/print.hpp"
#include "hilger/variational/restricted.hpp"
#include "hilger/variational/separated_hamiltonian.hpp"
#include "hilger/variational/sum_of_actions.hpp"
#include "hilger/variational/time_transformation.hpp"
#include "hilger/variational/variation.hpp"

// Standard Lagrangians
#include "hilger/models/mechanical.hpp"

// Flows and solutions
#include "hilger/accuracy/between_ends.hpp"
#include "hilger/accuracy/from_start.hpp"
#include "hilger/composition/methods.hpp"
#include "hilger/composition/residual.hpp"
#include "hilger/composition/times.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/integrator/solve.hpp"

// Histories as sums of exponentials; fractional damping, and problems with values at both ends
#include "hilger/boundary/residual.hpp"
#include "hilger/boundary/solve.hpp"
#include "hilger/fractional/accuracy.hpp"
#include "hilger/fractional/flow.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/of_variation.hpp"
#include "hilger/fractional/zener.hpp"
#include "hilger/history/history.hpp"
#include "hilger/history/stages.hpp"

// Trajectories recorded, interpolated, stopped at events, checkpointed, and measured
#include "hilger/fractional/residual.hpp"
#include "hilger/integrator/momenta.hpp"
#include "hilger/integrator/residual.hpp"
#include "hilger/integrator/times.hpp"
#include "hilger/trajectory/checkpoint.hpp"
#include "hilger/trajectory/dense_output.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "hilger/trajectory/events.hpp"
#include "hilger/trajectory/recording.hpp"
