// SPDX-License-Identifier: BSL-1.0
// Fractional damping at Radau's nodes: every state solves the derived equation with direct powers of the difference; several components and
// terms; checkpoints; what is refused. Orders are in stage_orders.cpp.
#include <doctest/doctest.h>

#include <cmath>
#include <sstream>

#include <Eigen/LU>

#include "../history/stage_judge.hpp"
#include "hilger/fractional/flow.hpp"
#include "hilger/history/history.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/trajectory/checkpoint.hpp"
#include "hilger/trajectory/recording.hpp"

namespace fractional_at_stages_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

using matrix = stage_judge::matrix;

/// x'' + x + rho D^mu[x - x0] = 0 under galerkin<s, radau>, with the values at 0, c_1, ..., c_s of each step as unknowns and the direct
/// matrix of D^mu: all of it is one linear system, whose rows are the derived equation. The states at the points of T.
struct direct_oscillator {
    runge_kutta<float50> method;
    std::vector<double> steps;
    float50 rho;
    int quarters; ///< of mu
    float50 x0, v0;

    [[nodiscard]] std::vector<std::pair<float50, float50>> states() const {
        auto const s = static_cast<index_type>(method.stages()), N = static_cast<index_type>(steps.size());
        matrix const power = stage_judge(method, steps).power(quarters);
        matrix const slope = slopes();
        // unknown: the increments from x0 at the nodes of all steps; in row (n, 0) momenta of two steps meet, in row (n, m) L_h is
        // stationary
        matrix K = matrix::Zero(N * s, N * s), r = matrix::Zero(N * s, 1);
        matrix tangent(N * s, 1); // v0 (t - t_0), which Caputo's derivative of an order above 1 leaves out
        float50 t(0);
        for (index_type n = 0; n < N; ++n) {
            for (index_type k = 0; k < s; ++k) tangent(n * s + k) = v0 * (t + method.c[at(k)] * float50(steps[at(n)]));
            t += float50(steps[at(n)]);
        }
        matrix const given = quarters > 4 ? matrix(-power * tangent) : matrix::Zero(N * s, 1);
        for (index_type n = 0; n < N; ++n) {
            float50 const h(steps[at(n)]);
            for (index_type k = 0; k < s; ++k) {
                float50 const w = method.b[at(k)] * h;
                // the force at node k, as a row over all unknowns, enters the row of its own value
                index_type const own = n * s + k;
                auto const add = [&](index_type row, float50 const& by, auto const& of, float50 const& constant) {
                    if (row >= N * s) return;
                    K.row(row) += by * of;
                    r(row) -= by * constant;
                };
                matrix force = -rho * power.row(own);
                force(own) -= 1;
                index_type const row_of_force = k + 1 == s ? (n + 1) * s : n * s + k + 1; // the last value's is met in the next step
                add(row_of_force, w, force, -x0 - rho * given(own));
                // the velocity at node k
                matrix velocity = matrix::Zero(1, N * s);
                for (index_type m = 0; m < s; ++m) velocity(n * s + m) = slope(k, m + 1) / h;
                if (n > 0) velocity(n * s - 1) += slope(k, 0) / h;
                for (index_type m = 0; m <= s; ++m) add(m == s ? (n + 1) * s : n * s + m, w * slope(k, m) / h, velocity, 0);
            }
            if (n == 0) r(0) -= v0;
        }
        matrix const x = K.partialPivLu().solve(r);
        std::vector<std::pair<float50, float50>> all{{x0, v0}};
        for (index_type n = 0; n < N; ++n) { // p_{n+1} = d_2 L_h
            float50 const h(steps[at(n)]);
            float50 p(0);
            for (index_type k = 0; k < s; ++k) {
                float50 velocity = n > 0 ? float50(slope(k, 0) / h * x(n * s - 1)) : float50(0);
                for (index_type m = 0; m < s; ++m) velocity += slope(k, m + 1) / h * x(n * s + m);
                p += method.b[at(k)] * slope(k, s) * velocity;
            }
            index_type const last = n * s + s - 1;
            float50 const derivative = (power.row(last) * x)(0) + given(last);
            p += method.b[at(s - 1)] * h * (-(x0 + x(last)) - rho * derivative);
            all.emplace_back(x0 + x(last), p);
        }
        return all;
    }

private:
    static std::size_t at(index_type k) { return static_cast<std::size_t>(k); }
    /// Derivatives of Lagrange's polynomials of 0, c_1, ..., c_s at c_1, ..., c_s.
    [[nodiscard]] matrix slopes() const {
        std::vector<float50> c{float50(0)};
        c.insert(c.end(), method.c.begin(), method.c.end());
        auto const n = static_cast<index_type>(c.size());
        matrix powers(n, n), of_slopes(n - 1, n);
        for (index_type j = 0; j < n; ++j)
            for (index_type k = 0; k < n; ++k) {
                powers(j, k) = k == 0 ? float50(1) : float50(pow(c[at(j)], k));
                if (j > 0) of_slopes(j - 1, k) = k == 0 ? float50(0) : float50(k * (k == 1 ? float50(1) : float50(pow(c[at(j)], k - 1))));
            }
        return of_slopes * powers.partialPivLu().inverse();
    }
};

