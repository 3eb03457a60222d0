// SPDX-License-Identifier: BSL-1.0
// Lagrangians of many degrees of freedom written as plain lambdas, of which nothing is said but their formula: a coupled oscillator with
// d = 6 and 12 (h = 0.01), and a chain of 1000 with walls, quartic springs and Eigen vectors of dynamic size (h = 0.1). And what it costs
// to judge them: residuals, energies, states between the points.
#include <array>
#include <iomanip>
#include <iostream>

#include "by_hand.hpp"
#include "hilger/hilger.hpp"
#include "scenes/measure.hpp"
#include "timing.hpp"

namespace bench {
namespace {

template <int D>
std::array<double, D> half_a_sine() {
    std::array<double, D> q;
    for (std::size_t k = 0; k < D; ++k) q[k] = std::sin(3.14159265358979 * static_cast<double>(k + 1) / (D + 1)) / 2;
    return q;
}
/// L = |v|^2/2 - |q|^2/2 - q_first^2 q_last^2
template <int D>
struct coupled {
    static auto start() { return half_a_sine<D>(); }
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
    static auto start() { return half_a_sine<D>(); }
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
template <class System, class V>
auto stepped(auto const& how) {
    return [flow = hilger::embed(System::L, how)](long n) {
        auto const first = System::start();
        V const q = Eigen::Map<Eigen::Matrix<double, System::d, 1> const>(first.data()), p = V::Zero(q.size());
        double s = 0;
        for (auto const& x : flow.along(hilger::uniform(0.0, System::h, n), q, p)) s += x.q(3);
        return s;
    };
}
template <class System, class V>
void race_of(std::string const& name, long steps) {
    race(name + ", order one", 10 * steps, 7, // to trace a chain takes as long as a thousand of its steps
         {{"hilger, a plain lambda", stepped<System, V>(hilger::order_one)}, {"symplectic Euler", symplectic_euler<System>, true}});
    race(name + ", mid-point", steps, 7,
         {{"hilger, a plain lambda", stepped<System, V>(hilger::mid_point)},
          {"iteration from six velocities", mid_point_by_iteration<System>, true}});
}

/// Microseconds a step of the mid-point: walked, and walked with what is asked of its states.
template <class System>
void judged(char const* name, hilger::index_type steps) {
    auto const first = System::start();
    Eigen::VectorXd const q = Eigen::Map<Eigen::Matrix<double, System::d, 1> const>(first.data()), p = Eigen::VectorXd::Zero(q.size());
    auto const path = hilger::embed(System::L, hilger::mid_point).along(hilger::uniform(0.0, System::h, steps), q, p);
    double kept = 0;
    auto const row = [&](char const* what, auto const& work) {
        std::cout << "  " << std::left << std::setw(60) << what << std::right << std::fixed << std::setprecision(1) << std::setw(10)
                  << program::fastest([&] { kept += work(); }) * 1e6 / static_cast<double>(steps) << " us\n";
    };
    std::cout << '\n' << name << '\n';
    row("walked", [&] { return hilger::record(path).states.back().q(0); });
    row("and its equation: largest_residual", [&] { return hilger::largest_residual(path); });
    row("and its energy: drift_along", [&] { return hilger::drift_along(path, hilger::energy(System::L)).largest; });
    row("and kept for states between its points: dense_output", [&] { return hilger::dense_output(path)(0.5 * System::h).q(0); });
    std::cout << std::defaultfloat << std::setprecision(6) << "  (" << kept << ")\n";
}

} // namespace

void plain_lambdas() {
    race_of<coupled<6>, Eigen::Matrix<double, 6, 1>>("Coupled oscillator, d = 6", 200'000);
    race_of<coupled<12>, Eigen::Matrix<double, 12, 1>>("Coupled oscillator, d = 12", 100'000);
    race_of<springs<1000>, Eigen::VectorXd>("Chain of 1000", 3'000);
    std::cout << "\nWhat judging costs, microseconds a step\n";
    judged<coupled<6>>("Coupled oscillator, d = 6", 1000);
    judged<springs<30>>("Chain of 30", 300);
    judged<springs<1000>>("Chain of 1000", 30);
}

} // namespace bench
