// SPDX-License-Identifier: BSL-1.0
// Tables 1 to 3 of A. C. Galucio, J.-F. Deue and F. Dubois, "The G^alpha-scheme for approximation of fractional derivatives" (2008), and
// the oscillator of section 3 against 45 digits.
#include <algorithm>
#include <array>
#include <cmath>

#include <doctest/doctest.h>

#include "../../tests/runtime/fractional/series.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "newmark_oscillator.hpp"

namespace galucio_oscillator_tests {

using namespace hilger;
using namespace hilger::papers;
using testing::fractional_oscillator;

namespace {

std::vector<row> printed(std::string const& name) { return table("galucio_deu_dubois_2008/" + name); }
template <generating_function G>
void converges(double order, double most_at_the_end) {
    for (auto const& line : printed("fractional_oscillator.csv")) {
        double const alpha = number<double>(line[0]), c = number<double>(line[1]), t = number<double>(line[2]),
                     exact = number<double>(line[3]);
        std::vector<double> errors;
        for (int const N : {1024, 2048, 4096}) errors.push_back(std::abs(last_position(oscillator<G>(alpha, c), t, N) - exact));
        CAPTURE(alpha);
        CAPTURE(t);
        CHECK(std::abs(fitted_slope(errors) - order) < 0.02);
        CHECK(errors.back() < most_at_the_end);
    }
}

} // namespace

TEST_CASE("table 1: the coefficients of G^alpha, exactly") {
    auto const lines = printed("galpha_coefficients.csv");
    REQUIRE(lines.size() == 11);
    std::array const orders{Q(1, 3), Q(1, 2), Q(3, 4)};
    for (std::size_t k = 0; k < orders.size(); ++k) {
        auto const g = first_weights<bdf<2>, Q>(orders[k], 11);
        for (std::size_t j = 0; j < g.size(); ++j) CHECK(g[j] == Q(lines[j][k + 1]));
    }
}

TEST_CASE("two solutions of (3) agree with the table: in closed form, and as a double power series") {
    auto const lines = printed("fractional_oscillator.csv");
    CHECK(lines.size() == 9);
    for (auto const& line : lines) {
        double const alpha = number<double>(line[0]), t = number<double>(line[2]);
        float100 const u = number<float100>(line[3]);
        CHECK(std::abs(oscillator_solution(alpha, 1.0)(t) - static_cast<double>(u)) < 32 * epsilon<double>());
        auto const series = fractional_oscillator<float100>{1, number<float100>(line[0]), 1, 0, 0, 1}.at(number<float100>(line[2]));
        CHECK(abs(float100(series.u - u)) < float100("1e-44"));
    }
}

TEST_CASE("G^alpha-Newmark is of order 2 and GL-Newmark of order 1, at t = 1, 5, 15") {
    converges<bdf<2>>(2, 5.1e-7);
    converges<grunwald_letnikov>(1, 4e-4);
}

TEST_CASE("any generating function of order 2 does it, and every beta; without a start-up step") {
    double const alpha = 0.5, t = 5, exact = 0.668914627671081225;
    auto const order = [&](auto const& scheme) {
        std::vector<double> errors;
        for (int const N : {512, 1024, 2048}) errors.push_back(std::abs(last_position(scheme, t, N) - exact));
        return fitted_slope(errors);
    };
    CHECK(std::abs(order(oscillator<trapezoid>(alpha, 1.0)) - 2) < 0.02);
    CHECK(std::abs(order(oscillator<bdf<2>>(alpha, 1.0, linear_acceleration)) - 2) < 0.02);
    CHECK(std::abs(order(oscillator<bdf<2>>(alpha, 1.0, fox_goodwin)) - 2) < 0.02);
    CHECK(std::abs(order(oscillator<bdf<2>>(alpha, 1.0, central_difference)) - 2) < 0.02);
}

TEST_CASE("in 50 digits: the order is 2 where double would see rounding") {
    float50 const exact("0.387738214241532959803301676058620860259871756");
    std::vector<float50> errors;
    for (int const N : {128, 256, 512})
        errors.push_back(abs(float50(last_position(oscillator<bdf<2>>(float50(1) / 2, float50(1)), float50(1), N) - exact)));
    CHECK(std::abs(fitted_slope(errors) - 2) < 0.02);
}

TEST_CASE("tables 2 and 3: rates of the largest error over [0, 15]") {
    auto const lines = printed("galpha_newmark_rates.csv");
    CHECK(lines.size() == 12);
    std::vector<std::vector<double>> all_errors;
    std::vector<std::string> rates;
    for (auto const& line : lines) {
        bool const second = line[0] == "G_alpha";
        double const alpha = number<double>(line[1]), c = number<double>(line[2]);
        auto const errors = second ? largest_errors<bdf<2>>(alpha, c) : largest_errors<grunwald_letnikov>(alpha, c);
        all_errors.push_back(errors);
        rates.push_back(line[3]);
        CAPTURE(line[0]);
        CAPTURE(alpha);
        CAPTURE(c);
        CHECK(std::abs(difference_in_units(fitted_rate(errors, {7, 9}), line[3])) <= 0.5);
        std::vector<double> const finest(errors.end() - 2, errors.end());
        CHECK(std::abs(fitted_slope(finest) - (second ? 2 : 1)) < 0.02);
    }
    // "7-9 meshes" are m = 7, 8, 9: no other range has all twelve rates.
    CHECK(ranges_with_rates(all_errors, rates) == std::vector<mesh_range>{{7, 9}});
}

TEST_CASE("(4): the meshes T / 2^m, T = 15, have the rates printed; 1 / 2^m up to j = 2^m, which ends at t = 1, has others") {
    double const rate = 1.90; // table 2, alpha = 3/4
    CHECK(std::abs(fitted_slope(largest_errors<bdf<2>>(0.75, 1, 7, 9)) - rate) < 0.005);
    auto const errors = largest_errors<bdf<2>>(0.75, 1, 1, 11, 1.0);
    for (std::size_t count = 3; count <= 9; ++count) // whatever meshes
        for (auto first = errors.begin(); first + static_cast<long>(count) <= errors.end(); ++first)
            CHECK(std::abs(fitted_slope(std::vector<double>(first, first + static_cast<long>(count))) - rate) > (count < 7 ? 0.02 : 0.05));
}

TEST_CASE("rounding does not stop it: at 2^13 steps the error is still that of truncation") {
    // Position form, (u_{n+1} - 2 u_n + u_{n-1}) / h^2 = ..., makes rounding of the size of N^2 epsilon: 1e-8 here, the increment N
    // epsilon.
    double const exact = 0.365145641817603315;
    std::array<double, 2> error{};
    for (std::size_t k = 0; k < 2; ++k) error[k] = last_position(oscillator<bdf<2>>(0.75, 1.0), 1.0, k == 0 ? 4096 : 8192) - exact;
    double const from_rounding = std::abs(error[1] - error[0] / 4);
    CHECK(std::abs(error[1]) < 3e-10);
    CHECK(from_rounding < 8192 * epsilon<double>());
}

} // namespace galucio_oscillator_tests
