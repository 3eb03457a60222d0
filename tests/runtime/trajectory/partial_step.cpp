// SPDX-License-Identifier: BSL-1.0
// Between its points, and at its events, a trajectory is as good as its method.
#include <doctest/doctest.h>

#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/jacobi_elliptic.hpp>

#include "hilger/trajectory/events.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"

namespace partial_step_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

float50 const k = float50(3) / 4; ///< q = 2 asin(k sn(t, k)), p = 2 k cn(t, k): from q = 0, p = 2 k
state<float50, float50> exact(float50 const& t) {
    float50 cn, dn;
    float50 const sn = boost::math::jacobi_elliptic(k, t, &cn, &dn);
    return {t, 2 * asin(float50(k * sn)), 2 * k * cn};
}
float50 distance(state<float50, float50> const& x) {
    auto const y = exact(x.t);
    return std::max(float50(abs(x.q - y.q)), float50(abs(x.p - y.p)));
}
/// The largest errors at the points of [0, 2], and between them.
template <class Flow>
std::pair<float50, float50> errors(Flow const& flow, int steps) {
    auto const path = flow.along(uniform(interval<float50>{0, 2}, steps), float50(0), 2 * k);
    dense_output const inside(path);
    float50 at(0), between(0);
    for (auto const& x : path) {
        at = std::max(at, distance(x));
        if (x.t < 2)
            for (int const part : {1, 5, 7}) between = std::max(between, distance(inside(x.t + float50(2 * part) / (8 * steps))));
    }
    return {at, between};
}
template <class Flow>
void check_order(Flow const& flow, double order, int steps) {
    CAPTURE(order);
    auto const coarse = errors(flow, steps), fine = errors(flow, 2 * steps);
    CHECK(std::abs(order_of(coarse.second, fine.second) - order) < 0.1);
    CHECK(fine.second <= 2 * fine.first);
}
/// How often g is evaluated.
template <class Path, class G>
int evaluations(Path const& path, G const& g) {
    int calls = 0;
    auto const counted = [&](auto const& x) { return ++calls, g(x); };
    for (auto const& x : events(path, counted)) (void)x;
    return calls;
}

/// A method whose steps are no longer than its number.
struct short_steps {
    double longest;
    struct memory {
        int made = 0;
        void advance(short_steps const& f, state<double, double>& x, double h) {
            if (h > f.longest) throw error::no_convergence("too long");
            x = {x.t + h, x.q + ++made, x.p};
        }
    };
};

} // namespace

TEST_CASE("a step that does not converge is divided, into eight at most") {
    auto const step = [](double longest) {
        return detail::partial_step(short_steps{longest}, short_steps::memory{}, state<double, double>{1, 0, 0}, 1.0);
    };
    CHECK(step(1) == state<double, double>{2, 1, 0});
    CHECK(step(0.5) == state<double, double>{2, 1 + 2, 0});
    CHECK(step(0.125).q == 36);
    CHECK_THROWS_WITH_AS((void)step(0.12), "the step from t = 1 with h = 0.125 failed: too long", error::no_convergence);
}

TEST_CASE("points are met exactly, and times are those that were given") {
    auto const flow = embed(bead, galerkin<2, gauss>);
    auto const path = flow.along(uniform(-1.0 / 3, 0.1, 20), 1.0, 0.5), from_zero = flow.along(uniform(0.0, 0.1, 20), 1.0, 0.5);
    dense_output const inside(path);
    for (auto const& x : path) CHECK(inside(x.t) == x);
    for (int i = -33; i < 160; ++i) CHECK(inside(0.01 * i).t == 0.01 * i);
    CHECK(dense_output(from_zero)(1e-320).q == 1.0);
    CHECK_THROWS_AS((void)inside(2.1), error::outside_domain);
}

TEST_CASE("the largest error between the points falls with the order of the method, and is that at the points") {
    check_order(embed(pendulum, mid_point), 2, 16);
    check_order(embed(pendulum, galerkin<2, gauss>), 4, 16);
    check_order(embed(pendulum, galerkin<4, gauss>), 8, 8);
    check_order(stoermer_verlet(pendulum), 2, 16);
    check_order(compose(kahan_li<8>, embed(pendulum, mid_point)), 8, 32);
}

