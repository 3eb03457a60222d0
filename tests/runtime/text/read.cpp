// SPDX-License-Identifier: BSL-1.0
// Formulas in text: what they mean, in exact rationals, and what is said about those that mean nothing.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/multiprecision.hpp"
#include "hilger/text/lagrangian.hpp"

namespace text_read_tests {

using namespace hilger;

namespace {

std::shared_ptr<text::vocabulary const> words() {
    auto made = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"x", "u", 0}, {"q", "v", 3}, {"z", "s", 0}});
    made->set("m", "3/2");
    made->set("n", "3");
    made->set("w", std::vector<std::string>{"1", "0.5", "1/3"});
    return made;
}
/// At t = 7, x = 2, u = -1, q = (3, 5, -4), v = (1/2, 0, 6), z = 9, s = 8.
template <class S = Q>
S value_of(std::string const& formula) {
    S const q[] = {2, 3, 5, -4, 9}, v[] = {-1, S(1) / S(2), 0, 6, 8};
    text::stated const f(text::read(formula), words(), "f");
    return f.value(
        S(7), [&](int k) { return q[k]; }, [&](int k) { return v[k]; });
}
std::string refusal_of(std::string const& formula) {
    try {
        value_of(formula);
    } catch (error::exception const& why) {
        return why.what();
    }
    return "accepted";
}

} // namespace

