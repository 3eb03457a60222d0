// SPDX-License-Identifier: BSL-1.0
// Plain lambdas in any number of dimensions, under every scheme: explicit where the equation is, by iteration with the masses, by Newton's
// method where that is too slow, whatever matrix there is to solve with. The derived equation is the judge.
#include "hilger/integrator/composition.hpp"
#include "programs.hpp"
#include "systems.hpp"

namespace any_dimension_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

auto const T = uniform(0.0, 0.05, 40);
time_scale<double> const uneven{0, 0.05, 0.1, 0.2, 0.22, 0.3, 0.5, 0.55, 0.6, 0.8, 0.9, 1.0, 1.2, 1.5};

/// A ring: the second derivatives have two corners.
constexpr auto ring = [](auto const& q, auto const& v) {
    auto L = v.dot(v) / 2 - q(0) * q(0) / 4;
    for (int k = 0; k < q.size(); ++k) {
        auto const r = plain_t<decltype(q(0))>(q(k) - q((k + 1) % q.size()));
        L = L - r * r / 2 - r * r * r * r / 4;
    }
    return L;
};
/// Each with each, and the mass of one of them is where another one is.
constexpr auto everything = [](auto const& q, auto const& v) {
    auto L = v.dot(v) / 2 + v(0) * v(0) * q(1) * q(1) / 4 + v(1) * q(2) - v(2) * q(1);
    for (int j = 0; j < q.size(); ++j)
        for (int k = 0; k < j; ++k) L = L - (q(j) - q(k)) * (q(j) - q(k)) * (1 + q(j) * q(k)) / (2 * q.size());
    return L;
};
constexpr auto separable = [](auto const& q, auto const& v) {
    auto L = v.dot(v) + v(0) * v(1) / 2 - q(0) * q(0) * q(q.size() - 1) / 3;
    for (int k = 0; k < q.size(); ++k) L = L + cos(q(k)) / (1 + k);
    return L;
};
/// Too stiff for an iteration with the masses alone.
constexpr auto stiff = [](auto const& q, auto const& v) {
    auto L = v.dot(v) / 2 - q(0) * q(0);
    for (int k = 1; k < q.size(); ++k) L = L - 300 * (1 - cos(q(k) - q(k - 1)));
    return L;
};

/// Under every scheme, on steps that are equal and that are not.
template <class V, class L>
void is_solved_by_all(L const& l, int d, double mass) {
    auto const each = [&](auto const& how) {
        is_a_solution(embed(l, how).along(T, place<V>(d), push<V>(d)), mass);
        is_a_solution(embed(l, how).along(uneven, place<V>(d), push<V>(d)), mass);
        is_a_solution(embed(l, how, compensated).along(T, place<V>(d), push<V>(d)), mass);
    };
    each(mid_point);
    each(order_one);
    each(order_one_left);
    each(theta<1, 3>);
}

} // namespace

TEST_CASE("every scheme, of vectors whose size is known") {
    is_solved_by_all<Eigen::Matrix<double, 5, 1>>(separable, 5, 4);
    is_solved_by_all<Eigen::Matrix<double, 6, 1>>(everything, 6, 4);
}
TEST_CASE("every scheme, of vectors of any size") {
    for (int const d : {3, 7}) {
        is_solved_by_all<Eigen::VectorXd>(separable, d, 4);
        is_solved_by_all<Eigen::VectorXd>(everything, d, 4);
    }
    is_solved_by_all<Eigen::VectorXd>(separable, 2, 4);
}
TEST_CASE("small, banded, sparse and dense matrices") {
    auto const solved = [](auto const& l, int d, double mass) {
        is_a_solution(embed(l, mid_point).along(T, place<Eigen::VectorXd>(d), push<Eigen::VectorXd>(d)), mass);
    };
    for (int const d : {2, 12, 16, 17, 60}) {
        solved(ring, d, 1);
        solved(stiff, d, 8);
    }
    solved(everything, 24, 4);
    solved(heavy_outside, 24, 4);
    solved(row_of_contacts, 30, 4);
}
TEST_CASE("with forces, and in time") {
    auto const solved = [](auto const& l, int d, double mass) {
        auto const each = [&](auto const& how) {
            is_a_solution(embed(l, how).along(T, place<Eigen::VectorXd>(d), push<Eigen::VectorXd>(d)), mass);
        };
        each(mid_point);
        each(order_one);
        each(order_one_left);
    };
    solved(with_force(ring, drag), 20, 1);
    solved(with_force(everything, drag), 6, 4);
    solved(with_force(separable, wind), 7, 4);
    solved(with_force(row_of_contacts, drag), 6, 4);
    solved(pulled, 5, 1);
    solved(with_force(pulled, wind), 5, 1);
}
TEST_CASE("in rational numbers the equation holds exactly") {
    using V = Eigen::Matrix<Q, 6, 1>;
    auto const quadratic = [](auto const& q, auto const& v) {
        auto L = v.dot(v) / 2 + v(0) * v(5) / 3 + q(1) * v(2) - q.dot(q) / 3;
        for (int k = 1; k < 6; ++k) L = L - q(k) * q(k - 1) / (1 + k);
        return L;
    };
    auto const quartic = [](auto const& q, auto const& v) { return v.dot(v) / 2 + v(0) * v(5) / 3 - q(0) * q(0) * q(5) * q(5); };
    time_scale<Q> const few{Q(0), Q(1, 7), Q(1, 3), Q(1, 2)};
    auto const holds = [&](auto const& l, auto const& how) {
        auto const path = embed(l, how).along(few, place<V>(), push<V>());
        CHECK(largest_residual(path) == 0);
        V last = place<V>();
        for (auto const& x : path) last = x.q;
        CHECK(not(last == place<V>()));
    };
    holds(quadratic, mid_point);
    holds(quadratic, order_one);
    holds(quadratic, order_one_left);
    holds(quadratic, theta<1, 3>);
    holds(quartic, order_one);
    holds(quartic, order_one_left);
}
TEST_CASE("a Lagrangian is looked at a few times, however many steps are made") {
    long long calls = 0;
    auto const counted = [&calls](auto const& q, auto const& v) {
        ++calls;
        return ring(q, v);
    };
    for (auto const& x : embed(counted, mid_point).along(T, place<Eigen::VectorXd>(9), push<Eigen::VectorXd>(9))) (void)x;
    CHECK(calls <= 4); // its velocity at the start, and the step
}

} // namespace any_dimension_tests
