// SPDX-License-Identifier: BSL-1.0
// Lagrangians of many degrees of freedom written as plain lambdas, of which nothing is said but their formula: a coupled oscillator with
// d = 6 and 12 (h = 0.01), and a chain of 1000 with walls, quartic springs and Eigen vectors of dynamic size (h = 0.1).
#include <algorithm>
#include <array>

#include "hilger/hilger.hpp"
#include "timing.hpp"

namespace bench {
namespace {

/// L = |v|^2/2 - |q|^2/2 - q_first^2 q_last^2
template <int D>
struct coupled {
    static constexpr int d = D;
    static constexpr double h = 0.01;
    using state = std::array<double, D>;
    static void force(state const& q, state& g) {
        for (std::size_t k = 0; k < D; ++k) g[k] = -q[k];
        g[0] -= 2 * q[0] * q[D - 1] * q[D - 1];
        g[D - 1] -= 2 * q[D - 1] * q[0] * q[0];
    }
    static constexpr auto L = [](auto const& q, auto const& v) {
        auto const last = q.size() - 1;
        return v.dot(v) / 2 - q.dot(q) / 2 - q(0) * q(0) * q(last) * q(last);
    };
};
/// U = sum_k r^2/2 + r^4/4 over the N + 1 springs
template <int D>
struct springs {
    static constexpr int d = D;
    static constexpr double h = 0.1;
    using state = std::array<double, D>;
    static void force(state const& q, state& g) {
        double before = q[0] + q[0] * q[0] * q[0];
        for (std::size_t k = 0; k + 1 < D; ++k) {
            double const r = q[k + 1] - q[k], tension = r + r * r * r;
            g[k] = tension - before;
            before = tension;
        }
        double const r = -q[D - 1];
        g[D - 1] = r + r * r * r - before;
    }
    static constexpr auto L = [](auto const& q, auto const& v) {
        auto const energy = [](auto const& r) { return r * r / 2 + r * r * r * r / 4; };
        auto const n = q.size();
        auto sum = v.dot(v) / 2 - energy(q(0)) - energy(q(n - 1));
        for (int k = 1; k < n; ++k) sum = sum - energy(q(k) - q(k - 1));
        return sum;
    };
};
template <class System>
typename System::state start() {
    typename System::state q;
    for (std::size_t k = 0; k < q.size(); ++k)
        q[k] = std::sin(3.14159265358979 * static_cast<double>(k + 1) / static_cast<double>(q.size() + 1)) / 2;
    return q;
}
template <class System>
double order_one_by_hand(long n) {
    auto q = start<System>();
    typename System::state p{}, g;
    double s = 0;
    for (long i = 0; i < n; ++i) {
        s += q[1];
        System::force(q, g);
        for (std::size_t k = 0; k < q.size(); ++k) {
            p[k] += System::h * g[k];
            q[k] += System::h * p[k];
        }
    }
    return s + q[1];
}
/// v = p + h/2 g(q + h/2 v), iterated; the guess is the polynomial through the last six velocities.
template <class System>
double mid_point_by_hand(long n) {
    constexpr double h = System::h;
    using state = typename System::state;
    constexpr std::size_t d = System::d;
    state q = start<System>(), p{}, g, v, A;
    std::array<state, 6> past{};
    double s = 0;
    for (long i = 0; i < n; ++i) {
        s += q[1];
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
    return s + q[1];
}
template <class System, class V>
auto stepped(auto const& how) {
    return [flow = hilger::embed(System::L, how)](long n) {
        auto const first = start<System>();
        V const q = Eigen::Map<Eigen::Matrix<double, System::d, 1> const>(first.data()), p = V::Zero(q.size());
        double s = 0;
        for (auto const& x : flow.along(hilger::uniform(0.0, System::h, n), q, p)) s += x.q(1);
        return s;
    };
}
template <class System, class V>
void race_of(std::string const& name, long steps) {
    race(name + ", order one", steps, 7,
         {{"hilger, a plain lambda", stepped<System, V>(hilger::order_one)}, {"symplectic Euler", order_one_by_hand<System>, true}});
    race(name + ", mid-point", steps, 7,
         {{"hilger, a plain lambda", stepped<System, V>(hilger::mid_point)},
          {"iteration from six velocities", mid_point_by_hand<System>, true}});
}

} // namespace

void plain_lambdas() {
    race_of<coupled<6>, Eigen::Matrix<double, 6, 1>>("Coupled oscillator, d = 6", 200'000);
    race_of<coupled<12>, Eigen::Matrix<double, 12, 1>>("Coupled oscillator, d = 12", 100'000);
    race_of<springs<1000>, Eigen::VectorXd>("Chain of 1000", 3'000);
}

} // namespace bench
