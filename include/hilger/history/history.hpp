// SPDX-License-Identifier: BSL-1.0
// Histories of fractional differences. make_history<G>(policy, alpha, like) with a generating function, an order and a value of the size of
// all values returns an engine: past() is sum_{n>=1} w_n x_{m-n} after m values, push(x) appends x_m, then there are count() and reset().
//   direct{}                  the sum over everything; exact in exact scalars
//   blocks{}                  the same in O(N log^2 N), for many values that must be exact or whose generating function has no modes
//   exponentials{tolerance}   a constant cost per value and a few kB, for Gruenwald-Letnikov and the BDF
// stage_history (history/stages.hpp) has the values at the stages of a Runge-Kutta method, on any T.
// toeplitz_triangle(first_weights<G>(alpha, n)) computes all sums of a known sequence.
#pragma once

#include "hilger/history/blocks.hpp"
#include "hilger/history/convolution.hpp"
#include "hilger/history/direct.hpp"
#include "hilger/history/exponentials.hpp"
