// SPDX-License-Identifier: BSL-1.0
// Operators that are known at run time only do what the same operators in types do: values, points lost at the ends, adjoints between any
// two sums, equality, and how they are written. Adjoints of random ones are proved in rationals.
#include <doctest/doctest.h>

#include <random>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/embedding.hpp"

namespace text_operator_tests {

using namespace hilger;
using text::operator_formula;
using text::operator_in;
using text::sum_weight;

namespace {

time_scale<Q> uneven() { return time_scale<Q>({0, Q(1, 3), Q(1), Q(7, 5), Q(2), Q(23, 10), Q(4), Q(9, 2)}); }
std::vector<Q> some_values(std::size_t n, unsigned seed) {
    std::mt19937_64 random(seed);
    std::vector<Q> x;
    for (std::size_t k = 0; k < n; ++k) x.emplace_back(static_cast<int>(random() % 199) - 99, static_cast<int>(random() % 19) + 1);
    return x;
}

template <class W>
constexpr sum_weight weight_of = std::same_as<W, delta_weight> ? sum_weight::delta : sum_weight::nabla;

/// The operator in a text is the typed one: on whole functions, in its points, its weights, its adjoint, and its two spellings.
template <class A>
void check_same(std::string const& words, A const& typed) {
    CAPTURE(words);
    auto const a = operator_in(words);
    auto const T = uneven();
    auto const f = function_on(T, some_values(8, 7));
    auto const there = typed[f];
    text::operator_in_numbers<Q> const here(a);
    using D = typename decltype(there)::domain_type;
    CHECK(a.lost() == text::lost_points{D::front, D::back});
    for (index_type i = D::front; i < 8 - D::back; ++i) CHECK(here.value(f, i) == Q(there.get(i)));
    CHECK(a.from_weight() == weight_of<typename A::from_weight>);
    CHECK(a.to_weight() == weight_of<typename A::to_weight>);

    auto const mirrored = adjoint(typed);
    auto const turned = a.adjoint();
    auto const g = mirrored[f];
    using M = typename decltype(g)::domain_type;
    CHECK(turned.lost() == text::lost_points{M::front, M::back});
    for (index_type i = M::front; i < 8 - M::back; ++i) CHECK(text::operator_in_numbers<Q>(turned).value(f, i) == Q(g.get(i)));

    std::ostringstream terminal;
    terminal << typed;
    CHECK(written(a, print_style::terminal) == terminal.str());
    CHECK(written(a, print_style::latex) == latex(typed));
    CHECK(operator_in(text_of(a)) == a);
    CHECK(operator_in(text_of(a, "")) == a);
}

/// sum of w f g over the points where both are.
Q paired(time_scale<Q> const& T, sum_weight w, std::vector<Q> const& f, std::vector<Q> const& g, std::size_t first, std::size_t end) {
    Q total = 0;
    for (std::size_t i = first; i < end; ++i) {
        auto const k = static_cast<index_type>(i);
        Q const after = i + 1 < f.size() ? T.step(k) : Q(0), before = i > 0 ? T.step(k - 1) : Q(0);
        total += (w == sum_weight::delta ? after : before) * f[i] * g[i];
    }
    return total;
}

struct random_operators {
    std::mt19937_64 random;
    int pick(int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); }
    operator_formula grow(int levels) {
        if (levels == 0) {
            side const s = pick(2) == 0 ? side::plus : side::minus;
            int const kind = pick(3);
            return kind == 0 ? operator_formula() : kind == 1 ? operator_formula::shift(s) : operator_formula::derivative(s);
        }
        operator_formula const a = grow(levels - 1);
        switch (pick(4)) {
        case 0:
            return operator_formula::multiple(
                operator_formula::stated_number(std::to_string(pick(9) - 4) + "/" + std::to_string(pick(5) + 1)), a);
        case 1:
            return a * grow(levels - 1);
        default:
            return a + grow(levels - 1);
        }
    }
};

} // namespace

