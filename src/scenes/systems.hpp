// SPDX-License-Identifier: BSL-1.0
// The systems of the scenes, in any scalar: Lagrangian, initial position and velocity, what stays constant.
#pragma once

#include "hilger/hilger.hpp"
#include "methods.hpp"
#include "scene.hpp"
#include "solar_system.hpp"

namespace program {

template <class S, int D>
using column = Eigen::Matrix<S, D, 1>;
template <class State>
using scalar_of_state = std::remove_cvref_t<decltype(std::declval<State const&>().t)>;

/// L = v^2 / 2 + cos q, swinging to 1.5.
struct pendulum_system {
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        return [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
    }
    template <class S>
    [[nodiscard]] auto start() const {
        return hilger::initial_velocity<S>{S(3) / S(2), S(0)};
    }
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        return std::vector<scalar_of_state<State>>{hilger::energy(l)(x)};
    }
};

/// L = |v|^2 / 2 + 1 / |q|, from the nearest point of an ellipse of eccentricity 3/5 and period 2 pi.
struct kepler_system {
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        return [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); };
    }
    template <class S>
    [[nodiscard]] auto start() const {
        return hilger::initial_velocity<column<S, 2>>{{S(2) / S(5), S(0)}, {S(0), S(2)}};
    }
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        using S = scalar_of_state<State>;
        return std::vector<S>{hilger::energy(l)(x), S(x.q(0) * x.p(1) - x.q(1) * x.p(0))};
    }
};

/// L = |v|^2 / 2 - |q|^2 / 2 - x^2 y + y^3 / 3 at the energy 0.1247.
struct henon_heiles_system {
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        return [](auto const& q, auto const& v) {
            return v.squaredNorm() / 2 - q.squaredNorm() / 2 - q(0) * q(0) * q(1) + q(1) * q(1) * q(1) / 3;
        };
    }
    template <class S>
    [[nodiscard]] auto start() const {
        return hilger::initial_velocity<column<S, 2>>{{S(0), S(1) / S(10)}, {S(49) / S(100), S(0)}};
    }
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        return std::vector<scalar_of_state<State>>{hilger::energy(l)(x)};
    }
};

/// The system of solar_system.hpp in any scalar.
struct planetary_system {
    solar_system data;
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        return data.lagrangian<S>();
    }
    template <class S>
    [[nodiscard]] auto start() const {
        return hilger::initial_velocity<column<S, dimension>>{data.q.cast<S>(), data.v.cast<S>()};
    }
    /// Energy and the three components of the angular momentum.
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        using S = scalar_of_state<State>;
        std::vector<S> all{S(x.p.dot(x.p.cwiseQuotient(l.mass())) / S(2) + l.potential()(x.q)), S(0), S(0), S(0)};
        for (int i = 0; i < dimension; i += 3)
            for (int c = 0; c < 3; ++c) {
                int const a = (c + 1) % 3, b = (c + 2) % 3;
                all[static_cast<std::size_t>(c) + 1] += x.q(i + a) * x.p(i + b) - x.q(i + b) * x.p(i + a);
            }
        return all;
    }
};

} // namespace program
