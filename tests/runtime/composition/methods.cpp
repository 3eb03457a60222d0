// SPDX-License-Identifier: BSL-1.0
// The parts of a step for orders 4, 6 and 8: they satisfy every order condition to the scalar's digits, and mid-point and Stoermer-Verlet
// over them have that order, preserve area and are their own adjoints.
#include <cmath>
#include <map>
#include <string>

#include <doctest/doctest.h>

#include "hilger/composition/methods.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/orders.hpp"
#include "support/systems.hpp"
#include "support/three_problems.hpp"

namespace composition_methods_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// A step of order one is exp(Y_1 + Y_2 + Y_3 + ...), its adjoint exp(Y_1 - Y_2 + Y_3 - ...), and a symmetric step has odd terms alone.
enum class steps_are { symmetric, of_adjoint_and_flow };

/// A product of Y_1, Y_2, Y_3, ... as a word of their numbers; its degree is their sum.
int degree(std::string const& word) {
    int sum = 0;
    for (char const letter : word) sum += letter - '0';
    return sum;
}
void words_up_to(int most, steps_are kind, std::string const& word, std::vector<std::string>& all) {
    all.push_back(word);
    for (char letter = '1'; degree(word) + (letter - '0') <= most;
         letter = static_cast<char>(letter + (kind == steps_are::symmetric ? 2 : 1)))
        words_up_to(most, kind, word + letter, all);
}
template <class S>
S over_factorial(S x, std::size_t n) {
    for (std::size_t k = 2; k <= n; ++k) x /= static_cast<int>(k);
    return x;
}

/// The largest distance of a coefficient in prod_k exp(sum_n (+-1)^(n+1) c_k^n Y_n) from that in exp(Y_1), over the words of the given
/// degrees.
template <class S, class Parts>
S order_error(Parts const& parts, int first, int last, steps_are kind = steps_are::symmetric) {
    std::vector<std::string> words;
    words_up_to(last, kind, "", words);
    std::map<std::string, S> product;
    for (auto const& word : words) product[word] = word.empty() ? S(1) : S(0);
    bool adjoint = kind == steps_are::of_adjoint_and_flow;
    for (S const& c : parts.template values<S>()) {
        auto const power = [&](std::string const& word) {
            S const x = pow(c, degree(word));
            return adjoint and (degree(word) - static_cast<int>(word.size())) % 2 == 1 ? S(-x) : x;
        };
        std::map<std::string, S> next;
        for (auto const& word : words)
            for (std::size_t k = 0; k <= word.size(); ++k)
                next[word] += product[word.substr(0, k)] * over_factorial(power(word.substr(k)), word.size() - k);
        product = next;
        if (kind == steps_are::of_adjoint_and_flow) adjoint = not adjoint;
    }
    S most(0);
    for (auto const& word : words) {
        if (degree(word) < first) continue;
        S const wanted = word.find_first_not_of('1') == std::string::npos ? over_factorial(S(1), word.size()) : S(0);
        S const rest = abs(product[word] - wanted);
        if (most < rest) most = rest;
    }
    return most;
}
template <class S, class Parts>
void has_order(Parts const& parts, int order, steps_are kind = steps_are::symmetric) {
    CHECK(order_error<S>(parts, 0, order, kind) < S(1000) * epsilon<S>());
    CHECK(order_error<S>(parts, order + 1, order + 1, kind) > S(1) / S(1'000'000));
    auto const c = parts.template values<S>();
    for (std::size_t k = 0; k < c.size(); ++k) CHECK(c[k] == c[c.size() - 1 - k]);
}

} // namespace

TEST_CASE("the order conditions hold in 16, 50 and 100 digits, and those of the next order do not") {
    has_order<float50>(triple_jump<4>, 4);
    has_order<float50>(suzuki<4>, 4);
    has_order<float50>(yoshida<6>, 6);
    has_order<float50>(kahan_li<6>, 6);
    has_order<float50>(suzuki_umeno<8>, 8);
    has_order<float50>(kahan_li<8>, 8);
    has_order<float50>(blanes_moan<4>, 4, steps_are::of_adjoint_and_flow);
    CHECK(order_error<float100>(blanes_moan<4>, 0, 4, steps_are::of_adjoint_and_flow) < 1000 * epsilon<float100>());
    CHECK(order_error<double>(kahan_li<8>, 0, 8) < 1000 * epsilon<double>());
    CHECK(order_error<float100>(suzuki<4>, 0, 4) < 1000 * epsilon<float100>());
    CHECK(order_error<float100>(yoshida<6>, 0, 6) < 1000 * epsilon<float100>());
    CHECK(order_error<float100>(kahan_li<6>, 0, 6) < 1000 * epsilon<float100>());
    CHECK(order_error<float100>(suzuki_umeno<8>, 0, 8) < 1000 * epsilon<float100>());
    CHECK(order_error<float100>(kahan_li<8>, 0, 8) < 1000 * epsilon<float100>());
}

