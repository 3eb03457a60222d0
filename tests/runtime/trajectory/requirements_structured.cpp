// SPDX-License-Identifier: BSL-1.0
// Only what a scene requires is computed and kept: large systems with a structure, and systems with memory.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "runtime/allocations.hpp"
#include "support/histories.hpp"
#include "support/requirements.hpp"
#include "support/systems.hpp"

namespace requirements_structured_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// A force makes a sine for each of d + 1 springs, and the second derivatives a cosine.
constexpr auto spring = [](hilger::index_type, auto const& r) { return 1 - cos(r); };
constexpr unknown<"q"> q;
constexpr unknown<"y"> y;
auto const T = uniform(0.0, 0.05, 200);

template <class Path>
requirements needs(Path const& path, hilger::index_type steps = 16) {
    return requirements_of(path, steps, allocations_until_now);
}
template <class E>
requirements chain_of(hilger::index_type d, double h, E const& how) {
    Eigen::VectorXd const x = Eigen::VectorXd::LinSpaced(d, -1, 1), p = Eigen::VectorXd::Zero(d);
    return needs(embed(mechanical(1.0, chain(spring)), how).along(uniform(0.0, h, 40), x, p));
}
/// What a path remembers of fractional derivatives after some steps.
template <class Path>
hilger::index_type history_of(Path const& path, int steps = 3) {
    auto at = path.begin();
    for (int i = 0; i < steps; ++i) ++at;
    return numbers_of_histories(at.remembered(), path.method());
}

} // namespace

TEST_CASE("a chain that is not stiff: forces only, whatever its length") {
    // Broken by Newton from the first step on, by a Hessian that is evaluated to see whether it is needed, by a d x d matrix.
    for (hilger::index_type const d : {16, 64}) {
        requirements const r = chain_of(d, 0.05, mid_point);
        CHECK(r.sines <= 4 * (static_cast<double>(d) + 1));
        CHECK(r.cosines == 0);
        CHECK(r.functions == r.sines);
        CHECK(r.divisions <= 2); // by h and 2: factors of a matrix would take d
        CHECK(r.allocations == 0);
        CHECK(r.growth_in_bytes == 0);
        CHECK(r.memory_bytes <= 8 * (16 * d + 16)); // eight velocities and five vectors to work in
    }
}

TEST_CASE("a stiff chain: one number a spring for the Hessian, and a tridiagonal factorization a round") {
    // Broken by a Hessian of d x d numbers, by more forces than rounds.
    double const d = 16;
    requirements const r = chain_of(16, 1.0, mid_point), twice = chain_of(32, 1.0, mid_point);
    double const rounds = r.cosines / (d + 1), rounds_of_twice = twice.cosines / (2 * d + 1);
    CHECK(rounds > 0);
    CHECK(r.sines <= (rounds + 1.5) * (d + 1));
    CHECK(twice.arithmetic / rounds_of_twice <= 2.5 * r.arithmetic / rounds);
    CHECK(r.allocations == 0);
}

TEST_CASE("under order one a chain costs one force, and each particle the same") {
    requirements const r = chain_of(16, 0.05, order_one), twice = chain_of(32, 0.05, order_one), four = chain_of(64, 0.05, order_one);
    CHECK(r.sines == 16 + 1);
    CHECK(r.functions == r.sines);
    CHECK(r.divisions == 0);
    CHECK(r.allocations == 0);
    CHECK(four.arithmetic - twice.arithmetic == 2 * (twice.arithmetic - r.arithmetic));
    CHECK(four.memory_bytes - twice.memory_bytes == 2 * (twice.memory_bytes - r.memory_bytes));
}

TEST_CASE("there is no history where the damping is local") {
    // Broken by an engine that is made for every order.
    auto const local = embed(with_fractional_damping(pendulum, 0.1, fraction<1>{}), order_one).along(T, 1.0, 0.5);
    requirements const one = needs(local);
    CHECK(history_of(local) == 0);
    CHECK(one.growth_in_bytes == 0);
    CHECK(one.functions == 1);
    auto const at_run_time = embed(with_fractional_damping(pendulum, 0.1, 1.0), order_one).along(T, 1.0, 0.5);
    CHECK(history_of(at_run_time) == 0);
    // Half a derivative of half a derivative
    auto const S = integral(pendulum(q, Delta_plus[q]), T) - 0.2 * integral(Delta_minus_alpha<1, 2>[q] * Delta_plus_alpha<1, 2>[y], T);
    CHECK(needs(flow_of(variation(S)).along(T, 1.0, 0.5)).growth_in_bytes == 0);
}

