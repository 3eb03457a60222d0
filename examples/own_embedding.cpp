// SPDX-License-Identifier: BSL-1.0
// A calculus of one's own is three operators. Here: positions a third of the way into each step.
#include <cmath>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr auto mine = make_embedding<step_weight>(on_lambda<1, 3> * extend_lambda<1, 3>, // where q is read, on T_{1/3}
                                                      pi_lambda_inverse<1, 3> * Delta_plus,  // where the velocity is read
                                                      "a third of the way");
    static_assert(mine.position == theta<1, 3>.position and mine.velocity == theta<1, 3>.velocity);

    constexpr lagrangian L{[](auto x, auto v) { return v * v / 2 - x * x / 2; }};
    auto const T = uniform(interval{0.0, 6.0}, 600);
    auto const path = embed(L, mine).along(T, 1.0, 0.0);
    double const residual = largest_residual(path); // of the equation that its operators and their adjoints make
    std::cout << equation_of(path.method(), T) << "largest residual: " << residual << '\n';
    for (auto const& [t, q, p] : path)
        if (t == T.max()) {
            std::cout << mine.name << ": q(" << t << ") = " << q << ", cos(" << t << ") = " << std::cos(t) << '\n';
            return std::abs(q - std::cos(t)) < 0.01 and residual < 1e-10 ? 0 : 1;
        }
    return 1;
}
