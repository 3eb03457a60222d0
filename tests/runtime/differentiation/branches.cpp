// SPDX-License-Identifier: BSL-1.0
// Lagrangians made of branches: a step is returned where its equation holds at what is returned, whichever branch that is on, for states of
// every kind.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace branches_tests {

using namespace hilger;

namespace {

/// Two masses on a line (the first of more components) with a spring that is k times as stiff in compression; a state that is a number is
/// their distance.
struct one_sided_spring {
    double k;
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if constexpr (requires { q(0); }) {
            plain_t<decltype(q(0))> const r = q(1) - q(0);
            return v.squaredNorm() / 2 - (r > 0 ? 1 : k) * r * r / 2;
        } else
            return v * v / 2 - (q > 0 ? 1 : k) * q * q / 2;
    }
};
template <class V>
V start() {
    if constexpr (std::same_as<V, double>)
        return 1.0;
    else {
        V q = V::Zero(V::SizeAtCompileTime == Eigen::Dynamic ? 2 : V::SizeAtCompileTime);
        q(0) = -0.25;
        q(1) = 0.75;
        return q;
    }
}
/// The residual of the derived equation along a mid-point trajectory, in units of its rounding.
template <class V>
double residual_of(double k, double h, index_type steps) {
    constexpr unknown q;
    constexpr auto q_o = extend[q];
    lagrangian const L(one_sided_spring{k});
    auto const T = uniform(0.0, h, steps);
    auto const EL = variation(integral(L(q_o, Delta_o_plus[q_o]), half(T)));
    V const q0 = start<V>();
    auto const x = solve(EL, T, initial_velocity<V>{q0, V(q0 * 0.5)});
    double largest = 0;
    for (auto const& value : x) largest = std::max(largest, magnitude(V(value)));
    return largest_residual(EL, x) / (epsilon<double>() * largest * (k + 4 / (h * h)));
}
template <class V>
std::vector<double> distances(double k, double h, index_type steps) {
    std::vector<double> all;
    V const q0 = start<V>();
    for (auto const& x : embed(one_sided_spring{k}, mid_point).along(uniform(0.0, h, steps), initial_velocity<V>{q0, V(q0 * 0.5)}))
        all.push_back(x.q(1) - x.q(0));
    return all;
}

} // namespace

TEST_CASE_TEMPLATE("the derived equation holds at the points that a mid-point step returns", V, double, Eigen::Vector2d, Eigen::Vector4d,
                   Eigen::Matrix<double, 6, 1>, Eigen::VectorXd) {
    for (auto const& [k, h] : {std::pair{25.0, 0.1}, {400.0, 0.05}, {1e4, 0.05}}) {
        double const stiffness = k;
        CAPTURE(stiffness);
        CHECK(residual_of<V>(k, h, 400) < 4);
    }
}
TEST_CASE("states of fixed and of dynamic size take the same branches") {
    for (auto const& [k, h] : {std::pair{25.0, 0.1}, {400.0, 0.05}}) {
        auto const dynamic = distances<Eigen::VectorXd>(k, h, 200), plane = distances<Eigen::Vector2d>(k, h, 200);
        double apart = 0;
        for (std::size_t i = 0; i < plane.size(); ++i) apart = std::max(apart, std::abs(plane[i] - dynamic[i]));
        double const stiffness = k;
        CAPTURE(stiffness);
        CHECK(apart < 1e-10);
    }
}

} // namespace branches_tests
