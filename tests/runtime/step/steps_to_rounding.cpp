// SPDX-License-Identifier: BSL-1.0
// Where corrections are known to shrink fast the first one is the last: what is left of a step's equation is rounding all the same. Each
// step of a trajectory is made again in 50 digits, from the state it began at.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "support/systems.hpp"

namespace steps_to_rounding_tests {

using namespace hilger;

namespace {

/// Roundings of each component of q and p, at most, in a step of a trajectory: of the numbers that the step adds up.
template <class Flow>
double roundings(Flow const& flow, Eigen::VectorXd const& q, Eigen::VectorXd const& p, double h, int steps) {
    using exact = Eigen::Matrix<float50, Eigen::Dynamic, 1>;
    auto const in_digits = [&](state<double, Eigen::VectorXd> const& x) {
        return state<float50, exact>{float50(x.t), x.q.template cast<float50>(), x.p.template cast<float50>()};
    };
    double most = 0;
    Eigen::VectorXd largest_q = q.cwiseAbs(), largest_p = p.cwiseAbs(); // what goes through zero has the rounding of what it was
    auto last = in_digits({0, q, p});
    bool is_first = true;
    for (auto const& x : flow.along(uniform(0.0, h, steps), q, p)) {
        if (not std::exchange(is_first, false)) {
            auto const right = flow.step(last, float50(h));
            auto const here = in_digits(x);
            for (int c = 0; c < q.size(); ++c) {
                auto const off = [&](auto const& a, auto const& b, double& largest) {
                    largest = std::max(largest, static_cast<double>(magnitude(b(c))));
                    return static_cast<double>(magnitude(float50(a(c) - b(c)))) / largest / std::numeric_limits<double>::epsilon();
                };
                most = std::max({most, off(here.q, right.q, largest_q(c)), off(here.p, right.p, largest_p(c))});
            }
        }
        last = in_digits(x);
    }
    return most;
}
constexpr auto coupled = [](auto const& q, auto const& v) {
    auto const last = q.size() - 1;
    return v.dot(v) / 2 - q.dot(q) / 2 - q(0) * q(0) * q(last) * q(last);
};
/// Nearly linear: corrections shrink by much more than the friction is.
constexpr auto nearly_linear = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) * q.dot(q) / 1e6; };
/// Stiff in some components only, which are much smaller.
constexpr auto stiff_and_soft = [](auto const& q, auto const& v) {
    auto sum = v.dot(v) / 2;
    for (int k = 0; k < q.size(); ++k) sum = sum - cos(q(k) * 10) / (k % 2 == 0 ? -1 : -100) - q(k) * q((k + 1) % q.size()) / 10;
    return sum;
};
constexpr auto with_friction = [](auto const& L, double c) {
    return with_force(lagrangian(L), [c](auto const&, auto const& v) { return (-c * v).eval(); });
};

} // namespace

TEST_CASE("each step is right to its rounding") {
    Eigen::VectorXd q(6), p(6);
    for (int k = 0; k < 6; ++k) {
        q(k) = std::sin(3.14159265358979 * (k + 1) / 7) / 2;
        p(k) = 0.3 - 0.1 * k;
    }
    auto const check = [&](auto const& flow, auto const& bound) {
        for (double const h : {0.01, 0.05, 0.1}) {
            CAPTURE(h);
            CHECK(roundings(flow, q, p, h, 150) <= bound(h));
        }
    };
    auto const few = [](double) { return 4.0; };
    check(embed(coupled, mid_point), few);
    check(embed(with_friction(nearly_linear, 0.5), mid_point), few);
    check(embed(with_friction(nearly_linear, 0.5), galerkin<2, gauss>), few);
    check(embed(coupled, theta<999, 1000>), few); // what the equation has a thousandth of, the momentum has all of
    // a rounding of q moves the force by 100 of them
    check(embed(stiff_and_soft, mid_point), [](double h) { return 4 + 1000 * h; });
}

} // namespace steps_to_rounding_tests
