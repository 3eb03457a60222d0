// SPDX-License-Identifier: BSL-1.0
// Powers of Radau's difference quotient as operators: against whole matrices in 50 digits, exactly where they are rational; semigroup and
// integration by parts on uneven T; one stage is Delta_-^alpha.
#include <doctest/doctest.h>

#include "../history/stage_judge.hpp"
#include "hilger/hilger.hpp"
#include "support/values.hpp"

namespace stage_difference_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

template <class S>
time_scale<S> scale_of(std::vector<double> const& steps) {
    std::vector<S> points{S(0)};
    for (double const nu : steps) points.push_back(points.back() + S(nu));
    return time_scale<S>(points);
}
/// Steps that are squares.
time_scale<Q> const squares{Q(0), Q(1), Q(5), Q(46, 9), Q(82, 9), Q(98, 9)};

template <int Stages, class Root>
auto some_f(Root const& T) {
    using S = typename Root::scalar_type;
    return function_on(at_nodes<radau, Stages>(T), [](S const& t) { return S(t * t / 4 - 3 * t + 5); });
}
template <int Stages, class Root>
auto some_g(Root const& T) {
    using S = typename Root::scalar_type;
    return function_on(at_nodes<radau, Stages>(T), [](S const& t) { return S(5 / (t + 2) - t); });
}
template <class F, class G>
auto distance(F const& f, G const& g) {
    using S = value_of<F>;
    S worst(0);
    for (index_type i = f.first(); i <= f.last(); ++i) worst = std::max(worst, S(magnitude(S(f[i] - g[i])) / (S(1) + magnitude(S(f[i])))));
    return worst;
}
/// The largest error of an entry of D^{quarters/4} for several of these, relative to the largest of its block, and above order 1, where two
/// rows are subtracted, of its rows.
template <class S, int Stages>
S worst_entry(std::vector<double> const& steps, std::vector<int> const& all_quarters) {
    auto const T = scale_of<S>(steps);
    stage_judge const judge(collocation<float50, radau>(Stages), steps);
    float50 worst(0);
    for (int const quarters : all_quarters) {
        auto const power = judge.power(quarters);
        for (index_type i = 0; i < static_cast<index_type>(steps.size()) * Stages; ++i) {
            index_type const n = i / Stages;
            auto const row = detail::stage_weights<S, Stages, side::minus>::of(run_time<S>{S(quarters) / S(4)}, i % Stages, n + 1,
                                                                               [&](index_type d) { return S(T.step(n - d)); });
            for (index_type d = 0; d <= n; ++d) {
                auto const expected = power.block(n * Stages, (n - d) * Stages, Stages, Stages);
                float50 const size =
                    quarters < 4 ? expected.cwiseAbs().maxCoeff() : power.middleRows(n * Stages, Stages).cwiseAbs().maxCoeff();
                for (index_type k = 0; k < Stages; ++k) {
                    float50 const entry(row[static_cast<std::size_t>(d)][static_cast<std::size_t>(k)]);
                    worst = std::max(worst, float50(abs(entry - expected(i % Stages, k)) / size));
                }
            }
        }
    }
    return static_cast<S>(worst);
}
template <auto A, auto B>
constexpr composition<std::remove_const_t<decltype(A)>, std::remove_const_t<decltype(B)>> after{A, B};

} // namespace

// Orders add up in the type, and over a finite field; the adjoint has the other side.
static_assert(std::is_empty_v<std::remove_const_t<decltype(Delta_minus_radau<3, 1, 2>)>>);
static_assert(Delta_minus_radau<3, 1, 4> * Delta_minus_radau<3, 1, 4> == Delta_minus_radau<3, 1, 2>);
static_assert(after<Delta_minus_radau<3, 1, 4>, Delta_minus_radau<3, 1, 4>> == Delta_minus_radau<3, 1, 2>);
static_assert(after<Delta_plus_radau<2, 1, 3>, Delta_plus_radau<2, 2, 3>> == Delta_plus_radau<2, 1, 1>);
static_assert(after<Delta_minus_radau<2, 1, 2>, Delta_minus_radau<2, -1, 2>> == Delta_minus_radau<2, 0, 1>);
static_assert(not(after<Delta_minus_radau<3, 1, 4>, Delta_minus_radau<3, 1, 2>> == Delta_minus_radau<3, 1, 2>));
static_assert(adjoint(Delta_minus_radau<3, 1, 2>) == Delta_plus_radau<3, 1, 2> and
              adjoint(Delta_plus_radau<3, 1, 2>) == Delta_minus_radau<3, 1, 2>);
