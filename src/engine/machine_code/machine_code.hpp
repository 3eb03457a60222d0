// SPDX-License-Identifier: BSL-1.0
// Machine code of formulas that are known at run time only: what an evaluation in double does, as C, compiled by the system's compiler
// beside the run that goes on interpreted meanwhile, and kept for the next time. Every bit is the same with and without.
#pragma once

#include <string>

#include "hilger/differentiation/evaluation.hpp"

namespace engine {

/// C99 of the parts of an evaluation, void part_0(double *x) ... part_3, x being its values, and of all, part_4. Nothing where that would
/// be too long.
std::string c_of(hilger::detail::evaluation<double> const& what);

enum class machine_code { off, on, at_once };
/// Whether formulas that are traced from now on become machine code when they are evaluated often; at_once waits for the compiler. The
/// environment says so too where nobody else does: HILGER_MACHINE_CODE=off. Where there is no compiler one line on stderr says so.
void set_machine_code(machine_code how);
/// As the environment says, unless it was set.
void prepare_machine_code();
[[nodiscard]] machine_code wanted_machine_code();
/// On stderr, once.
void say_there_is_no_compiler();
/// How many formulas were translated so far in this process, from the compiler or from what was kept.
int formulas_in_machine_code();

} // namespace engine
