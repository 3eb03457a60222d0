// SPDX-License-Identifier: BSL-1.0
// The work of a damping at the stages is never positive. Radau IIA is algebraically stable (Burrage, Butcher 1979): with the weights w of
// its quadrature <D f, f>_w >= f(t_N)^2 / 2 on every T. So D, its resolvents and the means of these, I^{1 - mu} and D^mu, are monotone, and
//   -rho <v, D^mu y>_w = -rho <v, I^{1 - mu} v>_w <= 0,   v = D y,   0 < mu <= 1,
// up to each point of T; above order 1 the same holds of <v, D^{mu - 1} v>_w, if the velocity is 0 at t_0.
#include <doctest/doctest.h>

#include <numeric>

#include "hilger/embedding/collocation.hpp"
#include "hilger/history/stages.hpp"
#include "stage_distances.hpp"

namespace history_stage_dissipation_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// The least sum of nu_n b_k (D y)_k (D^mu y)_k up to a step, in units of the sum of its terms' magnitudes up to there; y is noise.
double least_work(int s, double mu, std::vector<double> const& steps) {
    double const shortest = *std::min_element(steps.begin(), steps.end()), longest = std::accumulate(steps.begin(), steps.end(), 0.0);
    auto const method = collocation<double, radau>(s);
    auto const history = [&](double order) { return stage_history<double>(method, order, 1e-13, longest, shortest, 0.0); };
    auto power = history(mu), velocity = history(1);
    noise source;
    std::vector<double> y(static_cast<std::size_t>(s));
    double sum = 0, size = 0, least = 0;
    for (double const nu : steps) {
        power.begin(nu);
        velocity.begin(nu);
        for (double& x : y) x = source.next<double>();
        for (index_type i = 0; i < s; ++i) {
            auto const at = [&](auto const& h) {
                double value = h.past(i);
                for (index_type j = 0; j < s; ++j) value += h.leading()(i, j) * y[static_cast<std::size_t>(j)];
                return value;
            };
            double const term = nu * static_cast<double>(method.b[static_cast<std::size_t>(i)]) * at(velocity) * at(power);
            sum += term;
            size += std::abs(term);
        }
        power.push(y);
        velocity.push(y);
        least = std::min(least, sum / size);
    }
    CHECK(sum > 0);
    return least;
}

} // namespace

TEST_CASE("the work of the damping is not positive up to any step, for one to four stages, on equal, graded and uneven T") {
    for (int s = 1; s <= 4; ++s)
        for (auto const& steps : steps_of_scales(200)) {
            CAPTURE(s);
            CAPTURE(steps[0]);
            for (double const mu : {0.05, 0.5, 0.95, 1.0, 1.5}) CHECK(least_work(s, mu, steps) >= -1e-12);
        }
}

} // namespace history_stage_dissipation_tests
