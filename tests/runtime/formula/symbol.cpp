// SPDX-License-Identifier: BSL-1.0
// A formula recorded by running a callable on symbols: what it says, what it shares, and that its derivatives are those of the jets.
#include <map>
#include <random>

#include <doctest/doctest.h>

#include "hilger/formula/derivative.hpp"
#include "hilger/formula/print.hpp"
#include "hilger/hilger.hpp"

namespace symbol_tests {

using namespace hilger;

namespace {

template <class X>
std::string printed(X const& x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

/// The value of f at given values of its variables.
double value_at(symbol const& f, std::map<std::string, double> const& at) {
    auto const a = [&] { return value_at(f.first(), at); };
    auto const b = [&] { return value_at(f.second(), at); };
    switch (f.op()) {
    case operation::number:
        return f.value();
    case operation::variable:
        return at.at(printed(f));
    case operation::plus:
        return a() + b();
    case operation::minus:
        return a() - b();
    case operation::times:
        return a() * b();
    case operation::over:
        return a() / b();
    case operation::negative:
        return -a();
    case operation::power:
        return std::pow(a(), f.value());
    case operation::over_norm:
    case operation::where:
    case operation::elsewhere:
    case operation::atan2:
    case operation::maximum:
    case operation::minimum:
        return detail::call(f.op(), a(), b());
    default:
        return detail::call(f.op(), a());
    }
}

using std::max, std::min;

constexpr auto pendulum = [](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); };
constexpr auto kepler = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 1 / q.norm(); };
constexpr auto double_pendulum = [](auto const& q, auto const& v) {
    return v(0) * v(0) + v(1) * v(1) / 2 + v(0) * v(1) * cos(q(0) - q(1)) + 2 * cos(q(0)) + cos(q(1));
};
constexpr auto all_functions = [](auto const& x, auto const& v) {
    auto const z = x * v / 4; // in ]0, 1[ for x and v between 1/2 and 3/2
    return sin(z) + 2 * cos(3 * z) - tan(z) * exp(z) + log(z) / sqrt(1 + z) + pow(z, 3) - pow(z, -2) / 50 + pow(x, 2.5) * pow(v, 4) +
           sinh(z) * cosh(v) + tanh(x - v) + asin(z) - 3 * acos(z) + atan(x / v) + asinh(x - v) + acosh(2 + z) * atanh(z) + abs(x - 2 * v) +
           abs(z) + atan2(x, v - 1) + atan2(v, x) + cbrt(z + 1) * expm1(z) + log1p(z) * erf(x) + max(x, 2 * v) * min(z, v) +
           copysign(z, x - 2) + pow(2.0, z) + pow(x, v) + hypot(x, v) * x - (x - v) * (x + v) / (2 + x * x * v);
};

constexpr auto norms = [](auto const& q, auto const& v) {
    auto const r = q.norm();
    return v.dot(v) / 2 * (1 + r) - (r - 1) * (r - 1) - q.squaredNorm() * r / 3 - pow(r, 3) - pow(q.squaredNorm(), 2.5) -
           sqrt(2.0 * q(0) * q(0) + 3.0 * q(1) * q(1)) - sqrt(q.squaredNorm() / 4.0) * v(0) - pow(q.squaredNorm(), 1.5) -
           sqrt(q.squaredNorm() * q.squaredNorm() * q.squaredNorm()) - pow(q.squaredNorm(), 0.5) * q.squaredNorm() -
           hypot(q(0), 2 * q(1)) * v(0) - r * v.norm() - r * r * r * v(1) + sqrt(3 * q(0) * q(0) + q(1) * q(1) / 2) * cos(r);
};

/// The largest difference between the derivatives of the formula and those of the jets, in epsilons of 1 + their size; of states with
/// components between 1/2 and 3/2, of which some may be 0.
template <class V, class L>
double worst_of(L const& lagrangian, int trials, bool with_zeros = false) {
    using s = detail::shape<V>;
    std::mt19937 random(1);
    std::uniform_real_distribution<double> some(0.5, 1.5);
    auto const between = [&](std::mt19937& from) { return with_zeros and from() % 4 > 0 ? 0.0 : some(from); };
    auto const q = variables<V>("q"), v = variables<V>("v");
    symbol const f = lagrangian(q, v);
    double worst = 0;
    for (int trial = 0; trial < trials; ++trial) {
        V x, y;
        std::map<std::string, double> at;
        for (int k = 0; k < s::size; ++k) {
            at[printed(s::component(q, k))] = s::component(x, k) = between(random);
            at[printed(s::component(v, k))] = s::component(y, k) = between(random);
        }
        auto const compare = [&](symbol const& formula, double expected) {
            double const e = std::abs(value_at(formula, at) - expected) / (1 + std::abs(expected)) / epsilon<double>();
            worst = std::max(worst, e);
        };
        auto const e = expand(lagrangian, x, y);
        compare(f, lagrangian(x, y));
        for (int j = 0; j < s::size; ++j) {
            symbol const by_q = partial(f, s::component(q, j)), by_v = partial(f, s::component(v, j));
            compare(by_q, s::component(e.by_q, j));
            compare(by_v, s::component(e.by_v, j));
            for (int k = 0; k < s::size; ++k) {
                compare(partial(by_q, s::component(q, k)), s::entry(e.qq, j, k));
                compare(partial(by_q, s::component(v, k)), s::entry(e.qv, j, k));
                compare(partial(by_v, s::component(v, k)), s::entry(e.vv, j, k));
            }
        }
    }
    return worst;
}

} // namespace