TEST_CASE("the parts are the published ones") {
    auto const first = [](auto const& parts) { return parts.template values<double>()[0]; };
    CHECK(std::abs(first(triple_jump<4>) - 1.3512071919596578) <= 2 * epsilon<double>()); // Yoshida 1990, (4.1)
    CHECK(std::abs(first(suzuki<4>) - 0.4144907717943757) <= epsilon<double>());
    CHECK(first(yoshida<6>) == 0.78451361047755726381949763);
    CHECK(first(kahan_li<6>) == 0.39216144400731413927925056);
    CHECK(first(suzuki_umeno<8>) == 0.74167036435061295344822780);
    CHECK(first(kahan_li<8>) == 0.13020248308889008087881763);
    CHECK(std::abs(suzuki_umeno<8>.values<double>()[7] + 0.79688793935291635401978884) <= epsilon<double>());
    CHECK(std::abs(kahan_li<8>.values<double>()[8] + 0.60550853383003451169892108) <= epsilon<double>());
    CHECK(std::abs(blanes_moan<4>.values<double>()[11] - 0.0792036964311957) <= epsilon<double>()); // a_1; b_2 = c_3 + c_4
    CHECK(std::abs(blanes_moan<4>.values<double>()[2] + blanes_moan<4>.values<double>()[3] + 0.143851773179818) <= 1e-15);
    float50 const c = kahan_li<6>.values<float50>()[0];
    CHECK(abs(c - float50("0.39216144400731413927925056")) <= epsilon<float50>());
}

TEST_CASE("orders on a linear, a nonlinear and a non-separable problem, fitted in 50 digits") {
    for (auto const kind : three_problems) {
        CAPTURE(static_cast<int>(kind));
        auto const m = embed(problem_of(kind), mid_point);
        auto const v = stoermer_verlet(problem_of(kind));
        float50 const reference = at_one(compose(kahan_li<8>, m), 200).q;
        auto const check = [&](auto const& flow, int order, int steps) {
            CAPTURE(order);
            double const found = fitted_order(flow, steps, reference);
            CHECK(found > order - 0.02);
            CHECK(found < order + 0.02);
        };
        check(v, 2, 40);
        check(compose_with_adjoint(blanes_moan<4>, embed(problem_of(kind), order_one)), 4, 40);
        check(compose_with_adjoint(blanes_moan<4>, embed(problem_of(kind), theta<1, 3>)), 4, 40);
        check(compose(suzuki<4>, m), 4, 40);
        check(compose(triple_jump<4>, v), 4, 60);
        check(compose(yoshida<6>, m), 6, 40);
        check(compose(kahan_li<6>, v), 6, 40);
        check(compose(suzuki_umeno<8>, m), 8, 25);
        check(compose(kahan_li<8>, m), 8, 25);
    }
}

TEST_CASE("they preserve area and are their own adjoints") {
    float50 const h = float50(1) / 10, e("1e-15"), q(1), p = float50(1) / 2;
    auto const f = compose(suzuki_umeno<8>, embed(bead, mid_point));
    auto const step = [&](float50 const& x, float50 const& y) { return f.step(state<float50, float50>{0, x, y}, h); };
    auto const a = step(q + e, p), b = step(q - e, p), c = step(q, p + e), d = step(q, p - e);
    float50 const det = (a.q - b.q) * (c.p - d.p) - (c.q - d.q) * (a.p - b.p);
    CHECK(abs(det / (4 * e * e) - 1) < float50("1e-27")); // the differences' own error is 1e-30
    auto const back = f.step(step(q, p), float50(-h));
    CHECK(abs(back.q - q) + abs(back.p - p) < 1000 * epsilon<float50>());
    auto const there = adjoint(f).step(state<float50, float50>{0, q, p}, h);
    CHECK(abs(there.q - step(q, p).q) + abs(there.p - step(q, p).p) < 1000 * epsilon<float50>());
}

} // namespace composition_methods_tests
