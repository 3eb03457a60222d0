// SPDX-License-Identifier: BSL-1.0
// The history of stages against whole matrices in 50 digits, at every step, on any T.
#include <doctest/doctest.h>

#include <cmath>
#include <numeric>

#include "hilger/embedding/collocation.hpp"
#include "hilger/history/stages.hpp"
#include "stage_distances.hpp"

namespace history_stages_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

template <class S>
runge_kutta<typename detail::wider<S>::type> method_of(bool is_radau, int s) {
    return is_radau ? collocation<S, radau>(s) : lobatto_3c<S>(s);
}
int tolerance_digits(double tolerance) { return static_cast<int>(std::lround(-std::log10(tolerance))); }
/// D^alpha of the values at the stages of one step.
template <class V>
std::vector<V> apply(stage_history<V>& history, double nu, std::vector<V> const& F) {
    history.begin(nu);
    std::vector<V> result;
    for (index_type i = 0; i < static_cast<index_type>(F.size()); ++i) {
        V x = history.past(i);
        for (std::size_t j = 0; j < F.size(); ++j) x += history.leading()(i, static_cast<index_type>(j)) * F[j];
        result.push_back(x);
    }
    history.push(F);
    return result;
}
} // namespace

TEST_CASE("each past is within the tolerance of the direct one: equal, graded, uneven steps, and steps that grow by 10^6") {
    for (bool const is_radau : {true, false})
        for (int s = is_radau ? 1 : 2; s <= 4; ++s)
            for (auto const& steps : steps_of_scales(24 / s)) {
                stage_judge const judge(method_of<float50>(is_radau, s), steps);
                double longest = 0, shortest = 1;
                for (double const nu : steps) longest += nu, shortest = std::min(shortest, nu);
                for (int const quarters : {1, 2, 3, 5, 6}) {
                    auto const power = judge.power(quarters);
                    for (double const tolerance : {1e-6, 1e-10, 1e-13}) {
                        if (not is_radau and quarters + 4 != tolerance_digits(tolerance) and quarters != 2) continue;
                        CAPTURE(is_radau);
                        CAPTURE(s);
                        CAPTURE(steps[0]);
                        CAPTURE(quarters);
                        CAPTURE(tolerance);
                        stage_history<double> const history(method_of<double>(is_radau, s), 0.25 * quarters, tolerance, longest, shortest,
                                                            0.0);
                        auto const worst = distances_of(history, power, steps, s);
                        CHECK(worst.past <= tolerance);
                        CHECK(worst.leading <= 4 * epsilon<double>()); // rounded, a power of nu and a product
                    }
                }
            }
}

TEST_CASE("one stage on equal steps has Gruenwald-Letnikov's weights") {
    for (double const alpha : {0.05, 0.5, 0.95, 1.3, 1.9}) {
        CAPTURE(alpha);
        double const tolerance = 1e-12;
        stage_history<double> history(collocation<double, radau>(1), alpha, tolerance, 2000.0, 1.0, 0.0);
        auto const w = first_weights<grunwald_letnikov>(alpha, 2000);
        for (std::size_t n = 0; n < w.size(); ++n) { // of a single 1
            history.begin(1.0);
            double const x = n == 0 ? 1 : 0;
            // above order 1 two sums, each of them right to the tolerance, are subtracted
            double const size = alpha < 1 ? std::abs(w[n]) : std::abs(std::pow(static_cast<double>(n + 1), -alpha));
            REQUIRE(std::abs(history.leading()(0, 0) * x + history.past(0) - w[n]) <= 4 * tolerance * size);
            history.push(std::span(&x, 1));
        }
    }
}

TEST_CASE("D^1/2 D^1/2 = D, and whole orders are exact") {
    auto const method = collocation<double, radau>(3);
    double const tolerance = 1e-12;
    for (auto const& steps : steps_of_scales(30)) {
        double const shortest = *std::min_element(steps.begin(), steps.end()), longest = std::accumulate(steps.begin(), steps.end(), 0.0);
        auto const history = [&](double alpha) { return stage_history<double>(method, alpha, tolerance, longest, shortest, 0.0); };
        auto none = history(0), first = history(0.5), second = history(0.5), once = history(1), once_more = history(1), twice = history(2);
        noise source;
        for (double const nu : steps) {
            std::vector<double> const F{source.next<double>(), source.next<double>(), source.next<double>()};
            CHECK(apply(none, nu, F) == F);
            auto const half = apply(first, nu, F), whole = apply(second, nu, half), D = apply(once, nu, F), DD = apply(once_more, nu, D);
            auto const at_once = apply(twice, nu, F);
            for (std::size_t i = 0; i < 3; ++i) {
                // entries of (nu A)^-1 are 10 / nu at most, and the values 1
                CHECK(std::abs(whole[i] - D[i]) <= 100 * tolerance / nu);
                CHECK(std::abs(at_once[i] - DD[i]) <= 1e4 * epsilon<double>() / (nu * nu));
            }
            CHECK(none.modes() + once.modes() + twice.modes() == 0);
        }
    }
}

TEST_CASE("a mean that grows for a long time does not stop at its last digit: 400 000 equal values") {
    // Without the rounding errors of slow modes the distance is 2.5e-14 here, and grows with the number of values.
    for (double const alpha : {0.05, 0.5}) {
        CAPTURE(alpha);
        double const tolerance = 64 * epsilon<double>();
        stage_history<double> history(collocation<double, radau>(1), alpha, tolerance, 4e5, 1.0, 0.0);
        long double product = 1;
        double worst = 0;
        double const one = 1;
        for (int m = 1; m <= 400'000; ++m) {
            history.begin(1);
            worst = std::max(worst, std::abs(static_cast<double>(1 + static_cast<long double>(history.past(0)) - product)));
            history.push(std::span(&one, 1));
            product *= 1 - static_cast<long double>(alpha) / m;
        }
        CHECK(worst <= tolerance);
    }
}

TEST_CASE("vectors are their components, and the state does not grow") {
    auto const method = collocation<double, radau>(2);
    stage_history<Eigen::VectorXd> vectors(method, 1.5, 1e-8, 10.0, 0.1, Eigen::VectorXd::Zero(2));
    stage_history<double> x(method, 1.5, 1e-8, 10.0, 0.1, 0.0), y = x;
    stage_history<Eigen::Vector2d> fixed(method, 1.5, 1e-8, 10.0, 0.1, Eigen::Vector2d::Zero());
    auto const bytes = vectors.bytes();
    noise source;
    for (int n = 0; n < 20; ++n) {
        double const nu = n % 3 == 0 ? 0.1 : 0.2;
        std::vector<double> const of_x{source.next<double>(), source.next<double>()}, of_y{source.next<double>(), source.next<double>()};
        std::vector<Eigen::VectorXd> both(2, Eigen::VectorXd(2));
        std::vector<Eigen::Vector2d> both_fixed(2);
        for (std::size_t i = 0; i < 2; ++i) both_fixed[i] = both[i] = Eigen::Vector2d(of_x[i], of_y[i]);
        auto const result = apply(vectors, nu, both);
        auto const result_fixed = apply(fixed, nu, both_fixed);
        auto const result_x = apply(x, nu, of_x), result_y = apply(y, nu, of_y);
        for (std::size_t i = 0; i < 2; ++i) {
            CHECK((result[i](0) == result_x[i] and result[i](1) == result_y[i]));
            CHECK(result[i] == result_fixed[i]);
        }
    }
    CHECK(vectors.bytes() == bytes);
    CHECK(bytes < 8192);
}

} // namespace history_stages_tests
