// SPDX-License-Identifier: BSL-1.0
// expect 1: initial values do not determine its solution; with both end values given, solve(equation, T, {.q0 = ..., .qN = ...}) solves it
// expect 2: an action whose position or velocity reads all points before or after
// expect 3: an action whose position or velocity reads all points before or after
// expect 4: position and velocity of an embedding that is stepped read the two ends of one step, and these reach over two steps or more
// expect 5: has an equation that looks to both ends of T, and first values do not determine its solution
// expect 6: has an equation with rows at both ends of T, which first values do not determine
// expect 7: of the equations that look to both ends of T those are solved, without a force and a first guess, whose action is the nabla integral
// expect 8: the first and the last value determine the solution of an equation that reaches over one step, and this one reaches over more
// expect 9: data in braces are {.q0 = ..., .v0 = ...}, or .p0 or .q1 in place of .v0, for solve also {.q0 = ..., .qN = ...}
// A step that kept two points of the past would solve another equation.
#include <vector>

#include "hilger/boundary/solve.hpp"
#include "hilger/integrator/solve.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(0.0, 0.1, 10);
    auto const two_sided = variation(nabla_integral(L(q, Delta_minus(0.75)[q]), T));
#if not defined(MUST_NOT_COMPILE)
    (void)solve(two_sided, T, {.q0 = 1.0, .qN = 0.0});
    (void)solve(variation(integral(L(q, Delta_plus[q]), T)), T, {.q0 = 1.0, .qN = 0.0});
    // two halves of an order make a local difference
    (void)solve(variation(nabla_integral(L(q, Delta_minus_alpha<1, 2>[Delta_minus_alpha<1, 2>[q]]), T)), T, {.q0 = 1.0, .v0 = 0.0});
    (void)embed(L, make_embedding<delta_weight>(identity_T, fraction<1, 2>{} * (Delta_plus + Delta_plus), "one step"));
    (void)solve(variation(integral(L(q, (fraction<1, 2>{} * (Delta_plus + Delta_minus))[q]), T)), T, std::vector{1.0, 1.0, 0.9, 0.9});
#elif MUST_NOT_COMPILE == 1
    (void)solve(two_sided, T, {.q0 = 1.0, .v0 = 0.0});
#elif MUST_NOT_COMPILE == 2 // a step ahead of all that was
    (void)solve(variation(nabla_integral(L(q, sigma[Delta_minus_alpha<1, 2>[q]]), T)), T, {.q0 = 1.0, .v0 = 0.0});
#elif MUST_NOT_COMPILE == 3
    (void)flow_of(variation(integral(L(antiderivative[q], Delta_plus[q]), T))).along(T, 1.0, 0.0);
#elif MUST_NOT_COMPILE == 5
    (void)solve(two_sided, T, std::vector{1.0, 1.0});
#elif MUST_NOT_COMPILE == 6
    (void)solve(variation(nabla_integral(L(q, minus_alpha<bdf<2>, 1, 1>[q]), T)), T, std::vector{1.0, 1.0, 1.0, 1.0});
#elif MUST_NOT_COMPILE == 7
    (void)solve(variation(integral(L(antiderivative[q], Delta_plus[q]), T)), T, {.q0 = 1.0, .qN = 0.0});
#elif MUST_NOT_COMPILE == 8
    (void)solve(variation(integral(L(q, (fraction<1, 2>{} * (Delta_plus + Delta_minus))[q]), T)), T, {.q0 = 1.0, .qN = 0.0});
#elif MUST_NOT_COMPILE == 9
    (void)solve(variation(integral(L(q, Delta_plus[q]), T)), T, {.q0 = 1.0, .qN = "there"});
#else
    auto const mine = make_embedding<delta_weight>(identity_T, fraction<1, 2>{} * (Delta_plus + sigma * Delta_plus), "two steps");
    (void)embed(L, mine).along(T, 1.0, 0.0);
#endif
}
