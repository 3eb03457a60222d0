// SPDX-License-Identifier: BSL-1.0
// What a history of stages refuses, and how it goes on from a checkpoint.
#include <doctest/doctest.h>

#include <cmath>
#include <limits>

#include "hilger/embedding/collocation.hpp"
#include "hilger/history/stages.hpp"
#include "histories.hpp"

namespace history_stage_errors_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
stage_history<double> made(double alpha = 0.5, double tolerance = 1e-8, double longest = 2, double shortest = 0.125) {
    return {collocation<double, radau>(2), alpha, tolerance, longest, shortest, 0.0};
}
struct writer {
    std::vector<double> numbers;
    template <class X>
    void operator()(char const*, X& x) {
        numbers.push_back(static_cast<double>(x));
    }
};
struct reader {
    std::vector<double> const& numbers;
    std::size_t next = 0;
    template <class X>
    void operator()(char const*, X& x) {
        x = static_cast<X>(numbers.at(next++));
    }
};
} // namespace

TEST_CASE("parameters out of range, each with its sentence") {
    CHECK_THROWS_WITH_AS((void)made(-0.5), "a history of stages has an order from 0 to 2, not -0.5", error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)made(2.5), "a history of stages has an order from 0 to 2, not 2.5", error::invalid_parameter);
    CHECK_THROWS_AS((void)made(std::nan("")), error::invalid_parameter);
    CHECK_THROWS_WITH_AS(
        (void)made(0.5, 1e-15),
        "the tolerance of a history of stages is between 7.105427357601002e-15 (32 epsilon of the scalar) and 1/10, not 1e-15",
        error::invalid_parameter);
    CHECK_THROWS_AS((void)made(0.5, 0.5), error::invalid_parameter);
    CHECK_THROWS_AS((void)made(0.5, std::nan("")), error::invalid_parameter);
    char const* const lengths = "a history of stages is made for steps above 0 and a time that is not below them, not for ";
    CHECK_THROWS_WITH_AS((void)made(0.5, 1e-8, 1, 2), (std::string(lengths) + "2 and 1").c_str(), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)made(0.5, 1e-8, 1, 0), (std::string(lengths) + "0 and 1").c_str(), error::invalid_parameter);
    CHECK_THROWS_AS((void)made(0.5, 1e-8, 1, 1e-300), error::invalid_parameter);
    CHECK_THROWS_AS((void)made(0.5, 1e-8, std::numeric_limits<double>::infinity(), 1), error::invalid_parameter);
    CHECK_THROWS_AS((void)stage_history<double>(collocation<double, gauss>(2), 0.5, 1e-8, 2.0, 0.125, 0.0), error::invalid_parameter);
    CHECK_NOTHROW((void)made(0.5, 32 * epsilon<double>(), 1e6, 1.0));
}

TEST_CASE("steps too short and times too long are refused with their numbers, and nothing has changed") {
    auto history = made();
    std::vector<double> const F{1, 2};
    CHECK_THROWS_WITH_AS(history.push(F), "step 0 of a history of stages has not begun, and is given its values", error::mismatch);
    CHECK_THROWS_WITH_AS(history.begin(0.0625),
                         "this history of stages was made for steps of 0.125 and longer, and step 0 has the length 0.0625",
                         error::outside_domain);
    CHECK_THROWS_AS(history.begin(std::nan("")), error::outside_domain);
    history.begin(1.0);
    history.push(F);
    CHECK_THROWS_WITH_AS(history.push(F), "step 1 of a history of stages has not begun, and is given its values", error::mismatch);
    CHECK_THROWS_WITH_AS(history.begin(1.25), "this history of stages was made for a time of 2, and step 1 ends at 2.25",
                         error::outside_domain);
    history.begin(1.0 + 1e-9); // points of T are rounded
    double const before = history.past(1);
    CHECK_THROWS_WITH_AS(history.push(std::span(F.data(), 1)), "step 1 of a history of stages has 2 values, not 1", error::mismatch);
    CHECK_THROWS_WITH_AS(history.push(std::vector<double>{1, std::nan("")}), "value 1 of a history is not finite", error::not_finite);
    CHECK(history.count() == 1);
    history.begin(1.0 + 1e-9);
    CHECK(history.past(1) == before);
}

TEST_CASE("values of another size are refused") {
    stage_history<Eigen::VectorXd> history(collocation<double, radau>(1), 0.5, 1e-8, 2.0, 0.5, Eigen::VectorXd::Zero(3));
    history.begin(1);
    std::vector<Eigen::VectorXd> const two{Eigen::VectorXd::Ones(2)};
    CHECK_THROWS_WITH_AS(history.push(two), "value 0 of a history has 2 components, the history was made for 3", error::mismatch);
}

TEST_CASE("from a checkpoint, within a step too, everything goes on bit for bit, and after reset() from the beginning") {
    for (double const alpha : {0.5, 1.0, 1.5, 2.0}) {
        CAPTURE(alpha);
        auto history = made(alpha);
        noise source;
        auto const walk = [](auto& h, noise numbers, int first, int last) {
            std::vector<double> pasts;
            for (int n = first; n < last; ++n) {
                h.begin(n % 2 == 0 ? 0.125 : 0.25);
                pasts.insert(pasts.end(), {h.past(0), h.past(1), h.leading()(0, 1)});
                h.push(std::vector<double>{numbers.next<double>(), numbers.next<double>()});
            }
            return pasts;
        };
        auto const first = walk(history, source, 0, 5);
        writer between;
        history.visit(between);
        history.begin(0.25);
        writer within;
        history.visit(within);
        auto restored = made(alpha), restored_within = made(alpha);
        reader from_between{between.numbers}, from_within{within.numbers};
        restored.visit(from_between);
        restored_within.visit(from_within);
        CHECK(restored.count() == 5);
        CHECK_THROWS_AS(restored.begin(2.0), error::outside_domain); // the time is known too
        CHECK(restored_within.past(0) == history.past(0));
        std::vector<double> const F{1, -2};
        restored_within.push(F); // which is in the step already
        history.push(F);
        restored.begin(0.25);
        restored.push(F);
        auto const expected = walk(history, source, 0, 5);
        CHECK(walk(restored, source, 0, 5) == expected);
        CHECK(walk(restored_within, source, 0, 5) == expected);
        history.reset();
        CHECK(walk(history, source, 0, 5) == first);
    }
}

} // namespace history_stage_errors_tests
