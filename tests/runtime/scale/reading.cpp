// SPDX-License-Identifier: BSL-1.0
// Time scales from text: what is read, and for each thing that can be wrong the line that is.
#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <random>

#include "support/values.hpp"

namespace scale_reading_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// A file that goes away with the test.
struct temporary_file {
    std::filesystem::path path;
    explicit temporary_file(std::string const& content)
        : path(std::filesystem::temp_directory_path() / ("hilger_" + std::to_string(std::random_device()()) + ".txt")) {
        std::ofstream(path) << content;
    }
    temporary_file(temporary_file const&) = delete;
    temporary_file& operator=(temporary_file const&) = delete;
    ~temporary_file() { std::filesystem::remove(path); }
};

template <class S>
time_scale<S> from(std::string const& content) {
    std::istringstream in(content);
    return read_time_scale<S>(in);
}

std::string const good = "# the points of a scale\n0\n\n   1/3\n\t # the middle\n1   \n7/5\n";

} // namespace

TEST_CASE("one point a line, blank lines and comments ignored") {
    CHECK(points(from<Q>(good)) == "T: 0, 1/3, 1, 7/5");
    CHECK(points(from<Q>("0\r\n1\r\n")) == "T: 0, 1"); // lines from another system
    CHECK(points(from<Q>("-2\n-1")) == "T: -2, -1");   // no newline at the end
    CHECK(points(from<double>("# t\n0.5\n1e0\n+2.5\n")) == "T: 0.5, 1, 2.5");
    CHECK(from<double>("0.1\n0.2\n0.30000000000000004\n").max() == 0.1 + 0.2);
    CHECK(from<float>("0.1\n0.2\n").min() == 0.1f);
    CHECK(from<long double>("0.1\n0.2\n").min() == 0.1L);
    CHECK(from<float50>("0.1\n0.2\n").min() == float50(1) / 10);
}

TEST_CASE("a file is read as a stream is") {
    temporary_file const file(good);
    CHECK(read_time_scale<Q>(file.path.string()) == from<Q>(good));
}

TEST_CASE("what is not a number is named with its line") {
    CHECK_THROWS_WITH_AS(from<double>("0\n# one\nabc\n2\n"), "line 3 of the input should be one number and is 'abc'", error::unreadable);
    CHECK_THROWS_WITH_AS(from<Q>("0\n\nabc\n2\n"), "line 3 of the input should be one number and is 'abc'", error::unreadable);
    CHECK_THROWS_WITH_AS(from<double>("0\n1 2\n"), "line 2 of the input should be one number and is '1 2'", error::unreadable);
    CHECK_THROWS_WITH_AS(from<Q>("0 1\n2\n"), "line 1 of the input should be one number and is '0 1'", error::unreadable);
    CHECK_THROWS_AS(from<double>("0\n1x\n"), error::unreadable);
    CHECK_THROWS_AS(from<double>("0\n1,5\n"), error::unreadable);
    CHECK_THROWS_AS(from<double>("0\n1 # one\n"), error::unreadable); // a comment has its own line
    CHECK_THROWS_AS(from<double>("0\n1e99999\n"), error::unreadable);
    CHECK_THROWS_AS(from<Q>("0\n1/0\n"), error::unreadable);
    CHECK_THROWS_AS(from<Q>("0\n1/\n"), error::unreadable);
    CHECK_THROWS_AS(from<Q>("0\n0.5\n"), error::unreadable); // an exact rational is written as one
    CHECK_THROWS_AS(from<Q>("0\n--1\n"), error::unreadable);
}

TEST_CASE("points that make no scale are named with their line too") {
    CHECK_THROWS_WITH_AS(from<Q>("# decreasing\n0\n3\n\n2\n"), "the points of a time scale increase, and line 5 of the input is 2 after 3",
                         error::invalid_scale);
    CHECK_THROWS_WITH_AS(from<double>("0\n0.5\n0.5\n"), "the points of a time scale increase, and line 3 of the input is 0.5 after 0.5",
                         error::invalid_scale);
    CHECK_THROWS_WITH_AS(from<double>("0\nnan\n"), "the points of a time scale are finite, and line 2 of the input is 'nan'",
                         error::invalid_scale);
    CHECK_THROWS_AS(from<double>("0\ninf\n"), error::invalid_scale);
    CHECK_THROWS_AS(from<double>("0\n1e400\n"), error::invalid_scale); // finite in the file, infinite in double
    CHECK_THROWS_WITH_AS(from<double>("1\n"), "a time scale needs two points, and the input has 1", error::invalid_scale);
    CHECK_THROWS_WITH_AS(from<double>("# nothing\n"), "a time scale needs two points, and the input has 0", error::invalid_scale);
    CHECK_THROWS_AS(from<double>(""), error::invalid_scale);
}

TEST_CASE("the message says which file") {
    temporary_file const file("0\n1\n2 3\n");
    auto const path = file.path.string();
    CHECK_THROWS_WITH_AS(read_time_scale<double>(path), ("line 3 of '" + path + "' should be one number and is '2 3'").c_str(),
                         error::unreadable);
    temporary_file const decreasing("0\n1\n0.5\n");
    CHECK_THROWS_WITH_AS(read_time_scale<double>(decreasing.path.string()),
                         ("the points of a time scale increase, and line 3 of '" + decreasing.path.string() + "' is 0.5 after 1").c_str(),
                         error::invalid_scale);
}

TEST_CASE("a file that is not there, and a directory, cannot be read") {
    CHECK_THROWS_WITH_AS(read_time_scale<double>("/no/such/file"), "cannot open '/no/such/file' to read a time scale from it",
                         error::unreadable);
    CHECK_THROWS_AS(read_time_scale<double>(std::filesystem::temp_directory_path().string()), error::unreadable);
}

} // namespace scale_reading_tests
