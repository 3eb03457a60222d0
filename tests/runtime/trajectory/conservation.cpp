// SPDX-License-Identifier: BSL-1.0
// Every embedding is symplectic, on a Lagrangian that is not separable, and keeps the momentum maps of its symmetries (Bourdin and others,
// theorem 4; Marsden-West, 1.3.3), in 50 digits.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace conservation_tests {

using namespace hilger;

namespace {

using vector = Eigen::Matrix<float50, 2, 1>;

/// A charge in a magnetic field that grows outwards, in the field of a heavy one: invariant under rotations, not separable.
constexpr auto charge = [](auto const& q, auto const& v) {
    auto const r2 = q.squaredNorm();
    return v.squaredNorm() / 2 + r2 * (q(0) * v(1) - q(1) * v(0)) / 3 + 1 / sqrt(r2);
};

template <class Flow>
void conserves(char const* name, Flow const& flow) {
    CAPTURE(name);
    vector const q(1, float50(1) / 4), p(float50(1) / 3, float50(3) / 4);
    auto const M = jacobian_of_step(flow, state<float50, vector>{0, q, p}, float50(float50(1) / 10));
    CHECK(symplecticity_error(M) < float50("1e-38")); // differences of order 4 are good to epsilon^(4/5)
    auto const rotation = momentum_map([](vector const& x) { return vector(-x(1), x(0)); });
    auto const drift = drift_along(flow.along(uniform(float50(0), float50(1) / 10, 20), q, p), rotation);
    CHECK(drift.largest < 1000 * epsilon<float50>());
}

} // namespace

TEST_CASE("embeddings are symplectic and keep momentum maps") {
    conserves("order one", embed(charge, order_one));
    conserves("theta", embed(charge, theta<1, 3>));
    conserves("mid-point", embed(charge, mid_point));
    conserves("Galerkin, Gauss", embed(charge, galerkin<3, gauss>));
    conserves("Galerkin, Lobatto", embed(charge, galerkin<4, lobatto>));
    conserves("composition", compose(suzuki<4>, embed(charge, mid_point)));
}

TEST_CASE("a scheme that is not variational is not symplectic: the test can tell") {
    // explicit Euler of the oscillator, det M = 1 + h^2
    Eigen::Matrix<float50, 2, 2> M;
    M << 1, float50(1) / 10, float50(-1) / 10, 1;
    CHECK(abs(float50(symplecticity_error(M) - float50(1) / 100)) < epsilon<float50>());
}

} // namespace conservation_tests
