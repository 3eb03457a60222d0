// SPDX-License-Identifier: BSL-1.0
// Plain lambdas in any number of dimensions, under every scheme: explicit where the equation is, by iteration with the masses, by Newton's
// method where that is too slow, whatever matrix there is to solve with. The derived equation is the judge.
#include "hilger/composition/composition.hpp"
#include "programs.hpp"
#include "systems.hpp"

namespace any_dimension_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

auto const T = uniform(0.0, 0.05, 40);

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

Eigen::VectorXd dynamic(double x, double y) { return Eigen::Vector2d(x, y); }

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
TEST_CASE("components of very different sizes, beside each other") {
    // metres and an angle, which know nothing of each other
    auto const apart = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q(0) * q(0) / 20000 - 40 * (1 - cos(q(1))); };
    auto const angle = [&](double far, double fast) {
        double last = 0;
        for (auto const& x : embed(apart, mid_point).along(uniform(0.0, 0.05, 200), dynamic(far, 1), dynamic(fast, 0.2))) last = x.q(1);
        return last;
    };
    CHECK(std::abs(angle(1e11, 3e9) - angle(1, 3)) <= 4096 * epsilon<double>());
    // far away, and close together
    auto const close = [](auto const& q, auto const& v) { return v.dot(v) / 2 - 20 * pow(q(1) - q(0) - 1, 4); };
    auto const path = embed(close, mid_point).along(uniform(0.0, 0.05, 200), dynamic(1e8, 1e8 + 1.5), dynamic(0, 0));
    CHECK(largest_residual(path) <= 64 * epsilon<double>() * 1e8 / (0.05 * 0.05));
}
TEST_CASE("a mass that is singular is refused, and a small one is not, in any dimension") {
    // the velocity (1, ..., 1) has no momentum
    auto const singular = [](auto const& q, auto const& v) {
        auto L = 0 * v(0) - q.dot(q) / 2;
        for (int k = 0; k < q.size(); ++k) L = L + (0.1 + 0.37 * k) * pow(v(k) - v((k + 1) % q.size()), 2) / 2;
        return L;
    };
    auto const light = [](auto const& q, auto const& v) {
        auto L = 1e-18 * (v(0) * v(0) / 2 - q(0) * q(0));
        for (int j = 1; j < q.size(); ++j) {
            L = L + v(j) * v(j) / 2 - q(j) * q(j) / 2;
            for (int k = 0; k < j; ++k) L = L - (k == 0 ? 1e-18 : 1.0) * 1000 * pow(q(j) - q(k), 4);
        }
        return L;
    };
    for (int const d : {3, 12, 24, 40}) {
        Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(d, 0, 1), p = 0 * q;
        CHECK_THROWS_AS(
            [&] {
                for (auto const& x : embed(singular, order_one).along(T, q, p)) (void)x;
            }(),
            error::singular);
        CHECK(largest_residual(embed(light, mid_point).along(uniform(0.0, 0.01, 10), q, p)) <= 1e-9);
    }
}
TEST_CASE("no components, and zeros with a sign") {
    Eigen::VectorXd const nothing(0);
    auto const flat = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) * q.dot(q); };
    int points = 0;
    for (auto const& x : embed(flat, mid_point).along(T, nothing, nothing)) points += x.q.size() == 0 ? 1 : 0;
    CHECK(points == 41);
    long long calls = 0;
    auto const with_signs = [&calls](auto const& q, auto const& v) {
        ++calls;
        double const minus = -0.0;
        return v.dot(v) / 2 + 0.0 * q(1) - copysign(q(0), minus) * q(1) - atan2(q(1) * q(1), minus) * q(0);
    };
    Eigen::Vector2d const q(1, 0.5), p(0, 1);
    Eigen::Vector2d fixed = q;
    Eigen::VectorXd of_any_size = q;
    for (auto const& x : embed(with_signs, mid_point).along(T, q, p)) fixed = x.q;
    calls = 0;
    for (auto const& x : embed(with_signs, mid_point).along(T, of_any_size, Eigen::VectorXd(p))) of_any_size = x.q;
    CHECK(calls <= 12); // the formula that was traced holds where it was traced
    CHECK((fixed - of_any_size).norm() <= 1024 * epsilon<double>() * fixed.norm());
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
