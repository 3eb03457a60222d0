// SPDX-License-Identifier: BSL-1.0
// Every function that a Lagrangian may use: its value and its first and second derivatives in every scalar that has it, against central
// differences of the standard functions in 50 digits.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#if HILGER_HAS_FLOAT128
#include "hilger/float128.hpp"
#endif

namespace jet_function_tests {

using namespace hilger;

namespace {

using std::acosh, std::asinh, std::atan2, std::atanh, std::cbrt, std::copysign, std::erf, std::expm1, std::fmax, std::fmin, std::hypot,
    std::log1p, std::max, std::min, std::pow;

// Each takes x = (q, v) of any number type; all are smooth at the point below.
struct with_two_jets {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return erf(q * v) + log1p(q / 2) * v + expm1(v / 3) * q + cbrt(q + 2 * v) + hypot(q, v) * q + atan2(q, v) + hypot(v, q * q);
    }
};
struct with_constants {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return hypot(q, 3.0) + hypot(0.5, v) * q + atan2(q, 2.0) + atan2(0.25, v) * q + pow(2.0, q) * v + pow(3.0, q * v) + pow(q, 2.5) +
               pow(v, -1.5) * q + pow(q, 3) + pow(v, -2);
    }
};
struct with_inverses {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return asinh(q * v) * q + acosh(q + v) * v + atanh(q * v / 2) + asinh(v - 2 * q) + atanh(q - v) * q;
    }
};
struct of_branches {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return max(q * q, 2 * q) * v + min(q * v, v) + fmax(q, v * v) * q + fmin(v * q, q) + copysign(q * v, q - 4) +
               max(q * v, q) * min(v * v, v);
    }
};
constexpr double q0 = 0.625, v0 = 1.375; // exact in every scalar
/// 1, q, v, qq, qv, vv
using table = std::array<float50, 6>;
template <class F>
table by_differences(F const& f) {
    float50 const e("1e-9"), x(q0), y(v0);
    auto const at = [&](int i, int j) { return float50(f(float50(x + i * e), float50(y + j * e))); };
    float50 const here = at(0, 0);
    // of order 4
    auto const first = [&](auto const& g) { return float50((8 * (g(1) - g(-1)) - (g(2) - g(-2))) / (12 * e)); };
    auto const second = [&](auto const& g) { return float50((16 * (g(1) + g(-1)) - (g(2) + g(-2)) - 30 * here) / (12 * e * e)); };
    auto const along_q = [&](int i) { return at(i, 0); };
    auto const along_v = [&](int i) { return at(0, i); };
    auto const mixed = first([&](int i) { return first([&](int j) { return at(i, j); }); });
    return {here, first(along_q), first(along_v), second(along_q), mixed, second(along_v)};
}
template <class S, class F>
table by_jets(F const& f) {
    auto const e = expand(f, S(q0), S(v0));
    using Q = jet<S, 0, 1, 2>;
    using V = jet<S, 1, 1, 2>;
    auto const value = f(Q::variable(S(q0), 0, {1, 0}), V::variable(S(v0), 1, {0, 1})).value;
    return {float50(value), float50(e.by_q), float50(e.by_v), float50(e.qq), float50(e.qv), float50(e.vv)};
}
template <class S, class F>
void check(F const& f, table const& right) {
    table const found = by_jets<S>(f);
    for (std::size_t i = 0; i < right.size(); ++i) {
        CAPTURE(i);
        float50 const bound = std::max(float50(64 * float50(epsilon<S>()) * (1 + abs(right[i]))), float50("1e-25"));
        CHECK(float50(abs(found[i] - right[i])) < bound);
    }
}
template <class F>
void check_all(F const& f) {
    table const right = by_differences(f);
    check<double>(f, right);
    check<long double>(f, right);
    check<float50>(f, right);
#if HILGER_HAS_FLOAT128
    check<float128>(f, right);
#endif
}

} // namespace

TEST_CASE("functions of two arguments that both vary") { check_all(with_two_jets{}); }
TEST_CASE("functions of an argument and a constant") { check_all(with_constants{}); }
TEST_CASE("inverse hyperbolic functions") { check_all(with_inverses{}); }
TEST_CASE("slopes are no numbers where functions are none, as those of a logarithm") {
    auto const slope = [](auto const& f, double x) {
        return expand([&](auto const& q, auto const& v) { return f(q) + 0 * v; }, x, 0.0).by_q;
    };
    for (double const x : {1.5, -1.5, 2.0}) CHECK(std::isnan(slope([](auto const& q) { return atanh(q); }, x)));
    for (double const x : {0.5, -0.5, -2.0}) CHECK(std::isnan(slope([](auto const& q) { return acosh(q); }, x)));
}
TEST_CASE("the slope of a norm at 0 is taken for 0, so that |v| v has its derivatives there") {
    auto const e = expand([](auto const& q, auto const& v) { return q * sqrt(v * v) * v; }, 2.0, 0.0);
    CHECK(e.by_v == 0);
    CHECK(e.vv == 0);
}
TEST_CASE("functions with branches") { check_all(of_branches{}); }
TEST_CASE("max, min and copysign of jets and constants, in rationals too") {
    auto const f = [](auto const& q, auto const& v) { return max(q * v, 2) + min(1.0, q * q) + fmax(v * q, 3) + copysign(v * q, -1) * q; };
    auto const e = expand(f, Q(3), Q(1));
    CHECK(e.by_q == Q(1) + Q(1) - 6); // q v + 1 + q v - q^2 v: of two equal arguments max is the first
    auto const d = expand(f, 3.0, 1.5);
    CHECK(d.by_q == 1.5 + 1.5 - 2 * 3 * 1.5);
    CHECK(d.by_v == 3 + 3 - 9);
}

} // namespace jet_function_tests