TEST_CASE("derivatives of formulas are those of the jets") {
    CHECK(worst_of<double>(pendulum, 100) <= 4);
    CHECK(worst_of<Eigen::Vector2d>(kepler, 100) <= 8);
    CHECK(worst_of<Eigen::Vector2d>(double_pendulum, 100) <= 4);
    CHECK(worst_of<double>(all_functions, 100) <= 32);
}

TEST_CASE("the slope of a norm at 0 is 0 in formulas as it is in jets") {
    CHECK(worst_of<Eigen::Vector2d>(norms, 100) <= 32);
    CHECK(worst_of<Eigen::Vector2d>(norms, 100, true) <= 32);
    auto const q = variables<Eigen::Vector2d>("q");
    CHECK(printed(partial(q.norm(), q(0))) == "q₀/√(q₀² + q₁²)");
    CHECK(printed(partial(partial(q.norm() * q.squaredNorm(), q(0)), q(1))) == "3·(q₀·q₁/√(q₀² + q₁²))");
    CHECK(std::isinf(value_at(1 / q.norm(), {{"q₀", 0}, {"q₁", 0}}))); // what somebody divided by is divided by
    CHECK(std::isnan(value_at(partial(1 / q.norm(), q(0)), {{"q₀", 0}, {"q₁", 0}})));
    CHECK(std::isnan(value_at(partial(sqrt(pow(q(0), 3)), q(0)), {{"q₀", 0}}))); // no norm
    CHECK(value_at(partial(q.norm(), q(0)) + partial(q.norm(), q(1)), {{"q₀", 0}, {"q₁", 0}}) == 0);
}

TEST_CASE("of the larger one of two the derivative is that of the one, whatever the other is") {
    auto const q = variables<double>("q");
    symbol const cap = min(1 / pow(q, 12), 100 - q), well = max(q * q * q, 0.0);
    CHECK(value_at(partial(cap, q), {{"q", 1e-2}}) == -1); // beside 1e27
    CHECK(value_at(partial(cap, q), {{"q", 0}}) == -1);    // beside infinity
    CHECK(value_at(partial(cap, q), {{"q", 2}}) == -12 * std::pow(2, -13));
    CHECK(value_at(partial(partial(well, q), q), {{"q", 2}}) == 12);
    CHECK(value_at(partial(partial(well, q), q), {{"q", -2}}) == 0);
    CHECK(std::isnan(value_at(partial(max(sqrt(q), 2.0), q), {{"q", -1}})));
    CHECK(printed(partial(well, q)) == "[q³ ≥ 0]·(3·q²)");
    CHECK(latex(partial(max(q, 2.0), q)) == "[q - 2 \\ge 0] \\, 1");
}

TEST_CASE("a Lagrangian and its derivatives, written out") {
    auto const q = variables<double>("q"), v = variables<double>("v");
    symbol const L = pendulum(q, v);
    CHECK(printed(L) == "v²/2 − (1 − cos(q))");
    CHECK(printed(partial(L, q)) == "−sin(q)");
    CHECK(printed(partial(L, v)) == "v");
    CHECK(printed(partial(partial(L, v), v)) == "1");
    CHECK(latex(L) == "\\frac{{v}^{2}}{2} - (1 - \\cos(q))");

    auto const x = variables<Eigen::Vector2d>("q"), y = variables<Eigen::Vector2d>("v");
    symbol const K = kepler(x, y);
    Eigen::Matrix<symbol, 2, 1> const force = partial(K, x);
    CHECK(printed(force(1)) == "−q₁/√(q₀² + q₁²)³");
    CHECK(printed(partial(force(0), x(0))) == "3·q₀²/√(q₀² + q₁²)^5 − 1/√(q₀² + q₁²)³");
    CHECK(latex(force(0)) == "-\\frac{q_{0}}{{\\sqrt{{q_{0}}^{2} + {q_{1}}^{2}}}^{3}}");
    CHECK(printed(pow(-q, 3) * abs(v) / 1e20) == "−q³·|v|/1e+20");
    CHECK(printed((q - v) * (q + v) - (q - (v - 1))) == "(q − v)·(q + v) − (q − (v − 1))");
}

