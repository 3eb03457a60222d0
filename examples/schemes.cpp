// SPDX-License-Identifier: BSL-1.0
// One system, many schemes: what an embedding, a composition, a force, a Hamiltonian or a structure makes of it. Prints, for the same T,
// how far each is from the best of them.
#include <iomanip>
#include <iostream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const pendulum = [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
    auto const H = [](auto const& p, auto const& q) { return p * p / 2 - cos(q); };
    auto const friction = [](auto const& q, auto const& v) { return -v / 100 + q * 0.0; };
    auto const T = uniform(interval{0.0, 10.0}, 200);

    auto const end = [&](auto const& flow) { return record(flow.along(T, 1.0, 0.5), T.steps()).states.back().q; };
    double const best = end(embed(pendulum, galerkin<8, gauss>)); // order 16
    auto const say = [&](char const* what, auto const& flow) {
        std::cout << std::left << std::setw(44) << what << std::abs(end(flow) - best) << '\n';
    };
    say("order one", embed(pendulum, order_one));
    say("mid-point", embed(pendulum, mid_point));
    say("mid-point of H(p, q)", embed(lagrangian_of(H), mid_point));
    say("Galerkin, 4 Gauss nodes, order 8", embed(pendulum, galerkin<4, gauss>));
    say("Stoermer-Verlet: order one right after left", stoermer_verlet(pendulum));
    say("9 mid-point steps as one of order 6", compose(kahan_li<6>, embed(pendulum, mid_point)));
    say("mid-point with friction (another system)", embed(with_force(pendulum, friction), mid_point));

    // What is left of the equations, of the size of rounding over h.
    double const residual = std::max(largest_residual(embed(pendulum, mid_point).along(T, 1.0, 0.5)),
                                     largest_residual(embed(with_force(pendulum, friction), mid_point).along(T, 1.0, 0.5)));
    std::cout << "the equations hold to " << residual << '\n';

    // A thousand particles: the sum says that the Hessian is tridiagonal.
    auto const row = mechanical(1.0, chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(1000, 0, 1), p = Eigen::VectorXd::Zero(1000);
    drift_statistics const energies = drift_along(embed(row, mid_point).along(T, q, p), energy(row)); // costs what U(q) costs
    std::cout << "energy error of a chain of 1000: " << energies.largest << '\n';
    return residual < 1e-10 and energies.largest < 1e-3 and std::abs(end(compose(kahan_li<6>, embed(pendulum, mid_point))) - best) < 1e-6
               ? 0
               : 1;
}
