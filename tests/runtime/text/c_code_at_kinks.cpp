// SPDX-License-Identifier: BSL-1.0
// Generated C where norms are 0, at branches and beside what is no number: there too it steps as the flow it is generated from.
#include "compiled_c.hpp"

namespace c_code_at_kinks_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto oscillator = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
constexpr auto drag = [](auto const&, auto const& v) { return -0.3 * v.norm() * v; };
constexpr auto norm_cubed = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.norm() * q.squaredNorm(); };
constexpr auto capped = [](auto const& x, auto const& v) { return v * v / 2 - min(1 / pow(x, 12), 100.0 - x); };
constexpr auto floor_of_minus = [](auto const& x, auto const& v) { return v * v / 2 - 1000.0 * max(-x, 0.0) - 5.0 * abs(-x) - 9.81 * x; };
constexpr auto no_mass_at_rest = [](auto const& x, auto const& v) { return 2 * pow(abs(v), 1.5) / 3 - x * x / 2; };
constexpr auto root_or_more = [](auto const& x, auto const& v) { return v * v / 2 - max(sqrt(x), 0.0); };
constexpr auto root_or_less = [](auto const& x, auto const& v) { return v * v / 2 - min(sqrt(x), 1.0); };

compiled const& generated() {
    static compiled const c(
        c_code<vector>(embed(with_force(oscillator, drag), mid_point), "dragged") +
        c_code<vector>(embed(norm_cubed, order_one), "norm_cubed") + c_code<vector>(embed(norm_cubed, mid_point), "norm_cubed_between") +
        c_code(embed(capped, order_one), "capped") + c_code(embed(floor_of_minus, order_one), "floor_of_minus") +
        c_code(embed(no_mass_at_rest, mid_point), "no_mass_at_rest") + c_code(embed(root_or_more, mid_point), "root_or_more") +
        c_code(embed(root_or_less, mid_point), "root_or_less"));
    return c;
}

} // namespace

TEST_CASE("C starts from rest with a drag, and where a norm is 0") {
    if (not there_is_a_c_compiler()) return;
    double const bound = 32;
    vector const at_rest(0, 0), somewhere(0.5, -0.25);
    CHECK(distance_after_1000_steps(generated(), "dragged", embed(with_force(oscillator, drag), mid_point), somewhere, at_rest, 0.05) <
          bound);
    CHECK(distance_after_1000_steps(generated(), "norm_cubed", embed(norm_cubed, order_one), at_rest, somewhere, 0.05) < bound);
    CHECK(distance_after_1000_steps(generated(), "norm_cubed_between", embed(norm_cubed, mid_point), at_rest, somewhere, 0.05) < bound);
    CHECK(distance_after_1000_steps(generated(), "capped", embed(capped, order_one), 0.0, 0.0, 1e-4) <
          bound);                    // the other one is 1e27 and more
    double height = 0, p = 0, v = 0; // at the kink, which is written with a minus
    CHECK(generated().get<step_of>("floor_of_minus_step")(0.1, &height, &p, &v) == 0);
    CHECK(height == doctest::Approx(embed(floor_of_minus, order_one).step(state<double, double>{0, 0, 0}, 0.1).q).epsilon(1e-14));
    // Where the derivative is infinite a correction is 0, and proves nothing; from a guess beside it the step is the flow's.
    double x = 0.5, momentum = 0.9, velocity = 0;
    auto* const step = generated().get<step_of>("no_mass_at_rest_step");
    CHECK(step(0.1, &x, &momentum, &velocity) == 1);
    CHECK((x == 0.5 and momentum == 0.9 and velocity == 0));
    velocity = 0.9;
    CHECK(step(0.1, &x, &momentum, &velocity) == 0);
    CHECK(x == doctest::Approx(embed(no_mass_at_rest, mid_point).step(state<double, double>{0, 0.5, 0.9}, 0.1).q).epsilon(1e-14));
    double const behind = -1, before = 4, still = 0; // fmax and fmin pass over what is no number
    for (std::string const name : {"root_or_more_lagrangian", "root_or_less_lagrangian"}) {
        auto* const L = generated().get<lagrangian_in_c>(name);
        CHECK(std::isnan(L(&behind, &still)));
        CHECK(L(&before, &still) == (name == "root_or_more_lagrangian" ? -2 : -1));
    }
}

} // namespace c_code_at_kinks_tests
