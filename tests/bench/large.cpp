// SPDX-License-Identifier: BSL-1.0
// The outer solar system (d = 18, h = 100 days) and a Fermi-Pasta-Ulam chain (d = 128, alpha = 1/4, h = 0.1).
#include <fstream>
#include <sstream>

#include "by_hand.hpp"
#include "hilger/hilger.hpp"
#include "outer_solar_system_data.hpp"
#include "solar_system.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr int N = 128;
using row = std::array<double, N>;

void fpu_force(row const& q, row& g) {
    double tension[N + 1];
    for (std::size_t k = 0; k <= N; ++k) {
        double const r = (k < N ? q[k] : 0) - (k > 0 ? q[k - 1] : 0);
        tension[k] = r + r * r / 4;
    }
    for (std::size_t k = 0; k < N; ++k) g[k] = tension[k + 1] - tension[k];
}
row fpu_start() {
    row q;
    for (std::size_t k = 0; k < N; ++k) q[k] = std::sin(3.14159265358979 * static_cast<double>(k + 1) / (N + 1));
    return q;
}
/// Newton with a tridiagonal solve; the guess is linear.
double fpu_newton_by_hand(long n) {
    constexpr double h = 0.1;
    row q = fpu_start(), p{}, g, v{}, before{}, A, r, diagonal, below;
    double s = 0;
    for (long i = 0; i < n; ++i) {
        s += q[3];
        row const last = v;
        for (std::size_t k = 0; k < N; ++k) v[k] = 2 * v[k] - before[k];
        before = last;
        for (int iteration = 0; iteration < 20; ++iteration) {
            for (std::size_t k = 0; k < N; ++k) A[k] = q[k] + h / 2 * v[k];
            fpu_force(A, g);
            for (std::size_t k = 0; k < N; ++k) {
                double const left = A[k] - (k > 0 ? A[k - 1] : 0), right = (k + 1 < N ? A[k + 1] : 0) - A[k];
                diagonal[k] = 1 + h * h / 4 * (2 + left / 2 + right / 2);
                below[k] = -h * h / 4 * (1 + right / 2);
                r[k] = p[k] + h / 2 * g[k] - v[k];
            }
            for (std::size_t k = 0; k < N; ++k) {
                if (k > 0) {
                    double const f = below[k - 1] * diagonal[k - 1];
                    diagonal[k] -= f * below[k - 1];
                    r[k] -= f * r[k - 1];
                }
                diagonal[k] = 1 / diagonal[k];
            }
            double size = 0;
            r[N - 1] *= diagonal[N - 1];
            for (std::size_t k = N - 1; k-- > 0;) r[k] = (r[k] - below[k] * r[k + 1]) * diagonal[k];
            for (std::size_t k = 0; k < N; ++k) {
                v[k] += r[k];
                size = std::max(size, std::abs(r[k]));
            }
            if (size < 1e-9) break;
        }
        for (std::size_t k = 0; k < N; ++k) A[k] = q[k] + h / 2 * v[k];
        fpu_force(A, g);
        for (std::size_t k = 0; k < N; ++k) {
            q[k] += h * v[k];
            p[k] += h * g[k];
        }
    }
    return s + q[3];
}
struct fpu_chain {
    static constexpr std::size_t d = N;
    static constexpr double h = 0.1;
    static void force(row const& q, row& g) { fpu_force(q, g); }
    static row start() { return fpu_start(); }
};

using program::positions;
struct solar {
    program::solar_system system;
    std::array<double, 15> strength;
    positions inverse_mass, p0;

