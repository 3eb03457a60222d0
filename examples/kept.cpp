// SPDX-License-Identifier: BSL-1.0
// Runs that are kept: whole, as far as they got, continued tomorrow bit for bit; and the equation as the judge of them.
#include <iostream>
#include <sstream>

#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const pendulum = [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
    auto const friction = [](auto const& q, auto const& v) { return -v / 100 + 0 * q; };

    // A recording is whole, or its error is thrown. Who wants what there is of a run that fails says so.
    auto const blows_up = [](auto const& q, auto const& v) { return v * v / 2 + q * q * q * q; };
    auto const part = record(embed(blows_up, mid_point).along(uniform(0.0, 0.01, 1000), 1.0, 1.0), keep_partial);
    std::cout << part.states.size() << " states, and then: " << part.stopped.value_or("nothing") << '\n';

    // Written down at t = 5 and resumed: nine mid-point steps as one of order 6, and one that remembers all of its past.
    auto const T = uniform(0.0, 0.1, 100);
    bool same = true;
    auto const goes_on = [&](auto const& path) {
        std::stringstream file;
        auto at = path.begin();
        while (at.number() < 50) ++at;
        write_checkpoint(file, path, at.checkpoint());
        auto const rest = record(path.resume(read_checkpoint(file, path)));
        same = same and rest.states.back() == record(path).states.back();
    };
    goes_on(compose(kahan_li<6>, embed(pendulum, mid_point)).along(T, 1.0, 0.5));
    goes_on(embed(with_fractional_damping(pendulum, 0.2, fraction<1, 2>{}, exponentials{}), mid_point).along(T, 1.0, 0.5));
    std::cout << "continued at t = 5: " << (same ? "the same bits\n" : "other bits\n");

    // What is left of the discrete Euler-Lagrange equation at the positions of a run, its force included.
    double const residual = largest_residual(embed(with_force(pendulum, friction), mid_point).along(T, 1.0, 0.5));
    std::cout << "largest residual with friction: " << residual << '\n';
    return part.stopped and same and residual < 1e-12 ? 0 : 1;
}
