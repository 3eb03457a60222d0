// SPDX-License-Identifier: BSL-1.0
// Galerkin steps of a Lagrangian whose formula is traced: by the forces at the nodes where it has a constant mass, by the equation
// elsewhere; beside the same in jets, on any scale, and judged by the equation.
#include <doctest/doctest.h>

#include "runtime/trajectory/resuming.hpp"
#include "support/requirements.hpp"

namespace galerkin_traced_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

using fixed = Eigen::Vector4d;
using dynamic = Eigen::VectorXd;

/// Springs; a mass that is not diagonal and a term linear in v; and a mass that depends on the position, or on the velocity.
enum class kind { constant_mass, coupled, not_quadratic };
template <kind Kind>
constexpr auto lagrangian_of = [](auto const& q, auto const& v) {
    auto const spring = [](auto const& r) { return r * r / 2 + r * r * r * r / 8; };
    auto const L = v.squaredNorm() / 2 + v(0) * v(1) / 3 + v(2) / 5 - spring(q(1) - q(0)) - spring(q(2) - q(1)) - spring(q(3) - q(2)) -
                   q(0) * q(0) / 2 - q(3) * q(3) / 4;
    if constexpr (Kind == kind::coupled)
        return L + q(1) * q(1) * v(3) * v(3) / 4;
    else if constexpr (Kind == kind::not_quadratic)
        return L + v(3) * v(3) * v(3) * v(3) / 8;
    else
        return L;
};
fixed const q0(0.5, -0.25, 0.75, 0.125), p0(0.25, 0.5, 0.0, -0.5);

/// Against jets, at every point. What rounding does to regular motions grows linearly.
template <class L, class Embedding, class Scale>
void agrees(L const& of, Embedding const& how, Scale const& T) {
    auto const of_jets = record(embed(of, how).along(T, q0, p0));
    auto const flow = embed(of, how);
    auto const traced = record(flow.along(T, dynamic(q0), dynamic(p0)));
    REQUIRE(of_jets.states.size() == traced.states.size());
    for (std::size_t i = 0; i < traced.states.size(); ++i) {
        double const rounding = 64 * static_cast<double>(i + 1) * epsilon<double>();
        CHECK((traced.states[i].q - of_jets.states[i].q).cwiseAbs().maxCoeff() <= rounding);
        CHECK((traced.states[i].p - of_jets.states[i].p).cwiseAbs().maxCoeff() <= rounding);
    }
}
auto uneven() {
    std::vector<double> t;
    for (int i = 0; i <= 40; ++i) t.push_back(0.25 + 0.0625 * (i + 0.25 * std::sin(i)));
    return time_scale<double>(t);
}

} // namespace

TEST_CASE("traced Galerkin steps are those of jets") {
    auto const both = [](auto const& of) {
        agrees(of, galerkin<3, gauss>, uniform(0.0, 0.0625, 60));
        agrees(of, galerkin<3, lobatto>, uniform(0.0, 0.0625, 60));
        agrees(of, galerkin<3, gauss>, uneven());
        agrees(of, galerkin<3, gauss>, uniform(0.0, 0.5, 24)); // iterations of forces converge slowly, or not
    };
    both(lagrangian_of<kind::constant_mass>);
    both(lagrangian_of<kind::coupled>);
    agrees(lagrangian_of<kind::not_quadratic>, galerkin<3, gauss>, uniform(0.0, 0.0625, 60));
    agrees([](auto const& t, auto const& q, auto const& v) { return lagrangian_of<kind::constant_mass>(q, v) + cos(t) * q(2); },
           galerkin<3, gauss>, uniform(0.0, 0.0625, 60));
}
TEST_CASE("with a constant mass forces alone are evaluated, and no second derivatives in the steps") {
    auto const with_cosine = [](auto const& q, auto const& v) { return lagrangian_of<kind::constant_mass>(q, v) + cos(q(1)) / 4; };
    auto const flow = embed(with_cosine, galerkin<3, gauss>);
    auto const need = requirements_of(flow.along(uniform(0.0, 0.0625, 60), dynamic(q0), dynamic(p0)));
    CHECK(need.sines >= 3);
    CHECK(need.cosines == 0);
    CHECK(need.divisions <= 4); // factors of its 12 x 12 matrix would take more
}
TEST_CASE("runs of traced Galerkin steps are resumed bit for bit") {
    auto const both = [](auto const& of) {
        auto const flow = embed(of, galerkin<3, gauss>);
        CHECK(differences(flow.along(uniform(0.0, 0.0625, 40), dynamic(q0), dynamic(p0)), 17) == 0);
        CHECK(differences(flow.along(uneven(), dynamic(q0), dynamic(p0)), 17) == 0);
        CHECK(differences(flow.along(uniform(0.0, 0.5, 24), dynamic(q0), dynamic(p0)), 5) == 0);
    };
    both(lagrangian_of<kind::constant_mass>);
    both(lagrangian_of<kind::coupled>);
}

} // namespace galerkin_traced_tests
