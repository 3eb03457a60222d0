// SPDX-License-Identifier: BSL-1.0
// Kicks and drifts of H = A(p) + B(q) for any A; with logarithms they follow Kepler's orbits to rounding, and only the time is wrong.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/composition/methods.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"

namespace separated_hamiltonian_tests {

using namespace hilger;

namespace {

constexpr auto kinetic = [](auto const& p) { return p.dot(p) / 2; };
constexpr auto attraction = [](auto const& q) { return -1 / sqrt(q.dot(q)); };

template <class S>
using vector = Eigen::Matrix<S, 3, 1>;

/// The vector of Laplace, from the sun to the perihelion, of (q, p).
template <class S>
Eigen::Matrix<S, 2, 1> axis(vector<S> const& q, vector<S> const& p) {
    using std::sqrt;
    S const l = q(0) * p(1) - q(1) * p(0), r = sqrt(q(0) * q(0) + q(1) * q(1));
    return {S(p(1) * l - q(0) / r), S(-p(0) * l - q(1) / r)};
}

} // namespace

TEST_CASE("a kick, a drift and a kick, exactly") {
    auto const A = [](auto const& p) { return p * p * p / 3 + p; };
    auto const B = [](auto const& q) { return q * q * q * q / 4; };
    Q const h(1, 10), q(1, 2), p(1, 3);
    auto const x = stoermer_verlet(lagrangian_of(separated{A, B})).step(state<Q, Q>{0, q, p}, h);
    Q const middle = p - h / 2 * q * q * q, end = q + h * (middle * middle + 1);
    CHECK(x.q == end);
    CHECK(x.p == middle - h / 2 * end * end * end);
}

TEST_CASE("the logarithmic Hamiltonian follows an orbit of eccentricity 0.9 to rounding") {
    vector<double> const q(0.1, 0, 0), p(0, std::sqrt(19.0), 0.5);
    auto const method = position_verlet(lagrangian_of(logarithmic(kinetic, attraction)));
    double const h = 0.1, revolution = 2 * std::acos(-1.0);
    double off_orbit = 0, off_energy = 0;
    state<double, vector<double>> last{};
    for (auto const& x : method.along(uniform(0.0, h, 20'000), q, p)) {
        off_orbit = std::max(off_orbit, (axis<double>(x.q, x.p) - Eigen::Vector2d(0.9, 0)).norm());
        off_energy =
            std::max(off_energy, std::abs(x.p.head<2>().squaredNorm() / 2 - 1 / x.q.head<2>().norm() + 0.5) * x.q.head<2>().norm());
        CHECK(x.p(2) == 0.5);
        last = x;
    }
    CHECK(off_orbit <= 1e-12);
    CHECK(off_energy <= 1e-12);
    // at the place where it is, t should be E - e sin E
    double const E = std::atan2(last.q(1) / std::sqrt(0.19), last.q(0) + 0.9);
    double const off_time = std::remainder(last.q(2) - (E - 0.9 * std::sin(E)), revolution);
    CHECK(std::abs(off_time) >= 1e-6);
    CHECK(std::abs(last.q(2) - 2000) <= 20); // of the order of h^2
    // and of vectors of dynamic size
    auto const T = uniform(0.0, h, 20);
    auto const fixed = record(method.along(T, q, p)).states.back();
    auto const dynamic = record(method.along(T, Eigen::VectorXd(q), Eigen::VectorXd(p))).states.back();
    CHECK(magnitude(Eigen::VectorXd(dynamic.q - fixed.q)) <= 64 * epsilon<double>());
}

TEST_CASE("of a mechanical system: masses of any shape") {
    auto const check = [](auto const& mass, auto const& K) {
        auto const of_model = logarithmic(mechanical{mass, attraction});
        auto const by_parts = logarithmic(K, attraction);
        for (vector<double> const& x : {vector<double>(0.5, 1, 2), vector<double>(-1, 0.25, 0.5)}) {
            CHECK(std::abs(of_model(x, x) - by_parts(x, x)) <= 16 * epsilon<double>());
            auto const at = state<double, vector<double>>{0, x, x};
            auto const a = position_verlet(lagrangian_of(of_model)).step(at, 0.125);
            auto const b = position_verlet(lagrangian_of(by_parts)).step(at, 0.125);
            CHECK(magnitude(vector<double>(a.q - b.q)) <= 64 * epsilon<double>());
            CHECK(magnitude(vector<double>(a.p - b.p)) <= 64 * epsilon<double>());
        }
    };
    check(2.0, [](auto const& p) { return p.dot(p) / 4; });
    check(Eigen::Vector2d(2, 4), [](auto const& p) { return (p(0) * p(0) / 2 + p(1) * p(1) / 4) / 2; });
    Eigen::Matrix2d mass;
    mass << 2, 1, 1, 1;
    check(mass, [](auto const& p) { return (p(0) * p(0) - 2 * p(0) * p(1) + 2 * p(1) * p(1)) / 2; });
}

TEST_CASE("in 50 digits: symplectic, reversible, and of order 2 and 4 in the time") {
    vector<float50> const q(float50(1) / 2, 0, 0), p(0, sqrt(float50(3)), float50(1) / 2);
    auto const L = lagrangian_of(logarithmic(kinetic, attraction));
    auto const middle = position_verlet(L);
    state<float50, vector<float50>> const x{0, q, p};
    float50 const h = float50(1) / 10;
    CHECK(symplecticity_error(jacobian_of_step(middle, x, h)) < float50("1e-38"));
    CHECK(reversibility_error(middle, middle, x, h) < 64 * epsilon<float50>());
    auto const end_of = [&](auto const& method, int steps) {
        return float50(record(method.along(uniform(interval<float50>{0, 1}, steps), q, p)).states.back().q(2));
    };
    auto const exact = end_of(compose(kahan_li<8>, middle), 40);
    auto const order = [&](auto const& method, int steps) {
        return testing::order_of(float50(end_of(method, steps) - exact), float50(end_of(method, 2 * steps) - exact));
    };
    CHECK(std::abs(order(middle, 40) - 2) <= 0.05);
    CHECK(std::abs(order(compose(suzuki<4>, middle), 40) - 4) <= 0.1);
}

} // namespace separated_hamiltonian_tests
