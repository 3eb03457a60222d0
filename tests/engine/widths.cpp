// SPDX-License-Identifier: BSL-1.0
// Lanes of any width make the same states to the last bit, and the environment says how wide they are.
#include <doctest/doctest.h>

#include "engine/machine_code/c_library.hpp"
#include "members.hpp"

namespace widths_tests {

using namespace hilger;
using namespace testing::members;
using engine::lanes;
using testing::kept_here;
using testing::stated;
using testing::there_is_a_c_compiler;

TEST_CASE("registers of any width make the same states, to the last bit") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const with_functions = stated("v[0]^2*(2 + sin(q[0]))/2 - q[0]^2 - cos(q[0]) - exp(-q[0]) - sqrt(1 + q[0]^2) - tanh(q[0])/8 - "
                                       "cosh(q[0])/16 + sinh(q[0])/32 - atan(q[0])/8 - tan(q[0]/4) - (2 + q[0])^2.5/64 - "
                                       "expm1(q[0]/8) - cbrt(2 + q[0])/16 - erf(q[0])/64 - asinh(q[0])/64",
                                       1);
    auto const of_three = stated("dot(v, v)*(3 + cos(q[0]))/2 + v[0]*v[2]*q[1]/4 - dot(q, q)/2 - exp(q[2])/8", 3);
    std::size_t same = 0, states = 0;
    for (std::string const method : {"order-one", "order-one-left", "mid-point", "theta:0.25", "verlet", "kahan-li-8"})
        for (auto const& T : {equal, uneven()})
            for (auto const& what : {with_functions, of_three}) {
                CAPTURE(method);
                if (method == "kahan-li-8" and not T.is_uniform()) continue;
                int const d = what.lagrangian.formula().words().dimension();
                std::vector<seen> first;
                for (int const width : {1, 2, 4, 8}) {
                    CAPTURE(width);
                    auto const code = lanes::of(what, method, T, width);
                    REQUIRE(bool(code != nullptr));
                    CHECK(code->width() == width);
                    auto const made = walked(*code, starts(d, 0.25), steps);
                    if (first.empty()) first = made;
                    for (std::size_t m = 0; m < made.size(); ++m) {
                        CHECK(made[m].is_well == first[m].is_well);
                        for (std::size_t i = 0; i <= steps and made[m].is_well[i]; ++i, ++states)
                            same += made[m].q[i] == first[m].q[i] and made[m].p[i] == first[m].p[i] ? 1U : 0U;
                    }
                }
            }
    CHECK(same == states);
    CHECK(states > 40'000); // of 42944: the others are those of members that are lost on their way
}

TEST_CASE("the width of lanes is said by the environment") {
    if (not there_is_a_c_compiler()) return;
    kept_here const cache;
    auto const before = engine::environment_variable("HILGER_LANES");
    ::unsetenv("HILGER_LANES");
    int const most = lanes::width_here();
    for (int width = 1; width <= most; width *= 2) {
        ::setenv("HILGER_LANES", std::to_string(width).c_str(), 1);
        CHECK(lanes::of(stated("v[0]^2/2 - q[0]^2/2", 1), "mid-point", equal)->width() == width);
    }
    for (auto const& wrong : {std::to_string(2 * most), std::string("0"), std::string("3"), std::string("four"), std::string("2 ")}) {
        ::setenv("HILGER_LANES", wrong.c_str(), 1);
        auto const sentence = "HILGER_LANES is 1, 2, 4 or 8 and no more than the " + std::to_string(most) +
                              " numbers that a register of this processor has, and was '" + wrong + "'";
        CHECK_THROWS_WITH_AS(lanes::width_here(), sentence.c_str(), error::invalid_parameter);
    }
    before ? ::setenv("HILGER_LANES", before->c_str(), 1) : ::unsetenv("HILGER_LANES");
}

} // namespace widths_tests
