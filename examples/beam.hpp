// SPDX-License-Identifier: BSL-1.0
// A cantilever of Euler and Bernoulli by finite elements: cubic deflection in each, so that the degrees of freedom are deflection and slope
// at the nodes. Clamped at node 0; components 2j - 2 and 2j - 1 of a vector are deflection and slope at node j = 1 ... elements. Under a
// force at a node the static deflection is the exact one.
#pragma once

#include <Eigen/Core>

#include "hilger/error.hpp"
#include "hilger/scalar.hpp"

namespace beams {

/// Consistent mass and stiffness, 2 elements x 2 elements, symmetric.
template <class S>
struct beam_matrices {
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    matrix mass, stiffness;
    /// The degree of freedom that is the deflection of the free end.
    [[nodiscard]] hilger::index_type tip() const { return mass.rows() - 2; }
};

/// Length L, bending stiffness EI (force length^2), mass per length rho A. @throws hilger::error::invalid_parameter unless all are positive
template <class S>
beam_matrices<S> cantilever(S const& length, S const& bending_stiffness, S const& mass_per_length, int elements) {
    for (S const& x : {length, bending_stiffness, mass_per_length, S(elements)})
        if (not hilger::is_finite(x) or not(S(0) < x))
            hilger::error::raise<hilger::error::invalid_parameter>(
                "length, bending stiffness, mass and number of elements of a beam are positive, and one of "
                "them is ",
                x);
    S const l = length / S(elements);
    // Deflection and slope at the left, then at the right; slopes times l.
    int const k[4][4] = {{12, 6, -12, 6}, {6, 4, -6, 2}, {-12, -6, 12, -6}, {6, 2, -6, 4}};
    int const m[4][4] = {{156, 22, 54, -13}, {22, 4, 13, -3}, {54, 13, 156, -22}, {-13, -3, -22, 4}};
    hilger::index_type const d = 2 * elements;
    using matrix = typename beam_matrices<S>::matrix;
    beam_matrices<S> beam{matrix::Zero(d, d), matrix::Zero(d, d)};
    for (int e = 0; e < elements; ++e)
        for (int i = 0; i < 4; ++i)
            for (int j = 0; j < 4; ++j) {
                int const row = 2 * e + i - 2, column = 2 * e + j - 2;
                if (row < 0 or column < 0) continue; // clamped
                S slopes(1);
                for (int n = i % 2 + j % 2; n > 0; --n) slopes = slopes * l;
                beam.stiffness(row, column) = beam.stiffness(row, column) + S(k[i][j]) * slopes * bending_stiffness / (l * l * l);
                beam.mass(row, column) = beam.mass(row, column) + S(m[i][j]) * slopes * mass_per_length * l / S(420);
            }
    return beam;
}

} // namespace beams
