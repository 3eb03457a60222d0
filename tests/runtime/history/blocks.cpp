// SPDX-License-Identifier: BSL-1.0
// What holds of the values of blocks at a single point: the bound that the engine gives afterwards.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "histories.hpp"

namespace history_blocks_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

struct errors {
    double largest_of_bound = 0, largest = 0, largest_relative = 0; ///< error / bound, error, error / |sum|
};
template <class G>
errors compare(std::vector<double> const& x, double alpha) {
    auto const sums = sums_as_written<G>(alpha, x);
    auto engine = make_history<G>(blocks{}, alpha, 0.0);
    CHECK(engine.error_bound() == 0);
    errors e;
    for (std::size_t k = 0; k < x.size(); ++k) {
        engine.push(x[k]);
        double const bound = engine.error_bound();
        double const error = std::abs(engine.past() - sums[k]) - epsilon<double>() * std::abs(sums[k]); // they are rounded too
        if (bound == 0) CHECK(error <= 0);
        if (bound > 0) e.largest_of_bound = std::max(e.largest_of_bound, error / bound);
        e.largest = std::max(e.largest, error);
        if (sums[k] != 0) e.largest_relative = std::max(e.largest_relative, error / std::abs(sums[k]));
    }
    return e;
}

} // namespace

TEST_CASE("after an impulse the small sums have fewer digits, and the bound says so at every point") {
    for (double const alpha : {0.5, 1.5}) {
        std::vector<double> x(5000, 0.0);
        x[0] = 1;
        auto const e = compare<bdf<2>>(x, alpha);
        CHECK(e.largest_of_bound <= 1);
        CHECK(e.largest_of_bound > 1e-3); // and is no more than it must be by a thousand
        CHECK(e.largest <= 4 * epsilon<double>());
        CHECK(e.largest_relative > 1e4 * epsilon<double>()); // so it has to
    }
}
TEST_CASE("of noise, of what grows, and of an impulse in noise that is small") {
    auto const noisy = random_values<double>(3000);
    CHECK(compare<grunwald_letnikov>(noisy, 0.3).largest_of_bound <= 1);
    CHECK(compare<bdf<3>>(noisy, 1.25).largest_of_bound <= 1);
    std::vector<double> growing, small;
    for (std::size_t k = 0; k < noisy.size(); ++k) {
        growing.push_back(static_cast<double>(k * k));
        small.push_back(k == 700 ? 1 : 1e-12 * noisy[k]);
    }
    CHECK(compare<bdf<2>>(growing, 0.75).largest_of_bound <= 1);
    CHECK(compare<bdf<2>>(small, 0.75).largest_of_bound <= 1);
    CHECK(compare<trapezoid>(noisy, 0.4).largest_of_bound <= 1);
}
TEST_CASE("component by component") {
    auto const x = random_values<Eigen::Vector3d>(700);
    auto const sums = sums_as_written<bdf<2>>(0.5, x);
    auto engine = make_history<bdf<2>>(blocks{}, 0.5, x[0]);
    for (std::size_t k = 0; k < x.size(); ++k) {
        engine.push(Eigen::Vector3d(x[k](0), 1e-9 * x[k](1), 0));
        Eigen::Vector3d const bound = engine.error_bound();
        CHECK(std::abs(engine.past()(0) - sums[k](0)) <= bound(0) + epsilon<double>() * std::abs(sums[k](0)));
        CHECK(bound(1) <= 1e-8 * (bound(0) + 1e-12));
        CHECK(bound(2) == 0);
    }
}

} // namespace history_blocks_tests
