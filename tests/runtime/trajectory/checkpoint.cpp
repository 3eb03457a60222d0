// SPDX-License-Identifier: BSL-1.0
// A run that is stopped, written down, read back and resumed has the bits of the run that was not stopped.
#include <doctest/doctest.h>

#include "resuming.hpp"

namespace checkpoint_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// The text of a checkpoint after three steps.
template <class Path>
std::string written(Path const& path) {
    auto at = path.begin();
    for (int i = 0; i < 3; ++i) ++at;
    std::ostringstream text;
    write_checkpoint(text, path, at.checkpoint());
    return text.str();
}
template <class Path>
std::string why_unreadable(std::string const& text, Path const& path) {
    std::istringstream in(text);
    try {
        (void)read_checkpoint(in, path, "'run.txt'");
    } catch (error::unreadable const& e) {
        return e.what();
    }
    return "it was readable";
}

} // namespace

TEST_CASE("1000 steps are 400 and 600, bit for bit") {
    CHECK(differences(pendulum_path<double>(embed(pendulum, mid_point), 1000), 400) == 0);
    CHECK(differences(pendulum_path<double>(embed(pendulum, mid_point, compensated), 1000), 400) == 0);
    CHECK(differences(pendulum_path<double>(embed(pendulum, order_one), 1000), 400) == 0);
    CHECK(differences(pendulum_path<double>(embed(pendulum, order_one, compensated), 1000), 400) == 0);
    CHECK(differences(pendulum_path<float50>(embed(pendulum, mid_point), 1000), 400) == 0);
    CHECK(differences(pendulum_path<float50>(embed(pendulum, mid_point, compensated), 1000), 400) == 0);
    CHECK(differences(pendulum_path<float50>(embed(pendulum, order_one), 1000), 400) == 0);
    CHECK(differences(pendulum_path<float50>(embed(pendulum, order_one, compensated), 1000), 400) == 0);
}

TEST_CASE("what is remembered matters: forgetting it changes bits") {
    auto const path = pendulum_path<double>(embed(pendulum, mid_point, compensated), 1000);
    auto at = path.begin();
    for (int i = 0; i < 400; ++i) ++at;
    auto forgetful = path.begin().checkpoint();
    forgetful.at = *at;
    forgetful.number = at.number();
    auto const rest = path.resume(forgetful);
    int different = 0;
    for (auto x = rest.begin(); at != path.end(); ++at, ++x) different += not(*x == *at);
    CHECK(different > 0);
}

TEST_CASE("a run goes on beyond its scale's end") {
    auto const flow = embed(pendulum, mid_point);
    auto const whole = pendulum_path<double>(flow, 20), part = pendulum_path<double>(flow, 10);
    auto at = part.begin();
    while (at.number() < 10) ++at;
    auto end = whole.begin();
    while (end.number() < 20) ++end;
    state<double, double> last{};
    for (auto const& x : whole.resume(at.checkpoint())) last = x;
    CHECK(last == *end);

    auto elsewhere = at.checkpoint();
    elsewhere.at.t += 0.01;
    CHECK_THROWS_AS((void)whole.resume(elsewhere), error::mismatch);
    elsewhere = end.checkpoint();
    CHECK_THROWS_AS((void)part.resume(elsewhere), error::mismatch);
}

TEST_CASE("the format, and what is said of text that is not in it") {
    auto const path = pendulum_path<double>(embed(pendulum, order_one), 10);
    std::string const text = written(path);
    CHECK(text.find("hilger checkpoint 1\nscalar with 53 digits\npoint 3\ntime 0x1.3333333333334p-2\nposition 0x") == 0);
    CHECK(why_unreadable(text, path) == "it was readable");
    CHECK(why_unreadable("", path) == "line 1 of 'run.txt' should be 'hilger checkpoint 1', and the text ends before it");
    CHECK(why_unreadable("hilger checkpoint 2\n", path) ==
          "line 1 of 'run.txt' should be 'hilger checkpoint 1', and is 'hilger checkpoint 2'");
    CHECK(why_unreadable(text.substr(0, text.find("momentum")), path) ==
          "line 6 of 'run.txt' should be 'momentum' and a number, and the text ends before it");
    auto const with = [&](std::string const& line) { // instead of the sixth
        auto const begin = text.find("momentum");
        return text.substr(0, begin) + line + text.substr(text.find('\n', begin));
    };
    for (std::string const line : {"momentum x", "momentum", "momentum 1 2", "momentum nan", "momentum 0x1p+0z", "velocity 1", ""})
        CHECK(why_unreadable(with(line), path) == "line 6 of 'run.txt' should be 'momentum' and a number, and is '" + line + "'");
    // Of another scalar, of another method, and with something after it.
    CHECK(why_unreadable(written(pendulum_path<float50>(embed(pendulum, order_one), 10)), path) ==
          "line 2 of 'run.txt' should be 'scalar with 53 digits', and is 'scalar with 168 digits'");
    CHECK(why_unreadable(written(pendulum_path<double>(embed(pendulum, order_one, compensated), 10)), path)
              .find("should be 'end', and is 'carry ") != std::string::npos);
    CHECK(why_unreadable(written(pendulum_path<double>(embed(pendulum, mid_point), 10)), path).find("should be 'end', and is 'velocity ") !=
          std::string::npos);
}

} // namespace checkpoint_tests
