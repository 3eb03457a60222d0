// SPDX-License-Identifier: BSL-1.0
// What a formula is written as is read as the same formula, with no bracket too many where people write formulas.
#include <doctest/doctest.h>

#include <random>

#include "hilger/text/expression.hpp"

namespace text_write_tests {

using namespace hilger;
using text::expression;
using text::kind;

namespace {

bool same(text::node const& x, text::node const& y) {
    if (x.what != y.what or x.name != y.name or x.parts.size() != y.parts.size()) return false;
    for (std::size_t k = 0; k < x.parts.size(); ++k)
        if (not same(*x.parts[k], *y.parts[k])) return false;
    return true;
}
std::string again(std::string const& formula) { return *text::written(text::read(formula), 1'000'000); }

/// Of every kind of node, whatever it means.
class grower {
public:
    explicit grower(unsigned seed) : random_(seed) {}
    expression grow(int levels) {
        if (levels == 0) return pick(2) == 0 ? expression::number(std::to_string(pick(9)) + ".5") : expression::variable("x");
        auto const part = [&] { return grow(levels - 1 - pick(levels)); };
        switch (auto const what = static_cast<kind>(pick(static_cast<int>(kind::sum) + 1)); what) {
        case kind::number:
        case kind::name:
            return grow(0);
        case kind::element:
            return expression::element("q", part());
        case kind::negative:
        case kind::not_so:
            return {what, "", {part()}};
        case kind::call:
            return expression::call("atan2", {part(), part()});
        case kind::choice:
            return {what, "", {part(), part(), part()}};
        case kind::sum:
            return {what, "i", {part(), part(), part()}};
        default:
            return {what, "", {part(), part()}};
        }
    }

private:
    int pick(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    std::mt19937 random_;
};

} // namespace

TEST_CASE("formulas are written as people write them") {
    for (std::string const formula : {"m*v^2/2 - m*g*l*(1 - cos(q))",
                                      "a - (b - c)",
                                      "a - b - c",
                                      "a/(b*c)",
                                      "a/b*c",
                                      "-x^2",
                                      "(-x)^2",
                                      "x^-2",
                                      "x^(1/3)",
                                      "2^3^2",
                                      "(2^3)^2",
                                      "-(a + b)*c",
                                      "a*(-b)",
                                      "(a + b)*c/(d - e)",
                                      "-(-x)",
                                      "sum(i, 0, n - 1, (q[i + 1] - q[i])^2)/2",
                                      "if(t < 1 and not x <= 2, a, -b)",
                                      "if((a < 1 or b < 2) and x != 3, 0.25, 1e-5)",
                                      "if(a < 1 or b < 2 and c == 3, 1, 2)",
                                      "if(not (a < 1 and b < 2), max(x, 1), abs(x))"}) {
        CAPTURE(formula);
        CHECK(again(formula) == formula);
    }
    CHECK(again("1+2 * +x # and more") == "1 + 2*x");
    CHECK(again("q ** 2 > 1") == "1 < q^2");
}
TEST_CASE("what is written is read again as what it was") {
    for (unsigned seed = 0; seed < 2000; ++seed) {
        expression const e = grower(seed).grow(6);
        std::string const formula = *text::written(e, 1'000'000);
        CAPTURE(formula);
        CHECK(same(text::read(formula).root(), e.root()));
    }
}
TEST_CASE("long formulas are written without a deep stack, and endless ones not at all") {
    expression chain = expression::variable("x"), shared = chain;
    std::string right = "x";
    for (int k = 0; k < 100'000; ++k) {
        chain = chain + expression::variable("y");
        right += " + y";
    }
    CHECK(text::written(chain, right.size()) == right);
    CHECK_FALSE(text::written(chain, right.size() - 1));
    for (int k = 0; k < 200; ++k) shared = shared * shared; // 2^200 letters
    CHECK_FALSE(text::written(shared, 10'000));
}

} // namespace text_write_tests
