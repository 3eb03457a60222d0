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
    static constexpr in_many_digits wide = in_many_digits::gauss;
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

/// Two equal pendulums, one hanging from the other, angles q_0, q_1: L = v_0^2 + v_1^2 / 2 + v_0 v_1 cos(q_0 - q_1) + 2 cos q_0 + cos q_1.
struct double_pendulum_system {
    static constexpr in_many_digits wide = in_many_digits::nothing;
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        return [](auto const& q, auto const& v) {
            return v(0) * v(0) + v(1) * v(1) / 2 + v(0) * v(1) * cos(q(0) - q(1)) + 2 * cos(q(0)) + cos(q(1));
        };
    }
    template <class S>
    [[nodiscard]] auto start() const {
        return hilger::initial_velocity<column<S, 2>>{{S(3) / S(2), S(1)}, {S(0), S(0)}};
    }
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        return std::vector<scalar_of_state<State>>{hilger::energy(l)(x)};
    }
};

/// L = |v|^2 / 2 + 1 / |q|, from the nearest point of an ellipse of eccentricity 3/5 and period 2 pi.
struct kepler_system {
    static constexpr in_many_digits wide = in_many_digits::gauss;
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
    static constexpr in_many_digits wide = in_many_digits::gauss;
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

/// A charge in the field B = |q| e_z of a vector potential A = |q| (-y, x) / 3, with the electric potential 1 / (100 |q|); in the plane.
struct charged_particle_system {
    static constexpr in_many_digits wide = in_many_digits::nothing;
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        return [](auto const& q, auto const& v) {
            auto const r = q.norm();
            return v.squaredNorm() / 2 + r * (q(0) * v(1) - q(1) * v(0)) / 3 - 1 / (100 * r);
        };
    }
    template <class S>
    [[nodiscard]] auto start() const {
        return hilger::initial_velocity<column<S, 2>>{{S(0), S(1)}, {S(1) / S(10), S(1) / S(100)}};
    }
    /// Energy and, by the symmetry of rotations, q x p.
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        using S = scalar_of_state<State>;
        return std::vector<S>{hilger::energy(l)(x), S(x.q(0) * x.p(1) - x.q(1) * x.p(0))};
    }
};

/// Fermi, Pasta, Ulam: 32 particles between two walls, springs r^2/2 + r^3/12, the lowest mode excited.
struct fermi_pasta_ulam_system {
    static constexpr in_many_digits wide = in_many_digits::composition;
    static constexpr int size = 32;
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        return hilger::mechanical(S(1), hilger::chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    }
    template <class S>
    [[nodiscard]] auto start() const {
        using std::sin, std::atan;
        column<S, size> q, v = column<S, size>::Zero();
        for (int k = 0; k < size; ++k) q(k) = sin(S(S(4) * atan(S(1)) * S(k + 1) / S(size + 1)));
        return hilger::initial_velocity<column<S, size>>{q, v};
    }
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        using S = scalar_of_state<State>;
        return std::vector<S>{S(x.p.dot(x.p) / S(2) + l.potential()(x.q))};
    }
};

/// The system of solar_system.hpp in any scalar.
struct planetary_system {
    solar_system data;
    static constexpr in_many_digits wide = in_many_digits::gauss;
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
