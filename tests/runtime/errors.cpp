// SPDX-License-Identifier: BSL-1.0
// The errors: one root, one type for each thing a caller can do about it, and messages that keep the digits of the numbers in them.
#include <doctest/doctest.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "support/values.hpp"

namespace errors_tests {

using namespace hilger;

namespace {

template <class Error>
std::string message_of(auto const& throwing) {
    try {
        throwing();
    } catch (Error const& caught) {
        return caught.what();
    } catch (...) {
        return "another type was thrown";
    }
    return "nothing was thrown";
}

} // namespace

TEST_CASE_TEMPLATE("every error can be caught by its type, as hilger's and as the standard's", Error, error::invalid_scale,
                   error::outside_domain, error::mismatch, error::invalid_parameter, error::not_finite, error::unreadable, error::singular,
                   error::no_convergence) {
    auto const raise = [] { error::raise<Error>("what"); };
    CHECK_THROWS_WITH_AS(raise(), "what", Error);
    CHECK_THROWS_AS(raise(), error::exception);
    CHECK_THROWS_AS(raise(), std::runtime_error);
    static_assert(not std::is_convertible_v<std::string, Error>); // not from a text by accident
    static_assert(std::is_nothrow_copy_constructible_v<Error>);
}

TEST_CASE("the types are different") {
    auto const raise = [] { error::raise<error::mismatch>("x"); };
    CHECK(message_of<error::mismatch>(raise) == "x");
    CHECK(message_of<error::outside_domain>(raise) == "another type was thrown");
    CHECK(message_of<error::invalid_scale>(raise) == "another type was thrown");
}

TEST_CASE("a message is its parts, and its numbers can be read back") {
    CHECK(message_of<error::exception>([] { error::raise<error::exception>("n = ", 3, ", x = ", 0.5, " and ", Q(1, 3)); }) ==
          "n = 3, x = 0.5 and 1/3");
    double const x = 0.1 + 0.2;
    std::string const text = message_of<error::exception>([&] { error::raise<error::exception>(x); });
    CHECK(std::stod(text) == x);
}

TEST_CASE("an error leaves what it happened to as it was") {
    auto const T = testing::steps_1_2_4();
    auto const f = function_on(T, [](Q const& t) { return t; });
    CHECK_THROWS_AS((void)f(Q(2)), error::outside_domain);
    CHECK(f(Q(3)) == 3);
    std::vector<Q> points{Q(0), Q(1), Q(1)};
    CHECK_THROWS_AS((void)time_scale<Q>(points), error::invalid_scale);
    CHECK(points.size() == 3);
}

TEST_CASE("what is thrown needs no more than the alignment of exceptions, whatever its values need") {
    struct alignas(64) wide {
        double x = 0;
        bool operator==(wide const&) const = default;
    };
    static_assert(alignof(newton_failure<wide>) <= alignof(std::max_align_t));
    static_assert(alignof(step_failure<error::singular, double, wide>) <= alignof(std::max_align_t));
    try {
        throw newton_failure<wide>("of values", wide{1}, wide{2});
    } catch (newton_failure<wide> const& failure) {
        auto const copy = failure;
        CHECK(copy.iterate.x == 1);
        CHECK(copy.residual.x == 2);
        CHECK(reinterpret_cast<std::uintptr_t>(&copy.iterate) % 64 == 0);
    }
    try {
        throw step_failure<error::singular, double, wide>("of a state", state<double, wide>{0.5, wide{1}, wide{2}});
    } catch (interrupted<double, wide> const& stopped) {
        CHECK(stopped.last.t == 0.5);
        CHECK(stopped.last.p.x == 2);
        CHECK(reinterpret_cast<std::uintptr_t>(&stopped.last.q) % 64 == 0);
    }
}

} // namespace errors_tests
