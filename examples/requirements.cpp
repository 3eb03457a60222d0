// SPDX-License-Identifier: BSL-1.0
// What a step needs, by scene and method: forces, second derivatives, rounds of Newton, operations, numbers that are kept. Counted, not
// estimated: the methods run on numbers that count. A scene pays for what it asks for, and for nothing else.
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.05, 1000);
    auto const pendulum = [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
    auto const kepler = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 1 / q.norm(); };
    auto const row = mechanical(1.0, chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    auto const damped = [&](auto order) { return with_fractional_damping(pendulum, 0.1, order, exponentials{1e-10, 1000}); };
    Eigen::Vector2d const q(0.4, 0), p(0, 2);
    Eigen::VectorXd const x = Eigen::VectorXd::LinSpaced(32, -1, 1), y = Eigen::VectorXd::Zero(32);

    bool lean = true;
    auto const say = [&](char const* name, auto const& path) {
        requirements const r = requirements_of(path);
        std::cout << requirements_row{name, r};
        lean = lean and r.growth_in_bytes == 0; // no step keeps more than the one before
        return r;
    };
    write_heading(std::cout << "pendulum\n");
    auto const explicit_step = say("order one", embed(pendulum, order_one).along(T, 1.0, 0.5));
    say("Stoermer-Verlet", stoermer_verlet(pendulum).along(T, 1.0, 0.5));
    say("mid-point", embed(pendulum, mid_point).along(T, 1.0, 0.5));
    say("Galerkin, 4 nodes", embed(pendulum, galerkin<4, gauss>).along(T, 1.0, 0.5));
    std::cout << "Kepler's problem\n";
    say("order one", embed(kepler, order_one).along(T, q, p));
    say("Stoermer-Verlet", stoermer_verlet(kepler).along(T, q, p));
    say("mid-point", embed(kepler, mid_point).along(T, q, p));
    say("Galerkin, 4 nodes", embed(kepler, galerkin<4, gauss>).along(T, q, p));
    std::cout << "Fermi-Pasta-Ulam chain of 32\n";
    say("order one", embed(row, order_one).along(T, x, y));
    say("Stoermer-Verlet", stoermer_verlet(row).along(T, x, y));
    say("mid-point", embed(row, mid_point).along(T, x, y));
    std::cout << "pendulum with fractional damping\n";
    say("order one", embed(damped(fraction<1, 2>{}), order_one).along(T, 1.0, 0.5));
    say("order one, of order 1", embed(damped(fraction<1>{}), order_one).along(T, 1.0, 0.5));
    say("mid-point", embed(damped(fraction<1, 2>{}), mid_point).along(T, 1.0, 0.5));
    say("Galerkin, 4 nodes", embed(damped(fraction<1, 2>{}), galerkin<4, gauss>).along(T, 1.0, 0.5));
    return lean and explicit_step.forces == 1 and explicit_step.newton_rounds == 0 ? 0 : 1;
}
