// SPDX-License-Identifier: BSL-1.0
// Newmark's method with fractional damping: order two from any start, many degrees of freedom against a formulation by accelerations and
// against modes, and what is refused. The tables of its paper are in papers/galucio_deu_dubois_2008.
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/fractional/newmark.hpp"
#include "hilger/hilger.hpp"
#include "series.hpp"
#include "support/histories.hpp"

namespace fractional_newmark_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// The positions of a run in one list of columns.
template <class Scheme, class Scale, class V>
std::vector<state<double, V>> states(Scheme const& scheme, Scale const& T, V const& u0, V const& v0) {
    std::vector<state<double, V>> all;
    for (auto const& x : scheme.along(T, initial_velocity<V>{u0, v0})) all.push_back(x);
    return all;
}

struct frame { // three storeys; a damper between the upper two, another from the second to the ground, none at the first
    Eigen::MatrixXd mass{{2, 0.5, 0}, {0.5, 1, 0}, {0, 0, 1.5}};
    Eigen::MatrixXd damping{{0, 0, 0}, {0, 0.75, -0.5}, {0, -0.5, 0.5}};
    Eigen::MatrixXd stiffness{{5, -2, 0}, {-2, 3, -1}, {0, -1, 2}};
    Eigen::VectorXd u0{{0.5, -1, 0.25}}, v0{{1, 0, -0.5}};
    static Eigen::VectorXd load(double t) { return Eigen::VectorXd{{std::sin(t), 1, t}}; }
};

/// The same scheme by accelerations, as (5) and (6) are printed, with every value of every component in the sum.
std::vector<Eigen::VectorXd> by_accelerations(frame const& f, double alpha, double tau, double h, int N) {
    auto const g = first_weights<bdf<2>>(alpha, N + 1);
    double const scale = std::pow(1.5 * tau / h, alpha);
    Eigen::VectorXd u = f.u0, v = f.v0;
    std::vector<Eigen::VectorXd> all{u};
    Eigen::VectorXd a = f.mass.inverse() * (f.load(0) - f.stiffness * u); // Caputo's derivative of order < 1 begins with zero
    Eigen::MatrixXd const effective = f.mass + h * h / 4 * (f.stiffness + scale * f.damping);
    for (int n = 1; n <= N; ++n) {
        Eigen::VectorXd past = -f.u0;
        for (int k = 1; k <= n; ++k) past += g[static_cast<std::size_t>(k)] * (all[static_cast<std::size_t>(n - k)] - f.u0);
        Eigen::VectorXd const predicted = u + h * v + h * h / 4 * a;
        Eigen::VectorXd const force = f.load(n * h) - scale * (f.damping * past) - (f.stiffness + scale * f.damping) * predicted;
        Eigen::VectorXd const next = effective.partialPivLu().solve(force);
        u = predicted + h * h / 4 * next;
        v += h / 2 * (a + next);
        a = next;
        all.push_back(u);
    }
    return all;
}

} // namespace

TEST_CASE("order two from u_0 and u'_0 that are not zero, for orders below, at and above 1") {
    for (double const alpha : {0.25, 0.5, 0.75, 1.0, 1.25, 1.5}) {
        fractional_oscillator<float50> const wide{1, float50(alpha), 2, float50(1) / 2, float50(-1) / 4, 3};
        auto const exact = wide.at(1);
        std::vector<double> eu, ep;
        for (int const N : {512, 1024, 2048}) {
            auto const scheme = newmark<bdf<2>>(fractional_structure{2.0, 2.0, 4.0, 1.0, alpha}, [](double) { return 6.0; });
            auto const last = states(scheme, uniform(interval{0.0, 1.0}, N), 0.5, -0.25).back();
            eu.push_back(std::abs(last.q - static_cast<double>(exact.u)));
            ep.push_back(std::abs(last.p - 2 * static_cast<double>(exact.v)));
        }
        CAPTURE(alpha);
        CHECK(std::abs(fitted_slope(eu) - 2) < 0.02);
        CHECK(std::abs(fitted_slope(ep) - 2) < 0.02);
        CHECK(eu.back() < 1e-6);
    }
}