static_assert(not(Delta_minus_radau<3, 1, 2> == Delta_plus_radau<3, 1, 2>));
static_assert(not(Delta_minus_radau<3, 1, 2> == Delta_minus_radau<2, 1, 2>));
static_assert(adjoint(after<Delta_minus_radau<2, 1, 4>, Delta_minus_radau<2, 1, 4>>) == Delta_plus_radau<2, 1, 2>);

TEST_CASE("one stage is the power of Delta_- of functions that are 0 at t_0, exactly") {
    auto const f = some_f<1>(squares);
    std::vector<Q> values{Q(0)};
    for (index_type i = 0; i < squares.steps(); ++i) values.push_back(f[i]);
    auto const with_start = function_on(squares, values);
    auto const check = [&](auto const& a, auto const& b) {
        for (index_type i = 0; i < squares.steps(); ++i) CHECK(a[f][i] == b[with_start][i + 1]);
    };
    check(Delta_minus_radau<1, 1, 2>, Delta_minus_alpha<1, 2>);
    check(Delta_minus_radau<1, 3, 2>, Delta_minus_alpha<3, 2>);
    check(Delta_minus_radau<1, -1, 2>, Delta_minus_alpha<-1, 2>);
    check(Delta_minus_radau<1, 2, 1>, Delta_minus_alpha<2, 1>);
    check(Delta_plus_radau<1, 1, 2>, Delta_plus_alpha<1, 2>);
    check(Delta_plus_radau<1, -3, 2>, Delta_plus_alpha<-3, 2>);
    check(Delta_minus_at_radau<1>(Q(1, 2)), Delta_minus_alpha<1, 2>);
}

TEST_CASE("whole orders of two stages by hand: order -1 integrates, order 1 differentiates") {
    time_scale<Q> const T{Q(0), Q(3), Q(4)}; // nodes 1, 3, 10/3, 4
    auto const t = function_on(at_nodes<radau, 2>(T), [](Q const& x) { return x; });
    auto const square = function_on(at_nodes<radau, 2>(T), [](Q const& x) { return Q(x * x); });
    CHECK(values(Delta_minus_radau<2, 1, 1>[t]) == "T_R2: 1, 1, 1, 1");
    CHECK(values(Delta_minus_radau<2, 1, 1>[square]) == "T_R2: 2, 6, 20/3, 8");
    CHECK(values(Delta_minus_radau<2, -1, 1>[t]) == "T_R2: 1/2, 9/2, 50/9, 8");
    CHECK(values(Delta_minus_radau<2, 2, 1>[square]) == "T_R2: 2, 2, 2, 2");
    CHECK_THROWS_WITH_AS((void)(Delta_minus_radau<2, 1, 2>[t][1]),
                         "in an exact scalar a power of the difference quotient of a method with 2 stages has a whole order: the "
                         "others are irrational, and this one is 1/2 beyond a whole number",
                         error::invalid_parameter);
}

TEST_CASE("semigroup and integration by parts on uneven T, exactly") {
    auto const check = [](auto const& op, auto const& f, auto const& g) {
        auto const parts = by_parts(op, f, g);
        CHECK(parts.left == parts.interior);
        CHECK(parts.boundary == 0);
        CHECK_FALSE(parts.left == 0);
    };
    check(Delta_minus_radau<1, 1, 2>, some_f<1>(squares), some_g<1>(squares));
    check(Delta_plus_radau<1, 3, 2>, some_f<1>(squares), some_g<1>(squares));
    auto const f = some_f<2>(squares);
    auto const g = some_g<2>(squares);
    check(Delta_minus_radau<2, 1, 1>, f, g);
    check(Delta_minus_radau<2, -2, 1>, f, g);
    check(Delta_plus_radau<2, 2, 1>, f, g);
    auto const D = Delta_minus_radau<2, 1, 1>;
    auto const I = Delta_minus_radau<2, -1, 1>;
    CHECK(values(D[tabulate(I[f])]) == values(f));
    CHECK(values(I[tabulate(D[f])]) == values(f));
    CHECK(values(D[tabulate(D[f])]) == values(Delta_minus_radau<2, 2, 1>[f]));
    CHECK(values(adjoint(I)[tabulate(adjoint(D)[g])]) == values(g));
}

TEST_CASE("the difference quotient is monotone: <D f, f> >= f(t_N)^2 / 2") {
    auto const f = some_f<2>(squares);
    auto const g = some_g<2>(squares);
    CHECK(inner_product<step_weight>(Delta_minus_radau<2, 1, 1>[f], f) > f[f.last()] * f[f.last()] / 2);
    CHECK(inner_product<step_weight>(Delta_minus_radau<2, 1, 1>[g], g) > g[g.last()] * g[g.last()] / 2);
    CHECK(inner_product<step_weight>(Delta_minus_radau<1, 1, 2>[some_f<1>(squares)], some_f<1>(squares)) > 0);
}

