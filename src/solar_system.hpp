// SPDX-License-Identifier: BSL-1.0
// The outer solar system as a mechanical system: six bodies, d = 18, in the frame of their centre of mass.
// Units: au, day, solar mass. Data and G: Hairer, Lubich, Wanner, Geometric Numerical Integration, I.2.4.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "hilger/models/mechanical.hpp"

namespace program {

constexpr int bodies = 6;
constexpr int dimension = 3 * bodies;
using positions = Eigen::Matrix<double, dimension, 1>;

struct solar_system {
    std::vector<std::string> names;
    positions mass;                                     ///< each body's mass three times, once per coordinate
    positions q, v;                                     ///< initial positions and velocities, centre of mass at rest at the origin
    static constexpr double gravity = 2.95912208286e-4; ///< au^3 / (day^2 solar mass)

    /// L(q, v) = sum m |v|^2 / 2 + sum_{i<j} G m_i m_j / |q_i - q_j|, with constants in the digits of S.
    template <class S = double>
    [[nodiscard]] auto lagrangian() const {
        auto const list = hilger::all_pairs(bodies);
        std::vector<S> strength;
        for (auto const& [a, b] : list) strength.push_back(S(gravity) * S(mass(3 * a)) * S(mass(3 * b)));
        return hilger::mechanical(Eigen::Matrix<S, dimension, 1>(mass.cast<S>()),
                                  hilger::pairs<3>(list, [strength](hilger::index_type k, auto const& r) {
                                      return -strength[static_cast<std::size_t>(k)] / r.norm();
                                  }));
    }
    /// H(p, q) = sum |p|^2 / (2 m) + U(q)
    template <class L>
    [[nodiscard]] double energy(L const& l, positions const& x, positions const& p) const {
        return p.dot(p.cwiseQuotient(mass)) / 2 + l.potential()(x);
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
