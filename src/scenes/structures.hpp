// SPDX-License-Identifier: BSL-1.0
// The systems with a memory that the scenes walk along, in any scalar; and the problem that is solved at once.
#pragma once

#include <cmath>

#include "../papers/bourdin_cresson_greff_inizan_2013/exact.hpp"
#include "hilger/boundary/solve.hpp"
#include "hilger/fractional/zener.hpp"
#include "hilger/models/beam.hpp"

namespace program {

/// u'' + c D^alpha u + k u = f, f constant.
struct fractional_oscillator_system {
    int numerator, denominator;       ///< of alpha
    int damping_over, stiffness_over; ///< 1/c, 1/k
    int force;

    template <class S>
    [[nodiscard]] auto structure() const {
        return hilger::fractional_structure{S(1), S(1) / S(damping_over), S(1) / S(stiffness_over), S(1), S(numerator) / S(denominator)};
    }
    [[nodiscard]] auto load() const {
        return [f = force]<class S>(S const&) { return S(f); };
    }
};
inline constexpr fractional_oscillator_system damped_by_half_a_derivative{1, 2, 1, 1, 1}, plate_in_a_fluid{3, 2, 2, 2, 8};

/// A cantilever of 150 mm in five elements under 10 mN at its tip, of a fractional Zener material. Units: m, kg, s.
class viscoelastic_beam_system {
    static constexpr int elements_ = 5;

public:
    static constexpr int degrees_of_freedom = 2 * elements_;
    [[nodiscard]] static Eigen::VectorXd rest() { return Eigen::VectorXd::Zero(degrees_of_freedom); }
    [[nodiscard]] auto structure() const {
        return hilger::zener_structure{beam_.mass, beam_.stiffness, relaxed_, 50e6, 1e-3, hilger::fraction<1, 2>{}};
    }
    /// Grows for 50 ms.
    [[nodiscard]] auto load() const {
        return [tip = tip()]<class S>(S const& t) -> Eigen::Matrix<S, Eigen::Dynamic, 1> {
            double const force = 0.01, loaded = 0.05;
            return Eigen::Matrix<S, Eigen::Dynamic, 1>::Unit(degrees_of_freedom, tip) *
                   (t < S(loaded) ? S(t * S(force / loaded)) : S(force));
        };
    }
    [[nodiscard]] hilger::index_type tip() const { return beam_.tip(); }

private:
    static constexpr double length_ = 0.15, width_ = 0.025, thickness_ = 0.005, density_ = 1000, relaxed_ = 1e6;
    decltype(hilger::cantilever(1.0, 1.0, 1.0, elements_)) beam_ =
        hilger::cantilever(length_, relaxed_* width_* std::pow(thickness_, 3) / 12, density_* width_* thickness_, elements_);
};

/// D_+^alpha D_-^alpha q = 0, q(0) = 0, q(1) = 1, alpha = 3/4, in N steps.
[[nodiscard]] inline auto fractional_dirichlet_solution(hilger::index_type N) {
    return hilger::solve_boundary(hilger::fractional_problem(hilger::papers::dirichlet, hilger::fraction<3, 4>{}),
                                  hilger::uniform(hilger::interval{0.0, 1.0}, N), 0.0, 1.0);
}

} // namespace program
