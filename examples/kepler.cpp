// SPDX-License-Identifier: BSL-1.0
// Vectors are Eigen's, and the scalar is the user's: Kepler's ellipse, e = 0.6, in double and in 50 digits. Prints what rounding leaves of
// the angular momentum, and of the equation that was stepped.
#include <iostream>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

using namespace hilger;

template <class S>
struct errors {
    S momentum, equation;
};

template <class S>
errors<S> errors_in() {
    using vector = Eigen::Matrix<S, 2, 1>;
    lagrangian const L{[](auto const& q, auto const& v) {
        using std::sqrt;
        return v.dot(v) / 2 + 1 / sqrt(q.dot(q));
    }};
    vector const q0(S(2) / S(5), S(0)), p0(S(0), S(2));
    auto const path = embed(L, mid_point).along(uniform(S(0), S(1) / S(50), 500), q0, p0);
    S worst(0);
    for (auto const& [t, q, p] : path) {
        using std::abs;
        worst = std::max(worst, S(abs(q(0) * p(1) - q(1) * p(0) - S(4) / S(5))));
    }
    return {worst, largest_residual(path)};
}

int main() {
    auto const narrow = errors_in<double>();
    auto const wide = errors_in<float50>();
    std::cout << "error of the angular momentum: " << narrow.momentum << " in double, " << wide.momentum << " in 50 digits\n"
              << "residual of the equation: " << narrow.equation << " in double, " << wide.equation << " in 50 digits\n";
    bool const kept = narrow.momentum < 1e-12 and wide.momentum < float50(1e-45);
    return kept and narrow.equation < 1e-10 and wide.equation < float50(1e-43) ? 0 : 1;
}
