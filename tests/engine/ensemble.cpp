// SPDX-License-Identifier: BSL-1.0
// Ensembles: the same to the last bit whatever the number of threads and whoever else is there, in lanes and alone, with parameters that
// members bring. CI runs this under a sanitizer of what threads share.
#include <doctest/doctest.h>

#include "engine/ensemble/ensemble.hpp"
#include "stated.hpp"

namespace ensemble_tests {

using namespace hilger;
using engine::member;
using engine::second_datum;
using testing::kept_here;
using testing::stated;
using testing::there_is_a_c_compiler;
using vector = Eigen::VectorXd;

namespace {

constexpr index_type steps = 40;
engine::points<double> const T{0, 0.125, steps, {}};

engine::cast cast_of(engine::problem const& what, bool in_lanes) {
    return engine::make_cast(what, "mid-point", T, in_lanes, [](engine::problem const& one) {
        return engine::walker_of(engine::embedded_in_one_step(one, "mid-point", T));
    });
}
engine::ensemble walked(engine::cast const& all, std::vector<member> const& from, int threads, index_type stride = 8) {
    std::atomic<bool> const stop = false;
    std::atomic<index_type> done = 0;
    auto made = engine::walk_all(all, from, stride, threads, stop, done);
    CHECK(done == static_cast<index_type>(from.size()));
    return made;
}
std::vector<member> members(int count) {
    std::vector<member> all;
    for (int m = 0; m < count; ++m) {
        double const x = static_cast<double>(m) / count;
        all.push_back({{vector{{0.25 - x / 2, x / 4}}, second_datum::velocity, vector{{x / 4, 0.125}}}, {1 + x, 1 - x / 4, 2 + x}});
    }
    return all;
}
engine::problem of_members() { return stated("dot(v, v)/2*g - k[0]*q[0]^2/2 - k[1]*q[1]^2/2 - q[0]^2*q[1]", 2, {}, {"g", "k"}); }
bool same(std::vector<double> const& a, std::vector<double> const& b) {
    return a.size() == b.size() and
           std::equal(a.begin(), a.end(), b.begin(), [](double x, double y) { return x == y or (x != x and y != y); });
}

} // namespace

TEST_CASE("threads change nothing") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const from = members(37);
    for (bool const in_lanes : {false, true}) {
        auto const all = cast_of(of_members(), in_lanes);
        CHECK((all.together != nullptr) == in_lanes);
        auto const one = walked(all, from, 1), four = walked(all, from, 4);
        CHECK(one.points == 6);
        CHECK(one.t == std::vector<double>{0, 1, 2, 3, 4, 5});
        CHECK(one.failures == std::vector<std::string>(37));
        CHECK(four.failures == one.failures);
        CHECK(same(one.q, four.q));
        CHECK(same(one.p, four.p));
        auto const few = walked(all, {from.begin() + 3, from.begin() + 5}, 2);
        for (int k = 0; k < 12 * 2; ++k) CHECK(few.q[static_cast<std::size_t>(k)] == one.q[one.place(3, 0) + static_cast<std::size_t>(k)]);
    }
}

TEST_CASE("members with parameters of their own are what they are as problems of their own") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const from = members(5);
    auto const together = walked(cast_of(of_members(), true), from, 2), alone = walked(cast_of(of_members(), false), from, 2);
    for (std::size_t m = 0; m < from.size(); ++m) {
        auto const fixed = engine::with_words(of_members(), of_members().lagrangian.formula().words().with(from[m].parameters));
        auto const own = walked(cast_of(fixed, false), {from[m]}, 1);
        for (std::size_t k = 0; k < own.q.size(); ++k) {
            auto const at = alone.place(static_cast<index_type>(m), 0) + k;
            CHECK(alone.q[at] == own.q[k]);
            CHECK(std::abs(together.q[at] - own.q[k]) <= 16 * steps * epsilon<double>());
            CHECK(std::abs(together.p[at] - own.p[k]) <= 16 * steps * epsilon<double>() * 2);
        }
    }
}

TEST_CASE("momenta and next positions begin what velocities begin") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const all = cast_of(of_members(), true);
    auto const from = members(11);
    auto const made = walked(all, from, 2, 1);
    auto again = from;
    for (std::size_t m = 0; m < from.size(); ++m) {
        auto const at = made.place(static_cast<index_type>(m), m % 2 == 0 ? 0 : 1);
        auto const& numbers = m % 2 == 0 ? made.p : made.q;
        again[m].from.is = m % 2 == 0 ? second_datum::momentum : second_datum::next_position;
        again[m].from.other = vector{{numbers[at], numbers[at + 1]}};
    }
    auto const other = walked(all, again, 1, 1);
    for (std::size_t k = 0; k < made.q.size(); ++k) CHECK(std::abs(made.q[k] - other.q[k]) <= 64 * steps * epsilon<double>());
}

TEST_CASE("who fails is told, and what is stopped keeps what there is") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const what = stated("v[0]^2/2 + q[0]^4", 1);
    std::vector<member> from;
    for (int m = 0; m < 10; ++m)
        from.push_back({{vector::Constant(1, m == 4 ? 30 : 0.0078125 * m), second_datum::velocity, vector::Zero(1)}, {}});
    for (bool const in_lanes : {false, true}) {
        auto const all = cast_of(what, in_lanes);
        auto const made = walked(all, from, 3);
        for (std::size_t m = 0; m < from.size(); ++m) CHECK(made.failures[m].empty() == (m != 4));
        CHECK(made.failures[4].find("the step from t = ") == 0);
        CHECK(made.q[made.place(4, 0)] == 30);
        CHECK(std::isnan(made.q[made.place(4, made.points - 1)]));
        std::atomic<bool> const stop = true;
        std::atomic<index_type> done = 0;
        auto const stopped = engine::walk_all(all, from, 8, 2, stop, done);
        for (auto const& why : stopped.failures) CHECK(why == "interrupted");
        CHECK(std::isnan(stopped.q[stopped.place(2, stopped.points - 1)]));
        CHECK_THROWS_AS(engine::walk_all(all, from, 0, 1, stop, done), error::invalid_parameter);
        CHECK_THROWS_AS(engine::walk_all(all, from, 1, 0, stop, done), error::invalid_parameter);
    }
}

} // namespace ensemble_tests
