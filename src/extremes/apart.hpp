// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>
#include <cmath>

#include "hilger/scalar.hpp"

namespace extremes {

/// The largest distance of two trajectories on T from the same position and momentum, in epsilons.
template <class Flow, class Other, class Scale>
double apart(Flow const& flow, Other const& other, Scale const& T, double q0, double p0) {
    auto const path = flow.along(T, q0, p0);
    auto const there = other.along(T, q0, p0);
    auto y = there.begin();
    double worst = 0;
    for (auto const& x : path) {
        worst = std::max({worst, std::abs(x.q - y->q), std::abs(x.p - y->p)});
        ++y;
    }
    return worst / hilger::epsilon<double>();
}

} // namespace extremes
