// SPDX-License-Identifier: BSL-1.0
// Resuming has the bits of not stopping for every kind of state, scalar and scale.
#include "resuming.hpp"

namespace checkpoint_kinds_tests {

using namespace hilger;
using namespace hilger::testing;

TEST_CASE("runs of vectors of any length, in float, long double and the rationals are resumed bit for bit") {
    auto const T = uniform(0.0, 0.02, 300);
    Eigen::Vector2d const q(0.4, 0), p(0, 2);
    CHECK(differences(embed(kepler, mid_point, compensated).along(T, q, p), 100) == 0);
    CHECK(differences(embed(kepler, mid_point).along(T, Eigen::VectorXd(q), Eigen::VectorXd(p)), 100) == 0);
    CHECK(differences(embed(kepler, mid_point, compensated).along(T, Eigen::VectorXd(q), Eigen::VectorXd(p)), 100) == 0);
    CHECK(differences(pendulum_path<float>(embed(pendulum, mid_point, compensated), 100), 40) == 0);
    CHECK(differences(pendulum_path<long double>(embed(pendulum, mid_point, compensated), 100), 40) == 0);
    CHECK(differences(pendulum_path<Q>(embed(oscillator, mid_point), 12), 5) == 0);
}

TEST_CASE("structured systems, by iteration and by Newton") {
    auto const row = mechanical(1.0, chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(9, 0, 1), p = Eigen::VectorXd::Zero(9);
    CHECK(differences(embed(row, mid_point).along(uniform(0.0, 0.1, 60), q, p), 25) == 0);
    CHECK(differences(embed(row, mid_point, compensated).along(uniform(0.0, 1.0, 60), q, p), 25) == 0);
}

TEST_CASE("on steps of different lengths, at the start and at the end") {
    time_scale<double> const T{0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0, 1.1};
    auto const path = embed(pendulum, mid_point, compensated).along(T, 1.0, 0.0);
    for (hilger::index_type i = 0; i <= 8; ++i) CHECK(differences(path, i) == 0);
}

} // namespace checkpoint_kinds_tests