    solar() {
        std::istringstream data(outer_solar_system_csv);
        system = program::read_solar_system(data, "the built-in data");
        std::size_t n = 0;
        for (auto const& [a, b] : hilger::all_pairs(program::bodies))
            strength[n++] = system.gravity * system.mass(3 * a) * system.mass(3 * b);
        inverse_mass = system.mass.cwiseInverse();
        p0 = system.mass.cwiseProduct(system.v);
    }
    void force(positions const& q, positions& g) const {
        g.setZero();
        std::size_t n = 0;
        for (int a = 0; a < program::bodies; ++a)
            for (int b = 0; b < a; ++b, ++n) {
                double const x = q(3 * a) - q(3 * b), y = q(3 * a + 1) - q(3 * b + 1), z = q(3 * a + 2) - q(3 * b + 2);
                double const r2 = x * x + y * y + z * z, f = strength[n] / (r2 * std::sqrt(r2));
                g(3 * a) -= f * x, g(3 * a + 1) -= f * y, g(3 * a + 2) -= f * z;
                g(3 * b) += f * x, g(3 * b + 1) += f * y, g(3 * b + 2) += f * z;
            }
    }
    [[nodiscard]] double order_one_by_hand(long n) const {
        positions q = system.q, p = p0, g;
        double s = 0;
        for (long i = 0; i < n; ++i) {
            s += q(3);
            force(q, g);
            p += 100 * g;
            q += 100 * inverse_mass.cwiseProduct(p);
        }
        return s + q(3);
    }
    [[nodiscard]] double midpoint_by_hand(long n) const {
        constexpr double h = 100;
        positions q = system.q, p = p0, g, v, next;
        std::array<positions, 6> past;
        double s = 0;
        for (long i = 0; i < n; ++i) {
            s += q(3);
            auto const at = [&](long m) -> positions const& { return past[static_cast<std::size_t>((i + 5 - m) % 6)]; };
            if (i < 6)
                v = inverse_mass.cwiseProduct(p);
            else
                v = 6 * (at(0) + at(4)) + 20 * at(2) - 15 * (at(1) + at(3)) - at(5);
            double previous = 0;
            for (int round = 0; round < 30; ++round) {
                force(q + h / 2 * v, g);
                next = inverse_mass.cwiseProduct(p + h / 2 * g);
                double const size = (next - v).cwiseAbs().maxCoeff(), reach = next.cwiseAbs().maxCoeff();
                v = next;
                if (size <= 8 * 2.2e-16 * reach or (round > 0 and size * size <= 1.1e-16 * reach * previous)) break;
                previous = size;
            }
            q += h * v;
            p += h * g;
            past[static_cast<std::size_t>(i % 6)] = v;
        }
        return s + q(3);
    }
    [[nodiscard]] auto lagrangian() const {
        auto const energy = [k = strength](hilger::index_type n, auto const& r) { return -k[static_cast<std::size_t>(n)] / r.norm(); };
        return hilger::mechanical(system.mass, hilger::pairs<3>(hilger::all_pairs(program::bodies), energy));
    }
};

} // namespace

void large_systems() {
    using hilger::embed;
    auto const chain = hilger::mechanical(1.0, hilger::chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    auto const fpu = [&](auto const& how) {
        return [flow = embed(chain, how)](long n) {
            row const start = fpu_start();
            Eigen::VectorXd const q = Eigen::Map<Eigen::VectorXd const>(start.data(), N), p = Eigen::VectorXd::Zero(N);
            double s = 0;
            for (auto const& x : flow.along(hilger::uniform(0.0, 0.1, n), q, p)) s += x.q(3);
            return s;
        };
    };
    race("Fermi-Pasta-Ulam chain, d = 128, mid-point", 2000, 30,
         {{"hand: Newton, tridiagonal solve, linear guess", fpu_newton_by_hand, true},
          {"hand: iteration, guess through 6 velocities", mid_point_by_iteration<fpu_chain>, true},
          {"hilger: embed(mechanical(1, chain), mid_point)", fpu(hilger::mid_point)}});
    race("Fermi-Pasta-Ulam chain, d = 128, order one", 2000, 30,
         {{"hand: symplectic Euler", symplectic_euler<fpu_chain>, true},
          {"hilger: embed(mechanical(1, chain), order_one)", fpu(hilger::order_one)}});
    static solar const planets;
    auto const run = [](auto const& how) {
        return [flow = embed(planets.lagrangian(), how)](long n) {
            double s = 0;
            for (auto const& x : flow.along(hilger::uniform(0.0, 100.0, n), planets.system.q, planets.p0)) s += x.q(3);
            return s;
        };
    };
    race("Outer solar system, d = 18, mid-point", 2000, 30,
         {{"hand: iteration, guess through 6 velocities", [](long n) { return planets.midpoint_by_hand(n); }, true},
          {"hilger: embed(mechanical(m, pairs<3>), mid_point)", run(hilger::mid_point)}});
    race("Outer solar system, d = 18, order one", 2000, 30,
         {{"hand: symplectic Euler", [](long n) { return planets.order_one_by_hand(n); }, true},
          {"hilger: embed(mechanical(m, pairs<3>), order_one)", run(hilger::order_one)}});
}

} // namespace bench