TEST_CASE("the past at a cost that does not grow, and grows like its digits with the steps to come") {
    // Broken by keeping values that are in the exponentials already.
    auto const along = [](exponentials const& policy) {
        return embed(with_fractional_damping(pendulum, 0.1, fraction<1, 2>{}, policy), order_one).along(T, 1.0, 0.5);
    };
    auto const thousand = history_of(along({1e-12, 1000})), million = history_of(along({1e-12, 1'000'000})),
               milliard = history_of(along({1e-12, 1'000'000'000}));
    CHECK(thousand > 0);
    CHECK(history_of(along({1e-12, 1000}), 150) == thousand);
    // a + b log N with a >= 0
    CHECK(million <= 2 * thousand);
    CHECK(milliard <= 3 * thousand);
    requirements const r = needs(along({1e-12, 1000}));
    CHECK(8 * thousand < r.memory_bytes);
    CHECK(r.growth_in_bytes == 0);
    CHECK(r.functions == 1); // one force, and no round
    CHECK(r.divisions <= 2); // the history's newest weight is part of the equation
    CHECK(r.allocations == 0);
    auto const kicked = embed(with_fractional_impulses(pendulum, 0.1, fraction<1, 2>{}, exponentials{1e-12, 1000}), order_one);
    requirements const by_impulses = needs(kicked.along(T, 1.0, 0.5));
    CHECK(by_impulses.functions == 1);
    CHECK(by_impulses.divisions == 0); // explicit
    CHECK(history_of(kicked.along(T, 1.0, 0.5)) == thousand);
    requirements const sum = needs(embed(with_fractional_damping(pendulum, 0.1, fraction<1, 2>{}), order_one).along(T, 1.0, 0.5), 128);
    CHECK(sum.growth_in_bytes >= 2 * 8); // a value and a weight a step
}

TEST_CASE("a hundred degrees of freedom with one fractional damper keep one history") {
    // Broken by a history for each component, or for each column of the damping.
    exponentials const policy{1e-10, 1000};
    auto const alone = history_of(embed(with_fractional_damping(pendulum, 0.1, fraction<1, 2>{}, policy), order_one).along(T, 1.0, 0.5));
    REQUIRE(alone > 0);
    hilger::index_type const d = 100;
    Eigen::VectorXd const x = Eigen::VectorXd::LinSpaced(d, -1, 1), zero = Eigen::VectorXd::Zero(d);
    Eigen::VectorXd rho = zero;
    auto const damped = [&] { return with_fractional_damping(mechanical(1.0, chain(spring)), rho, fraction<1, 2>{}, policy); };
    CHECK(history_of(embed(damped(), order_one).along(T, x, zero)) == 0);
    rho(41) = 0.1;
    CHECK(history_of(embed(damped(), order_one).along(T, x, zero)) == alone);

    Eigen::MatrixXd const M = Eigen::MatrixXd::Identity(d, d);
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(d, d);
    C(41, 41) = 0.1;
    auto const load = [&](double) { return zero; };
    auto const scheme =
        newmark<grunwald_letnikov>(fractional_structure{M, C, M, 1.0, fraction<1, 2>{}}, load, average_acceleration, policy);
    CHECK(history_of(scheme.along(T, x, zero)) == alone);
}

TEST_CASE("Newmark's method of a structure solves once a step and factorizes before the first") {
    using number = counted;
    auto const scheme = newmark<bdf<2>>(
        fractional_structure{number(1), number(1), number(1), 1.0, fraction<1, 2>{}}, [](auto const& t) { return t; }, average_acceleration,
        exponentials{1e-10, 1000});
    auto const path = scheme.along(uniform(number(0), number(0.1), 100), number(1), number(0));
    requirements const r = requirements_of(path);
    CHECK(r.divisions <= 2); // by the factor that was made before
    CHECK(r.functions == 0);
    CHECK(history_of(path) > 0);
    CHECK(r.growth_in_bytes == 0);
}

TEST_CASE("a structure's step by Newmark's scheme: its force twice and one solve, the matrix factorized before the first") {
    // Broken by a matrix that is factorized in every step, by a history for each component.
    using matrix = Eigen::Matrix<counted, 3, 3>;
    using vector = Eigen::Matrix<counted, 3, 1>;
    auto const M = matrix(Eigen::Matrix3d::Identity().cast<counted>());
    Eigen::Matrix3d C = Eigen::Matrix3d::Zero(), K;
    C(1, 1) = 0.5;
    K << 2, -1, 0, -1, 2, -1, 0, -1, 2;
    long loads = 0;
    auto const load = [&loads](counted const& t) {
        ++loads;
        return vector(t, counted(0), counted(1));
    };
    fractional_structure const one_damper{M, matrix(C.cast<counted>()), matrix(K.cast<counted>()), 1.0, 0.5};
    zener_structure const everywhere{M, matrix(K.cast<counted>()), 1.0, 2.0, 0.1, fraction<1, 2>{}};
    vector const x(1, 0, -1);
    auto const history_after_check = [&](auto const& structure, double divisions) {
        auto const scheme = newmark<bdf<2>>(structure, load, average_acceleration, exponentials{1e-10, 1000});
        auto const path = scheme.along(uniform(counted(0), counted(0.05), 200), x, x);
        requirements const r = needs(path);
        CHECK(r.divisions <= divisions); // three by the pivots of factors that were made before: making them divides, too
        CHECK(r.functions == 0);
        CHECK(r.allocations == 0);
        CHECK(r.growth_in_bytes == 0);
        return history_of(path);
    };
    auto const one = history_after_check(one_damper, 4);
    CHECK(one > 0);
    CHECK(history_after_check(everywhere, 5) == 3 * one);
    CHECK(loads > 0);
}

} // namespace requirements_structured_tests
