// SPDX-License-Identifier: BSL-1.0
// Structured systems solve the equations that the same Lagrangian has without its structure, whatever iteration they take.
#include <algorithm>
#include <cmath>
#include <optional>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"

namespace structured_tests {

using namespace hilger;

namespace {

constexpr auto spring = [](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12 + r * r * r * r / 7; };
constexpr auto gravity = [](hilger::index_type k, auto const& r) { return -(1 + static_cast<double>(k) / 8) / r.norm(); };

/// How far a trajectory is from p_i = -d_1 L_h, p_{i+1} = d_2 L_h with one node at q_i + lambda (q_{i+1} - q_i), by derivatives of the
/// whole L.
template <class L, class Path, class S>
S defect(L const& l, Path const& path, S const& h, S const& lambda) {
    S worst(0);
    std::optional<typename Path::iterator::value_type> last;
    for (auto const& x : path) {
        if (last) {
            auto const v = plain_t<decltype(x.q)>((x.q - last->q) / h);
            auto const A = plain_t<decltype(x.q)>(last->q + lambda * (x.q - last->q));
            auto const g = gradient_first(l, A, v), m = gradient_second(l, A, v);
            worst = std::max({worst, S((last->p + (S(1) - lambda) * h * g - m).norm()), S((x.p - lambda * h * g - m).norm())});
        }
        last = x;
    }
    return worst;
}

} // namespace

TEST_CASE("chain, pairs and mass matrices solve their equations, by iteration and by Newton") {
    using vector6 = Eigen::Matrix<double, 6, 1>;
    vector6 q, p;
    q << 0.5, -0.25, 0.375, 1.5, -1.25, 0.75;
    p << 0.1, -0.2, 0.3, 0.25, 0.125, -0.5;
    Eigen::Matrix<double, 6, 6> M = Eigen::Matrix<double, 6, 6>::Identity();
    M(0, 1) = M(1, 0) = 0.25;
    M(5, 5) = 3;
    vector6 m;
    m << 1, 2, 3, 1, 2, 3;
    auto const check = [&](auto const& l, double h) {
        auto const T = uniform(0.0, h, 20);
        CHECK(defect(l, embed(l, mid_point).along(T, q, p), h, 0.5) < 64 * epsilon<double>() * 10 / h);
    };
    // h = 1 is beyond where iterating with the mass alone converges
    for (double const h : {0.05, 1.0}) {
        CAPTURE(h);
        check(mechanical(m, chain(spring)), h);
        check(mechanical(M, chain(spring)), h);
        check(mechanical(m, [](auto const& x) { return x.dot(x) * x(0) / 9 + x.dot(x); }), h);
    }
    check(mechanical(m, pairs<3>({{0, 1}, {1, -1}}, gravity)), 0.01);
    check(mechanical(m, pairs<3>({{0, 1}, {-1, 1}}, gravity)), 0.01); // the wall first: r = -q
    CHECK(mechanical(m, pairs<1>({{-1, 2}}, [](hilger::index_type, auto const& r) { return r; })).potential()(q) == -q(2));
    auto const T = uniform(0.0, 0.05, 20);
    auto const l = mechanical(m, chain(spring));
    CHECK(defect(l, embed(l, order_one).along(T, q, p), 0.05, 0.0) < 64 * epsilon<double>() * 10 / 0.05);
    CHECK(defect(l, embed(l, order_one_left).along(T, q, p), 0.05, 1.0) < 64 * epsilon<double>() * 10 / 0.05);
}

TEST_CASE("a hundred bodies on a line, far apart in the list: the Hessian is sparse") {
    hilger::index_type const d = 100;
    std::vector<std::pair<hilger::index_type, hilger::index_type>> list;
    for (hilger::index_type k = 0; k < d; ++k) list.emplace_back(k, (k * 37 + 1) % d == k ? -1 : (k * 37 + 1) % d);
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(d, -1, 1), p = Eigen::VectorXd::LinSpaced(d, 0.5, 0);
    auto const sparse = mechanical(1.0, pairs<1>(list, spring));
    int entries = 0;
    sparse.potential().hessian(q, [&](auto const&...) { ++entries; });
    REQUIRE(entries <= 3 * d);
    CHECK(defect(sparse, embed(sparse, mid_point).along(uniform(0.0, 0.8, 5), q, p), 0.8, 0.5) < 1e-12);
}

TEST_CASE("every two of n bodies, with and without a list") {
    std::vector<std::pair<hilger::index_type, hilger::index_type>> const list{{1, 0}, {2, 0}, {2, 1}, {3, 0}, {3, 1}, {3, 2}};
    REQUIRE(std::ranges::equal(all_pairs(4), list));
    CHECK(std::ranges::empty(all_pairs(1)));
    CHECK(std::ranges::empty(all_pairs(0)));
    using vector = Eigen::Matrix<double, 12, 1>;
    vector q, p;
    for (int k = 0; k < 12; ++k) q(k) = std::sin(3.0 * k) * (k + 1), p(k) = std::cos(2.0 * k);
    auto const energy = [](hilger::index_type k, auto const& r) { return -(2 + static_cast<double>(k)) / r.norm() + r(0) * r(0) * r(1); };
    auto const listed = mechanical(2.0, pairs<3>(list, energy));
    auto const every = mechanical(2.0, pairs<3>(all_pairs(4), energy));
    CHECK(listed.potential()(q) == every.potential()(q));
    vector g, h;
    Eigen::VectorXd room(13);
    listed.potential().gradient(q, g, room);
    every.potential().gradient(q, h, room);
    CHECK((g - h).norm() <= 8 * epsilon<double>() * g.norm());
    CHECK((g + gradient_first(every, q, p)).norm() <= 64 * epsilon<double>() * g.norm());
    auto const T = uniform(0.0, 0.01, 20);
    CHECK(defect(every, embed(every, mid_point).along(T, q, p), 0.01, 0.5) < 64 * epsilon<double>() * 1000);
}

TEST_CASE("structured steps in 50 digits: the energy of an FPU chain, order 2") {
    using vector = Eigen::Matrix<float50, 4, 1>;
    auto const l = mechanical(float50(1), chain(spring));
    vector const q(1, float50(1) / 2, 0, 0), p(0, 0, 1, 0);
    auto const drift = [&](int n) {
        float50 worst(0), E0 = p.dot(p) / 2 + l.potential()(q);
        for (auto const& x : embed(l, mid_point).along(uniform(interval<float50>{0, 1}, n), q, p))
            worst = std::max(worst, float50(abs(float50(x.p.dot(x.p) / 2 + l.potential()(x.q) - E0))));
        return worst;
    };
    CHECK(std::abs(testing::order_of(drift(40), drift(80)) - 2) < 0.05);
}

TEST_CASE("the first guess goes through a polynomial of the last values") {
    auto const cubic = [](int t) { return 2 * t * t * t - 5 * t + 1; };
    for (int const n : {4, 5, 8}) {
        int next = 0;
        for (int i = 0; i < n; ++i) next += detail::extrapolation(n, i) * cubic(10 - i);
        CHECK(next == cubic(11));
    }
    CHECK(detail::extrapolation(2, 0) == 2);
    CHECK(detail::extrapolation(2, 1) == -1);
}

TEST_CASE("what a structured system needs is said") {
    Eigen::VectorXd const q = Eigen::VectorXd::Ones(6);
    auto const T = uniform(0.0, 0.1, 3);
    auto const walk = [&](auto const& l) {
        for (auto const& x : embed(l, mid_point).along(T, q, q)) (void)x;
    };
    CHECK_THROWS_WITH_AS(mechanical(-1.0, chain(spring)), "a mass is positive, and one of these is not", error::singular);
    CHECK_THROWS_WITH_AS(walk(mechanical(Eigen::VectorXd(Eigen::VectorXd::Ones(5)), chain(spring))),
                         "the mass has dimension 5, and the state has 6", error::mismatch);
    CHECK_THROWS_AS((void)mechanical(Eigen::VectorXd(Eigen::VectorXd::Ones(5)), chain(spring))(q, q), error::mismatch);
    CHECK_THROWS_AS((void)mechanical(Eigen::MatrixXd(Eigen::MatrixXd::Identity(7, 7)), chain(spring))(q, q), error::mismatch);
    CHECK_THROWS_WITH_AS(walk(mechanical(1.0, pairs<3>({{0, 2}}, gravity))),
                         "a pair takes two different bodies from -1 (the origin) to 1, and one is (0, 2)", error::outside_domain);
    CHECK_THROWS_AS(walk(mechanical(1.0, pairs<3>({{0, 1}}, gravity))), error::not_finite); // two bodies in one place
}

} // namespace structured_tests
