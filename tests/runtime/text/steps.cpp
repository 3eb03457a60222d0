// SPDX-License-Identifier: BSL-1.0
// What is stepped of a formula in text is what is stepped of the same formula in C++: random Lagrangians, rational in t, q and v, with and
// without branches, in rationals and in double; the equation is the judge.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/embedding.hpp"
#include "hilger/text/formula.hpp"
#include "hilger/text/lagrangian.hpp"
#include "support/random_lagrangian.hpp"

namespace text_steps_tests {

using namespace hilger;
using testing::in_text;
using testing::random_potential;
using testing::typed;

namespace {

template <class S>
using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

/// The states along a path, as far as it gets, and why it stops.
template <class Path>
auto walked(Path const& path) {
    return record(path, keep_partial);
}

} // namespace

/// Operators on which equations are explicit, as order one: the position is an end of the step.
std::string explicit_embedding(unsigned seed) {
    std::string const c = "(" + std::to_string(static_cast<int>(seed % 11) - 5) + "/7)";
    return seed % 2 == 0 ? "integral(L((1 - " + c + ")*q + " + c + "*q, Delta_plus[q]))"
                         : "nabla_integral(L(q, " + c + "*rho[Delta_plus[q]] + (1 - " + c + ")*Delta_minus[q]))";
}

TEST_CASE("explicit steps in rationals under operators in text are those of the same formula in C++ under order one") {
    int whole = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        random_potential const U(seed);
        CAPTURE(U.text());
        auto const T = uniform(Q(1, 3), Q(1, 8), 2);
        vector<Q> const q{{Q(1, 2), Q(-2, 3)}}, p{{Q(1, 5), Q(1)}};
        auto const compare = [&](auto const& path, auto const& in_types) {
            auto const here = walked(path), there = walked(in_types);
            REQUIRE(here.stopped == there.stopped);
            REQUIRE(here.states.size() == there.states.size());
            for (std::size_t i = 0; i < here.states.size(); ++i) CHECK(here.states[i] == there.states[i]);
            if (here.stopped) return;
            ++whole;
            CHECK(largest_residual(path) == 0);
        };
        auto const how = text::embedding_in(explicit_embedding(seed));
        CAPTURE(how.text);
        text::with_embedding<Q>(how, seed % 4 < 2, [&](auto const& e) {
            auto const path = embed(lagrangian{in_text(U)}, e).along(T, q, p);
            if (how.weight == text::sum_weight::delta)
                compare(path, embed(lagrangian{typed{&U}}, order_one).along(T, q, p));
            else
                compare(path, embed(lagrangian{typed{&U}}, order_one_left).along(T, q, p));
        });
    }
    CHECK(whole > 100);
}
TEST_CASE("mid-point steps in double are those of the same formula in C++") {
    int whole = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        random_potential const U(seed);
        CAPTURE(U.text());
        auto const T = uniform(0.25, 0.03125, 20);
        vector<double> const q{{0.5, -0.75}}, p{{0.25, 1.0}};
        auto const here = walked(embed(lagrangian{in_text(U)}, mid_point).along(T, q, p)),
                   there = walked(embed(lagrangian{typed{&U}}, mid_point).along(T, q, p));
        REQUIRE(here.stopped.has_value() == there.stopped.has_value());
        REQUIRE(here.states.size() == there.states.size());
        for (std::size_t i = 0; i < here.states.size(); ++i) {
            // n/10 is rounded once in both, and a formula traced from either has the same operations
            CHECK(here.states[i].q == there.states[i].q);
            CHECK(here.states[i].p == there.states[i].p);
        }
        whole += not here.stopped;
    }
    CHECK(whole > 100);
}
TEST_CASE("forces, the time, and what is printed") {
    auto words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 2}});
    words->set("k", "1/4");
    auto const L = text::lagrangian_in("dot(v, v)/2 - k*dot(q, q) + q[0]*t", words);
    text::stated_force const f({text::stated(text::read("-v[0]/8"), words, "f"), text::stated(text::read("q[0]*v[1]"), words, "f")});
    auto const path = embed(with_force(lagrangian{L}, f), order_one).along(uniform(Q(0), Q(1, 4), 6), vector<Q>{{1, 2}}, vector<Q>{{0, 1}});
    auto const by_hand = [](auto const& t, auto const& q, auto const& v) {
        using R = plain_t<decltype(q(0) * v(0))>;
        return R((v(0) * v(0) + v(1) * v(1)) / 2 - (q(0) * q(0) + q(1) * q(1)) / 4 + q(0) * t);
    };
    auto const pull = [](auto const&, auto const& q, auto const& v) {
        Eigen::Matrix<plain_t<decltype(q(0) * v(0))>, Eigen::Dynamic, 1> made(2);
        made(0) = -v(0) / 8;
        made(1) = q(0) * v(1);
        return made;
    };
    auto const typed_path =
        embed(with_force(by_hand, pull), order_one).along(uniform(Q(0), Q(1, 4), 6), vector<Q>{{1, 2}}, vector<Q>{{0, 1}});
    CHECK(record(path).states == record(typed_path).states);
    CHECK(largest_residual(path) == 0);

    std::ostringstream out;
    out << formula_of(L.formula(), {{"q", "v", 2}}, "t");
    CHECK(out.str() == "(v₀² + v₁²)/2 − 0.25·(q₀² + q₁²) + q₀·t");
    CHECK(L.formula().reads(text::meaning::role::time));
    auto const flow = embed(lagrangian{L}, mid_point);
    auto const T = uniform(Q(0), Q(1), 2);
    CHECK_THROWS_AS((void)flow.along(T, initial_velocity<vector<Q>>{vector<Q>{{1, 2}}, vector<Q>{{1}}}), error::mismatch);
    CHECK_THROWS_AS((void)flow.along(T, initial_velocity<vector<Q>>{vector<Q>{{1, 2}}, vector<Q>{{1, 2, 3}}}), error::mismatch);
    CHECK_THROWS_AS((void)flow.along(T, initial_positions<vector<Q>>{vector<Q>{{1, 2}}, vector<Q>{{1}}}), error::mismatch);
    auto const longer = embed(lagrangian{L}, order_one).along(uniform(Q(0), Q(1), 2), vector<Q>{{1, 2, 3}}, vector<Q>{{0, 1, 2}});
    CHECK_THROWS_WITH_AS((void)record(longer), "L has 2 coordinates, and the state has 3", error::mismatch);
    CHECK_THROWS_AS(text::stated_force({text::stated(text::read("1"), words, "f")}), error::mismatch);
}
TEST_CASE("numbers write down how a formula compares them, as jets do") {
    auto words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 1}});
    auto const in_text = text::lagrangian_in("if(q[0] < 1, max(q[0], 0), abs(q[0] - 3)) + min(v[0], 2)", words);
    auto const by_hand = [](auto const& q, auto const& v) {
        using std::abs;
        using T = plain_t<decltype(q(0))>;
        auto const least = [](T const& x, T const& y) { return x <= y ? x : y < x ? y : x; };
        auto const most = [](T const& x, T const& y) { return y <= x ? x : x < y ? y : x; };
        T const of_position = q(0) < T(1) ? most(q(0), T(0)) : abs(T(q(0) - 3)); // compared first, as in the text
        return T(of_position + least(v(0), T(2)));
    };
    for (double const x : {-1.0, 0.5, 2.0, 5.0})
        for (double const y : {1.0, 4.0}) {
            CAPTURE(x);
            CAPTURE(y);
            auto const q = detail::in_constants(Eigen::VectorXd{{x}}), v = detail::in_constants(Eigen::VectorXd{{y}});
            detail::branch_watch const here;
            auto const value = in_text(0.0, q, v);
            auto const path = here.path();
            detail::branch_watch const there;
            CHECK(value.value == by_hand(q, v).value);
            CHECK(path == there.path());
            CHECK(path.made >= 2);
        }
}

} // namespace text_steps_tests
