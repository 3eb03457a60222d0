// SPDX-License-Identifier: BSL-1.0
// expect 1: a state is given in real numbers with no more digits than those of T: round them first, or make T of such numbers
// expect 2: a state is given in real numbers with no more digits than those of T: round them first, or make T of such numbers
// expect 3: a state is a number or a vector, one of Eigen (row or column) or an array of numbers, and this is neither
// expect 4: the two parts of a state are two numbers or two vectors of one length, and these are not
// expect 5: data in braces are {.q0 = ..., .v0 = ...}, or .p0 or .q1 in place of .v0, for solve also {.q0 = ..., .qN = ...}, of two numbers or two vectors of one length
// expect 6: data in braces are {.q0 = ..., .v0 = ...}, or .p0 or .q1 in place of .v0, for solve also {.q0 = ..., .qN = ...}, of two numbers or two vectors of one length
// expect 8: data in braces are {.q0 = ..., .v0 = ...}, or .p0 or .q1 in place of .v0, for solve also {.q0 = ..., .qN = ...}, of two numbers or two vectors of one length
// expect 9: a walk starts from a position and a momentum, along(T, q0, p0), or from {.q0 = ..., .v0 = ...}, or .p0 or .q1 in place of .v0
// expect 7: a state is given in real numbers with no more digits than those of T
// expect 10: data in braces are {.q0 = ..., .v0 = ...}, or .p0 or .q1 in place of .v0
// expect 11: both ends say no step to begin with: solve(variation(S), T, {.q0 = ..., .qN = ...}) joins them
// A number that would lose digits is rounded by whoever means it.
#include "hilger/boundary/solve.hpp"
#include "hilger/integrator/flow.hpp"

using namespace hilger;

struct kinetic {
    auto operator()(auto const& q, auto const& v) const {
        if constexpr (requires { v.dot(v); })
            return v.dot(v) / 2 + 0 * q.dot(q);
        else
            return v * v / 2 + 0 * q;
    }
};

int main() {
    auto const flow = embed(kinetic{}, mid_point);
    auto const T = uniform(0.0, 0.1, 10);
    Eigen::Vector2d const two(1, 2);
    Eigen::Vector3d const three(1, 2, 3);
#if not defined(MUST_NOT_COMPILE)
    for (auto const& x : flow.along(T, {.q0 = two, .v0 = {1, 0}})) (void)x;
    for (auto const& x : flow.along(T, {.q0 = two, .p0 = {1, 0}})) (void)x;
    for (auto const& x : flow.along(T, {.q0 = three.transpose(), .q1 = three.cast<float>()})) (void)x;
    for (auto const& x : flow.along(T, static_cast<double>(1.0L), 0)) (void)x;
    auto const not_const = [](auto& q, auto& v) { return v * v / 2 - q * q / 2; };
    for (auto const& x : embed(not_const, mid_point).along(T, 1.0, 0.0)) (void)x;
#elif MUST_NOT_COMPILE == 1
    for (auto const& x : flow.along(T, 1.0L, 0.0)) (void)x;
#elif MUST_NOT_COMPILE == 2
    for (auto const& x : flow.along(uniform(0.0F, 0.1F, 10), two, two)) (void)x;
#elif MUST_NOT_COMPILE == 3
    for (auto const& x : flow.along(T, Eigen::Matrix2d(), two)) (void)x;
#elif MUST_NOT_COMPILE == 4
    for (auto const& x : flow.along(T, two, three)) (void)x;
#elif MUST_NOT_COMPILE == 5
    for (auto const& x : flow.along(T, {.q0 = two, .v0 = three})) (void)x;
#elif MUST_NOT_COMPILE == 6
    for (auto const& x : flow.along(T, {1.0, 0.0})) (void)x;
#elif MUST_NOT_COMPILE == 8
    constexpr unknown q;
    (void)solve(variation(nabla_integral(lagrangian{kinetic{}}(q, Delta_minus[q]), T)), T, {.q0 = 1.0});
#elif MUST_NOT_COMPILE == 9
    for (auto const& x : flow.along(T, 1.0)) (void)x;
#elif MUST_NOT_COMPILE == 10
    for (auto const& x : flow.along(T, {.q0 = two, .p0 = 1.0})) (void)x;
#elif MUST_NOT_COMPILE == 11
    for (auto const& x : flow.along(T, {.q0 = 0.0, .qN = 1.0})) (void)x;
#else
    constexpr unknown q;
    (void)solve(variation(nabla_integral(lagrangian{kinetic{}}(q, Delta_minus_alpha<3, 4>[q]), T)), T, boundary_values{0.0, 1.0L});
#endif
}
