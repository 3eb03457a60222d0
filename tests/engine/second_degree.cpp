// SPDX-License-Identifier: BSL-1.0
// A Lagrangian of second degree is read as the matrices of a structure, and what is not of second degree is refused.
#include <doctest/doctest.h>

#include "engine/second_degree.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/lagrangian.hpp"

namespace second_degree_tests {

using namespace hilger;
using engine::second_degree_of;

namespace {

/// What a Lagrangian of one coordinate is said to have.
template <class L>
std::string refusal(L const& l) {
    try {
        (void)second_degree_of<double>(l, 1);
    } catch (error::invalid_parameter const& e) {
        std::string const said = e.what(), beginning =
                                               "a linear structure has a Lagrangian v.Mv/2 - q.Kq/2 + f.q with constant M, K and f, "
                                               "and this one has ";
        return said.starts_with(beginning) ? said.substr(beginning.size()) : said;
    }
    return "nothing wrong";
}

} // namespace

TEST_CASE("a Lagrangian of second degree is a structure, exactly, and what is not is refused with what it has") {
    auto const L = [](auto const& q, auto const& v) {
        return (v(0) * v(0) + 3 * v(1) * v(0) + 5 * v(1) * v(1)) / 4 - (q(0) - q(1)) * (q(0) - q(1)) / 3 - q(0) * q(0) / 2 + 7 * q(0) / 2 -
               q(1) + q(0) * v(0) * 0 + 11;
    };
    using matrix = Eigen::Matrix<Q, Eigen::Dynamic, Eigen::Dynamic>;
    auto const parts = second_degree_of<Q>(L, 2);
    CHECK(parts.mass == matrix{{Q(1, 2), Q(3, 4)}, {Q(3, 4), Q(5, 2)}});
    CHECK(parts.stiffness == matrix{{Q(5, 3), Q(-2, 3)}, {Q(-2, 3), Q(2, 3)}});
    CHECK(parts.load == Eigen::Matrix<Q, Eigen::Dynamic, 1>{{Q(7, 2), Q(-1)}});
    // A component that is not bound, and one that has no mass.
    auto const loose = second_degree_of<Q>([](auto const&, auto const& v) { return v(1) * v(1); }, 2);
    CHECK(loose.mass == matrix{{Q(0), Q(0)}, {Q(0), Q(2)}});
    CHECK(loose.stiffness.isZero());
    CHECK(loose.load.isZero());

    CHECK(refusal([](auto const& q, auto const& v) { return v(0) * v(0) / 2 + cos(q(0)); }) == "a force that is not linear in q");
    CHECK(refusal([](auto const& q, auto const& v) { return (1 + q(0) * q(0)) * v(0) * v(0); }) == "a mass that changes");
    CHECK(refusal([](auto const&, auto const& v) { return v(0) * v(0) * v(0) * v(0); }) == "a mass that changes");
    CHECK(refusal([](auto const& q, auto const& v) { return v(0) * v(0) + v(0) * q(0); }) == "a term with both q and v");
    CHECK(refusal([](auto const&, auto const& v) { return v(0) * v(0) + v(0); }) == "a term that is linear in v");
    CHECK(refusal([](auto const& q, auto const& v) { return v(0) * v(0) - (0 < q(0) ? q(0) * q(0) : 2 * q(0) * q(0)); }) == "branches");
    CHECK_THROWS_AS(
        (void)second_degree_of<double>([](auto const& q, auto const& v) { return v(0) * v(0) - 1e308 * (10 * q(0)) * q(0); }, 1),
        error::not_finite);
    auto const words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 0}});
    CHECK(refusal(text::lagrangian_in("v^2/2 - q^2/2 + 3*q", words)) == "nothing wrong");
    CHECK(refusal(text::lagrangian_in("v^2/2 - q^2/2 + q*sin(t)", words)) == "the time: what drives a structure is a force");
}

} // namespace second_degree_tests
