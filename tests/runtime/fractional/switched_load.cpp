// SPDX-License-Identifier: BSL-1.0
// u'' + D^{3/2} u + u = f from rest, where f jumps: Newmark's scheme keeps its order two wherever in a step a jump is.
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include "hilger/fractional/newmark.hpp"
#include "hilger/history/history.hpp"
#include "series.hpp"

namespace switched_load_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// Steps at the times `at`, by `by` each; at a jump itself it is already behind it, or still before it.
struct steps_of_load {
    std::vector<double> at, by;
    bool behind;
    double operator()(double t) const {
        double f = 0;
        for (std::size_t k = 0; k < at.size(); ++k)
            if (behind ? at[k] <= t : at[k] < t) f += by[k];
        return f;
    }
    [[nodiscard]] std::vector<double> switching_times(double a, double b) const {
        std::vector<double> there;
        for (double const t : at)
            if (a < t and t < b) there.push_back(t);
        return there;
    }
};
/// The series of the answer to a step of one, which is shifted.
double exact(steps_of_load const& f, double t) {
    fractional_oscillator<float50> const answer{1, float50(3) / 2, 1, 0, 0, 1};
    float50 u = 0;
    for (std::size_t k = 0; k < f.at.size(); ++k)
        if (f.at[k] < t) u += f.by[k] * answer.at(float50(t) - float50(f.at[k])).u;
    return static_cast<double>(u);
}
double error_of(steps_of_load const& f, int N, double at) {
    auto const scheme = newmark<bdf<2>>(fractional_structure{1.0, 1.0, 1.0, 1.0, 1.5}, f, average_acceleration, direct{});
    state<double, double> last{};
    for (auto const& x : scheme.along(uniform(interval{0.0, at}, N), initial_velocity{0.0, 0.0})) last = x;
    return last.q - exact(f, at);
}

} // namespace

TEST_CASE("jumps on a point, within steps, within one step, and at the start") {
    CHECK(std::abs(exact({{0, 1}, {8, -8}, true}, 2) - 4.425462195858) < 1e-12);
    CHECK(std::abs(exact({{0, 1}, {8, -8}, true}, 5) + 0.455641340538) < 1e-12);
    for (bool const behind : {true, false})
        for (auto const& load : {std::pair<std::vector<double>, std::vector<double>>{{0, 1}, {8, -8}},
                                 {{0.003, std::sqrt(2.0)}, {8, -8}},
                                 {{0.5, 0.505, 1.7}, {50, -40, -10}},
                                 {{0.998, 1, 1.002}, {500, 1, -501}}})
            for (int const N : {200, 400, 800}) {
                steps_of_load const f{load.first, load.second, behind};
                double const e = error_of(f, N, 2), h = 2.0 / N;
                CAPTURE(behind);
                CAPTURE(load.first[0]);
                CAPTURE(N);
                CAPTURE(e / (h * h));
                CHECK(std::abs(e) <= 4 * h * h); // of order one it is up to 8 h, forty times and more as large
            }
}

} // namespace switched_load_tests