TEST_CASE("three storeys: the scheme is the one of accelerations, and the first keeps no history") {
    frame const f;
    double const alpha = 0.5, tau = 0.3, h = 0.05;
    int const N = 200;
    auto const expected = by_accelerations(f, alpha, tau, h, N);
    auto const scheme = newmark<bdf<2>>(fractional_structure{f.mass, f.damping, f.stiffness, tau, alpha}, frame::load);
    auto const T = uniform(0.0, h, N);
    auto const made = states(scheme, T, f.u0, f.v0);
    for (std::size_t n = 0; n < made.size(); ++n) CHECK((made[n].q - expected[n]).norm() < 256 * N * epsilon<double>());
    // Fixed sizes and an order in the type are the same.
    Eigen::Matrix3d const M = f.mass, C = f.damping, K = f.stiffness;
    auto const fixed =
        newmark<bdf<2>>(fractional_structure{M, C, K, tau, fraction<1, 2>{}}, [](double t) -> Eigen::Vector3d { return frame::load(t); });
    auto const same = states(fixed, T, Eigen::Vector3d(f.u0), Eigen::Vector3d(f.v0));
    for (std::size_t n = 0; n < made.size(); ++n) CHECK((made[n].q - same[n].q).norm() < 64 * N * epsilon<double>());

    decltype(scheme)::memory<double, Eigen::VectorXd> memory(scheme, h, f.u0);
    state<double, Eigen::VectorXd> x{0.0, f.u0, f.mass * f.v0};
    memory.advance(scheme, x, h);
    CHECK(testing::numbers_of_histories(memory, scheme) == 2 * 2); // two values of two components
    CHECK((x.q - expected[1]).norm() < 64 * epsilon<double>());
    // What is continued from a checkpoint has its history.
    auto const path = scheme.along(T, f.u0, Eigen::VectorXd(f.mass * f.v0));
    auto at = path.begin();
    for (int n = 0; n < 70; ++n) ++at;
    Eigen::VectorXd last;
    for (auto const& y : path.resume(at.checkpoint())) last = y.q;
    CHECK(last == made.back().q);
}

TEST_CASE("modes: where M, C and K have common ones, each moves as an oscillator") {
    Eigen::Matrix2d const phi{{0.6, -0.8}, {0.8, 0.6}}; // orthogonal
    Eigen::Vector2d const k(1, 9), c(0.5, 2), u0(1, -0.5), load(1, 2);
    Eigen::Matrix2d const M = Eigen::Matrix2d::Identity(), C = phi * c.asDiagonal() * phi.transpose(),
                          K = phi * k.asDiagonal() * phi.transpose();
    auto const T = uniform(0.0, 0.05, 200);
    Eigen::Vector2d const f = phi * load, zero(0, 0);
    auto const both =
        states(newmark<bdf<2>>(fractional_structure{M, C, K, 1.0, 0.75}, [&](double) { return f; }), T, Eigen::Vector2d(phi * u0), zero);
    for (int j = 0; j < 2; ++j) {
        auto const one =
            states(newmark<bdf<2>>(fractional_structure{1.0, c(j), k(j), 1.0, 0.75}, [&](double) { return load(j); }), T, u0(j), 0.0);
        for (std::size_t n = 0; n < one.size(); ++n) CHECK(std::abs(phi.col(j).dot(both[n].q) - one[n].q) < 1024 * 9 * epsilon<double>());
    }
}

TEST_CASE("without damping there is no history, and average acceleration is the mid-point rule: its energy stays") {
    auto const scheme = newmark<bdf<2>>(fractional_structure{1.0, 0.0, 4.0, 1.0, 0.5}, [](double) { return 0.0; });
    for (auto const& x : states(scheme, uniform(0.0, 0.1, 500), 1.0, 0.5))
        CHECK(std::abs(x.p * x.p / 2 + 2 * x.q * x.q - 2.125) < 500 * 4 * epsilon<double>());
    auto const path = scheme.along(uniform(0.0, 0.1, 500), 1.0, 0.5);
    auto at = path.begin();
    for (int n = 0; n < 20; ++n) ++at;
    CHECK(testing::numbers_of_histories(at.remembered(), scheme) == 0);
}

