// SPDX-License-Identifier: BSL-1.0
// Vectors are Eigen's, and the scalar is the user's: Kepler's ellipse, e = 0.6, in double and in 50 digits.
#include <iostream>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

using namespace hilger;

template <class S>
S angular_momentum_error() {
    using vector = Eigen::Matrix<S, 2, 1>;
    lagrangian const L{[](auto const& q, auto const& v) {
        using std::sqrt;
        return v.dot(v) / 2 + 1 / sqrt(q.dot(q));
    }};
    vector const q0(S(2) / S(5), S(0)), p0(S(0), S(2));
    S worst(0);
    for (auto const& [t, q, p] : embed(L, mid_point).along(uniform(S(0), S(1) / S(50), 500), q0, p0)) {
        using std::abs;
        worst = std::max(worst, S(abs(q(0) * p(1) - q(1) * p(0) - S(4) / S(5))));
    }
    return worst;
}

int main() {
    double const narrow = angular_momentum_error<double>();
    float50 const wide = angular_momentum_error<float50>();
    std::cout << "error of the angular momentum: " << narrow << " in double, " << wide << " in 50 digits\n";
    return narrow < 1e-12 and wide < float50(1e-45) ? 0 : 1;
}
