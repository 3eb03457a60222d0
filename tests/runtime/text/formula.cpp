// SPDX-License-Identifier: BSL-1.0
// A callable as a formula: what it says, and that its derivatives are those of the jets.
#include <random>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/text/formula.hpp"

namespace formula_tests {

using namespace hilger;

namespace {

template <class X>
std::string printed(X const& x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

using std::max, std::min;

constexpr auto pendulum = [](auto const& x, auto const& v) { return v * v / 2 - (1 - cos(x)); };
constexpr auto kepler = [](auto const& q, auto const& v) { return v.dot(v) / 2 + 1 / q.norm(); };
constexpr auto kepler_in_line = [](auto const& q, auto const& v) { return v * v / 2 + 1 / sqrt(1 + q * q); };
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
    formula const f = formula_of<V>(lagrangian);
    double worst = 0;
    for (int trial = 0; trial < trials; ++trial) {
        V x, y;
        std::vector<double> at(2 * s::size + 1);
        for (int k = 0; k < s::size; ++k) {
            at[static_cast<std::size_t>(k)] = s::component(x, k) = between(random);
            at[static_cast<std::size_t>(s::size + k)] = s::component(y, k) = between(random);
        }
        auto const compare = [&](formula const& g, double expected) {
            double const e = std::abs(g.value(at) - expected) / (1 + std::abs(expected)) / epsilon<double>();
            worst = std::max(worst, e);
        };
        auto const e = expand(lagrangian, x, y);
        compare(f, lagrangian(x, y));
        for (int j = 0; j < s::size; ++j) {
            formula const by_q = f.by_q(j), by_v = f.by_v(j);
            compare(by_q, s::component(e.by_q, j));
            compare(by_v, s::component(e.by_v, j));
            for (int k = 0; k < s::size; ++k) {
                compare(by_q.by_q(k), s::entry(e.qq, j, k));
                compare(by_q.by_v(k), s::entry(e.qv, j, k));
                compare(by_v.by_v(k), s::entry(e.vv, j, k));
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
    auto const norm = formula_of<Eigen::Vector2d>([](auto const& q, auto const&) { return q.norm(); });
    auto const cube = formula_of<Eigen::Vector2d>([](auto const& q, auto const&) { return q.norm() * q.squaredNorm(); });
    auto const pole = formula_of<Eigen::Vector2d>([](auto const& q, auto const&) { return 1 / q.norm(); });
    auto const power = formula_of<Eigen::Vector2d>([](auto const& q, auto const&) { return sqrt(pow(q(0), 3)); });
    CHECK(printed(norm.by_q(0)) == "q₀/√(q₀² + q₁²)");
    CHECK(printed(cube.by_q(0).by_q(1)) == "3·q₀·q₁/√(q₀² + q₁²)");
    std::vector<double> const zero(5);
    CHECK(std::isinf(pole.value(zero))); // what somebody divided by is divided by
    CHECK(std::isnan(pole.by_q(0).value(zero)));
    CHECK(std::isnan(power.by_q(0).value(zero))); // no norm
    CHECK(norm.by_q(0).value(zero) + norm.by_q(1).value(zero) == 0);
}

TEST_CASE("of the larger one of two the derivative is that of the one, whatever the other is") {
    auto const cap = formula_of([](auto const& q, auto const&) { return min(1 / pow(q, 12), 100 - q); });
    auto const well = formula_of([](auto const& q, auto const&) { return max(q * q * q, 0.0); });
    auto const root = formula_of([](auto const& q, auto const&) { return max(sqrt(q), 2.0); });
    auto const at = [](formula const& f, double q) { return f.value({q, 0, 0}); };
    CHECK(at(cap.by_q(), 1e-2) == -1); // beside 1e27
    CHECK(at(cap.by_q(), 0) == -1);    // beside infinity
    CHECK(at(cap.by_q().by_q(), 0) == 0);
    CHECK(at(cap.by_q(), 2) == doctest::Approx(-12 * std::pow(2, -13)).epsilon(1e-15));
    CHECK(at(well.by_q().by_q(), 2) == 12);
    CHECK(at(well.by_q().by_q(), -2) == 0);
    CHECK(std::isnan(at(root.by_q(), -1)));
    CHECK(at(formula_of([](auto const& q, auto const&) { return abs(q); }).by_q(), 0) == 1);
    CHECK(printed(well.by_q()) == "3·q²·[q³ ≥ 0]");
    CHECK(latex(formula_of([](auto const& q, auto const&) { return max(q, 2.0); }).by_q()) == "[q - 2 \\ge 0]");
}

TEST_CASE("a Lagrangian and its derivatives, written out") {
    formula const L = formula_of(pendulum);
    CHECK(printed(L) == "v²/2 − (1 − cos(q))");
    CHECK(printed(L.by_q()) == "−sin(q)");
    CHECK(printed(L.by_v()) == "v");
    CHECK(printed(L.by_v().by_v()) == "1");
    CHECK(printed(L.by_t()) == "0");
    CHECK(latex(L) == "\\frac{{v}^{2}}{2} - (1 - \\cos(q))");

    auto const K = formula_of<Eigen::Vector2d>(kepler);
    CHECK(printed(K) == "(v₀² + v₁²)/2 + 1/√(q₀² + q₁²)");
    CHECK(printed(K.by_q(1)) == "−q₁/√(q₀² + q₁²)³");
    CHECK(printed(K.by_q(0).by_q(0)) == "3·q₀²/√(q₀² + q₁²)^5 − 1/√(q₀² + q₁²)³");
    CHECK(latex(K.by_q(0)) == "-\\frac{q_{0}}{{\\sqrt{{q_{0}}^{2} + {q_{1}}^{2}}}^{3}}");
    auto const of_one = [](auto const& f) { return printed(formula_of(f)); };
    CHECK(of_one([](auto const& q, auto const& v) { return pow(-q, 3) * abs(v) / 1e20; }) == "−q³·|v|/1e+20");
    CHECK(of_one([](auto const& q, auto const& v) { return (q - v) * (q + v) - (q - (v - 1)); }) == "(q − v)·(q + v) − (q − (v − 1))");
    CHECK(of_one([](auto const& t, auto const& q, auto const&) { return q * t; }) == "q·t");
    CHECK(printed(formula_of([](auto const& t, auto const& q, auto const&) { return q * t; }).by_t()) == "q");
}

TEST_CASE("a Lagrangian in a transformed time is written out as any other") {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 - q * q; };
    formula const in_tau = formula_of(transform_time(
        L, [](auto const& q) { return 1 + q * q; }, 3));
    CHECK(printed(in_tau) == "(q² + 1)·(v²/(2·(q² + 1)²) − q² + 3)");
    CHECK(printed(in_tau.by_v()) == "v/(q² + 1)");
    CHECK(printed(formula_of(transform_time(
                                 L, [](auto const&) { return 1; }, 3))
                      .by_q()) == printed(formula_of(L).by_q()));
    auto const pushed = [](auto const& t, auto const& q, auto const& v) { return v(0) * v(0) / 2 + t * q(0); };
    auto const with_time = formula_of<Eigen::Vector3d>(transform_time(pushed, [](auto const& q) { return q(0); }));
    CHECK(printed(with_time.by_q(2)) == "q₀ − v₁"); // t' = g
    CHECK(printed(with_time.by_q(1)) == "q₀²");     // e' = -g dL/dt
}
TEST_CASE("constants are folded, zeros and ones disappear, powers and equal terms are gathered") {
    auto const of_one = [](auto const& f) { return printed(formula_of(f)); };
    CHECK(of_one([](auto const& q, auto const& v) { return 0 + q - 0 * v; }) == "q");
    CHECK(of_one([](auto const& q, auto const&) { return -(-q); }) == "q");
    CHECK(of_one([](auto const& q, auto const&) { return q / 2 + q / 2; }) == "q");
    CHECK(of_one([](auto const& q, auto const&) { return 4 * (q / 2); }) == "2·q");
    CHECK(of_one([](auto const& q, auto const&) { return q / -2; }) == "−q/2");
    CHECK(of_one([](auto const& q, auto const&) { return q * q * q; }) == "q³");
    CHECK(of_one([](auto const& q, auto const&) { return q * q / q; }) == "q");
    CHECK(of_one([](auto const& q, auto const&) { return sqrt(q) * sqrt(q); }) == "q");
    CHECK(of_one([](auto const& q, auto const&) { return q * sqrt(q); }) == "√(q)³");
    CHECK(of_one([](auto const& q, auto const&) { return q / 4 + q / 2; }) == "0.75·q");
    CHECK(of_one([](auto const& q, auto const& v) { return q * v - v * q; }) == "0");
    CHECK(of_one([](auto const& q, auto const& v) { return pow(q, 2.5) + pow(2.0, q - v); }) == "q^2.5 + 2^(q − v)");
    // Digits are those that are read back: 0.1 + 0.2 is not 0.3.
    CHECK(of_one([](auto const& q, auto const&) { return 0.1 * q; }) == "0.1·q");
    CHECK(of_one([](auto const& q, auto const&) { return 0.1 * q + 0.2 * q; }) == "0.30000000000000004·q");
    CHECK(formula_of(kepler_in_line).size(1000) == 14);
    CHECK(formula_of(kepler_in_line).size(10) == 10);
}

TEST_CASE("what is no formula is refused") {
    CHECK_THROWS_WITH_AS((void)formula_of([](auto const& x, auto const&) { return x < 0 ? -x : x * x; }),
                         "what compares its arguments, by if or otherwise, is not one formula, nor is what iterates, as the Legendre "
                         "transform of a Hamiltonian does: "
                         "constants can be compared, and min, max and abs are formulas",
                         error::no_formula);
    auto const infinite = formula_of([](auto const& q, auto const&) { return q * std::numeric_limits<double>::infinity(); });
    CHECK_THROWS_WITH_AS((void)printed(infinite), "the constants of a formula are finite doubles, and this one is inf", error::no_formula);
}

TEST_CASE("names of several letters in LaTeX are names") {
    auto const named = [](std::string const& name, int component = -1) {
        auto const in = std::make_shared<detail::named_graph>(1);
        in->names[0] = {name, component};
        return latex(formula(in, detail::named_graph::argument(0)));
    };
    CHECK(named("q") == "q");
    CHECK(named("q", 3) == "q_{3}");
    CHECK(named("omega_dot") == "\\omega_{\\mathrm{dot}}");
    CHECK(named("q_1", 0) == "q_{1,0}");
    CHECK(named("q_a_b") == "q_{\\mathrm{a\\_b}}");
    CHECK(named("_q") == "\\mathrm{\\_q}");
    CHECK(named("angle", 2) == "\\mathrm{angle}_{2}");
    CHECK(named("q_{i+1}") == "q_{i+1}"); // somebody's own LaTeX
    // functions that LaTeX has a name for, and others
    auto const of_one = [](auto const& f) { return latex(formula_of(f)); };
    CHECK(of_one([](auto const& q, auto const&) { return asin(q); }) == "\\arcsin(q)");
    CHECK(of_one([](auto const& q, auto const&) { return asinh(q) + atanh(q); }) == "\\operatorname{asinh}(q) + \\operatorname{atanh}(q)");
}

TEST_CASE("an embedding's operators run on formulas: the tableau in h") {
    detail::named_graph in(1);
    detail::tracing<double> const here(in.graph);
    auto const h = in.variable("h");
    auto const quarter = tableau_of(theta<1, 4>, h);
    CHECK(quarter.w(0).node == h.node);
    CHECK(in.variable("h").node == h.node);
    CHECK(quarter.a(0, 0).is_constant());
    CHECK(quarter.a(0, 0).value == 0.75);
    CHECK(quarter.a(0, 1).value == 0.25);
    CHECK(tableau_of(order_one_left, h).a(0, 0).is(0));
}

TEST_CASE("sums of many terms are differentiated and written") {
    auto const sum = formula_of([](auto const& q, auto const&) {
        auto total = 1 * q;
        for (int k = 1; k < 1500; ++k) total += cos((k + 1) * q);
        return total;
    });
    CHECK(printed(sum.by_q().by_q()).size() > 10'000);
}

} // namespace formula_tests
