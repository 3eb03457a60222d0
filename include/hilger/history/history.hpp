// SPDX-License-Identifier: BSL-1.0
// Histories of fractional differences: make_history<G>(policy, alpha, like) for a policy below.
//   direct{}                  the sum over everything; exact in exact scalars
//   exponentials{tolerance}   a constant cost per step and a few kB, for Gruenwald-Letnikov and the BDF
#pragma once

#include "hilger/history/direct.hpp"
#include "hilger/history/exponentials.hpp"
