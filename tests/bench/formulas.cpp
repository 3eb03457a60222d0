// SPDX-License-Identifier: BSL-1.0
// Formulas that are known at run time, interpreted and as machine code, and steps that are machine code as a whole, against the same
// formula in C++: mid-point, order one and Stoermer-Verlet.
#include <iomanip>

#include "engine/ensemble/whole_steps.hpp"
#include "engine/machine_code/machine_code.hpp"
#include "engine/motions.hpp"
#include "scenes/measure.hpp"
#include "timing.hpp"

namespace bench {
namespace {

using namespace hilger;
using vector = Eigen::VectorXd;
constexpr double h = 0.01;

/// Nanoseconds a step of walks of n steps, of many: a program that begins can be slow for some tenths of a second.
template <class Walk>
double nanoseconds(index_type n, Walk const& walk) {
    return program::fastest(walk, 1.0) * 1e9 / static_cast<double>(n);
}

template <class Typed, class V>
void race(char const* name, char const* text, int size, Typed const& L, V const& q0, V const& v0, index_type n) {
    auto const words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", size}});
    vector q(std::max(size, 1)), v = q;
    for (int k = 0; k < q.size(); ++k) {
        q(k) = detail::shape<V>::component(q0, k);
        v(k) = detail::shape<V>::component(v0, k);
    }
    auto const row = [&](auto const& flow, char const* method) {
        auto const T = uniform(0.0, h, n);
        // As elsewhere all states are kept: of the typed walk too, in room that is new each time.
        std::vector<double> typed_q;
        engine::set_machine_code(engine::machine_code::off); // or typed formulas of many coordinates had it too
        double const typed = nanoseconds(n, [&] {
            std::vector<double> room, typed_p;
            for (auto* x : {&room, &typed_p}) x->reserve(static_cast<std::size_t>((n + 1) * q.size()));
            for (auto const& x : flow.along(T, initial_velocity<V>{q0, v0}))
                for (int k = 0; k < q.size(); ++k) {
                    room.push_back(detail::shape<V>::component(x.q, k));
                    typed_p.push_back(detail::shape<V>::component(x.p, k));
                }
            typed_q = std::move(room);
        });
        engine::problem const stated{text::lagrangian_in(text, words), {}, {}, "direct"};
        engine::points<double> const points{0, h, n, {}};
        engine::initial<double> const from{q, engine::second_datum::velocity, v};
        auto const of_formula = [&](engine::machine_code code, std::vector<double>& to) {
            engine::set_machine_code(code);
            auto motion = engine::embedded_in_one_step(stated, method, points);
            if (not motion) motion = engine::composed(stated, method, points);
            return nanoseconds(n, [&] {
                std::vector<double> p;
                to = {};
                motion->walk(from, [&](double, vector const& x, vector const& y) {
                    to.insert(to.end(), x.begin(), x.end());
                    p.insert(p.end(), y.begin(), y.end());
                    return true;
                });
            });
        };
        std::vector<double> one, other;
        double const interpreted = of_formula(engine::machine_code::off, one), compiled = of_formula(engine::machine_code::at_once, other);
        std::optional<engine::states_in_whole_steps> whole;
        double const in_whole_steps =
            nanoseconds(n, [&] { whole = engine::walk_in_whole_steps(stated, method, points, from, {}, [](index_type) { return true; }); });
        auto const off = [&](std::vector<double> const& x) { return std::abs(x[x.size() - 1] - typed_q[typed_q.size() - 1]); };
        std::cout << std::left << std::setw(16) << name << std::setw(11) << method << std::right << std::fixed << std::setprecision(0)
                  << std::setw(8) << typed;
        for (double const x : {interpreted, compiled})
            std::cout << std::setprecision(0) << std::setw(10) << x << std::setprecision(2) << std::setw(7) << x / typed;
        std::cout << (one == other ? "  same bits" : "  OTHER BITS") << std::scientific << std::setprecision(0) << std::setw(9) << off(one);
        if (whole)
            std::cout << std::fixed << std::setw(10) << in_whole_steps << std::setprecision(2) << std::setw(7) << in_whole_steps / typed
                      << std::scientific << std::setprecision(0) << std::setw(9) << off(whole->q);
        std::cout << std::defaultfloat << '\n';
    };
    row(embed(L, mid_point), "mid-point");
    row(embed(L, order_one), "order-one");
    row(stoermer_verlet(L), "verlet");
}

} // namespace

void formulas() {
    std::cout << "Nanoseconds a step, all states kept: in C++; interpreted, as machine code, and how far its end is from that of C++; in "
                 "whole steps, which set-up and the first step are counted to. With ratios to C++\n\n";
    using V2 = Eigen::Vector2d;
    race(
        "pendulum", "v^2/2 + cos(q)", 0, [](auto const& q, auto const& v) { return v * v / 2 + cos(q); }, 1.5, 0.0, 500'000);
    race(
        "henon-heiles", "dot(v, v)/2 - dot(q, q)/2 - q[0]^2*q[1] + q[1]^3/3", 2,
        [](auto const& q, auto const& v) {
            return v.squaredNorm() / 2 - q.squaredNorm() / 2 - q(0) * q(0) * q(1) + q(1) * q(1) * q(1) / 3;
        },
        V2(0, 0.1), V2(0.49, 0), 500'000);
    race(
        "kepler", "dot(v, v)/2 + 1/norm(q)", 2, [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); }, V2(0.4, 0),
        V2(0, 2), 500'000);
    int const n = 1000;
    vector q(n);
    for (int k = 0; k < n; ++k) q(k) = 0.1 * std::sin(0.3 * k);
    race(
        "chain of 1000", "dot(v, v)/2 - sum(k, 0, 998, (q[k+1] - q[k])^2/2 + (q[k+1] - q[k])^4/4)", n,
        [](auto const& x, auto const& v) {
            auto sum = v.squaredNorm() / 2;
            for (int k = 0; k + 1 < n; ++k) {
                auto const r = x(k + 1) - x(k);
                sum -= r * r / 2 + r * r * r * r / 4;
            }
            return sum;
        },
        q, vector(vector::Zero(n)), 1000);
    vector x(9), y(9);
    x << 1, 0, 0, -0.5, 0.8, 0.1, 0, -1, 0.3;
    y << 0, 0.5, 0, 0.3, -0.4, 0.1, 0, 0, -0.5;
    race(
        "three bodies",
        "dot(v, v)/2 + sum(i, 0, 1, sum(j, i + 1, 2, 1/sqrt((q[3*i] - q[3*j])^2 + (q[3*i+1] - q[3*j+1])^2 + (q[3*i+2] - q[3*j+2])^2)))", 9,
        [](auto const& z, auto const& v) {
            auto sum = v.squaredNorm() / 2;
            for (int i = 0; i < 2; ++i)
                for (int j = i + 1; j < 3; ++j) sum += 1 / (z.template segment<3>(3 * i) - z.template segment<3>(3 * j)).norm();
            return sum;
        },
        x, y, 1000);
    engine::set_machine_code(engine::machine_code::off);
}

} // namespace bench
