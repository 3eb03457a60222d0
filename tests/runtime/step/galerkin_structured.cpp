// SPDX-License-Identifier: BSL-1.0
// Galerkin steps of systems that say how they are put together: as the same without, and nothing is allocated (no_allocation.cpp).
#include <doctest/doctest.h>

#include "runtime/trajectory/resuming.hpp"

namespace galerkin_structured_tests {

using namespace hilger;

namespace {

constexpr auto bond = [](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; };
auto const row = mechanical(2.0, chain(bond));
Eigen::Vector3d const q(0.2, -0.4, 0.9), p(0, 0.3, 0);

auto path(auto const& L, double end, hilger::index_type steps, auto const& x, auto const& y) {
    return embed(L, galerkin<3, gauss>).along(uniform(interval{0.0, end}, steps), x, y);
}

} // namespace

TEST_CASE("a system that says its structure steps as the same without, by iteration and by Newton") {
    auto const plain = [](auto const& x, auto const& v) {
        return v.dot(v) - (bond(0, x(0)) + bond(1, x(1) - x(0)) + bond(2, x(2) - x(1)) + bond(3, -x(2)));
    };
    for (double const end : {10.0, 200.0}) {
        state<double, Eigen::VectorXd> a;
        state<double, Eigen::Vector3d> b;
        for (auto const& x : path(row, end, 50, Eigen::VectorXd(q), Eigen::VectorXd(p))) a = x;
        for (auto const& x : path(plain, end, 50, q, p)) b = x;
        // Fifty steps that each round the state by an epsilon or, by Newton, leave a few, in bounded motion.
        CHECK((a.q - b.q).norm() + (a.p - b.p).norm() <= 50 * 100 * epsilon<double>());
        CHECK((b.q - q).norm() > 0.01);
    }
}
TEST_CASE("its runs are resumed bit for bit") {
    CHECK(testing::differences(path(row, 10.0, 50, Eigen::VectorXd(q), Eigen::VectorXd(p)), 21) == 0);
    CHECK(testing::differences(path(row, 200.0, 50, Eigen::VectorXd(q), Eigen::VectorXd(p)), 21) == 0);
}

} // namespace galerkin_structured_tests
