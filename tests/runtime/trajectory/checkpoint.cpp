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

TEST_CASE("a number is the whole of a word, as the scalar writes it") {
    using detail::number_from;
    CHECK(number_from<double>("+2.5") == 2.5);
    CHECK(number_from<float>("0.1") == 0.1f);
    CHECK(number_from<long double>("0.1") == 0.1L);
    CHECK(number_from<float50>("0.1") == float50(1) / 10);
    CHECK(number_from<Q>("-7/5") == Q(-7, 5));
    for (auto const* word : {"abc", "1x", "1,5", "1e99999"}) CHECK_THROWS_AS((void)number_from<double>(word), std::exception);
    for (auto const* word : {"abc", "1/0", "1/", "0.5", "--1"}) CHECK_THROWS_AS((void)number_from<Q>(word), std::exception);
}

TEST_CASE("the format, and what is said of text that is not in it") {
    auto const path = pendulum_path<double>(embed(pendulum, order_one), 10);
    std::string const text = written(path);
    CHECK(text.find("hilger checkpoint 2\nscalar with 53 digits\npoint 3\ntime 0x1.3333333333334p-2\nposition 0x") == 0);
    CHECK(why_unreadable(text, path) == "it was readable");
    CHECK(why_unreadable("", path) == "line 1 of 'run.txt' should be 'hilger checkpoint 2', and the text ends before it");
    CHECK(why_unreadable("hilger checkpoint 1\n", path) ==
          "line 1 of 'run.txt' should be 'hilger checkpoint 2', and is 'hilger checkpoint 1'");
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
              .find("should be 'step' and a number, and is 'carry ") != std::string::npos);
    CHECK(why_unreadable(written(pendulum_path<double>(embed(pendulum, mid_point), 10)), path)
              .find("should be 'step' and a number, and is 'velocity ") != std::string::npos);
}

TEST_CASE("a checkpoint of another problem does not go on in silence") {
    auto const complaint = [](auto const& from, auto const& to) -> std::string {
        std::istringstream in(written(from));
        try {
            (void)read_checkpoint(in, to, "'run.txt'");
        } catch (error::mismatch const& e) {
            return e.what();
        }
        return "";
    };
    auto const refuses = [&](auto const& from, auto const& to) {
        return complaint(from, to).find(
                   "'run.txt' is a checkpoint of another problem or method: a step of 0.1 from its state at t = 0.3") == 0;
    };
    auto const along = [](auto const& flow) { return pendulum_path<double>(flow, 10); };
    auto const driven = [](double f) { return with_force(pendulum, [f](auto const& t, auto const&, auto const&) { return f * (1 + t); }); };
    auto const heavier = [](double g) { return [g](auto const& q, auto const& v) { return v * v / 2 + g * cos(q); }; };
    auto const damped = [&](double rho, double alpha) { return along(embed(with_fractional_damping(pendulum, rho, alpha), mid_point)); };
    CHECK(complaint(along(embed(driven(0.2), mid_point)), along(embed(driven(0.2), mid_point))) == "");
    CHECK(refuses(along(embed(driven(0.2), mid_point)), along(embed(driven(0.2001), mid_point))));
    CHECK(refuses(along(embed(heavier(1.0), order_one)), along(embed(heavier(1.0001), order_one))));
    CHECK(refuses(along(embed(pendulum, theta_at(0.25))), along(embed(pendulum, theta_at(0.5)))));
    CHECK(complaint(damped(0.2, 0.5), damped(0.2, 0.5)) == "");
    CHECK(refuses(damped(0.2, 0.5), damped(0.3, 0.5)));
    CHECK(refuses(damped(0.2, 0.5), damped(0.2, 0.6)));
    // At the end of T the step before is made again; a longer T goes on.
    auto const part = along(embed(driven(0.2), mid_point));
    auto at = part.begin();
    while (at.number() < 10) ++at;
    std::stringstream text;
    write_checkpoint(text, part, at.checkpoint());
    CHECK(read_checkpoint(text, pendulum_path<double>(embed(driven(0.2), mid_point), 20)).number == 10);
    text.clear();
    text.seekg(0);
    CHECK_THROWS_AS((void)read_checkpoint(text, pendulum_path<double>(embed(driven(0.1), mid_point), 20)), error::mismatch);
    // So is a memory's, which does not go on in other steps.
    auto const remembering = [&](double rho, auto const& T) {
        return embed(with_fractional_damping(pendulum, rho, 0.5), mid_point).along(T, 1.0, 0.5);
    };
    auto const whole = remembering(0.2, uniform(0.0, 0.125, 24));
    auto last = whole.begin();
    while (last.number() < 24) ++last;
    auto const goes_on = [&](auto const& to) {
        std::stringstream kept;
        write_checkpoint(kept, whole, last.checkpoint());
        return read_checkpoint(kept, to).number == 24;
    };
    CHECK(goes_on(remembering(0.2, uniform(0.0, 0.125, 60))));
    CHECK_THROWS_AS(goes_on(remembering(2.0, uniform(0.0, 0.125, 60))), error::mismatch);
    CHECK_THROWS_WITH_AS(goes_on(remembering(0.2, uniform(1.5, 0.0625, 60))),
                         "the input is a checkpoint of a walk in steps of 0.125, whose memory does not go on in steps of 0.0625",
                         error::mismatch);
    // However short the steps are.
    auto const shortly = [&](double g) { return embed(heavier(g), mid_point).along(uniform(0.0, 0x1p-20, 10), 1.0, 0.25); };
    CHECK(complaint(shortly(9.81), shortly(9.81)) == "");
    CHECK(complaint(shortly(9.81), shortly(9.80665)) != "");
    // Where a step fails it tells nothing, and what is read back fails where the run did.
    auto const pole = [](auto const& q, auto const& v) { return v * v / 2 - log(q); };
    auto const falling = embed(pole, mid_point).along(uniform(0.0, 4.0, 3), 1e-3, -9.0);
    std::stringstream lost;
    write_checkpoint(lost, falling, falling.begin().checkpoint());
    CHECK(lost.str().find("\nstep 0x0p+0\nend\n") != std::string::npos);
    CHECK(read_checkpoint(lost, falling).number == 0);
}

} // namespace checkpoint_tests
