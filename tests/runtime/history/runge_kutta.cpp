// SPDX-License-Identifier: BSL-1.0
// Stiffly accurate methods, their order conditions, and the direct judge of powers of their difference quotients.
#include <doctest/doctest.h>

#include "hilger/embedding/collocation.hpp"
#include "stage_judge.hpp"

namespace history_runge_kutta_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
/// The largest |sum_j a_ij c_j^{k-1} - c_i^k / k| for k = 1, ..., order, and for b at c = 1.
template <class W>
W stage_order(runge_kutta<W> const& m, int order) {
    W worst(0);
    for (int k = 1; k <= order; ++k)
        for (std::size_t i = 0; i < m.stages(); ++i) {
            W sum = -pow(m.c[i], k) / k;
            for (std::size_t j = 0; j < m.stages(); ++j) sum += m.A[i][j] * (k == 1 ? W(1) : W(pow(m.c[j], k - 1)));
            worst = std::max(worst, W(abs(sum)));
        }
    return worst;
}
float50 const rounding = 64 * epsilon<float50>();

template <class M>
float50 distance(M const& x, M const& y) {
    return (x - y).cwiseAbs().maxCoeff() / (x.cwiseAbs().maxCoeff() + y.cwiseAbs().maxCoeff());
}
} // namespace

TEST_CASE("known coefficients, exactly") {
    auto const one = collocation<Q, radau>(1), two = collocation<Q, radau>(2);
    CHECK((one.A == std::vector<std::vector<Q>>{{1}} and one.b == std::vector<Q>{1} and one.c == std::vector<Q>{1}));
    CHECK(two.A == std::vector<std::vector<Q>>{{Q(5, 12), Q(-1, 12)}, {Q(3, 4), Q(1, 4)}});
    CHECK((two.b == std::vector<Q>{Q(3, 4), Q(1, 4)} and two.c == std::vector<Q>{Q(1, 3), 1}));
    auto const three = lobatto_3c<Q>(3);
    CHECK(lobatto_3c<Q>(2).A == std::vector<std::vector<Q>>{{Q(1, 2), Q(-1, 2)}, {Q(1, 2), Q(1, 2)}});
    CHECK(three.A ==
          std::vector<std::vector<Q>>{{Q(1, 6), Q(-1, 3), Q(1, 6)}, {Q(1, 6), Q(5, 12), Q(-1, 12)}, {Q(1, 6), Q(2, 3), Q(1, 6)}});
    CHECK(collocation<Q, gauss>(1).A == std::vector<std::vector<Q>>{{Q(1, 2)}});
}

TEST_CASE("Radau IIA has stage order s, Lobatto IIIC s - 1, and both end their last stage with the step") {
    for (int s = 1; s <= 8; ++s) {
        CAPTURE(s);
        auto const m = collocation<float50, radau>(s);
        CHECK(stage_order(m, s) <= rounding);
        CHECK(stage_order(m, s + 1) > 1e-10);
        CHECK_NOTHROW(detail::memory::require_stiffly_accurate<float50, float50>(m));
        if (s == 1) continue;
        auto const n = lobatto_3c<float50>(s);
        CHECK(stage_order(n, s - 1) <= rounding);
        CHECK(stage_order(n, s) > 1e-10);
        CHECK_NOTHROW(detail::memory::require_stiffly_accurate<float50, float50>(n));
    }
}

TEST_CASE("powers of one matrix: A^-1/2 squared is A^-1, and in double by numbers of twice its digits") {
    for (int s = 1; s <= 8; ++s)
        for (bool const is_radau : {true, false}) {
            if (s == 1 and not is_radau) continue;
            CAPTURE(s);
            auto const A = (is_radau ? collocation<float50, radau>(s) : lobatto_3c<float50>(s)).A;
            detail::memory::stage_resolvent<float50, float50> const wide(A);
            auto const root = wide.inverse_power(0.5), inverse = wide.inverse();
            auto const difference = detail::memory::multiply_add(inverse, float50(-1), root, root);
            auto const in_twice_double = (is_radau ? collocation<double, radau>(s) : lobatto_3c<double>(s)).A;
            auto const in_double =
                detail::memory::stage_resolvent<double, detail::double_double<double>>(in_twice_double).inverse_power(0.5);
            float50 worst(0), worst_in_double(0), size(0), size_of_root(0);
            for (std::size_t i = 0; i < A.size(); ++i)
                for (std::size_t j = 0; j < A.size(); ++j) {
                    size = std::max(size, float50(abs(inverse[i][j])));
                    size_of_root = std::max(size_of_root, float50(abs(root[i][j])));
                    worst = std::max(worst, float50(abs(difference[i][j])));
                    auto const rounded = static_cast<double>(in_double[i][j]);
                    worst_in_double = std::max(worst_in_double, float50(abs(float50(rounded) - root[i][j])));
                }
            CHECK(worst <= 1e-45 * size);
            CHECK(worst_in_double <= epsilon<double>() * size_of_root);
        }
}

TEST_CASE("the judge: D is the inverse of the integral and D^1/2 D^1/2 = D to 45 digits") {
    int const N = 8;
    for (int s = 1; s <= 4; ++s)
        for (auto const& steps : steps_of_scales(N)) {
            CAPTURE(s);
            stage_judge const judge(collocation<float50, radau>(s), steps);
            stage_judge::matrix const one = stage_judge::matrix::Identity(judge.size(), judge.size());
            CHECK(distance(judge.product(judge.integral, judge.difference), one) <= 1e-40);
            CHECK(distance(judge.product(judge.half, judge.half), judge.difference) <= 1e-45);
            CHECK(distance(judge.product(judge.quarter, judge.quarter), judge.half) <= 1e-45);
            CHECK(distance(judge.power(6), judge.product(judge.half, judge.difference)) <= 1e-45);
        }
}

TEST_CASE("methods that are refused, each with its sentence") {
    namespace m = detail::memory;
    auto const check = [](runge_kutta<double> const& method) { return m::require_stiffly_accurate<double, double>(method); };
    char const* const sentence =
        "powers of an integral need a stiffly accurate Runge-Kutta method, whose last stage is the end of the step: "
        "c_s = 1 and the last row of A is b";
    CHECK_NOTHROW(check({{{1}}, {1}, {1}}));
    CHECK_THROWS_WITH_AS(check({{{0.5}}, {1}, {0.5}}), sentence, error::invalid_parameter); // mid-point
    CHECK_THROWS_WITH_AS(check({{{0.5}}, {0.5}, {0.5}}), sentence, error::invalid_parameter);
    CHECK_THROWS_WITH_AS(check({{{1}}, {0.5}, {1}}), sentence, error::invalid_parameter);
    CHECK_THROWS_WITH_AS(check({}), sentence, error::invalid_parameter);
    CHECK_THROWS_WITH_AS(check({{{1}, {1, 2}}, {1, 2}, {0, 1}}),
                         "a Runge-Kutta method has s x s, s and s numbers, and this one has a row of 1 in 2, then 2 and 2",
                         error::mismatch);
    CHECK_THROWS_WITH_AS((m::stage_resolvent<double, double>({{0, 0}, {0.5, 0.5}})), // Lobatto IIIA
                         "powers of an integral need a regular matrix A of the Runge-Kutta method, and this one is singular",
                         error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)lobatto_3c<double>(1), "Lobatto IIIC has two stages or more, not 1", error::invalid_parameter);
}

} // namespace history_runge_kutta_tests
