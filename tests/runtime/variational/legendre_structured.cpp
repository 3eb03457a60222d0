// SPDX-License-Identifier: BSL-1.0
// The Legendre map costs what is known of the mass: nothing but a product where it is constant and said, and no second derivatives but
// those by the velocity where it is not. Counted, not timed.
#include <doctest/doctest.h>

#include "hilger/integrator/flow.hpp"
#include "hilger/models/mechanical.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/trajectory/dense_output.hpp"
#include "hilger/trajectory/diagnostics.hpp"
#include "hilger/variational/legendre_transform.hpp"
#include "support/counted.hpp"

namespace legendre_structured_tests {

using namespace hilger;

namespace {

long long calls = 0;
struct gravity {
    template <class R>
    auto operator()(hilger::index_type, R const& r) const {
        ++calls;
        return -1 / sqrt(1 + r.squaredNorm());
    }
};
/// A row of springs without a structure that is said, whose mass depends on the position.
struct row {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        ++calls;
        auto L = v.dot(v) / 2 - q.dot(q) / 2;
        for (int k = 1; k < q.size(); ++k) L = L + q(k) * q(k) * v(k) * v(k - 1) / 8;
        return L;
    }
};

template <class Work>
long long calls_of(Work const& work) {
    calls = 0;
    work();
    return calls;
}
template <class V>
V numbers(int d, double first) {
    V x(d);
    for (int k = 0; k < d; ++k) x(k) = typename V::Scalar(first + k % 7 + 0.125 * k);
    return x;
}
using dynamic = Eigen::VectorXd;

} // namespace

TEST_CASE("energy, momentum and velocity of 40 bodies ask each pair for its energy once, or not at all") {
    int const bodies = 40, d = 3 * bodies, pairs_of_them = bodies * (bodies - 1) / 2;
    dynamic const q = numbers<dynamic>(d, 1), p = numbers<dynamic>(d, -2), masses = numbers<dynamic>(d, 3);
    auto const L = mechanical(masses, pairs<3>(all_pairs(bodies), gravity{}));
    double E = 0;
    CHECK(calls_of([&] { E = energy(L)(state<double, dynamic>{0, q, p}); }) == pairs_of_them);
    CHECK(std::abs(E - (p.cwiseQuotient(masses).dot(p) / 2 + L.potential()(q))) <= 64 * epsilon<double>() * std::abs(E));
    dynamic v, back;
    CHECK(calls_of([&] { v = velocity_of(L, q, p); }) == 0);
    CHECK(calls_of([&] { back = momentum_of(L, q, v); }) == 0);
    CHECK((back - p).cwiseAbs().maxCoeff() <= 4 * epsilon<double>() * p.cwiseAbs().maxCoeff());
    // Along a path: one for each state, beside what its steps ask for.
    auto const path = embed(L, mid_point).along(uniform(0.0, 0.01, 10), q, p);
    long long const walking = calls_of([&] {
        for (auto const& x : path) (void)x;
    });
    CHECK(calls_of([&] { (void)drift_along(path, energy(L)); }) == walking + 11 * pairs_of_them);
}

TEST_CASE("the slopes between states take first derivatives only, in one evaluation") {
    int const bodies = 8, d = 3 * bodies, pairs_of_them = bodies * (bodies - 1) / 2;
    dynamic const q = numbers<dynamic>(d, 1), p = numbers<dynamic>(d, -2);
    auto const L = mechanical(2.0, pairs<3>(all_pairs(bodies), gravity{}));
    auto const drag = [](auto const& x, auto const& v) { return -v / 4 + 0 * x; };
    slopes<dynamic> s, forced;
    CHECK(calls_of([&] { s = slopes_at(embed(L, mid_point).mechanics(), state<double, dynamic>{0, q, p}); }) == pairs_of_them);
    forced = slopes_at(with_force(L, drag), state<double, dynamic>{0, q, p});
    CHECK(s.q == dynamic(p / 2));
    CHECK(forced.q == s.q);
    CHECK((forced.p - s.p + p / 8).cwiseAbs().maxCoeff() <= 4 * epsilon<double>() * s.p.cwiseAbs().maxCoeff());
    CHECK((s.p - expand(L, q, s.q).by_q).cwiseAbs().maxCoeff() <= 64 * epsilon<double>() * s.p.cwiseAbs().maxCoeff());
}