TEST_CASE("constants are folded, zeros and ones disappear, equal parts are one node") {
    auto const q = variables<double>("q"), v = variables<double>("v");
    CHECK(symbol(2) * 3 - 7 == -1);
    CHECK(sqrt(symbol(4)) == 2);
    CHECK((0 + q).same_as(q));
    CHECK((q - 0 * v).same_as(q));
    CHECK((1 * q / 1).same_as(q));
    CHECK((-(-q)).same_as(q));
    CHECK((q - q).is(0));
    CHECK((q / 2 + q / 2).same_as(q));
    CHECK((4 * (q / 2)).same_as(2 * q));
    CHECK((q * q * q).same_as(pow(q, 3)));
    CHECK((q * q / q).same_as(q));
    CHECK((sqrt(q) * sqrt(q)).same_as(q));
    CHECK((q + v).same_as(v + q));
    CHECK((sin(q * v) + 1).same_as(1 + sin(v * q)));
    CHECK_FALSE((q - v).same_as(v - q));
    // Digits are those that are read back: 0.1 + 0.2 is not 0.3.
    CHECK(printed(symbol(0.1)) == "0.1");
    CHECK(printed(symbol(0.1) + 0.2) == "0.30000000000000004");
    // 1/0 is not folded into a number that is none.
    CHECK(printed(1 / symbol(0)) == "1/0");
    CHECK(printed(symbol(0) / 0) == "0/0");
    CHECK(printed(symbol(1e200) * 2e200) == "1e+200·2e+200");
}

TEST_CASE("what is no formula is refused") {
    auto const q = variables<double>("q");
    auto const by_cases = [](auto const& x) { return x < 0 ? -x : x * x; };
    CHECK_THROWS_WITH_AS(
        (void)by_cases(q),
        "what compares its arguments, by if or otherwise, is not one formula, nor is what iterates, as the Legendre transform "
        "of a Hamiltonian does: "
        "constants can be compared, and min, max and abs are formulas",
        error::no_formula);
    CHECK_THROWS_AS((void)(q == 0), error::no_formula);
    CHECK_THROWS_WITH_AS((void)(q * std::numeric_limits<double>::infinity()),
                         "the constants of a formula are finite doubles, and this one is inf", error::no_formula);
    CHECK(symbol(1) < symbol(2));
    CHECK(q == q);
}

TEST_CASE("names of several letters in LaTeX are names") {
    CHECK(latex(symbol::variable("q")) == "q");
    CHECK(latex(symbol::variable("q", 3)) == "q_{3}");
    CHECK(latex(symbol::variable("omega_dot")) == "\\omega_{\\mathrm{dot}}");
    CHECK(latex(symbol::variable("q_1", 0)) == "q_{1,0}");
    CHECK(latex(symbol::variable("q_a_b")) == "q_{\\mathrm{a\\_b}}");
    CHECK(latex(symbol::variable("_q")) == "\\mathrm{\\_q}");
    CHECK(latex(symbol::variable("angle", 2)) == "\\mathrm{angle}_{2}");
    CHECK(latex(symbol::variable("q_{i+1}")) == "q_{i+1}"); // somebody's own LaTeX
    // functions that LaTeX has a name for, and others
    CHECK(latex(asin(symbol::variable("q"))) == "\\arcsin(q)");
    CHECK(latex(asinh(symbol::variable("q")) + atanh(symbol::variable("q"))) == "\\operatorname{asinh}(q) + \\operatorname{atanh}(q)");
}

TEST_CASE("an embedding's operators run on symbols: the tableau as formulas in h") {
    symbol const h = symbol::variable("h");
    auto const quarter = tableau_of(theta<1, 4>, h);
    CHECK(quarter.w(0).same_as(h));
    CHECK(quarter.a(0, 0) == 0.75);
    CHECK(quarter.a(0, 1) == 0.25);
    CHECK(quarter.b(0, 1).same_as(1 / h));
    CHECK(tableau_of(order_one_left, h).a(0, 0) == 0);
    CHECK(printed(tableau_of(mid_point, h).b(0, 0)) == "−1/h");
}

TEST_CASE("a formula that is too deep for a stack is refused, and one that is not so deep is differentiated, written and let go") {
    symbol const q = symbol::variable("q");
    auto const sum_of = [&](int terms) {
        symbol sum = q;
        for (int k = 1; k < terms; ++k) sum += cos(symbol(k + 1) * q);
        return sum;
    };
    symbol const long_sum = sum_of(1500);
    CHECK(printed(partial(partial(long_sum, q), q)).size() > 1500);
    CHECK_THROWS_WITH_AS((void)sum_of(20'000), doctest::Contains("a formula has at most 2000 operations inside of each other"),
                         error::no_formula);
    symbol const half = sum_of(1500) / 3;
    CHECK_FALSE(partial(half + sum_of(1200), q).is(0)); // sums of partial sums
}

} // namespace symbol_tests
