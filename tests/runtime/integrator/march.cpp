// SPDX-License-Identifier: BSL-1.0
// Equations of several steps march from their first values, and what is returned solves them.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"

namespace march_tests {

using namespace hilger;

namespace {

constexpr unknown q;
constexpr lagrangian quadratic{[](auto const& x, auto const& v) { return v * v / 2 + v * x / 3 - x * x / 2; }};
constexpr lagrangian pendulum{[](auto const& x, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(x);
}};
/// (q_{i+1} - q_{i-1}) / 2h on equal steps: three points.
constexpr auto central = fraction<1, 2>{} * (Delta_plus + Delta_minus);
constexpr auto mean_of_three = fraction<1, 4>{} * rho + fraction<1, 2>{} * identity_T + fraction<1, 4>{} * sigma;

} // namespace

TEST_CASE("in rational numbers the equation holds exactly, whatever the operators reach") {
    auto const holds = [](auto const& EL, auto const& T, auto const& first) {
        auto const x = solve(EL, T, first);
        auto const rest = EL.residual(x);
        for (auto i = rest.domain().first(T); i <= rest.domain().last(T); ++i) CHECK(rest[i] == 0);
        CHECK(rest.domain().last(T) - rest.domain().first(T) > 3);
        for (std::size_t i = 0; i < first.size(); ++i) CHECK(x[static_cast<hilger::index_type>(i)] == first[i]);
        CHECK(not(x[T.size() - 1] == x[T.size() - 2]));
    };
    auto const T = uniform(Q(0), Q(1, 5), 12);
    std::vector<Q> const two{Q(1), Q(6, 5)}, four{Q(1), Q(6, 5), Q(5, 4), Q(6, 5)};
    holds(variation(integral(quadratic(q, Delta_plus[q]), T)), T, two);
    holds(variation(integral(quadratic((on_half * extend)[q], (pi_inverse * Delta_plus)[q]), half(T))), T, two);
    holds(variation(integral(quadratic(q, central[q]), T)), T, four);
    holds(variation(integral(quadratic(mean_of_three[q], central[q]), T)), T, four);
    time_scale<Q> const uneven{Q(0), Q(1, 7), Q(1, 3), Q(1, 2), Q(3, 5), Q(4, 5), Q(1), Q(5, 4), Q(3, 2)};
    holds(variation(integral(quadratic(q, (Delta_plus * Delta_plus)[q]), T)), T, four);
    holds(variation(integral(quadratic(q, Delta_plus[q]), uneven)), uneven, two);
    holds(variation(integral(quadratic(mean_of_three[q], central[q]), uneven)), uneven, four);
}

TEST_CASE("over one step it is the step") {
    auto const T = uniform(0.0, 0.1, 50);
    auto const EL = variation(integral(pendulum((on_half * extend)[q], (pi_inverse * Delta_plus)[q]), half(T)));
    auto const stepped = solve(EL, T, initial_positions{1.0, 1.02});
    auto const marched = solve(EL, T, std::vector{1.0, 1.02});
    for (hilger::index_type i = 0; i < T.size(); ++i) CHECK(std::abs(stepped[i] - marched[i]) <= 4096 * epsilon<double>());
}

TEST_CASE("over steps that are nearly too long, where whole corrections of Newton's method do not arrive") {
    constexpr lagrangian hanging{[](auto const& x, auto const& v) { return v * v / 2 + cos(x); }};
    auto const T = uniform(0.0, 1.9, 600); // the equation has one solution up to h = 2
    auto const EL = variation(integral(hanging(extend[q], Delta_o_plus[extend[q]]), half(T)));
    auto const x = solve(EL, T, std::vector{1.0, 2.0});
    CHECK(x.size() == 601);
    CHECK(largest_residual(EL, x) <= 64 * epsilon<double>());
}

TEST_CASE("a motion that runs away is not marched on at the other side") {
    constexpr lagrangian runs_away{[](auto const& x, auto const& v) { return v * v / 2 + x * x * x * x; }};
    for (double h : {0.1, 0.03, 0.01}) { // of the cubic equation of a point one root is always there
        auto const T = uniform(0.0, h, static_cast<index_type>(3 / h));
        auto const EL = variation(integral(runs_away(extend[q], Delta_o_plus[extend[q]]), half(T)));
        CHECK_THROWS_AS((void)solve(EL, T, std::vector{1.0, 1.0 + h}), error::no_convergence);
    }
}

TEST_CASE("with a force beside dL/dq") {
    auto const T = uniform(Q(0), Q(1, 5), 12);
    auto const EL = variation(integral(quadratic(mean_of_three[q], central[q]), T));
    auto const force = [](auto const& t, auto const& x, auto const& v) { return t / 3 - x / 5 - v / 7; };
    auto const x = solve(EL, T, std::vector<Q>{Q(1), Q(6, 5), Q(5, 4), Q(6, 5)}, force);
    auto const rest = EL.residual(x, force);
    for (auto i = rest.domain().first(T); i <= rest.domain().last(T); ++i) CHECK(rest[i] == 0);
    CHECK(not(EL.residual(x)[5] == 0));
}

TEST_CASE("states of every kind, to rounding") {
    auto const solved = [](auto const& L, auto const& start, auto const& push) {
        using V = std::remove_cvref_t<decltype(start)>;
        auto const T = uniform(0.0, 0.05, 40);
        auto const EL = variation(integral(L(mean_of_three[q], central[q]), T));
        std::vector<V> first;
        for (int i = 0; i < 4; ++i) first.push_back(V(start + push * (0.05 * i)));
        auto const x = solve(EL, T, first);
        double size = 0;
        for (auto const& value : x) size = std::max(size, magnitude(V(value)));
        CHECK(size > 1.05 * magnitude(start));
        CHECK(size < 100);
        CHECK(largest_residual(EL, x) <= 64 * epsilon<double>() * size / (0.05 * 0.05));
    };
    solved(pendulum, 1.0, 0.5);
    auto const coupled = lagrangian{[](auto const& x, auto const& v) {
        auto L = v.dot(v) / 2 - x.dot(x) / 2;
        for (int k = 1; k < x.size(); ++k) L = L - pow(x(k) - x(k - 1), 4) / 4 + v(k) * x(k - 1) / 3;
        return L;
    }};
    solved(coupled, Eigen::Vector2d(1, 0.5), Eigen::Vector2d(0.5, 0));
    using vector6 = Eigen::Matrix<double, 6, 1>;
    solved(coupled, vector6(vector6::LinSpaced(-1, 1)), vector6(vector6::Constant(1)));
    solved(coupled, Eigen::VectorXd(Eigen::VectorXd::LinSpaced(9, -1, 1)), Eigen::VectorXd(Eigen::VectorXd::Constant(9, 1)));
}

TEST_CASE("what is missing is said in a sentence") {
    auto const T = uniform(0.0, 0.1, 10);
    auto const EL = variation(integral(pendulum(q, central[q]), T));
    CHECK_THROWS_WITH_AS((void)solve(EL, T, std::vector{1.0, 1.0}), doctest::Contains("is solved from 4 values on; these are 2"),
                         error::mismatch);
    CHECK_THROWS_WITH_AS((void)solve(EL, uniform(0.0, 0.1, 2), std::vector{1.0, 1.0, 1.0, 1.0}), doctest::Contains("T has 3 points"),
                         error::mismatch);
    std::vector<Eigen::VectorXd> const uneven{Eigen::VectorXd::Ones(2), Eigen::VectorXd::Ones(3), Eigen::VectorXd::Ones(2),
                                              Eigen::VectorXd::Ones(2)};
    auto const plane = lagrangian{[](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2; }};
    CHECK_THROWS_AS((void)solve(variation(integral(plane(q, central[q]), T)), T, uneven), error::mismatch);
    CHECK(solve(EL, T, std::vector{1, 1, 1, 1})[3] == 1.0); // whole numbers are numbers
    auto const no_mass = lagrangian{[](auto const& x, auto const& v) { return 0 * v - x * x / 2; }};
    auto const singular = variation(integral(no_mass(q, central[q]), T));
    CHECK_THROWS_AS((void)solve(singular, T, std::vector{1.0, 1.0, 1.0, 1.0}), error::singular);
}

} // namespace march_tests