constexpr auto oscillator = [](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; };
template <class S>
time_scale<S> scale_of(std::vector<double> const& steps) {
    std::vector<S> points{S(0)};
    for (double const h : steps) points.push_back(points.back() + S(h));
    return time_scale<S>(points);
}
/// The largest distance of positions and momenta from the direct solution.
template <class S, int Stages>
double distance_from_direct(int quarters, std::vector<double> const& steps, double tolerance) {
    direct_oscillator const direct{collocation<float50, radau>(Stages), steps, float50(0.5), quarters, float50(1), float50(-0.5)};
    auto const expected = direct.states();
    auto const flow =
        embed(with_fractional_damping(oscillator, S(0.5), S(quarters) / S(4), exponentials{tolerance}), galerkin<Stages, radau>);
    double worst = 0;
    std::size_t i = 0;
    for (auto const& x : flow.along(scale_of<S>(steps), S(1), S(-0.5))) {
        worst = std::max(worst, static_cast<double>(abs(float50(x.q) - expected[i].first)));
        worst = std::max(worst, static_cast<double>(abs(float50(x.p) - expected[i].second)));
        ++i;
    }
    CHECK(i == expected.size());
    return worst;
}

} // namespace

TEST_CASE("the states solve the derived equation with direct powers of the difference, on equal, graded and uneven T") {
    auto const scales = steps_of_scales(4);
    for (auto const& steps : scales)
        for (int const quarters : {2, 6}) {
            CAPTURE(quarters);
            CHECK(distance_from_direct<double, 2>(quarters, steps, 1e-13) <= 1e-12);
        }
    for (int const quarters : {1, 3, 5}) {
        CAPTURE(quarters);
        CHECK(distance_from_direct<double, 3>(quarters, scales[1], 1e-13) <= 1e-12);
    }
    CHECK(distance_from_direct<double, 1>(2, steps_of_scales(8)[1], 1e-13) <= 1e-12);
    CHECK(distance_from_direct<double, 2>(4, scales[2], 1e-13) <= 1e-12);
    CHECK(distance_from_direct<float50, 3>(2, scales[1], 1e-30) <= 1e-29);
    CHECK(distance_from_direct<float50, 2>(6, scales[2], 1e-30) <= 1e-29);
}

