// SPDX-License-Identifier: BSL-1.0
// Steps and velocities of Lagrangians with branches of which none has a solution end in an error that says so; and in exact rationals the
// equation holds exactly.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace branches_without_solution_tests {

using namespace hilger;

TEST_CASE("where no branch has a solution an error says so") {
    auto const jump = [](auto const& q, auto const& v) {
        if constexpr (requires { q(0); })
            return v.squaredNorm() / 2 - abs(q(0));
        else
            return v * v / 2 - abs(q);
    };
    auto const T = uniform(0.0, 0.5, 4);
    auto const walk = [&](auto const& q0) {
        auto const flow = embed(jump, mid_point);
        auto const path = flow.along(T, q0, q0);
        for (auto const& x : path) (void)x;
    };
    // q = 0, p = 0: v = -h / 2 sign(q + h v / 2), and the sign is that of v
    CHECK_THROWS_AS(walk(0.0), error::no_branch);
    CHECK_THROWS_AS(walk(Eigen::Vector2d(0, 0)), error::no_branch);
    CHECK_THROWS_AS(walk(Eigen::VectorXd(Eigen::Vector2d(0, 0))), error::no_branch);
    try {
        walk(0.0);
    } catch (step_failure<error::no_branch, double, double> const& stopped) {
        CHECK(stopped.last.q == 0);
        CHECK(std::string(stopped.what()).find("has no solution on any branch of L that was met") != std::string::npos);
    }
    std::vector<std::pair<index_type, index_type>> const wall{{0, -1}};
    auto const held = embed(mechanical(1.0, pairs<1>(wall, [](index_type, auto const& r) { return abs(r); })), mid_point);
    Eigen::VectorXd const zero = Eigen::VectorXd::Zero(1);
    CHECK_THROWS_AS((void)held.step(state<double, Eigen::VectorXd>{0.0, zero, zero}, 0.5), error::no_branch);
    // a velocity with a jump in its momentum, -1 below zero and 2 above: no v has p = 0.5
    auto const kick = [](auto const&, auto const& v) { return v * v / 2 + (v < 0 ? -1 : 2) * v; };
    CHECK_THROWS_AS((void)velocity_of(kick, 0.0, 0.5), error::no_branch);
    CHECK(velocity_of(kick, 0.0, 3.0) == 1);
    CHECK(velocity_of(kick, 0.0, -3.0) == -2);
}
TEST_CASE("a residual is not small beside a size that is no number") {
    double const infinity = std::numeric_limits<double>::infinity();
    double x = 1, rest = 0;
    auto const evaluate = [&](double const& y, double& r) {
        r = 1 + y * y;
        return y == 1 ? 2.0 : infinity;
    };
    auto const linearize = [] { return true; };
    auto const correct = [&](double const& r, double& d) { d = -r / (2 * x); };
    for (auto const how : {detail::corrections::smaller, detail::corrections::on_the_path, detail::corrections::followed}) {
        x = 1;
        CHECK(detail::newton<double>({evaluate, linearize, correct}, x, rest, how) != detail::newton_outcome::found);
    }
}
TEST_CASE("in exact rationals the equation holds exactly") {
    constexpr unknown q;
    constexpr auto q_o = extend[q];
    lagrangian const L([](auto const& x, auto const& v) { return v * v / 2 - (x > 0 ? 1 : 100) * x * x / 2; });
    auto const T = uniform(Q(0), Q(1, 4), 12);
    auto const EL = variation(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    CHECK(largest_residual(EL, solve(EL, T, initial_velocity<Q>{Q(1), Q(-2)})) == 0);
}

} // namespace branches_without_solution_tests
