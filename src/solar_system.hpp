// SPDX-License-Identifier: BSL-1.0
// The outer solar system as a mechanical system: six bodies, d = 18, in the frame of their centre of mass.
// Units: au, day, solar mass. Data and G: Hairer, Lubich, Wanner, Geometric Numerical Integration, I.2.4.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace program {

constexpr int bodies = 6;
constexpr int dimension = 3 * bodies;
using positions = Eigen::Matrix<double, dimension, 1>;

struct solar_system {
    std::vector<std::string> names;
    positions mass;                                     ///< each body's mass three times, once per coordinate
    positions q, v;                                     ///< initial positions and velocities, centre of mass at rest at the origin
    static constexpr double gravity = 2.95912208286e-4; ///< au^3 / (day^2 solar mass)

    /// L(q, v) = sum m |v|^2 / 2 + sum_{i<j} G m_i m_j / |q_i - q_j|, in any number type.
    [[nodiscard]] auto lagrangian() const {
        return [m = mass](auto const& x, auto const& w) {
            using std::sqrt;
            using number = typename std::remove_cvref_t<decltype(x)>::Scalar;
            number sum(0);
            for (int k = 0; k < dimension; ++k) sum += w(k) * w(k) * (m(k) / 2);
            for (int i = 0; i < bodies; ++i)
                for (int j = 0; j < i; ++j) {
                    number const dx = x(3 * i) - x(3 * j), dy = x(3 * i + 1) - x(3 * j + 1), dz = x(3 * i + 2) - x(3 * j + 2);
                    sum += (gravity * m(3 * i) * m(3 * j)) / sqrt(dx * dx + dy * dy + dz * dz);
                }
            return sum;
        };
    }
    /// sum q x p
    [[nodiscard]] Eigen::Vector3d angular_momentum(positions const& x, positions const& p) const {
        Eigen::Vector3d total = Eigen::Vector3d::Zero();
        for (int i = 0; i < bodies; ++i) total += Eigen::Vector3d(x.segment<3>(3 * i)).cross(Eigen::Vector3d(p.segment<3>(3 * i)));
        return total;
    }
};

/// Lines "body,mass,x,y,z,vx,vy,vz" after a header, heliocentric; # starts a comment. @throws hilger::error::unreadable
solar_system read_solar_system(std::istream& in, std::string const& source);

} // namespace program
