// SPDX-License-Identifier: BSL-1.0
// Times at which formulas switch: they are found, an accurate solution has points there, and the accuracy is met against closed forms.
#include <cmath>
#include <memory>
#include <string>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/lagrangian.hpp"

namespace switching_tests {

using namespace hilger;

namespace {

double const pi = std::acos(-1.0);

text::stated_lagrangian in_text(std::string const& formula) {
    return text::lagrangian_in(formula, std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 0}}));
}
std::vector<double> switches(std::string const& formula, double a = 0, double b = 20) { return in_text(formula).switching_times(a, b); }
void are(std::vector<double> const& found, std::vector<double> const& right) {
    REQUIRE(found.size() == right.size());
    for (std::size_t k = 0; k < right.size(); ++k) CHECK(std::abs(found[k] - right[k]) <= 256 * epsilon<double>() * 20);
}
/// An oscillator of frequency one, pushed from rest by f(t).
auto pushed(std::string const& f, double end, double wanted, double longest_step = 0) {
    Eigen::VectorXd const rest = Eigen::VectorXd::Zero(1);
    return solve(in_text("v^2/2 - q^2/2 + q*(" + f + ")"), interval{0.0, end}, initial_velocity<Eigen::VectorXd>{rest, rest},
                 accuracy{wanted, longest_step});
}
template <class Solution, class Exact>
void meets(Solution const& x, double wanted, Exact const& exact) {
    auto const& T = x.q.root();
    double worst = 0;
    for (index_type i = 0; i <= x.steps; ++i) worst = std::max(worst, std::abs(x.q[i](0) - exact(T.element(i))));
    CAPTURE(worst);
    CHECK(worst <= wanted);
    CHECK(0 < x.error);
    CHECK(x.error <= wanted);
    CHECK(x.steps < 2000); // the order is not lost
    CHECK(std::abs(x(T.max() / 3).q(0) - exact(T.max() / 3)) <= wanted);
}
/// What a push of one from t = s on makes of that oscillator.
double behind(double s, double t) { return t < s ? 0 : 1 - std::cos(t - s); }

} // namespace

TEST_CASE("where formulas compare the time alone, in any form") {
    are(switches("v^2/2 + q*if(abs(t - 7) < 0.01, 100, 0)"), {6.99, 7, 7.01});
    are(switches("v^2/2 + q*if(t < 5 and not 2*t + 1 < 7, 100, 0)"), {3, 5});
    are(switches("v^2/2 + q*abs(t - pi)"), {pi});
    are(switches("v^2/2 + q*min(min(t/3, 4 - t), 1)"), {3});
    are(switches("v^2/2 + q*if(sin(t) < 0.5, 1, 0)"),
        {pi / 6, 5 * pi / 6, 13 * pi / 6, 17 * pi / 6, 25 * pi / 6, 29 * pi / 6, 37 * pi / 6});
    are(switches("v^2/2 + q*if(t^2 < 10, 1, 0)"), {std::sqrt(10.0)});
    are(switches("v^2/2 + sum(i, 1, 4, if(t < 2*i, q, 0))"), {2, 4, 6, 8});
    are(switches("v^2/2 + if(q > 2, if(t < 5, q, 0), if(t < 6, q, 0))"), {5, 6}); // wherever the state leads
    are(switches("v^2/2 - if(q < t, 1, 0)*q + t*abs(q)"), {});                    // of the state too: no time is known
    are(switches("v^2/2 - q^2/2"), {});
    are(switches("v^2/2 - if(t < 0, q, 2*q)*if(t < 20, 1, 2)"), {}); // at the ends
    are(switches("v^2/2 - if(t < -3, q, 2*q)", -20, 0), {-3});
    auto const in_digits = in_text("v^2/2 + q*if(t < sqrt(2), 0, 1)").switching_times(float50(0), float50(2));
    REQUIRE(in_digits.size() == 1);
    CHECK(abs(in_digits[0] - sqrt(float50(2))) <= 256 * epsilon<float50>());
    CHECK_THROWS_AS((void)switches("v^2/2 + q*if(sin(100000*t) < 0, 0, 1)"), error::invalid_parameter);
}

TEST_CASE("a push that all steps would pass over") {
    auto const exact = [](double t) { return 100 * (behind(6.99, t) - behind(7.01, t)); };
    CHECK(std::abs(exact(20) - 0.8403200681553974) <= 100 * epsilon<double>());
    for (double const longest : {0.0, 0.5}) meets(pushed("if(abs(t - 7) < 0.01, 100, 0)", 20, 1e-8, longest), 1e-8, exact);
}
TEST_CASE("two narrow pushes, in opposite directions") {
    meets(pushed("if(abs(t - 3) < 0.001, 1000, 0) - if(abs(t - 11.1) < 0.003, 50, 0)", 20, 1e-9), 1e-9,
          [](double t) { return 1000 * (behind(2.999, t) - behind(3.001, t)) - 50 * (behind(11.097, t) - behind(11.103, t)); });
}
TEST_CASE("a load from an irrational time on") {
    for (double const wanted : {1e-1, 1e-4, 1e-11})
        meets(pushed("if(t < sqrt(2), 0, 1)", 10, wanted), wanted, [](double t) { return behind(std::sqrt(2.0), t); });
}
TEST_CASE("a ramp with a kink") {
    meets(pushed("abs(t - pi)", 10, 1e-10), 1e-10, [](double t) {
        double const s = t - pi;
        return s < 0 ? -s - pi * std::cos(t) + std::sin(t) : s + pi * std::cos(s) - 3 * std::sin(s);
    });
}
TEST_CASE("a square wave that a sine makes") {
    Eigen::VectorXd const rest = Eigen::VectorXd::Zero(1);
    auto const x = solve(in_text("v^2/2 + q*if(sin(3*t) < 0, -1, 1)"), interval{0.0, 20.0}, initial_velocity<Eigen::VectorXd>{rest, rest},
                         accuracy{1e-9});
    double const h = pi / 3, n = std::floor(20 / (2 * h)), r = 20 - 2 * h * n, s = r - h;
    CHECK(std::abs(x.end.q(0) - n * h * h - (s < 0 ? r * r / 2 : h * h / 2 + h * s - s * s / 2)) <= 1e-9);
}
TEST_CASE("what no run sees is not said to be without an error") {
    // a push that is smooth: nothing says where it is
    auto const x = pushed("100*exp(-((t - 7.1)*3000)^2)", 20, 1e-8);
    CHECK(x.error == 1e-8); // it is the accuracy alone that is said
    auto const y =
        solve([](auto const& q, auto const& v) { return v * v / 2 + 0 * q; }, interval{0.0, 8.0}, {.q0 = 1.0, .v0 = 0.0}, accuracy{1e-6});
    CHECK(y.error >= epsilon<double>()); // right to the last bit, which no two runs can say
}

} // namespace switching_tests
