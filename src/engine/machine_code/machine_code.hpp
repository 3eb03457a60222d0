// SPDX-License-Identifier: BSL-1.0
// Machine code of formulas that are known at run time only: what an evaluation in double does, as C, compiled by the system's compiler
// beside the run that goes on interpreted meanwhile, and kept for the next time. Every bit is the same with and without.
#pragma once

#include <string>
#include <vector>

#include "hilger/differentiation/traced/evaluation.hpp"

namespace engine {

/// C99 of the parts of an evaluation, void part_0(double *x) ... part_3, x being its values, and of all, part_4. Nothing where that would
/// be too long.
std::string c_of(hilger::detail::evaluation<double> const& what);

/// C99 of derivatives of d coordinates at a node: void first(const double *x, double t, const double *q, const double *v, double *to) puts
/// the first so many of `places`, which are no second derivatives, one after the other, and void all(...) all of them; x is the values,
/// where numbers are read, and -1 stands for a zero. void force(...), as these, puts the first d of them,
/// which are forces, and void many(const double *x, double t, const double *q, double *to, long n) the same for n positions and v = 0. In
/// double, or all of it in float. Nothing where that would be too long.
template <class S>
std::string c_of_node(hilger::detail::evaluation<S> const& what, int d, std::vector<int> const& places, std::size_t first);

class c_library;
enum class machine_code { off, on, at_once };
/// Whether formulas that are traced from now on become machine code when they are evaluated often; at_once waits for the compiler. The
/// environment says so too where nobody else does: HILGER_MACHINE_CODE=off. Where there is no compiler one line on stderr says so.
void set_machine_code(machine_code how);
/// What becomes of such a text, for the length of the process; nothing while it is not ready, and where there is none.
c_library const* machine_code_of(std::string text);
/// As the environment says, unless it was set.
void prepare_machine_code();
[[nodiscard]] machine_code wanted_machine_code();
/// On stderr, once.
void say_there_is_no_compiler();
/// How many formulas were translated so far in this process, from the compiler or from what was kept.
int formulas_in_machine_code();

} // namespace engine
