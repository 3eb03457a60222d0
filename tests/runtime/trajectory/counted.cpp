// SPDX-License-Identifier: BSL-1.0
// Numbers that count: what is needed is counted, once, and nothing else is.
#include <doctest/doctest.h>

#include <vector>

#include "support/counted.hpp"

namespace counted_tests {

using namespace hilger::testing;

namespace {

/// What is counted while `work`, a function of two variables, makes the number that is asked for.
template <class Work>
counts counts_of(Work const& work) {
    counted const x = counted::variable(3), y = counted::variable(4);
    auto& record = record_of_operations::of_this_thread();
    record.begin();
    counted const z = work(x, y);
    record.stop_counting();
    z.need();
    return record.end();
}

} // namespace

TEST_CASE("operations that the result depends on are counted, each once") {
    counts const n = counts_of([](counted const& x, counted const& y) {
        counted const superfluous = exp(x) / y;
        return sqrt(x * x + y * y) - x * x / 7;
    });
    CHECK(n.arithmetic == 5); // x x, y y, +, / 7, -
    CHECK(n.divisions == 1);
    CHECK(n.functions == 1);
    counts const of_angles = counts_of([](counted const& x, counted const& y) { return sin(x) * cos(x) + cos(y) / sqrt(y); });
    CHECK(of_angles.sines == 1);
    CHECK(of_angles.cosines == 2);
    CHECK(of_angles.functions == 4);
    CHECK(counts_of([](counted const& x, counted const& y) { return (x + y) * (y + x); }).arithmetic == 2);
    CHECK(counts_of([](counted const& x, counted const& y) { return (x - y) * (y - x); }).arithmetic == 3);
    CHECK(counts_of([](counted const& x, counted const& y) { return x * counted::variable(2) + y * counted::variable(2); }).arithmetic ==
          3);
}

TEST_CASE("constants are folded; signs, absolute values, and factors of one are free") {
    CHECK(counts_of([](counted const& x, counted const&) { return x * (counted(2) * 3 + sqrt(counted(4))); }).arithmetic == 1);
    CHECK(counts_of([](counted const& x, counted const&) { return abs(-(x / 1)) * 1 - 0; }).arithmetic == 0);
    CHECK(counts_of([](counted const& x, counted const&) { return x + 0; }).arithmetic == 1); // -0 + 0 is 0
    CHECK(counts_of([](counted const& x, counted const&) { return x * 0; }).arithmetic == 1); // and NaN may be x
    CHECK(counted(3).is_constant());
    CHECK_FALSE(counted::variable(3).is_constant());
    CHECK_FALSE((counted::variable(3) * 0).is_constant());
}

TEST_CASE("a branch needs what it looks at") {
    auto const branch = [](counted const& x, counted const& y) { return x * x < y ? x : y; };
    CHECK(counts_of(branch).arithmetic == 1);
}

TEST_CASE("what was made before is a variable, and what is made after the counting shows what was needed") {
    counted const x = counted::variable(2);
    counted const before = sin(x);
    auto& record = record_of_operations::of_this_thread();
    record.begin();
    counted const kept = before * x, forgotten = before + x;
    record.stop_counting();
    counted const later = kept + 1;
    later.need();
    counts const n = record.end();
    CHECK(n.arithmetic == 1);
    CHECK(n.functions == 0);
}

TEST_CASE("numbers are counted wherever they are") {
    auto& record = record_of_operations::of_this_thread();
    long long const before = record.numbers;
    {
        std::vector<counted> const x(10);
        Eigen::Matrix<counted, Eigen::Dynamic, 1> const y = Eigen::Matrix<counted, Eigen::Dynamic, 1>::Zero(5);
        auto const z = x;
        CHECK(record.numbers - before == 25);
    }
    CHECK(record.numbers == before);
}

} // namespace counted_tests
