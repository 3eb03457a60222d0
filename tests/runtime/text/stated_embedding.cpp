// SPDX-License-Identifier: BSL-1.0
// Embeddings in text: their steps, their equation and what it prints are those of the same embedding in types; random ones leave nothing of
// their own equation, exactly in rationals.
#include <doctest/doctest.h>

#include <random>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/embedding.hpp"
#include "hilger/text/lagrangian.hpp"
#include "support/orders.hpp"

namespace stated_embedding_tests {

using namespace hilger;
using text::embedding_in;
using text::with_embedding;

namespace {

/// Rational, and its equation is linear in the new position: steps in rationals are exact.
auto const springs = [](auto const& q, auto const& v) {
    using R = plain_t<decltype(q(0) * v(0))>;
    return R((v(0) * v(0) + v(1) * v(1) / 3) / 2 + v(0) * q(1) / 5 - (q(0) * q(0) + q(0) * q(1) + q(1) * q(1)) / 4 + q(0) / 7);
};
template <class S>
using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

template <class EL>
std::string printed(EL const& equation) {
    std::ostringstream out;
    out << equation << hamiltonian_form(equation) << latex(equation);
    return out.str();
}
/// Exactly the steps of a typed embedding, with nothing left of either's equation.
template <class Scale, class Typed>
void check_steps(char const* words, Scale const& T, Typed const& typed) {
    CAPTURE(words);
    with_embedding<Q>(embedding_in(words), Scale::is_uniform, [&](auto const& how) {
        vector<Q> const q{{Q(1, 2), Q(-1, 3)}}, p{{Q(1), Q(1, 5)}};
        auto const mine = embed(springs, how).along(T, q, p);
        auto const there = embed(springs, typed).along(T, q, p);
        CHECK(record(mine).states == record(there).states);
        CHECK(largest_residual(mine) == 0);
        vector<Q> const near{{Q(2, 3), Q(0)}};
        auto const from_two = embed(springs, how).along(T, initial_positions<vector<Q>>{q, near});
        CHECK(record(from_two).states == record(embed(springs, typed).along(T, initial_positions<vector<Q>>{q, near})).states);
    });
}
/// What is printed, derived and judged is what the same operators in types make.
template <class Scale, class Typed>
void check_equation(char const* words, Scale const& T, Typed const& typed) {
    CAPTURE(words);
    with_embedding<Q>(embedding_in(words), Scale::is_uniform, [&](auto const& how) {
        auto const mine = equation_of(embed(springs, how), T);
        auto const there = equation_of(embed(springs, typed), T);
        CHECK(printed(mine) == printed(there));
        auto const x = function_on(T, [](Q const& t) { return vector<Q>{{t * t, Q(1) - t}}; });
        auto const r = mine.residual(x);
        auto const s = there.residual(x);
        using R = typename decltype(r)::domain_type;
        using D = typename decltype(s)::domain_type;
        REQUIRE((R::front == D::front and R::back == D::back));
        for (index_type i = R::front; i < T.size() - R::back; ++i) CHECK(vector<Q>(r.get(i)) == vector<Q>(s.get(i)));
    });
}

} // namespace

TEST_CASE("steps in rationals are those of the same embedding in types") {
    auto const on = [](auto const& T) {
        check_steps("integral(L(q, Delta_plus[q]))", T, order_one);
        check_steps("nabla_integral(L(q, Delta_minus[q]))", T, order_one_left);
        check_steps("integral(L((q + sigma[q])/2, Delta_plus[q]))", T, mid_point);
        check_steps("nabla_integral(L((q + rho[q])/2, rho[Delta_plus[q]]))", T, mid_point);
        check_steps("integral(L(q/3 + 2/3*sigma[q], Delta_plus[q]))", T, theta<2, 3>);
        check_steps("integral(L(sigma[q], Delta_plus[q]))", T, order_one_left);
    };
    on(uniform(Q(0), Q(1, 4), 5));
    on(time_scale<Q>({0, Q(1, 3), Q(1, 2), Q(4, 5), Q(1)}));
}

TEST_CASE("the equation is that of the same operators in types, printed and judged") {
    auto const on = [](auto const& T) {
        check_equation("integral(L(q, Delta_plus[q]))", T, order_one);
        check_equation("nabla_integral(L(q, Delta_minus[q]))", T, order_one_left);
        check_equation("integral(L((q + sigma[q])/2, Delta_plus[q]))", T,
                       make_embedding<delta_weight>(fraction<1, 2>{} * (identity_T + sigma), Delta_plus, "mean"));
        check_equation("integral(L(q/3 + 2/3*sigma[q], Delta_plus[q]))", T,
                       make_embedding<delta_weight>(fraction<1, 3>{} * identity_T + fraction<2, 3>{} * sigma, Delta_plus, "third"));
    };
    on(uniform(Q(0), Q(1, 4), 5));
    on(time_scale<Q>({0, Q(1, 3), Q(1, 2), Q(4, 5), Q(1)}));
}
TEST_CASE("random embeddings leave nothing of their equation, and are numbers between the ends of a step") {
    std::mt19937_64 random(3);
    auto const fraction_of = [&] {
        std::string n = std::to_string(static_cast<int>(random() % 23) - 11);
        return n + "/" + std::to_string(random() % 9 + 1);
    };
    time_scale<Q> const T({0, Q(1, 3), Q(1, 2), Q(4, 5)});
    vector<Q> const q{{Q(1, 2), Q(-1, 3)}}, p{{Q(1), Q(1, 5)}};
    int whole = 0;
    for (int seed = 0; seed < 40; ++seed) {
        std::string const c = "(" + fraction_of() + ")", d = "(" + fraction_of() + ")";
        bool const nabla = random() % 2 == 0;
        std::string const words =
            nabla ? "nabla_integral(L(" + c + "*q + (1 - " + c + ")*rho[q], (" + d + " + 1)*Delta_minus[q] - " + d + "*rho[Delta_plus[q]]))"
                  : "integral(L(q + " + c + "*(sigma - 1)*q, " + d + "*Delta_plus[q] + (1 - " + d + ")*Delta_plus[q]))";
        CAPTURE(words);
        auto const how = embedding_in(words);
        auto const lambda = text::lambda_of_step<Q>(how);
        with_embedding<Q>(how, false, [&](auto const& e) {
            auto const path = embed(springs, e).along(T, q, p);
            auto const here = record(path, keep_partial);
            auto const there = record(embed(springs, text::embedding_at(lambda)).along(T, q, p), keep_partial);
            CHECK(here.states == there.states);
            if (here.stopped) return; // where 1/lambda meets the springs
            CHECK(largest_residual(path) == 0);
            ++whole;
        });
    }
    CHECK(whole > 30);
}
TEST_CASE("a derivative in the position makes another mean of the ends for each length of the step") {
    auto const how = embedding_in("integral(L(q + Delta_plus[q]/20, Delta_plus[q]))");
    CHECK(text::depends_on_step(how));
    CHECK(text::lambda_of_step<Q>(how, Q(1, 10)) == Q(1, 2));
    CHECK(text::lambda_of_step<Q>(how, Q(1, 5)) == Q(1, 4));
    CHECK(text::lambda_of_step<double>(how, 0.1) == 0.5);
    CHECK_THROWS_AS((void)text::lambda_of_step<Q>(how), error::invalid_parameter);
    auto const irrational = embedding_in("integral(L(q + sqrt(2)*Delta_plus[q]/20, Delta_plus[q]))");
    CHECK(text::depends_on_step(irrational));
    CHECK(abs(text::lambda_of_step<float50>(irrational, float50(1)) - sqrt(float50(2)) / 20) < 1e-49);
    for (char const* words :
         {"integral(L(q + Delta_plus[q] - Delta_plus[q], Delta_plus[q]))", "integral(L((q + sigma[q])/2, Delta_plus[q]))",
          "integral(L(q + sqrt(2)*Delta_plus[q] - sqrt(2)*Delta_plus[q], Delta_plus[q]))",
          "nabla_integral(L(rho[q]/3 + 2/3*q, Delta_minus[q]))"}) {
        CAPTURE(words);
        CHECK_FALSE(text::depends_on_step(embedding_in(words)));
    }
    // consistent in steps of length 7919 alone
    CHECK_THROWS_AS((void)text::lambda_of_step<Q>(embedding_in("integral(L(q, (sigma[q] - q)/7919))"), Q(1)), error::invalid_parameter);
}
TEST_CASE("orders by a fit, of operators in text") {
    auto const pendulum = [](auto const& q, auto const& v) {
        using std::cos;
        return v * v / 2 + cos(q);
    };
    auto const reference = testing::at_one(embed(pendulum, galerkin<8, gauss>), 40).q;
    for (auto const& [words, order] : {std::pair{"integral(L((q + sigma[q])/2, Delta_plus[q]))", 2.0},
                                       std::pair{"integral(L((1/2 - sqrt(3)/6)*q + (1/2 + sqrt(3)/6)*sigma[q], Delta_plus[q]))", 1.0}})
        with_embedding<float50>(embedding_in(words), true, [&, o = order](auto const& how) {
            CHECK(std::abs(testing::fitted_order(embed(pendulum, how), 400, reference) - o) < 0.02);
        });
}
TEST_CASE("what cannot be stepped is refused in one sentence") {
    auto const refused = [](char const* words, char const* what) {
        CHECK_THROWS_WITH_AS(text::require_one_step(embedding_in(words)), what, error::invalid_parameter);
    };
    refused("integral(L(q, q))", "an embedding reads both ends of a step, and integral(L(q, q)) reads the points of T alone");
    refused("integral(L(q, (Delta_plus[q] + Delta_minus[q])/2))",
            "position and velocity of an embedding read the two ends of one step, and those of integral(L(q, (Delta_plus[q] + "
            "Delta_minus[q])/2)) reach further: of T they lose 1 points at the beginning and 1 at the end");
    refused("integral(L(q, Delta_minus[q]))",
            "what reads rho(t) and t is summed by nabla_integral(L(...)), and what reads t and sigma(t) by "
            "integral(L(...)): integral(L(q, Delta_minus[q])) has the other one");
    // on a uniform scale it is q, and in a scale of one step 0
    refused("integral(L(nu_over_mu[q], Delta_plus[q]))",
            "position and velocity of an embedding read one step, and mu/nu in integral(L(nu_over_mu[q], Delta_plus[q])) is of two");
    refused("nabla_integral(L(q, Delta_minus[q + mu_over_nu[q] - mu_over_nu[q]]))",
            "position and velocity of an embedding read one step, and mu/nu in nabla_integral(L(q, Delta_minus[q + mu_over_nu[q] - "
            "mu_over_nu[q]])) is of two");
    refused("integral(L(2*q, Delta_plus[q]))", "the position of an embedding makes 1 of the constant 1, and that of integral(L(2*q, "
                                               "Delta_plus[q])) not, so that its steps would follow another system");
    refused("integral(L(q, Delta_plus[q] + q))",
            "the velocity of an embedding makes 0 of the constant 1, and that of integral(L(q, Delta_plus[q] "
            "+ q)) not, so that its steps would follow another system");
    refused("integral(L(q, 3*Delta_plus[q]))", "the velocity of an embedding makes 1 of the function t, and that of integral(L(q, "
                                               "3*Delta_plus[q])) not, so that its steps would follow another system");
    // Digits of doubles, whose sum is 1 but for rounding: right in double, and not exactly.
    auto const rounded = embedding_in("integral(L(0.7*q + 0.30000000000000004*sigma[q], Delta_plus[q]))");
    CHECK(text::lambda_of_step<double>(rounded) == 0.30000000000000004);
    CHECK_THROWS_AS((void)text::lambda_of_step<Q>(rounded), error::invalid_parameter);
    CHECK_THROWS_AS((void)text::lambda_of_step<double>(embedding_in("integral(L(0.7*q + 0.30000000000001*sigma[q], Delta_plus[q]))")),
                    error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)embedding_in("integral(L(q/0, Delta_plus[q]))"),
                         "the embedding, line 1, column 14: an operator is divided by 0", error::unreadable);
    CHECK_THROWS_WITH_AS((void)text::operator_in_numbers<Q>(text::operator_in("q/(1 - 1)")), "the operator: a division by zero",
                         error::unreadable);
    CHECK_NOTHROW(text::require_one_step(embedding_in("integral(L(sqrt(2)*q + (1 - sqrt(2))*sigma[q], Delta_plus[q]))")));
    refused("integral(L(sqrt(2)*q, Delta_plus[q]))",
            "the position of an embedding makes 1 of the constant 1, and that of integral(L(sqrt(2)*q, "
            "Delta_plus[q])) not, so that its steps would follow another system");
    CHECK_THROWS_WITH_AS((void)embedding_in("L(q, Delta_plus[q])"),
                         "the embedding, line 1, column 1: an embedding is written integral(L(A, B)) or nabla_integral(L(A, B))",
                         error::unreadable);
    CHECK_THROWS_WITH_AS((void)embedding_in("integral(L(q))"),
                         "the embedding, line 1, column 1: what is integrated is L(A, B), a position and a velocity made of q, as in "
                         "integral(L(q, Delta_plus[q]))",
                         error::unreadable);
    auto words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 0}});
    words->set("lam", "2/3");
    CHECK(text::lambda_of_step<Q>(embedding_in("integral(L((1 - lam)*q + lam*sigma[q], Delta_plus[q]))", words)) == Q(2, 3));
}

} // namespace stated_embedding_tests