TEST_CASE("entries are those of whole matrices, on equal, graded and uneven T, and where steps grow by 10^6") {
    for (auto const& steps : steps_of_scales(6)) {
        CAPTURE(steps[0]);
        CHECK(worst_entry<double, 1>(steps, {1, 2, 3, 5}) <= 64 * epsilon<double>());
        CHECK(worst_entry<double, 2>(steps, {1, 2, 3, 5}) <= 64 * epsilon<double>());
        CHECK(worst_entry<double, 4>(steps, {1, 2, 3, 5}) <= 64 * epsilon<double>());
    }
    CHECK(worst_entry<float50, 3>(steps_of_scales(3)[1], {2}) <= 256 * epsilon<float50>());
}

TEST_CASE("the unit of time is without meaning, next to the ends of the scalar's range too") {
    auto const row = [](double unit) {
        std::vector<double> const nu{3 * unit, 2 * unit, 1024 * unit, unit};
        return detail::stage_weights<double, 3, side::minus>::of(fraction<1, 2>{}, 1, 4,
                                                                 [&](index_type d) { return nu[static_cast<std::size_t>(d)]; });
    };
    auto const expected = row(1);
    for (double const root : {0x1p-500, 0x1p250}) // of the unit
        for (std::size_t d = 0; d < 4; ++d)
            for (std::size_t k = 0; k < 3; ++k)
                CHECK(row(root * root)[d][k] * root == doctest::Approx(expected[d][k]).epsilon(8 * epsilon<double>()));
}

TEST_CASE("semigroup and integration by parts on uneven T in 50 digits") {
    auto const T = scale_of<float50>(steps_of_scales(3)[2]);
    auto const f = some_f<3>(T);
    auto const g = some_g<3>(T);
    float50 const bound = 4096 * epsilon<float50>();
    CHECK(distance(Delta_minus_radau<3, 1, 2>[f], Delta_minus_radau<3, 1, 4>[tabulate(Delta_minus_radau<3, 1, 4>[f])]) <= bound);
    CHECK(distance(f, Delta_minus_radau<3, -3, 4>[tabulate(Delta_minus_radau<3, 3, 4>[f])]) <= bound);
    auto const parts = by_parts(adjoint(Delta_minus_at_radau<3>(float50(5) / 4)), f, g);
    CHECK(abs(float50(parts.left - parts.interior)) <= bound * abs(parts.left));
}

TEST_CASE("vectors are their components") {
    auto const T = scale_of<double>(steps_of_scales(5)[1]);
    auto const f = some_f<2>(T);
    auto const both = function_on(at_nodes<radau, 2>(T), [](double t) { return Eigen::Vector2d(t * t / 4 - 3 * t + 5, t); });
    for (index_type i = 0; i < 10; ++i)
        CHECK(Delta_plus_radau<2, 1, 2>[both][i](0) == doctest::Approx(Delta_plus_radau<2, 1, 2>[f][i]).epsilon(1e-15));
}

TEST_CASE("orders that are whole to rounding are whole") {
    auto const f = some_f<2>(scale_of<double>(steps_of_scales(5)[1]));
    for (index_type i = 0; i < 10; ++i) {
        CHECK(Delta_minus_at_radau<2>(-1e-20)[f][i] == f[i]);
        CHECK(Delta_minus_at_radau<2>(1e-20)[f][i] == doctest::Approx(f[i]).epsilon(1e-14));
        CHECK(Delta_minus_at_radau<2>(1 - 1e-16)[f][i] == doctest::Approx(Delta_minus_radau<2, 1, 1>[f][i]).epsilon(1e-12));
    }
}

TEST_CASE("how they are printed") {
    CHECK(printed(Delta_minus_radau<3, 1, 2>) == "D₃^(1/2)[f],   D₃ = the inverse of the integral of Radau IIA with s = 3");
    CHECK(printed(Delta_plus_radau<2, 1, 1>) == "(D₂^1)*[f],   D₂ = the inverse of the integral of Radau IIA with s = 2");
    CHECK(latex(Delta_plus_radau<3, 1, 2>).starts_with("\\left(D_{3}^{1/2}\\right)^{*}\\left[f\\right], \\quad D_{3} \\text{"));
    CHECK(std::string(Delta_plus_radau<3, -1, 2>.name().text().view()) == "Delta_plus_radau<3,-1/2>");
}

} // namespace stage_difference_tests
