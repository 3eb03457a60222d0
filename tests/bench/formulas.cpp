// SPDX-License-Identifier: BSL-1.0
// Formulas that are known at run time, interpreted and as machine code, against the same formula in C++: mid-point and order one.
#include <iomanip>

#include "engine/machine_code/machine_code.hpp"
#include "engine/motions.hpp"
#include "scenes/measure.hpp"
#include "timing.hpp"

namespace bench {
namespace {

using namespace hilger;
using vector = Eigen::VectorXd;
constexpr double h = 0.01;

/// Nanoseconds a step of walks of n steps.
template <class Walk>
double nanoseconds(index_type n, Walk const& walk) {
    return program::fastest(walk) * 1e9 / static_cast<double>(n);
}

template <class Typed, class V>
void race(char const* name, char const* text, int size, Typed const& L, V const& q0, V const& v0, index_type n) {
    auto const words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", size}});
    vector q(std::max(size, 1)), v = q;
    for (int k = 0; k < q.size(); ++k) {
        q(k) = detail::shape<V>::component(q0, k);
        v(k) = detail::shape<V>::component(v0, k);
    }
    auto const row = [&](auto const& how, char const* method) {
        auto const T = uniform(0.0, h, n);
        V typed_end = q0;
        double const typed = nanoseconds(n, [&] {
            for (auto const& x : embed(L, how).along(T, initial_velocity<V>{q0, v0})) typed_end = x.q;
        });
        engine::problem const stated{text::lagrangian_in(text, words), {}, {}, "direct"};
        auto const of_formula = [&](engine::machine_code code, vector& end) {
            engine::set_machine_code(code);
            auto const motion = engine::embedded_in_one_step(stated, method, {0, h, n, {}});
            return nanoseconds(n, [&] {
                motion->walk({q, engine::second_datum::velocity, v}, [&](double, vector const& x, vector const&) {
                    end = x;
                    return true;
                });
            });
        };
        vector one, other;
        double const interpreted = of_formula(engine::machine_code::off, one), compiled = of_formula(engine::machine_code::at_once, other);
        double const off = std::abs(one(0) - detail::shape<V>::component(typed_end, 0));
        std::cout << std::left << std::setw(16) << name << std::setw(11) << method << std::right << std::fixed << std::setprecision(0)
                  << std::setw(8) << typed << std::setw(12) << interpreted << std::setprecision(2) << std::setw(7) << interpreted / typed
                  << std::setprecision(0) << std::setw(14) << compiled << std::setprecision(2) << std::setw(7) << compiled / typed
                  << (one == other ? "   same bits" : "   OTHER BITS") << std::scientific << std::setprecision(0) << std::setw(9) << off
                  << std::defaultfloat << '\n';
    };
    row(mid_point, "mid-point");
    row(order_one, "order-one");
}

} // namespace

void formulas() {
    std::cout << "Nanoseconds a step: in C++, interpreted, as machine code, with ratios to C++; how far the ends are from each other\n\n";
    using V2 = Eigen::Vector2d;
    race(
        "pendulum", "v^2/2 + cos(q)", 0, [](auto const& q, auto const& v) { return v * v / 2 + cos(q); }, 1.5, 0.0, 20'000);
    race(
        "henon-heiles", "dot(v, v)/2 - dot(q, q)/2 - q[0]^2*q[1] + q[1]^3/3", 2,
        [](auto const& q, auto const& v) {
            return v.squaredNorm() / 2 - q.squaredNorm() / 2 - q(0) * q(0) * q(1) + q(1) * q(1) * q(1) / 3;
        },
        V2(0, 0.1), V2(0.49, 0), 20'000);
    race(
        "kepler", "dot(v, v)/2 + 1/norm(q)", 2, [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); }, V2(0.4, 0),
        V2(0, 2), 20'000);
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
