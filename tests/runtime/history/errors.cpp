// SPDX-License-Identifier: BSL-1.0
// What histories refuse.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "histories.hpp"

namespace history_errors_tests {

using namespace hilger;
using namespace hilger::testing;

using GL = grunwald_letnikov;

TEST_CASE("what is not finite is refused with its number, and the engine goes on as if it had not been there") {
    auto const check = [](auto engine) {
        engine.push(1);
        engine.push(2);
        double const before = engine.past();
        CHECK_THROWS_WITH_AS(engine.push(std::nan("")), "value 2 of a history is not finite", error::not_finite);
        CHECK_THROWS_AS(engine.push(std::numeric_limits<double>::infinity()), error::not_finite);
        CHECK(engine.count() == 2);
        CHECK(engine.past() == before);
        engine.push(3);
        auto const w = first_weights<GL>(0.5, 4);
        CHECK(engine.past() == doctest::Approx(w[3] + 2 * w[2] + 3 * w[1]).epsilon(1e-15));
    };
    check(make_history<GL>(direct{}, 0.5, 0.0));
    check(make_history<GL>(blocks{}, 0.5, 0.0));
    check(make_history<GL>(exponentials{}, 0.5, 0.0));
}

TEST_CASE("values of another size are refused") {
    auto const check = [](auto engine) {
        engine.push(Eigen::VectorXd::Ones(3));
        CHECK_THROWS_WITH_AS(engine.push(Eigen::VectorXd::Ones(2)), "value 1 of a history has 2 components, the history was made for 3",
                             error::mismatch);
        CHECK(engine.past().size() == 3);
    };
    Eigen::VectorXd const like = Eigen::VectorXd::Constant(3, std::nan("")); // its size is what counts
    check(make_history<GL>(direct{}, 0.5, like));
    check(make_history<GL>(blocks{}, 0.5, like));
    check(make_history<GL>(exponentials{}, 0.5, like));
}

TEST_CASE("parameters out of range") {
    double const nan = std::nan("");
    CHECK_THROWS_AS((void)make_history<GL>(direct{}, nan, 0.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(blocks{}, nan, 0.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(exponentials{}, nan, 0.0), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)make_history<GL>(exponentials{}, 2.5, 0.0),
                         "exponentials represent the history of orders from -9/10 to 2, not 2.5", error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(exponentials{}, -1.0, 0.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(exponentials{1e-16}, 0.5, 0.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(exponentials{1e-10}, 0.5F, 0.0F), error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(exponentials{nan}, 0.5, 0.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(exponentials{0.5}, 0.5, 0.0), error::invalid_parameter);
    CHECK_THROWS_AS((void)make_history<GL>(exponentials{0, 0}, 0.5, 0.0), error::invalid_parameter);
    // Next to whole orders the recurrence that exponentials are compared with has fewer digits than its smallest weights ask for.
    CHECK_THROWS_AS((void)make_history<bdf<6>>(exponentials{}, 2 - 3e-13, 0.0), error::invalid_parameter);
    auto short_run = make_history<GL>(exponentials{0, 2}, 0.5, 0.0);
    for (int n = 0; n <= 2; ++n) short_run.push(1); // at t_0, t_1, t_2
    CHECK_THROWS_WITH_AS(short_run.push(1), "these exponentials were made for 2 steps, and this is step 3", error::outside_domain);
}

} // namespace history_errors_tests