TEST_CASE("what is no structure is refused in one sentence") {
    double const nan = std::nan("");
    auto const still = [](double) { return 0.0; };
    auto const make = [&](double m, double c, double k, double tau, double alpha) {
        return newmark<bdf<2>>(fractional_structure{m, c, k, tau, alpha}, still);
    };
    for (double const alpha : {0.0, 2.0, -1.0, nan}) CHECK_THROWS_AS((void)make(1, 1, 1, 1, alpha), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)make(1, 1, 1, 0, 0.5), "a relaxation time is positive, and this one is 0", error::invalid_parameter);
    CHECK_THROWS_AS((void)make(1, 1, 1, nan, 0.5), error::invalid_parameter);
    CHECK_THROWS_AS((void)make(nan, 1, 1, 1, 0.5), error::not_finite);
    CHECK_THROWS_AS((void)make(1, 1, nan, 1, 0.5), error::not_finite);

    auto const walk = [](auto const& path) {
        for (auto const& x : path) (void)x;
    };
    auto const T = uniform(0.0, 0.5, 4);
    CHECK_THROWS_WITH_AS((void)make(0, 1, 1, 1, 0.5), "the mass of a structure is singular", error::singular);
    CHECK_THROWS_WITH_AS(walk(make(1, 0, -16, 1, 0.5).along(T, 0.0, 0.0)), "the matrix of a Newmark step is singular", error::singular);
    auto const noisy = newmark<bdf<2>>(fractional_structure{1.0, 1.0, 1.0, 1.0, 0.5}, [&](double t) { return t > 0.75 ? nan : 1.0; });
    try {
        walk(noisy.along(T, 0.0, 0.0));
        FAIL("a load that is NaN must be reported");
    } catch (error::not_finite const& e) {
        CHECK(dynamic_cast<interrupted<double, double> const&>(e).last.t == 0.5);
    }
    Eigen::MatrixXd const two = Eigen::MatrixXd::Identity(2, 2), three = Eigen::MatrixXd::Identity(3, 3),
                          wide = Eigen::MatrixXd::Ones(2, 3);
    auto const none = [](double) -> Eigen::VectorXd { return Eigen::VectorXd::Zero(2); };
    CHECK_THROWS_WITH_AS((void)newmark<bdf<2>>(fractional_structure{two, three, two, 1.0, 0.5}, none),
                         "the matrices of a structure are square and of one size", error::mismatch);
    CHECK_THROWS_AS((void)newmark<bdf<2>>(fractional_structure{wide, wide, wide, 1.0, 0.5}, none), error::mismatch);
    Eigen::VectorXd const short_one = Eigen::VectorXd::Zero(1), u0 = Eigen::VectorXd::Zero(2), nans = Eigen::VectorXd::Constant(2, nan);
    auto const good = newmark<bdf<2>>(fractional_structure{two, two, two, 1.0, 0.5}, none);
    CHECK_THROWS_WITH_AS((void)good.along(T, short_one, short_one),
                         "a structure of 2 degrees of freedom starts from as many, and not from 1", error::mismatch);
    CHECK_THROWS_AS((void)good.along(T, u0, short_one), error::mismatch);
    CHECK_THROWS_AS((void)good.along(T, nans, u0), error::not_finite);
    CHECK_THROWS_AS((void)newmark<bdf<2>>(fractional_structure{Eigen::MatrixXd(two * 0), two, two, 1.0, 0.5}, none), error::singular);
    auto const long_load = newmark<bdf<2>>(fractional_structure{three, three, three, 1.0, 0.5}, none);
    CHECK_THROWS_WITH_AS(walk(long_load.along(T, Eigen::VectorXd(Eigen::VectorXd::Zero(3)), Eigen::VectorXd(Eigen::VectorXd::Zero(3)))),
                         "a load has one component for each degree of freedom, and this one has 2 for 3", error::mismatch);
}

TEST_CASE("with beta below 1/4 a damping limits the steps") {
    auto const walked = [](auto const& method, double h) {
        double last = 0;
        for (auto const& x : method.along(uniform(0.0, h, 2000), 1.0, 0.0)) last = std::max(last, std::abs(x.q));
        return last;
    };
    auto const none = [](double) { return 0.0; };
    // bdf<2> of order 3/2: h^(1/2) 4^(3/2) C (1 - 4 beta) + h^2 K (1 - 4 beta) < 4
    auto const damped = [&](double C, auto beta) { return newmark<bdf<2>>(fractional_structure{1.0, C, 1.0, 1.0, 1.5}, none, beta); };
    for (double const h : {0.01, 0.0025}) {
        double const limit = (4 - h * h) / (8 * std::sqrt(h));
        CHECK(walked(damped(0.99 * limit, central_difference), h) < 2);
        CHECK(walked(damped(1.1 * limit, central_difference), h) > 1e3);
        CHECK(walked(damped(2.9 * limit, linear_acceleration), h) < 2);
        CHECK(walked(damped(3.3 * limit, linear_acceleration), h) > 1e3);
        CHECK(walked(damped(30 * limit, average_acceleration), h) < 2);
    }
}

} // namespace fractional_newmark_tests
