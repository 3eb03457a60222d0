// SPDX-License-Identifier: BSL-1.0
// Loops by hand for unit masses, the fastest we know. A System has d, the step h, force(q, g) and start(); both loops return the sum of the
// positions of one component, so that nothing is optimised away.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace bench {

template <class System>
double symplectic_euler(long n) {
    auto q = System::start();
    decltype(q) p{}, g;
    double s = 0;
    for (long i = 0; i < n; ++i) {
        s += q[3];
        System::force(q, g);
        for (std::size_t k = 0; k < q.size(); ++k) {
            p[k] += System::h * g[k];
            q[k] += System::h * p[k];
        }
    }
    return s + q[3];
}
/// v = p + h/2 g(q + h/2 v), iterated; the guess is the polynomial through the last six velocities.
template <class System>
double mid_point_by_iteration(long n) {
    constexpr double h = System::h;
    auto q = System::start();
    using state = decltype(q);
    constexpr std::size_t d = System::d;
    state p{}, g, v, A;
    std::array<state, 6> past{};
    double s = 0;
    for (long i = 0; i < n; ++i) {
        s += q[3];
        auto const at = [&](long m) -> state const& { return past[static_cast<std::size_t>((i + 5 - m) % 6)]; };
        state const &a = at(0), &b = at(1), &c = at(2), &e = at(3), &f = at(4), &l = at(5);
        for (std::size_t k = 0; k < d; ++k) v[k] = i < 6 ? p[k] : 6 * (a[k] + f[k]) + 20 * c[k] - 15 * (b[k] + e[k]) - l[k];
        double previous = 0;
        for (int round = 0; round < 30; ++round) {
            for (std::size_t k = 0; k < d; ++k) A[k] = q[k] + h / 2 * v[k];
            System::force(A, g);
            double size = 0, reach = 0;
            for (std::size_t k = 0; k < d; ++k) {
                double const next = p[k] + h / 2 * g[k];
                size = std::max(size, std::abs(next - v[k]));
                reach = std::max(reach, std::abs(next));
                v[k] = next;
            }
            if (size <= 8 * 2.2e-16 * reach or (round > 0 and size * size <= 1.1e-16 * reach * previous)) break;
            previous = size;
        }
        for (std::size_t k = 0; k < d; ++k) {
            q[k] += h * v[k];
            p[k] += h * g[k];
        }
        past[static_cast<std::size_t>(i % 6)] = v;
    }
    return s + q[3];
}

} // namespace bench
