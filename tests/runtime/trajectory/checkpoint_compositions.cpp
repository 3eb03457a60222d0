// SPDX-License-Identifier: BSL-1.0
// Compositions are resumed bit for bit: in turns, as kicks and drifts, and where one becomes the other on the way.
#include "hilger/composition/methods.hpp"
#include "hilger/models/mechanical.hpp"
#include "resuming.hpp"

namespace checkpoint_compositions_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// Kicks and drifts up to x = 1 and a mass that depends on the position beyond.
constexpr lagrangian changing{[](auto const& x, auto const& v) {
    auto L = v * v / 2 - x * x / 8;
    if (x > 1) L = L + v * v * (x - 1) * (x - 1) / 4;
    return L;
}};

} // namespace

TEST_CASE("in turns") {
    auto const flow = embed(pendulum, mid_point);
    CHECK(differences(pendulum_path<double>(compose(suzuki<4>, flow), 60), 25) == 0);
    CHECK(differences(pendulum_path<double>(compose(suzuki<4>, embed(pendulum, mid_point, compensated)), 60), 25) == 0);
    CHECK(differences(pendulum_path<double>(compose(shares<fraction<1, 3>, fraction<2, 3>>{}, flow, embed(bead, order_one)), 60), 1) == 0);
    // A composition of compositions, of a mass that depends on the position.
    CHECK(differences(pendulum_path<double>(compose(shares<fraction<1, 3>, fraction<2, 3>>{}, symmetrized(embed(bead, order_one))), 60),
                      25) == 0);
    time_scale<double> const T{0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0, 1.1};
    auto const path = compose(suzuki<4>, flow).along(T, 1.0, 0.0);
    for (hilger::index_type i = 0; i <= 8; ++i) CHECK(differences(path, i) == 0);
}

TEST_CASE("kicks and drifts") {
    CHECK(differences(pendulum_path<double>(stoermer_verlet(pendulum), 60), 25) == 0);
    CHECK(differences(pendulum_path<double>(position_verlet(pendulum, compensated), 60), 25) == 0);
    CHECK(differences(pendulum_path<double>(compose(suzuki<4>, stoermer_verlet(pendulum, compensated)), 60), 25) == 0);
    CHECK(differences(pendulum_path<Q>(stoermer_verlet(oscillator), 6), 2) == 0);
    auto const row = mechanical(1.0, chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(9, 0, 1), p = Eigen::VectorXd::Zero(9);
    CHECK(differences(stoermer_verlet(row, compensated).along(uniform(0.0, 0.1, 60), q, p), 25) == 0);
    lagrangian const traced{[](auto const& x, auto const& v) { return v.dot(v) / 2 + v(0) * v(1) / 3 - cos(x(0) - x(8)) - x.dot(x); }};
    CHECK(differences(stoermer_verlet(traced, compensated).along(uniform(0.0, 0.1, 60), q, p), 25) == 0);
    time_scale<double> const T{0, 0.1, 0.2, 0.3, 0.5, 0.7, 0.9, 1.0, 1.1};
    auto const path = stoermer_verlet(pendulum, compensated).along(T, 1.0, 0.0);
    for (hilger::index_type i = 0; i <= 8; ++i) CHECK(differences(path, i) == 0);
}

TEST_CASE("turns of states whose size is known at run time") {
    lagrangian const magnetic{[](auto const& x, auto const& v) { return v.dot(v) / 2 + x(0) * v(1) - x.dot(x) / 2; }};
    Eigen::VectorXd const q = Eigen::Vector2d(1, 0.5), p = Eigen::Vector2d(0.25, -1);
    for (hilger::index_type const i : {0, 1, 25}) CHECK(differences(stoermer_verlet(magnetic).along(uniform(0.0, 0.1, 60), q, p), i) == 0);
}

TEST_CASE("kicks and drifts that become turns on the way") {
    auto const path = stoermer_verlet(changing, compensated).along(uniform(0.0, 0.1, 60), 0.5, 0.5);
    bool beyond = false;
    for (auto const& x : path) beyond = beyond or x.q > 1;
    CHECK(beyond);
    for (hilger::index_type const i : {0, 5, 12, 20, 40, 60}) CHECK(differences(path, i) == 0);
}

} // namespace checkpoint_compositions_tests
