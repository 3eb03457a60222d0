// SPDX-License-Identifier: BSL-1.0
// Histories of stages in 50 digits, and in the other scalars: within their tolerance of the direct powers; and the orders with which
// D^alpha t^p converges.
#include <doctest/doctest.h>

#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "hilger/embedding/collocation.hpp"
#include "hilger/history/stages.hpp"
#include "stage_distances.hpp"
#include "support/orders.hpp"

namespace history_stages_wide_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
template <class S>
void is_within(double tolerance, int s, int quarters) {
    auto const steps = steps_of_scales(6)[1];
    stage_judge const judge(collocation<float50, radau>(s), steps);
    stage_history<S> const history(collocation<S, radau>(s), S(quarters) / S(4), S(tolerance), S(1), S(steps[0]), S(0));
    auto const worst = distances_of(history, judge.power(quarters), steps, s);
    CHECK(worst.past <= tolerance);
    CHECK(worst.leading <= tolerance);
}
/// The error of D^alpha t^p at t = 1 on t_i = (i/N)^grading.
float50 error_at_one(int s, float50 const& alpha, int p, int N, double grading) {
    auto const method = collocation<float50, radau>(s);
    auto const point = [&](int i) { return float50(pow(float50(i) / N, float50(grading))); };
    stage_history<float50> history(method, alpha, float50(1e-10), float50(1), float50(point(1)), float50(0));
    float50 value(0);
    for (int n = 0; n < N; ++n) {
        float50 const t = point(n), nu = point(n + 1) - t;
        std::vector<float50> F;
        for (auto const& c : method.c) F.push_back(pow(float50(t + c * nu), p));
        history.begin(nu);
        value = history.past(s - 1);
        for (int j = 0; j < s; ++j) value += history.leading()(s - 1, j) * F[static_cast<std::size_t>(j)];
        history.push(F);
    }
    return value - boost::math::tgamma(float50(p + 1)) / boost::math::tgamma(float50(p + 1 - alpha));
}
} // namespace

TEST_CASE("in 50 digits within 1e-30 and 1e-20 of the direct powers, in all other scalars within their tolerances") {
    is_within<float50>(1e-30, 1, 3);
    is_within<float50>(1e-30, 2, 2);
    is_within<float50>(1e-20, 3, 5);
    is_within<long double>(1e-16, 3, 2);
    is_within<float>(1e-5, 2, 2);
    is_within<float>(1e-5, 3, 5);
}

TEST_CASE("D^alpha t^6 at t = 1 converges with order s + 1 - alpha, as stage order s has it, on equal and on graded steps") {
    for (int const s : {2, 3})
        for (double const alpha : {0.5, 1.5}) {
            CAPTURE(s);
            CAPTURE(alpha);
            double const grading = s == 2 ? 1 : 1.5;
            float50 const coarse = error_at_one(s, float50(alpha), 6, 24, grading), fine = error_at_one(s, float50(alpha), 6, 48, grading);
            CHECK(std::abs(order_of(coarse, fine) - (s + 1 - alpha)) <= 0.15);
        }
}

} // namespace history_stages_wide_tests
