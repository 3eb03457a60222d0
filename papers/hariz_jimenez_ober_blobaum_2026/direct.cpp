// SPDX-License-Identifier: BSL-1.0
// Problem B under the preprint's scheme as one linear system in 50 digits: Galerkin at Lobatto's nodes, with the whole matrix of D^{1/2} of
// Lobatto IIIC. The flow has the same positions.
#include <algorithm>
#include <cmath>
#include <vector>

#include <boost/math/constants/constants.hpp>
#include <doctest/doctest.h>

#include "../../tests/runtime/history/stage_judge.hpp"
#include "hilger/embedding/collocation.hpp"
#include "stage_schemes.hpp"

namespace hariz_direct_tests {

using namespace hilger;
using namespace hilger::papers;
using matrix = testing::stage_judge::matrix;

namespace {

/// Derivatives of the polynomials that are 1 at one node and 0 at the others, at the nodes: row k, column m.
matrix slopes_at(std::vector<float50> const& c) {
    auto const n = static_cast<index_type>(c.size());
    matrix powers(n, n), derivatives = matrix::Zero(n, n);
    for (index_type k = 0; k < n; ++k) {
        float50 power(1);
        for (index_type j = 0; j < n; ++j) {
            powers(k, j) = power;
            if (j + 1 < n) derivatives(k, j + 1) = (j + 1) * power;
            power *= c[static_cast<std::size_t>(k)];
        }
    }
    return derivatives * powers.partialPivLu().inverse();
}
float50 force(float50 const& t) {
    return t * t * t + 6 * t + float50(16) / 5 / sqrt(boost::math::constants::pi<float50>()) * t * t * sqrt(t);
}
/// x(t_1), ..., x(t_N) on [0, 1]. Unknown are the values at all nodes but t_0, of which steps share the ends.
std::vector<float50> positions(int stages, int steps) {
    auto const method = lobatto_3c<float50>(stages);
    index_type const s = stages, N = steps, unknowns = N * (s - 1);
    matrix const root = testing::stage_judge(method, std::vector<double>(static_cast<std::size_t>(N), 1.0 / steps)).half;
    matrix const slope = slopes_at(method.c);
    float50 const h = float50(1) / steps;
    auto const place = [s](index_type i, index_type k) { return i * (s - 1) + k; }; // 0 is x(t_0) = 0
    matrix values = matrix::Zero(N * s, unknowns + 1), velocities = values;
    for (index_type i = 0; i < N; ++i)
        for (index_type k = 0; k < s; ++k) {
            values(i * s + k, place(i, k)) = 1;
            for (index_type m = 0; m < s; ++m) velocities(i * s + k, place(i, m)) = slope(k, m) / h;
        }
    matrix const damping = root * values;
    matrix K = matrix::Zero(unknowns + 1, unknowns + 1), r = matrix::Zero(unknowns + 1, 1); // the last row would be the momentum at t_N
    for (index_type i = 0; i < N; ++i)
        for (index_type k = 0; k < s; ++k) {
            auto const at = static_cast<std::size_t>(k);
            float50 const w = method.b[at] * h;
            K.row(place(i, k)) -= w * (values.row(i * s + k) + damping.row(i * s + k));
            r(place(i, k)) -= w * force((i + method.c[at]) * h);
            for (index_type m = 0; m < s; ++m) K.row(place(i, m)) += w * slope(k, m) / h * velocities.row(i * s + k);
        }
    matrix const x = K.block(0, 1, unknowns, unknowns).partialPivLu().solve(r.topRows(unknowns));
    std::vector<float50> at_points;
    for (index_type i = 1; i <= N; ++i) at_points.push_back(x(place(i, 0) - 1));
    return at_points;
}

} // namespace

TEST_CASE("the flow at the stages of Lobatto IIIC solves the linear system of problem B") {
    for (int const stages : {2, 3, 4}) {
        int const steps = 4;
        auto const expected = positions(stages, steps);
        double worst = 0, largest = 0;
        with_stages(stages, [&](auto s) {
            std::size_t i = 0;
            auto const flow = lobatto_flow<s>(problem_b.mechanics(), problem_b.rho, problem_b.mu);
            for (auto const& x : flow.along(uniform(interval{0.0, 1.0}, steps), 0.0, 0.0)) {
                if (i++ == 0) continue;
                auto const direct = static_cast<double>(expected[i - 2]);
                worst = std::max(worst, std::abs(x.q - direct));
                largest = std::max(largest, std::abs(direct - x.t * x.t * x.t));
            }
            CHECK(i == expected.size() + 1);
        });
        CAPTURE(stages);
        CHECK(worst <= 1e-14);
        CHECK(largest == doctest::Approx(stages == 2 ? 4.80e-2 : stages == 3 ? 2.077e-5 : 5.04e-7).epsilon(0.001));
    }
}

} // namespace hariz_direct_tests
