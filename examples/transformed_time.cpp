// SPDX-License-Identifier: BSL-1.0
// A time scale that follows the motion: Kepler's problem with the eccentricity 0.9 over ten revolutions, in steps of equal t and in as many
// steps of equal tau, dt = r dtau, implicit ones of order 6 and explicit ones of order 2. Prints the errors of the energy and of the place
// at the solution's own times. Then a damped and driven oscillator, whose energy is no constant.
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

constexpr double eccentricity = 0.9;

/// The place at time t, by Kepler's equation.
Eigen::Vector2d ellipse(double t) {
    double const mean = std::remainder(t, 2 * std::acos(-1.0));
    double E = std::copysign(std::min(3.0, std::abs(mean) + eccentricity), mean);
    for (int i = 0; i < 50; ++i) E -= (E - eccentricity * std::sin(E) - mean) / (1 - eccentricity * std::cos(E));
    return {std::cos(E) - eccentricity, std::sqrt(1 - eccentricity * eccentricity) * std::sin(E)};
}

struct errors {
    double energy = 0, place = 0;
};

/// Along a path whose times are t(i).
template <class Path, class Times>
errors errors_of(Path const& path, Times const& t) {
    errors largest;
    index_type i = 0;
    for (auto const& x : path) {
        Eigen::Vector2d const q = x.q.template head<2>(), p = x.p.template head<2>();
        largest.energy = std::max(largest.energy, std::abs(p.squaredNorm() / 2 - 1 / q.norm() + 0.5));
        largest.place = std::max(largest.place, (q - ellipse(t(i))).norm());
        ++i;
    }
    return largest;
}

int main() {
    auto const kepler = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); };
    Eigen::Vector2d const q0(1 - eccentricity, 0), p0(0, std::sqrt((1 + eccentricity) / (1 - eccentricity)));
    auto const T = uniform(interval{0.0, 20 * std::acos(-1.0)}, 1000); // the mean of r over tau is 1

    auto const plain = embed(kepler, galerkin<3, gauss>).along(T, q0, p0);
    double const E = hamiltonian(kepler)(p0, q0);
    auto const path = embed(transform_time(kepler, sundman(1), E), galerkin<3, gauss>).along(T, q0, p0);
    auto const t = times_of(path);

    auto const K = [](auto const& p) { return p.squaredNorm() / 2; };
    auto const U = [](auto const& q) { return -1 / q.norm(); };
    Eigen::Vector3d const x0(q0(0), q0(1), 0), y0(p0(0), p0(1), -E); // (q, t) and (p, -E)
    auto const explicit_steps = record(position_verlet(lagrangian_of(logarithmic(K, U))).along(T, x0, y0));

    errors const equal = errors_of(plain, [&](index_type i) { return T.element(i); });
    errors const following = errors_of(path, [&](index_type i) { return t[i]; });
    errors const kicked =
        errors_of(explicit_steps.states, [&](index_type i) { return explicit_steps.states[static_cast<std::size_t>(i)].q(2); });
    std::cout << std::scientific << std::setprecision(1) << "errors of          energy     place\n"
              << "equal steps in t  " << equal.energy << "   " << equal.place << '\n'
              << "t' = r            " << following.energy << "   " << following.place << '\n'
              << "logarithmic       " << kicked.energy << "   " << kicked.place << '\n';

    // x = (q, t, e), and the momentum (p, -e, 0): q'' = -q + sin t - q'/5
    auto const driven = [](auto const& s, auto const& q, auto const& v) { return (v.dot(v) - q.dot(q)) / 2 + q(0) * sin(s); };
    auto const friction = [](auto const&, auto const& v) { return evaluated(-v / 5); };
    auto const rate = [](auto const& q) { return 1 / (1 + q.dot(q)); };
    auto const method = embed(transform_time(with_force(driven, friction), rate), galerkin<4, gauss>);
    double worst = 0; // -5 cos t is a motion
    for (auto const& [tau, x, p] : method.along(uniform(0.0, 0.05, 1000), Eigen::Vector3d(-5, 0, 12.5), Eigen::Vector3d(0, -12.5, 0)))
        worst = std::max(worst, std::abs(x(0) + 5 * std::cos(x(1))));
    std::cout << "a driven oscillator at its own times: within " << worst << '\n';
    return following.energy < 1e-7 and following.place < 1e-6 and following.energy < 1e-3 * equal.energy and kicked.energy < 1e-10 and
                   kicked.place < 1 and worst < 1e-6
               ? 0
               : 1;
}
