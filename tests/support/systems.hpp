// SPDX-License-Identifier: BSL-1.0
// The systems that tests of whole trajectories run.
#pragma once

#include <cmath>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::testing {

inline constexpr lagrangian pendulum{[](auto const& x, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(x);
}};
/// Non-separable: the mass depends on the position.
inline constexpr lagrangian bead{[](auto const& x, auto const& v) { return v * v * (1 + x * x) / 2 - x * x / 2; }};
/// Quadratic with a gyroscopic term: steps are exact in the rationals.
inline constexpr lagrangian oscillator{[](auto const& x, auto const& v) { return v * v / 2 + v * x / 3 - x * x / 2; }};
/// In the plane, with gravitational parameter 1.
inline constexpr lagrangian kepler{[](auto const& x, auto const& v) {
    using std::sqrt;
    return v.dot(v) / 2 + 1 / sqrt(x.dot(x));
}};
/// y - 1 = 5 ((1 + y)/2)^2: from x = 1 a mid-point step h = 1 has no solution; shorter ones run away in finite time.
inline constexpr lagrangian cubic{[](auto const& x, auto const& v) { return v * v / 2 + 10 * x * x * x / 3; }};

/// Equal to a relative tolerance; doctest's Approx compares small numbers absolutely.
inline bool near(double value, double expected, double tolerance) { return std::abs(value / expected - 1) <= tolerance; }
} // namespace hilger::testing