TEST_CASE("operators bind as in mathematics") {
    CHECK(value_of("1 + 2*3") == 7);
    CHECK(value_of("(1 + 2)*3") == 9);
    CHECK(value_of("10 - 4 - 3") == 3);
    CHECK(value_of("24/4/3*2") == 4);
    CHECK(value_of("-x^2") == -4);
    CHECK(value_of("(-x)^2") == 4);
    CHECK(value_of("2^3^2") == 512);
    CHECK(value_of("2**3**0") == 2);
    CHECK(value_of("x^-2") == Q(1, 4));
    CHECK(value_of("2*-x") == -4);
    CHECK(value_of("- - +x") == 2);
    CHECK(value_of("x\n  # the rest is a comment ) (\n + 1 # and this") == 3);
    CHECK(value_of(" \t m*x\r\n") == 3);
}
TEST_CASE("numbers are what was written") {
    CHECK(value_of("0.1") == Q(1, 10));
    CHECK(value_of(".5") == Q(1, 2));
    CHECK(value_of("5.") == 5);
    CHECK(value_of("1.25e-2") == Q(1, 80));
    CHECK(value_of("3E+2") == 300);
    CHECK(value_of("1/3") == Q(1, 3));
    CHECK(text::number_in<Q>("-12/8") == Q(-3, 2));
    CHECK(text::number_in<double>("0.1") == 0.1);
    CHECK(text::number_in<double>("-1e-320") == -1e-320);
    CHECK(text::number_in<float50>("0.1") == float50("0.1"));
    CHECK(text::number_in<float100>("0.1") == float100("0.1"));
    CHECK(text::number_in<long double>("0.1") == 0.1L);
    CHECK(value_of<float>("x/3") == 2.0F / 3);
    CHECK(value_of<long double>("x/3") == 2.0L / 3);
    CHECK(value_of<float100>("x/3") == float100(2) / 3);
    for (char const* none : {"", "-", "1e", "e5", "1/0", "1/2/3", "0x10", "1 ", "nan", "inf", "1.2.3", "1e99999999", "--1"}) {
        CAPTURE(none);
        CHECK_FALSE(text::number_in<Q>(none));
        CHECK_FALSE(text::number_in<double>(none));
    }
    CHECK_FALSE(text::number_in<double>("1e400")); // there is none of this size
}
TEST_CASE("names stand for coordinates, velocities, the time and parameters") {
    CHECK(value_of("x + 10*u + 100*t") == 692);
    CHECK(value_of("z + 10*s") == 89);
    CHECK(value_of("q[0] + 10*q[1] + 100*q[2]") == 3 + 50 - 400);
    CHECK(value_of("v[n - 1] + w[0]/w[2] + m") == 6 + 3 + Q(3, 2));
    CHECK(value_of("dot(q, v)") == Q(3, 2) - 24);
    CHECK(value_of("dot(q, w)") == 3 + Q(5, 2) - Q(4, 3));
    CHECK(value_of("x^n + x^(n - 1) + x^w[0]") == 8 + 4 + 2);
}
TEST_CASE("sums, choices and comparisons") {
    CHECK(value_of("sum(i, 0, n - 1, q[i])") == 4);
    CHECK(value_of("sum(i, 0, 1, (q[i + 1] - q[i])^2)") == 4 + 81);
    CHECK(value_of("sum(i, 0, n - 2, sum(j, i + 1, n - 1, q[i]*q[j]))") == 15 - 12 - 20);
    CHECK(value_of("sum(i, 1, 4, i^2)") == 30);
    CHECK(value_of("sum(i, 1, 0, q[i + 100])") == 0);
    CHECK(value_of("sum(i, 0, 2, if(i == 0, 0, q[i - 1]))") == 8);
    CHECK(value_of("if(x < 3, 1, 2)") == 1);
    CHECK(value_of("if(x > 3, 1, 2)") == 2);
    CHECK(value_of("if(2 >= x, 1, 2)") == 1);
    CHECK(value_of("if(x > 3 or u < 0 and t >= 7, 1, 2)") == 1);
    CHECK(value_of("if(not x != 2, 1, 2)") == 1);
    CHECK(value_of("if(x <= 2 and not (u == -1), 1, 2)") == 2);
    CHECK(value_of("min(x, u) + 10*max(x, u) + 100*abs(u)") == -1 + 20 + 100);
    for (char const* none : {"max(0, sqrt(u))", "max(sqrt(u), 0)", "min(0, sqrt(u))", "min(sqrt(u), 0)", "max(1, max(sqrt(u), 0))"})
        CHECK(std::isnan(value_of<double>(none)));
}
TEST_CASE("what means nothing is said, and where") {
    auto const says = [](std::string const& formula, std::string const& sentence) {
        CAPTURE(formula);
        CHECK(refusal_of(formula) == sentence);
    };
    says("", "the formula, line 1, column 1: a formula was expected, and there is none");
    says("1 +", "the formula, line 1, column 4: a number, a name or a bracket was expected, and there is the end");
    says("x +\n (1 - u", "the formula, line 2, column 8: ')' was expected, and there is the end");
    says("1 + not", "the formula, line 1, column 5: a number, a name or a bracket was expected, and there is 'not'");
    says("if(x < 1 and or u < 2, x, u)", "the formula, line 1, column 14: a number, a name or a bracket was expected, and there is 'or'");
    says("x u", "the formula, line 1, column 3: an operator or the end was expected, and there is 'u'");
    says("2x", "the formula, line 1, column 2: a number ends before 'x': a product is written with *, as 2*q");
    says("2−x", "the formula, line 1, column 2: a number ends before '−': a product is written with *, as 2*q");
    says("x = 2", "the formula, line 1, column 3: equality is ==");
    says("α + $", "the formula, line 1, column 5: '$' has no meaning in a formula");
    says("sum(i, 0, 3)", "the formula, line 1, column 1: it is written sum(index, first, last, term), and here are 3 arguments");
    says("if(x)", "the formula, line 1, column 1: it is written if(condition, where it holds, where not), and here are 1 argument");
    says("sum(2, 0, 3, x)", "the formula, line 1, column 1: the index of a sum is a name, as in sum(i, 0, n - 1, q[i]^2)");
    says("x + y", "f, line 1, column 5: 'y' has no meaning: there are m, n, q[], s, t, u, v[], w[], x, z");
    says("q", "f, line 1, column 1: 'q' has 3 components: q[0], dot(q, q), norm(q)");
    says("q[3]", "f, line 1, column 1: 'q' has the components 0 to 2, and here is asked for number 3");
    says("if(x < 3, 1, q[0 - 1])", "f, line 1, column 14: 'q' has the components 0 to 2, and here is asked for number -1");
    says("if(x < 3 or q[9] < 1, 1, 2)", "f, line 1, column 13: 'q' has the components 0 to 2, and here is asked for number 9");
    says("q[x]",
         "f, line 1, column 3: indices are whole numbers below 10^9, made of numbers, parameters and indices of sums, and here is none");
    says("q[1/2]",
         "f, line 1, column 3: indices are whole numbers below 10^9, made of numbers, parameters and indices of sums, and here is none");
    says("x[0]", "f, line 1, column 1: 'x' is a number, and has no components");
    says("x(2)", "f, line 1, column 1: 'x' is no function: a product is written with *, as 2*q, and a component with q[0]");
    says("cos(x, u)", "f, line 1, column 1: cos takes 1 argument, and here are 2");
    says("dot(q, x)", "f, line 1, column 8: 'x' is a number, and has no components");
    says("dot(q, q[0])", "f, line 1, column 8: dot takes names of vectors, as in dot(q, v)");
    says("x < 2", "f, line 1, column 1: a number was expected, and here is a condition, which belongs into if(condition, a, b)");
    says("if(x, 1, 2)", "f, line 1, column 4: a condition was expected, as q < 0, and here is a number");
    says("sum(i, 0, 1, sum(i, 0, 1, i))",
         "f, line 1, column 14: the index of a sum has a name of its own, and 'i' is another thing already");
    says("sum(i, 0, 9999, sum(j, 0, 9999, x))", "f, line 1, column 17: sums have at most 2000000 terms together");
    says("cos(x)", "f, line 1, column 1: cos has no exact value in rationals");
    says("x^(1/2)", "f, line 1, column 1: in rationals exponents are whole numbers");
    says("2^3^9", "f, line 1, column 1: in rationals exponents are at most 1000, and here is 19683");
    says("x + pi", "f, line 1, column 5: pi is no rational number");
    CHECK(refusal_of("sinus(x)").find("there is no function 'sinus': there are sin, cos, tan") != std::string::npos);
    CHECK(refusal_of(std::string(100'000, '(')).find("at most 400 levels") != std::string::npos);
    CHECK(refusal_of(std::string(100'000, '-') + "x").find("at most 400 levels") != std::string::npos);
}
TEST_CASE("long sums are no deep ones") {
    std::string text = "x";
    for (int k = 0; k < 50'000; ++k) text += k % 2 == 0 ? " + 1" : " - u";
    CHECK(value_of(text) == 2 + 25'000 + 25'000);
    CHECK(refusal_of("x^(" + text + ")") == "f, line 1, column 1: in rationals exponents are whole numbers");
    std::string one = "1";
    for (int k = 0; k < 50'000; ++k) one += k % 2 == 0 ? " + 1" : " - 1";
    CHECK(value_of("x^(" + one + ")") == 2);
    CHECK(text::stated(text::read(text), words(), "f").operations() > 100'000);
}
TEST_CASE("parameters that states bring with them") {
    text::vocabulary made({{"q", "v", 0}, {"x", "u", 2}});
    made.set("m", "3");
    made.set("k", std::vector<std::string>{"1", "2"});
    made.set("g", "5");
    made.bring_with_states("k");
    made.bring_with_states("m");
    CHECK(made.dimension() == 3);
    CHECK(made.brought() == 3);
    auto const value = [](text::vocabulary const& words) {
        auto const number = [](int k) { return Q(10 + k); }; // 3 and 4 are k, 5 is m
        return text::stated(text::read("1000*m + 100*k[0] + 10*k[1] + g + x[1]"), std::make_shared<text::vocabulary>(words), "f")
            .value(Q(0), number, number);
    };
    CHECK(value(made) == 15'000 + 1'300 + 140 + 5 + 12);
    auto const fixed = made.with({0.5, 7, 9});
    CHECK(fixed.brought() == 0);
    CHECK(value(fixed) == 9'000 + 50 + 70 + 5 + 12);
    CHECK_THROWS_WITH_AS((void)made.with({0.5, std::nan(""), 9}), "the parameter 'k' is a number, and is nan here", error::not_finite);
    CHECK_THROWS_WITH_AS((void)made.with({0.5, 7, HUGE_VAL}), "the parameter 'm' is a number, and is inf here", error::not_finite);
    CHECK_THROWS_WITH_AS(made.bring_with_states("q"), "there is no parameter 'q': there are g, k[], m, q, t, u[], v, x[]",
                         error::invalid_parameter);
}
TEST_CASE("a name has one meaning") {
    CHECK_THROWS_WITH_AS(text::vocabulary({{"q", "q", 0}}), "each name has one meaning, and 'q' was given two", error::invalid_parameter);
    text::vocabulary made({{"q", "v", 0}});
    CHECK_THROWS_AS(made.set("t", "1"), error::invalid_parameter);
    CHECK_THROWS_AS(made.set("sum", "1"), error::invalid_parameter);
    CHECK_THROWS_AS(made.set("2m", "1"), error::invalid_parameter);
    CHECK_THROWS_WITH_AS(made.set("m", "heavy"), "the parameter 'm' is a number, as 0.1, 1e-3 or 1/3, and was given as 'heavy'",
                         error::invalid_parameter);
    CHECK_THROWS_WITH_AS(made.set("pi", "3"), "pi is the number 3.14159..., and the name of nothing else", error::invalid_parameter);
    CHECK_THROWS_AS(text::vocabulary({{"pi", "v", 0}}), error::invalid_parameter);
    CHECK_THROWS_WITH_AS(made.set("k", std::vector<std::string>{}), "the parameter 'k' is a list of numbers, and of none here",
                         error::invalid_parameter);
    CHECK(text::stated(text::read("q + v"), std::make_shared<text::vocabulary>(made), "f")
              .value(
                  Q(1), [](int) { return Q(2); }, [](int) { return Q(3); }) == 5);
}

} // namespace text_read_tests
