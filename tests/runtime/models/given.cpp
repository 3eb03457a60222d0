// SPDX-License-Identifier: BSL-1.0
// What structured systems are given: a mass matrix whose symmetric part counts, and lists of pairs that fit the state, wherever L is asked.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace given_models_tests {

using namespace hilger;
using vector = Eigen::VectorXd;

TEST_CASE("v.Mv / 2 has the symmetric part of M, in L, its Legendre map and its steps") {
    Eigen::MatrixXd given(2, 2);
    given << 1, 0.5, 0, 1;
    auto const bowl = [](auto const& q) { return q.squaredNorm() / 2; };
    auto const L = mechanical(given, bowl);
    auto const same = mechanical(Eigen::MatrixXd((given + given.transpose()) / 2), bowl);
    auto const plain = [](auto const& q, auto const& v) { return (v(0) * v(0) + v(0) * v(1) / 2 + v(1) * v(1)) / 2 - q.squaredNorm() / 2; };
    vector const q = Eigen::Vector2d(1, 0), v = Eigen::Vector2d(0, 1), p = Eigen::Vector2d(0.25, 1);
    CHECK(L(q, v) == plain(q, v));
    CHECK(L.momentum(q, v) == p);
    CHECK((L.velocity(q, p) - v).norm() <= 8 * epsilon<double>());
    auto const T = uniform(0.0, 0.125, 16);
    auto const end = [&](auto const& of) { return record(embed(of, mid_point).along(T, q, p)).states.back().q; };
    CHECK(end(L) == end(same));
    CHECK((end(L) - end(plain)).norm() <= 64 * epsilon<double>());
    CHECK_THROWS_WITH_AS((void)mechanical(Eigen::MatrixXd(2, 3).setOnes(), bowl),
                         "a mass matrix is square, and this one has 2 rows and 3 columns", error::mismatch);
}

TEST_CASE("pairs of bodies that the state has not, and components that are of no body") {
    auto const spring = [](index_type, auto const& r) { return r.squaredNorm() / 2; };
    auto const three = mechanical(1.0, pairs<3>(all_pairs(3), spring)), two = mechanical(1.0, pairs<3>(all_pairs(2), spring));
    vector const six = vector::LinSpaced(6, 0, 1), seven = vector::LinSpaced(7, 0, 1);
    CHECK_THROWS_AS((void)energy(three)(state<double, vector>{0.0, six, six}), error::outside_domain);
    CHECK_THROWS_AS((void)three(six, six), error::outside_domain);
    CHECK_THROWS_WITH_AS((void)energy(two)(state<double, vector>{0.0, seven, seven}),
                         "bodies of 3 components each make states of a multiple of 3, and this one has 7", error::mismatch);
    CHECK_THROWS_AS((void)record(embed(two, mid_point).along(uniform(0.0, 0.1, 2), seven, seven)), error::mismatch);
    CHECK_THROWS_WITH_AS((void)all_pairs(-1), "a number of bodies is not negative, and this one is -1", error::invalid_parameter);
    // (1/2) |x_a - x_b|^2 + two kinetic energies
    CHECK(energy(two)(state<double, vector>{0.0, six, six}) ==
          doctest::Approx((six.squaredNorm() + (six.head(3) - six.tail(3)).squaredNorm()) / 2).epsilon(4 * epsilon<double>()));
}

} // namespace given_models_tests