TEST_CASE("components with their own coefficients, and several terms, are those of one component each") {
    using V = Eigen::Vector3d;
    auto const L = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
    auto const T = graded(0.0, 2.0, 12, 3.0);
    auto const three = record(embed(with_fractional_damping(L, V(0.5, 0, 2), 0.5, exponentials{1e-13}), galerkin<3, radau>)
                                  .along(T, V(1, 1, 1), V(-0.5, 0, 0.25)));
    auto const alone = [&](double rho, double p) {
        return record(embed(with_fractional_damping(oscillator, rho, 0.5, exponentials{1e-13}), galerkin<3, radau>).along(T, 1.0, p))
            .states.back();
    };
    CHECK(std::abs(three.states.back().q(0) - alone(0.5, -0.5).q) <= 16 * epsilon<double>());
    CHECK(std::abs(three.states.back().q(2) - alone(2, 0.25).q) <= 16 * epsilon<double>());
    auto const twice = [&](std::vector<fractional_term<double>> const& terms) {
        return record(embed(with_fractional_damping(oscillator, terms, exponentials{1e-13}), galerkin<3, radau>).along(T, 1.0, -0.5))
            .states.back()
            .q;
    };
    CHECK(std::abs(twice({{0.25, 0.5}, {0.25, 0.5}}) - alone(0.5, -0.5).q) <= 16 * epsilon<double>());
    CHECK(std::abs(twice({{0.25, 0.5}, {0.25, 1.5}}) - alone(0.5, -0.5).q) > 1e-3);
}

TEST_CASE("a checkpoint goes on to the same bits") {
    auto const flow = embed(with_fractional_damping(oscillator, 0.5, 1.5, exponentials{1e-10}), galerkin<2, radau>);
    auto const path = flow.along(graded(0.0, 1.0, 10, 2.0), 1.0, -0.5);
    auto at = path.begin();
    for (int i = 0; i < 4; ++i) ++at;
    std::stringstream text;
    write_checkpoint(text, path, at.checkpoint());
    auto const rest = path.resume(read_checkpoint(text, path));
    double there = 0, here = 0;
    for (auto const& x : rest) there = x.q;
    for (auto const& x : path) here = x.q;
    CHECK(there == here);
}

TEST_CASE("the damping takes energy, for one to four stages, on equal and on graded T") {
    auto const well = [](auto const& x, auto const& v) { return v * v / 2 + x * x / 2 - x * x * x * x / 4; };
    auto const falls = [&](auto const& how, auto const& T) {
        auto const energy = [](auto const& x) { return x.p * x.p / 2 - x.q * x.q / 2 + x.q * x.q * x.q * x.q / 4; };
        auto const path = embed(with_fractional_damping(well, 0.1, fraction<1, 2>{}, exponentials{1e-8}), how).along(T, 1.8, 0.0);
        auto const states = record(path).states;
        CHECK(energy(states[states.size() / 2]) < energy(states.front()));
        CHECK(energy(states.back()) < energy(states[states.size() / 2]));
    };
    auto const each = [&](auto const& how) {
        falls(how, uniform(0.0, 0.125, 160));
        falls(how, graded(0.0, 20.0, 160, 1.5));
    };
    each(galerkin<1, radau>);
    each(galerkin<2, radau>);
    each(galerkin<3, radau>);
    each(galerkin<4, radau>);
}

TEST_CASE("graded scales begin and end where they should, and refuse what is none") {
    auto const T = graded(1.0, 3.0, 4, 2.0);
    CHECK(T.element(0) == 1);
    CHECK(T.element(2) == 1.5);
    CHECK(T.element(4) == 3);
    auto const start = graded_start(0.0, 5.0, 0.1, 3.0);
    CHECK(start.max() == 5);
    double longest = 0;
    for (index_type i = 0; i < start.steps(); ++i) longest = std::max(longest, start.step(i));
    CHECK(longest <= 0.11);
    CHECK(start.step(0) < 1e-4);
    CHECK_THROWS_WITH_AS((void)graded(1.0, 1.0, 4, 2.0),
                         "graded(a, b, N, gamma) needs a < b, one step or more and gamma >= 1, and was given 1, 1, 4 and 2",
                         error::invalid_scale);
    CHECK_THROWS_AS((void)graded(0.0, 1.0, 4, 0.5), error::invalid_scale);
    CHECK_THROWS_AS((void)graded(0.0, 1.0, 0, 2.0), error::invalid_scale);
    CHECK_THROWS_AS((void)graded(1.0, 1.0 + 1e-15, 100, 2.0), error::invalid_scale);
    CHECK_THROWS_WITH_AS((void)graded_start(0.0, 1.0, 0.0, 2.0), "a graded start needs steps 0 < h, and they are 0", error::invalid_scale);
}

} // namespace fractional_at_stages_tests