TEST_CASE("operators in text are those of types") {
    check_same("sigma", sigma);
    check_same("rho", rho);
    check_same("Delta_plus", Delta_plus);
    check_same("Delta_minus", Delta_minus);
    check_same("sigma[Delta_plus]", sigma[Delta_plus]);
    check_same("Delta_minus*Delta_plus", Delta_minus * Delta_plus);
    check_same("Delta_plus[Delta_plus[q]]", Delta_plus * Delta_plus);
    check_same("-Delta_minus", -Delta_minus);
    check_same("2/3*sigma", fraction<2, 3>{} * sigma);
    check_same("(Delta_plus + Delta_minus)/2", fraction<1, 2>{} * (Delta_plus + Delta_minus));
    check_same("sigma(q) - rho(q)", sigma - rho);
    check_same("rho*Delta_plus", rho * Delta_plus); // is Delta_minus
    check_same("sigma*rho", sigma * rho);           // has values at the first point again
    check_same("rho[sigma[q]]", rho * sigma);
    check_same("sigma[sigma[q]] + sigma[q]", sigma * sigma + sigma);
    check_same("(identity + sigma)/2", fraction<1, 2>{} * (identity_T + sigma));
    check_same("(1 + sigma)/2", fraction<1, 2>{} * (identity_T + sigma));
}
TEST_CASE("the adjoint of a random operator is one between any two sums, exactly") {
    random_operators source{std::mt19937_64(11)};
    auto const T = uneven();
    int whole = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        auto const a = source.grow(3);
        CAPTURE(text_of(a));
        auto const lost = a.lost();
        if (lost.front + lost.back > 3) continue;
        for (auto const P : {sum_weight::delta, sum_weight::nabla})
            for (auto const W : {sum_weight::delta, sum_weight::nabla}) {
                auto const b = a.adjoint(P, W);
                auto const gone = b.lost();
                // f and g vanish beside some inner points, so that the end points add nothing
                std::vector<Q> f = some_values(8, seed), g = some_values(8, seed + 1000), Af(8, Q(0)), Bg(8, Q(0));
                for (std::size_t k : {0U, 1U, 2U, 5U, 6U, 7U}) f[k] = g[k] = 0;
                text::operator_in_numbers<Q> const A(a), B(b);
                auto const x = function_on(T, f), y = function_on(T, g);
                for (index_type i = std::max(lost.front, 1); i < 8 - std::max(lost.back, 1); ++i)
                    Af[static_cast<std::size_t>(i)] = A.value(x, i);
                for (index_type i = std::max(gone.front, 1); i < 8 - std::max(gone.back, 1); ++i)
                    Bg[static_cast<std::size_t>(i)] = B.value(y, i);
                // f and g live at points 3 and 4, where both operators have values
                REQUIRE((lost.front <= 3 and lost.back <= 3 and gone.front <= 3 and gone.back <= 3));
                CHECK(paired(T, W, Af, g, 0, 8) == paired(T, P, f, Bg, 0, 8));
            }
        CHECK(operator_in(text_of(a)) == a);
        CHECK(operator_in(text_of(a, "")) == a);
        ++whole;
    }
    CHECK(whole > 100);
}
TEST_CASE("operators are equal when they do the same") {
    CHECK(operator_in("rho*Delta_plus") == operator_in("Delta_minus"));
    CHECK_FALSE(operator_in("Delta_plus*sigma") == operator_in("sigma*Delta_plus"));
    CHECK(equal(operator_in("Delta_plus*sigma"), operator_in("sigma*Delta_plus"), true));
    CHECK_FALSE(operator_in("sigma*rho") == operator_in("identity")); // it has lost a point
    CHECK_FALSE(operator_in("sigma") == operator_in("sigma + rho - rho"));
    CHECK(operator_in("sqrt(2)*sigma*sqrt(2)") == operator_in("2*sigma"));
    CHECK_FALSE(operator_in("sqrt(2)*sigma") == operator_in("1.41421356237309504880*sigma"));
    CHECK(operator_in("0.3*sigma") == operator_in("3/10*sigma"));
}
TEST_CASE("how composed operators are written") {
    auto const terminal = [](char const* words, bool uniform) { return written(operator_in(words), print_style::terminal, uniform); };
    CHECK(terminal("(q + sigma[q])/2", false) == "1/2 f + 1/2 σ[f]");
    CHECK(terminal("2*Delta_plus[rho[q]]", true) == "2 Δ₊[ρ[f]]");
    CHECK(terminal("sqrt(3)/6*q - rho[q]", false) == "(sqrt(3)/6) f − ρ[f]");
    CHECK(written(operator_in("(q + sigma[q])/2").adjoint(sum_weight::delta, sum_weight::delta), print_style::terminal) ==
          "1/2 f + 1/2 (ν/μ) ρ[f]");
    CHECK(written(operator_in("(q + sigma[q])/2").adjoint(sum_weight::delta, sum_weight::delta).on_equal_steps(), print_style::latex,
                  true) == "\\tfrac{1}{2}\\,f + \\tfrac{1}{2}\\,\\rho\\left[f\\right]");
    CHECK(text_of(operator_in("(Delta_plus - sigma)*q")) == "Delta_plus[q] - sigma[q]");
    CHECK(text_of(operator_in("(q + sigma[q])/2")) == "(q + sigma[q])/2");
    CHECK(text_of(operator_in("(Delta_plus - sigma)[q]")) == "Delta_plus[q] - sigma[q]");
    CHECK(operator_in("((1 + sigma)/2)[q]") == operator_in("(q + sigma[q])/2"));
    CHECK(operator_in("(1 + sigma)[2*Delta_minus[q]]/2") == operator_in("Delta_minus[q] + sigma[Delta_minus[q]]"));
    CHECK(operator_in("(1 - sigma)[(1 + sigma)][q]") == operator_in("q - sigma[sigma[q]]"));
    CHECK(operator_in("sigma[(1/2)[q]]") == operator_in("sigma[q]/2"));
    CHECK(text_of(operator_in("2/3*Delta_minus[(1 + sigma)*q]"), "") == "2/3*Delta_minus[1*identity + sigma]");
}
TEST_CASE("rows are what values are made of, on every scale") {
    auto const T = uneven();
    for (char const* words : {"Delta_plus[(sigma + 2*rho)[Delta_minus[q]]]", "(1 - 3*Delta_plus)[(rho - sigma/2)[q]]",
                              "Delta_minus[Delta_plus[q]] - sigma[(q + Delta_minus[q])/3]"}) {
        CAPTURE(words);
        for (auto const& a :
             {operator_in(words), operator_in(words).adjoint(), operator_in(words).adjoint(sum_weight::delta, sum_weight::delta)}) {
            text::operator_in_numbers<Q> const op(a);
            auto const f = function_on(T, some_values(8, 11));
            for (index_type i = a.lost().front; i < 8 - a.lost().back; ++i) {
                Q sum = 0;
                for (auto const& [j, c] : op.row(T, i)) sum += c * f.get(j);
                CHECK(sum == op.value(f, i));
            }
        }
    }
}
TEST_CASE("high powers are compared at once, and roots that cancel are rounding") {
    auto const power = [](operator_formula const& a, int n) {
        auto made = a;
        for (int k = 1; k < n; ++k) made = made * a;
        return made;
    };
    operator_formula const one, mean = operator_in("(q + sigma[q])/2");
    CHECK(power(mean, 60) == power(power(mean, 10), 6));
    CHECK_FALSE(power(mean, 60) == power(mean, 59) * operator_in("(q + rho[q])/2"));
    CHECK_FALSE(power(mean, 60) == power(mean, 59) * operator_in("(q + 2*sigma[q])/3"));
    CHECK(operator_in("sqrt(2)*sqrt(2)*sigma[q] - 2*sigma[q] + q") == operator_in("0*sigma[q] + q"));
    CHECK(operator_in("(sqrt(2) + sigma)[sqrt(2)*q - sigma[q]]") == operator_in("2*q - sigma[sigma[q]]"));
    CHECK_FALSE(operator_in("sqrt(2)*sigma[q]") == operator_in("1.41421356237309504880168872420969807857*sigma[q]"));
    CHECK_FALSE(operator_in("1e-30*sqrt(2)*sigma[q] + q") == operator_in("0*sigma[q] + q"));
}
TEST_CASE("what is no operator is refused where it stands") {
    auto const says = [](char const* words, char const* what) { CHECK_THROWS_WITH_AS((void)operator_in(words), what, error::unreadable); };
    says("q*q", "the operator, line 1, column 1: an operator is linear in q, and this product is not");
    says("q + 1", "the operator, line 1, column 1: both terms of a sum are made of q, or none is, as in q + sigma[q]");
    says("1/sigma", "the operator, line 1, column 3: an operator is divided by a number");
    says("sigma[2]", "the operator, line 1, column 7: sigma[...] acts on q or on an operator, and here is a number");
    says("(1 + sigma)[2]", "the operator, line 1, column 13: (...)[...] acts on q or on an operator, and here is a number");
    says("(q + sigma[q])[q]", "the operator, line 1, column 1: an operator is linear in q, and this one is not");
    says("(1 + sigma)[q", "the operator, line 1, column 14: ']' was expected, and there is the end");
    CHECK_THROWS_AS((void)operator_in("sqrt((4)[4])*q"), error::unreadable);
    // In formulas of numbers brackets do not act.
    CHECK_THROWS_AS((void)text::read("(q + 1)[0]"), error::unreadable);
    says("sigma(q, q)", "the operator, line 1, column 1: sigma acts on one function, as in sigma[q]");
    says("Delta[q]",
         "the operator, line 1, column 1: 'Delta' has no meaning: there are q, identity, sigma, rho, Delta_plus, Delta_minus and numbers");
    says("(q + sigma[q])^2", "the operator, line 1, column 2: an operator is linear in q, and this power is not");
    for (char const* wrong : {"sigma^(1/2)", "sigma^1.5", "sigma^1e1", "sigma^-1", "sigma^100", "sigma^sigma"})
        CHECK_THROWS_AS((void)operator_in(wrong), error::unreadable);
    CHECK(operator_in("sigma^2") == operator_in("sigma[sigma]"));
    CHECK(operator_in("((1 - sigma)^3)[q]") == operator_in("q - 3*sigma[q] + 3*sigma[sigma[q]] - sigma[sigma[sigma[q]]]"));
    CHECK(operator_in("Delta_plus^0") == operator_formula());
    for (char const* no_number : {"sqrt(-1)*sigma", "log(0)*sigma", "sigma/(1 - 1)", "(1/0)*sigma"}) {
        CAPTURE(no_number);
        CHECK_THROWS_AS((void)(operator_in(no_number) == operator_in("sigma")), error::exception);
        CHECK_THROWS_AS((void)text::operator_in_numbers<double>(operator_in(no_number)), error::exception);
    }
    CHECK_FALSE(operator_in("sqrt(2)*(1 + sigma + sigma^2 + sigma^3) + Delta_plus^3") ==
                operator_in("sqrt(2)*(1 + sigma + sigma^2 + sigma^3) - 5*Delta_plus^3"));
    says("sin(q)", "the operator, line 1, column 5: 'q' has no meaning: there are numbers alone");
    auto const words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"x", "v", 0}});
    CHECK_THROWS_WITH_AS((void)operator_in("x*sigma[q]", words),
                         "the operator, line 1, column 1: a factor is a number, and this one depends on the state; an operator acts on q, "
                         "which stands for every coordinate",
                         error::unreadable);
    CHECK_THROWS_AS((void)text::operator_in_numbers<Q>(operator_in("sqrt(2)*q")), error::unreadable);
    auto dense = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"x", "v", 0}});
    dense->set("rho", "1/4");
    CHECK_THROWS_WITH_AS((void)operator_in("(1 - rho)*q + rho*sigma[q]", dense),
                         "the operator, line 1, column 6: 'rho' is an operator, and a parameter of the problem: one of them needs another "
                         "name, or write rho[q]",
                         error::unreadable);
    CHECK(operator_in("rho[q]", dense) == operator_in("rho"));
    std::string deep = "q";
    for (int k = 0; k < 150; ++k) deep = "2*(q + sigma[" + deep + "])";
    CHECK_THROWS_AS((void)operator_in(deep), error::exception);
}

} // namespace text_operator_tests