TEST_CASE("events of the pendulum in 50 digits are at multiples of the elliptic integral K") {
    auto const path = embed(pendulum, galerkin<8, gauss>).along(uniform(interval<float50>{0, 10}, 200), float50(0), 2 * k);
    float50 const K = boost::math::ellint_1(k), bound("1e-32"); // gauss(8) has 1.3e-33 at the end of 200 steps
    int odd = 1, even = 2;
    for (auto const& x : events(path, [](auto const& y) { return y.p; })) {
        CHECK(abs(x.t - odd * K) <= bound);
        odd += 2;
    }
    for (auto const& x : events(path, [](auto const& y) { return y.q; })) {
        CHECK(abs(x.t - even * K) <= bound);
        CHECK(abs(abs(x.p) - 2 * k) <= bound);
        even += 2;
    }
    CHECK(odd == 7);
    CHECK(even == 6);
}

TEST_CASE("an event takes few steps inside of its own") {
    auto const path = embed(pendulum, mid_point).along(uniform(0.0, 0.05, 400), 0.0, 1.5);
    auto const count = [&](auto const& g) {
        auto const found = record(events(path, g)).states.size();
        REQUIRE(found > 0);
        return (evaluations(path, g) - 401.0) / static_cast<double>(found);
    };
    CHECK(count([](auto const& x) { return x.q; }) <= 5);
    CHECK(count([](auto const& x) { return x.p; }) <= 5);
    CHECK(count([](auto const& x) { return x.q > 0.5; }) <= 60); // by bisection
}

TEST_CASE("the periods of Kepler's orbit, from nearest point to nearest point") {
    using vector = Eigen::Vector2d;
    // 1/a = 2/r - v.v = 7/4 exactly, and d(q.p)/dt = v.v - 1/r = 9/4 at the nearest point
    double const period = 2 * std::acos(-1.0) * std::pow(4.0 / 7, 1.5);
    auto const path = embed(kepler, galerkin<8, gauss>).along(uniform(0.0, 0.0625, 200), vector(0.25, 0), vector(0, 2.5));
    int periods = 0;
    for (auto const& x : events(
             path, [](auto const& y) { return y.q.dot(y.p); }, crossing::rising)) {
        ++periods;
        CHECK(std::abs(x.t - period * periods) <= 8 * epsilon<double>() * x.t);
        CHECK(std::abs(x.q.norm() - 0.25) <= 8 * epsilon<double>());
    }
    CHECK(periods == 4);
}

TEST_CASE("a stone that bounces") {
    auto const flow = embed(lagrangian{[](auto const& q, auto const& v) { return v * v / 2 - q; }}, mid_point);
    state<double, double> x{0, 1, 0};
    for (int bounce = 0; bounce < 5; ++bounce) {
        auto const fall = until(
            flow.along(uniform(x.t, 0.125, 40), x.q, x.p), [](auto const& y) { return y.q; }, crossing::falling);
        x = record(fall).states.back();
        CHECK(std::abs(x.t - std::sqrt(2.0) * (1 + 2 * bounce)) <= 8 * epsilon<double>() * x.t);
        CHECK(std::abs(x.p + std::sqrt(2.0)) <= 8 * epsilon<double>() * (1 + bounce));
        x.p = -x.p;
    }
}

TEST_CASE("a section of Henon and Heiles has in double the digits that it has of 50") {
    lagrangian const henon_heiles{[](auto const& q, auto const& v) {
        auto const &x = q(0), &y = q(1);
        return v.dot(v) / 2 - (x * x + y * y) / 2 - x * x * y + y * y * y / 3;
    }};
    auto const section = [&]<class S>(S const& h) {
        using vector = Eigen::Matrix<S, 2, 1>;
        std::vector<state<S, vector>> all;
        auto const path =
            embed(henon_heiles, galerkin<4, gauss>).along(uniform(S(0), h, 320), vector(S(0), S(1) / 8), vector(S(3) / 8, S(1) / 16));
        for (auto const& x : events(
                 path, [](auto const& y) { return y.q(0); }, crossing::rising))
            all.push_back(x);
        return all;
    };
    auto const in_double = section(0.125);
    auto const in_50_digits = section(float50(1) / 8);
    REQUIRE(in_double.size() == in_50_digits.size());
    CHECK(in_double.size() >= 5);
    for (std::size_t i = 0; i < in_double.size(); ++i) {
        auto const& x = in_double[i];
        auto const& y = in_50_digits[i];
        CHECK(std::abs(static_cast<double>(float50(x.t) - y.t)) <= 256 * epsilon<double>());
        CHECK(std::abs(static_cast<double>(float50(x.q(1)) - y.q(1))) <= 256 * epsilon<double>());
    }
}

} // namespace partial_step_tests
