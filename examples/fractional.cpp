// SPDX-License-Identifier: BSL-1.0
// Fractional calculus as types: damping of order 1/2 from a variational principle, as a mean over each step, of several terms; a
// difference on uneven steps, and a problem with values at both ends.
#include <cmath>
#include <iostream>
#include <vector>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr unknown<"y"> y; // a second curve with the same variation
    constexpr auto q_o = extend[q];
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); }};
    auto const T = uniform(0.0, 0.01, 4000);

    auto const S = integral(L(q_o, Delta_o_plus[q_o]), half(T)) - 0.2 * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T);
    auto const EL = variation(S); // [∂L/∂q]½,− − Δ½,−[∂L/∂v] = ρ Δ₋^½[q], and the same of y in reversed time
    static_assert(decltype(EL)::damping() == Delta_minus_alpha<1, 2>);
    static_assert(adjoint(Delta_minus_alpha<1, 4>) == Delta_plus_alpha<1, 4>);
    std::cout << EL;

    double amplitude = 0, last = 0;
    // A history of a few kB, however long the run; of q - q(0), so that letting go is no blow.
    for (auto const& x : flow_of(EL, exponentials{}, {.history = initial_history::caputo}).along(T, 1.0, 0.0)) {
        last = x.q;
        if (x.t > 30) amplitude = std::max(amplitude, std::abs(x.q));
    }
    std::cout << "released at 1, the pendulum swings to " << amplitude << " after t = 30 and is at " << last << " in the end\n";

    // The principle has impulses at the points: explicit, of order one. As a mean over the step the damping has order two and no limit.
    auto const damped = embed(with_fractional_damping(L, 0.2, fraction<1, 2>{}, exponentials{}), mid_point);
    auto const both =
        embed(with_fractional_damping(L, {{0.2, 0.5}, {0.05, 1.25}}, exponentials{}), mid_point); // −0.2 D^½ q − 0.05 D^(5/4) q
    double mean = 0, of_two = 0;
    for (auto const& x : damped.along(T, 1.0, 0.0)) mean = x.q;
    for (auto const& x : both.along(T, 1.0, 0.0)) of_two = x.q;
    std::cout << "with the mean over each step it is at " << mean << ", with a second term at " << of_two << '\n';
    auto const path = damped.along(T, 1.0, 0.0);
    double const residual = largest_residual(path); // the differences made again as sums over all of the past
    std::cout << "its equation holds to " << residual << '\n';
    auto const turns = events(path, [](auto const& x) { return x.p; }); // located with the force of the history
    std::cout << "it turns first at t = " << (*turns.begin()).t << '\n';

    // The power of Delta_- needs no equal steps: T may have short ones where a function is steep.
    std::vector<double> points;
    for (int i = 0; i <= 400; ++i) points.push_back(i * i / 160'000.0);
    time_scale<double> const graded(points);
    auto const half_derivative = Delta_minus_alpha<1, 2>[function_on(graded, [](double t) { return std::sqrt(t); })];
    static_assert(composition(Delta_minus_alpha<1, 2>, Delta_minus_alpha<1, 2>) == Delta_minus_alpha<1, 1>); // on every T
    static_assert(uniformly(minus_Delta_plus_alpha<1, 2>) == Delta_plus_alpha<1, 2>);
    double const of_root = half_derivative[400];
    std::cout << "D^(1/2) of the root of t is " << of_root << " at t = 1, and 0.886227 without steps\n";

    constexpr lagrangian kinetic{[](auto const& x, auto const& v) { return v * v / 2 + 0 * x; }};
    auto const D = uniform(interval{0.0, 1.0}, 100'000);
    auto const two_sided = variation(nabla_integral(kinetic(q, Delta_minus_alpha<3, 4>[q]), D));
    auto const x = solve(two_sided, D, {.q0 = 0.0, .qN = 1.0});
    double const exact = 0.434147892582709; // 2/3 2^(-3/4) 2F1(1/4, 1; 7/4; 1/2)
    std::cout << two_sided << "q(0) = 0, q(1) = 1: q(1/2) = " << x[50'000] << ", and " << exact << " without steps\n";
    return amplitude < 0.7 and std::abs(of_root - std::sqrt(std::acos(-1.0)) / 2) < 0.001 and residual < 1e-8 and
                   std::abs(mean - last) < 0.01 and std::abs(x[50'000] - exact) < 0.0005
               ? 0
               : 1;
}
