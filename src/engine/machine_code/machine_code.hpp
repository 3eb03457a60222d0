// SPDX-License-Identifier: BSL-1.0
// Machine code of formulas known at run time only: an evaluation in double as C, compiled by the system's compiler while the run continues
// interpreted, and cached. Results are the same to the last bit.
#pragma once

#include <string>
#include <vector>

#include "hilger/differentiation/traced/evaluation.hpp"

namespace engine {

/// C99 of the parts of an evaluation, void part_0(double *x) ... part_3, and of all, part_4; x is the array of values. Nothing for a text
/// that would be too long.
std::string c_of(hilger::detail::evaluation<double> const& what);

/// C99 of derivatives of d coordinates at a node. void first(const double *x, double t, const double *q, const double *v, double *to)
/// writes the first derivatives, the first `first` of `places`, and void all(...) all derivatives; x holds the constants, and a place of -1
/// is a zero. void force(...), with the same arguments, writes the d forces, and void many(const double *x, double t, const double *q,
/// double *to, long n) the forces at n positions and v = 0. In double, or entirely in float. Nothing for a text that would be too long.
template <class S>
std::string c_of_node(hilger::detail::evaluation<S> const& what, int d, std::vector<int> const& places, std::size_t first);

class c_library;
enum class machine_code { off, on, at_once };
/// Whether formulas traced from here on become machine code when they are evaluated often; at_once waits for the compiler. The default is
/// on, unless the environment has HILGER_MACHINE_CODE=off. Without a compiler one line on stderr says so.
void set_machine_code(machine_code how);
/// The library of a text, valid until the process ends; nothing while it is not ready, or without one.
c_library const* machine_code_of(std::string text);
/// Applies the environment's choice, unless one was set.
void prepare_machine_code();
[[nodiscard]] machine_code wanted_machine_code();
/// Prints that to stderr, once.
void say_there_is_no_compiler();
/// The number of formulas in machine code of this process so far, compiled or from the cache.
int formulas_in_machine_code();

} // namespace engine