TEST_CASE("in numbers that count: the energy is L and a product more") {
    using testing::counted;
    using vector = Eigen::Matrix<counted, Eigen::Dynamic, 1>;
    auto const operations = [](auto const& work) {
        auto& record = testing::record_of_operations::of_this_thread();
        record.begin();
        counted const z = work();
        record.stop_counting();
        z.need();
        return record.end().arithmetic;
    };
    int const d = 24;
    vector q(d), p(d);
    for (int k = 0; k < d; ++k) q(k) = counted::variable(k * k % 11), p(k) = counted::variable(k % 5 + 1);
    auto const L = mechanical(2.0, chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    auto const plain = operations([&] { return L(q, p); });
    auto const all = operations([&] { return hamiltonian(L)(p, q); });
    CHECK(all <= plain + 3 * d + 2); // p / M, p.v, one less the other
}

TEST_CASE("every kind of mass, in exact numbers and in vectors of fixed size") {
    using V = Eigen::Matrix<Q, 3, 1>;
    V const q(1, 2, 3), p(2, -1, 5);
    auto const U = [](auto const& x) { return x.dot(x) / 2; };
    auto const plain = [](auto const& x, auto const& v) { return v.dot(v) * 3 / 2 - x.dot(x) / 2; };
    CHECK(velocity_of(mechanical(Q(3), U), q, p) == velocity_of(plain, q, p));
    CHECK(momentum_of(mechanical(Q(3), U), q, p) == momentum_of(plain, q, p));
    V const masses(3, 4, 5);
    CHECK(velocity_of(mechanical(masses, U), q, p) == V(Q(2, 3), Q(-1, 4), Q(1)));
    CHECK(momentum_of(mechanical(masses, U), q, p) == V(6, -4, 25));
    Eigen::Matrix3d full;
    full << 4, 1, 0, 1, 3, 1, 0, 1, 2;
    Eigen::Vector3d const x(1, 2, 3), y(2, -1, 5);
    auto const heavy = mechanical(full, U);
    CHECK((full * velocity_of(heavy, x, y) - y).cwiseAbs().maxCoeff() <= 16 * epsilon<double>());
    CHECK(momentum_of(heavy, x, y) == Eigen::Vector3d(full * y));
    CHECK_THROWS_AS((void)velocity_of(mechanical(Eigen::VectorXd(Eigen::VectorXd::Ones(2)), U), dynamic(x), dynamic(y)), error::mismatch);
    CHECK_THROWS_AS((void)velocity_of(mechanical(Eigen::MatrixXd(-full), U), dynamic(x), dynamic(y)), error::singular);
    CHECK_THROWS_AS(
        (void)velocity_of(mechanical(Eigen::Matrix2d(Eigen::Matrix2d::Ones()), U), Eigen::Vector2d(1, 2), Eigen::Vector2d(1, 1)),
        error::singular);
    Eigen::Matrix<Q, 3, 3> exact;
    exact << 4, 1, 0, 1, 3, 1, 0, 1, 2;
    V const v = velocity_of(mechanical(exact, U), q, p);
    CHECK(V(exact * v) == p);
}

TEST_CASE("without a structure: no derivatives by the position") {
    int const d = 20;
    dynamic const q = numbers<dynamic>(d, -1) / 8, p = numbers<dynamic>(d, 1) / 4;
    dynamic v;
    long long const once = calls_of([&] { (void)detail::trace_there(row{}, q, p, detail::on_velocity); });
    CHECK(once == 1);
    long long const n = calls_of([&] { v = velocity_of(row{}, q, p); });
    CHECK(n % once == 0);
    CHECK(n <= 3 * once);
    auto const e = expand(row{}, q, v);
    auto const second = detail::trace_there(row{}, q, v, detail::on_velocity);
    Eigen::MatrixXd by_vv = Eigen::MatrixXd::Zero(d, d);
    second.for_each_in(detail::block_vv, [&](int j, int k, double x) { by_vv(j, k) = x; });
    CHECK(by_vv == e.vv);
    CHECK(second.by_v == e.by_v);
    CHECK(second.formula.places.entries[detail::block_qq].empty());
    CHECK((e.by_v - p).cwiseAbs().maxCoeff() <= 64 * epsilon<double>() * p.cwiseAbs().maxCoeff());
}

TEST_CASE("a Hamiltonian's velocity is its derivative, with the time in it too") {
    auto const H = [](auto const& p, auto const& q) { return p * p * (1 + q * q) / 2 + q * q / 2; };
    CHECK(velocity_of(lagrangian_of(H), Q(2), Q(3)) == 15);
    auto const timed = [](auto const& t, auto const& p, auto const& q) { return p * p * (1 + t) / 2 + q * q / 2; };
    Q const t = 4;
    auto const L = lagrangian_of(timed);
    CHECK(velocity_of(detail::at_time{L, t}, Q(2), Q(3)) == 15);
    CHECK(momentum_of(detail::at_time{L, t}, Q(2), Q(15)) == 3);
}

} // namespace legendre_structured_tests
