// SPDX-License-Identifier: BSL-1.0
// Pendulum (q = 1.5, h = 0.1), Henon-Heiles (E = 0.1247, h = 0.05), Kepler (e = 0.6, h = 0.01) by hand: the fastest loops we know. Each
// makes n steps and returns the sum of the first positions, so that nothing is optimised away.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace bench {

// The three systems by hand: g = -grad U, H = -Hess U (xx, xy, yy).
struct pendulum {
    static constexpr int d = 1;
    static constexpr double h = 0.1;
    static constexpr std::array<double, 1> q0{1.5}, p0{0.0};
    static void force(std::array<double, 1> const& q, std::array<double, 1>& g) { g[0] = -std::sin(q[0]); }
    static void both(std::array<double, 1> const& q, std::array<double, 1>& g, std::array<double, 3>& H) {
        g[0] = -std::sin(q[0]);
        H[0] = -std::cos(q[0]);
    }
    static constexpr auto L = [](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); };
};
struct henon_heiles {
    static constexpr int d = 2;
    static constexpr double h = 0.05;
    static constexpr std::array<double, 2> q0{0.0, 0.1}, p0{0.49, 0.0};
    static void force(std::array<double, 2> const& q, std::array<double, 2>& g) {
        g[0] = -q[0] - 2 * q[0] * q[1];
        g[1] = -q[1] - q[0] * q[0] + q[1] * q[1];
    }
    static void both(std::array<double, 2> const& q, std::array<double, 2>& g, std::array<double, 3>& H) {
        force(q, g);
        H = {-1 - 2 * q[1], -2 * q[0], -1 + 2 * q[1]};
    }
    static constexpr auto L = [](auto const& x, auto const& v) {
        return v.squaredNorm() / 2 - (x.squaredNorm() / 2 + x(0) * x(0) * x(1) - x(1) * x(1) * x(1) / 3);
    };
};
struct kepler {
    static constexpr int d = 2;
    static constexpr double h = 0.01;
    static constexpr std::array<double, 2> q0{0.4, 0.0}, p0{0.0, 2.0};
    static void force(std::array<double, 2> const& q, std::array<double, 2>& g) {
        double const r2 = q[0] * q[0] + q[1] * q[1], i3 = 1 / (r2 * std::sqrt(r2));
        g[0] = -q[0] * i3;
        g[1] = -q[1] * i3;
    }
    static void both(std::array<double, 2> const& q, std::array<double, 2>& g, std::array<double, 3>& H) {
        double const r2 = q[0] * q[0] + q[1] * q[1], i = 1 / std::sqrt(r2), i2 = i * i, i3 = i * i2, i5 = 3 * i3 * i2;
        g[0] = -q[0] * i3;
        g[1] = -q[1] * i3;
        H = {i5 * q[0] * q[0] - i3, i5 * q[0] * q[1], i5 * q[1] * q[1] - i3};
    }
    static constexpr auto L = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + 1 / x.norm(); };
};

template <class P>
using vector = std::array<double, static_cast<std::size_t>(P::d)>;

/// A friction of so many thousandths of v.
template <int Thousandths>
inline constexpr double friction = Thousandths / 1000.0;

template <class P, int Thousandths = 0>
double order_one_by_hand(long n, vector<P> q = P::q0, vector<P> p = P::p0) {
    double s = 0;
    for (long i = 0; i < n; ++i) {
        s += q[0];
        vector<P> g;
        P::force(q, g);
        for (std::size_t k = 0; k < P::d; ++k) p[k] = (p[k] + P::h * g[k]) * (1 / (1 + P::h * friction<Thousandths>));
        for (std::size_t k = 0; k < P::d; ++k) q[k] += P::h * p[k];
    }
    return s + q[0];
}
/// One force a step.
template <class P>
double verlet_by_hand(long n, vector<P> q = P::q0, vector<P> p = P::p0) {
    double s = 0;
    vector<P> g;
    P::force(q, g);
    for (long i = 0; i < n; ++i) {
        s += q[0];
        for (std::size_t k = 0; k < P::d; ++k) p[k] += P::h / 2 * g[k];
        for (std::size_t k = 0; k < P::d; ++k) q[k] += P::h * p[k];
        P::force(q, g);
        for (std::size_t k = 0; k < P::d; ++k) p[k] += P::h / 2 * g[k];
    }
    return s + q[0];
}
/// Newton to 1e-8 with the last correction applied to the gradient; no further gradient for p. Guess: the polynomial through the last Past
/// velocities, 2 being the usual linear one.
template <class P, int Past, int Thousandths = 0>
double midpoint_by_hand(long n, vector<P> q = P::q0, vector<P> p = P::p0) {
    constexpr double h = P::h, r = friction<Thousandths>;
    std::array<vector<P>, Past> past;
    past.fill(p);
    double s = 0;
    for (long i = 0; i < n; ++i) {
        s += q[0];
        vector<P> v{};
        double binomial = 1;
        for (int m = 0; m < Past; ++m) {
            binomial = binomial * (Past - m) / (m + 1);
            for (std::size_t k = 0; k < P::d; ++k) v[k] += (m % 2 == 0 ? binomial : -binomial) * past[static_cast<std::size_t>(m)][k];
        }
        for (int iteration = 0;; ++iteration) {
            vector<P> A, g, d;
            std::array<double, 3> H{};
            for (std::size_t k = 0; k < P::d; ++k) A[k] = q[k] + h / 2 * v[k];
            P::both(A, g, H);
            for (std::size_t k = 0; k < P::d; ++k) {
                if constexpr (Thousandths > 0) g[k] -= r * v[k]; // no compiler drops 0 * v
                d[k] = v[k] - h / 2 * g[k] - p[k];
            }
            constexpr double c = h * h / 4, one = 1 + h / 2 * r;
            if constexpr (P::d == 1) {
                d[0] /= one - c * H[0];
                g[0] -= (h / 2 * H[0] - r) * d[0];
            } else {
                double const a = one - c * H[0], b = -c * H[1], e = one - c * H[2], i1 = 1 / (a * e - b * b);
                d = {(e * d[0] - b * d[1]) * i1, (a * d[1] - b * d[0]) * i1};
                g[0] -= h / 2 * (H[0] * d[0] + H[1] * d[1]);
                g[1] -= h / 2 * (H[1] * d[0] + H[2] * d[1]);
                if constexpr (Thousandths > 0)
                    for (std::size_t k = 0; k < P::d; ++k) g[k] += r * d[k];
            }
            double size = 0, reach = 0;
            for (std::size_t k = 0; k < P::d; ++k) {
                v[k] -= d[k];
                size = std::max(size, std::abs(d[k]));
                reach = std::max(reach, std::abs(v[k]));
            }
            if (size < 1e-8 * (1 + reach) or iteration > 20) {
                for (std::size_t k = 0; k < P::d; ++k) {
                    q[k] += h * v[k];
                    p[k] += h * g[k];
                }
                break;
            }
        }
        for (std::size_t m = Past - 1; m > 0; --m) past[m] = past[m - 1];
        past[0] = v;
    }
    return s + q[0];
}

} // namespace bench
