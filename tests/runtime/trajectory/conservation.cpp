// SPDX-License-Identifier: BSL-1.0
// Every embedding and every composition is symplectic, on a Lagrangian that is not separable, and keeps the momentum maps of its symmetries
// (Bourdin and others, theorem 4; Marsden-West, 1.3.3), in 50 digits; so are those that split a separable one into kicks and drifts.
#include <doctest/doctest.h>

#include "hilger/composition/methods.hpp"
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
constexpr auto planet = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / sqrt(q.squaredNorm()); };

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
    conserves("order one, left", embed(charge, order_one_left));
    conserves("theta", embed(charge, theta<1, 3>));
    conserves("mid-point", embed(charge, mid_point));
    conserves("Galerkin, Gauss", embed(charge, galerkin<3, gauss>));
    conserves("Galerkin, Lobatto", embed(charge, galerkin<4, lobatto>));
}

TEST_CASE("compositions are symplectic and keep momentum maps") {
    auto const middle = embed(charge, mid_point);
    conserves("Stoermer-Verlet", stoermer_verlet(charge));
    conserves("triple jump", compose(triple_jump<4>, middle));
    conserves("Suzuki", compose(suzuki<4>, middle));
    conserves("Yoshida", compose(yoshida<6>, middle));
    conserves("Suzuki-Umeno", compose(suzuki_umeno<8>, middle));
    conserves("Kahan-Li 6", compose(kahan_li<6>, middle));
    conserves("Kahan-Li 8", compose(kahan_li<8>, middle));
    conserves("Blanes-Moan", compose_with_adjoint(blanes_moan<4>, embed(charge, order_one)));
}

TEST_CASE("so are compositions of kicks and drifts") {
    conserves("Stoermer-Verlet", stoermer_verlet(planet));
    conserves("Suzuki", compose(suzuki<4>, stoermer_verlet(planet)));
    conserves("Kahan-Li 8", compose(kahan_li<8>, stoermer_verlet(planet)));
    conserves("Blanes-Moan", compose_with_adjoint(blanes_moan<4>, embed(planet, order_one)));
}

TEST_CASE("a scheme that is not variational is not symplectic: the test can tell") {
    // explicit Euler of the oscillator, det M = 1 + h^2
    Eigen::Matrix<float50, 2, 2> M;
    M << 1, float50(1) / 10, float50(-1) / 10, 1;
    CHECK(abs(float50(symplecticity_error(M) - float50(1) / 100)) < epsilon<float50>());
}

} // namespace conservation_tests
