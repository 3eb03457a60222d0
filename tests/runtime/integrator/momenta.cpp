// SPDX-License-Identifier: BSL-1.0
// Momenta of a solution between two ends are those of the motion that its first state begins: exactly in rationals, and to rounding.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace momenta_tests {

using namespace hilger;

namespace {

constexpr auto oscillator = [](auto const& x, auto const& v) { return v * v / 2 + x * v / 3 - x * x / 2; };

/// The flow of the solution between q0 and qN leads along it, from its first state.
template <class Flow, class Scale, class V>
auto farthest(Flow const& flow, Scale const& T, V const& q0, V const& qN) {
    using S = scalar_of<V>;
    auto const& force = flow.mechanics().force;
    auto const x = solve(equation_of(flow, T), T, boundary_values<V>{q0, qN}, force);
    auto const p = momenta_of(flow, x);
    auto const parts = (x.size() - 1) / T.steps();
    S most(0);
    index_type i = 0;
    for (auto const& at : flow.along(T, q0, V(p[0]))) {
        most = std::max({most, S(magnitude(V(at.q - x[parts * i]))), S(magnitude(V(at.p - p[i])))});
        ++i;
    }
    CHECK(i == p.size());
    return most;
}

} // namespace

TEST_CASE("in rationals, on uneven points, with a force and with points inside the steps") {
    time_scale<Q> const T{Q(0), Q(1, 10), Q(3, 10), Q(7, 20)};
    auto const push = [](auto const& t, auto const& x, auto const& v) { return plain_t<decltype(x * v)>(t - x / 5 - v / 7); };
    CHECK(farthest(embed(oscillator, theta<1, 3>), T, Q(1), Q(1, 2)) == 0);
    CHECK(farthest(embed(with_force(oscillator, push), mid_point), T, Q(1), Q(1, 2)) == 0);
    CHECK(farthest(embed(oscillator, galerkin<3, lobatto>), T, Q(1), Q(1, 2)) == 0);
}

TEST_CASE("in doubles, of vectors, and of Lagrangians that are read in ways of their own") {
    auto const in_a_plane = [](auto const& x, auto const& v) { return v.dot(v) / 2 + x(0) * v(1) / 3 - x.dot(x) * x.dot(x) / 4; };
    auto const T = uniform(0.0, 0.125, 8);
    Eigen::Vector2d const a(0.5, -0.25), b(0.25, 0.75);
    double const rounding = 64 * epsilon<double>() * 8 * 8;
    CHECK(farthest(embed(in_a_plane, mid_point), T, a, b) <= rounding);
    CHECK(farthest(embed(in_a_plane, galerkin<3, gauss>), T, a, b) <= rounding);
    auto const slow = [](auto const& x, auto const&) { return -x * x * x * x / 4; };
    constexpr unknown q;
    auto const sum =
        variation(integral(lagrangian{oscillator}(q, Delta_plus[q]), T) + nabla_integral(lagrangian{slow}(q, Delta_minus[q]), T));
    CHECK(farthest(flow_of(sum), T, 0.5, 0.25) <= rounding);
}

TEST_CASE("the first and the last are not mixed up") {
    // free motion with a magnetic term that changes along the way: p = v + x / 3, and v = 1 / 2
    auto const T = uniform(0.0, 0.5, 4);
    auto const free = [](auto const& x, auto const& v) { return v * v / 2 + x * v / 3; };
    auto const flow = embed(free, mid_point);
    auto const p = momenta_of(flow, solve(equation_of(flow, T), T, {.q0 = 1.0, .qN = 2.0}));
    for (index_type i = 0; i < p.size(); ++i)
        CHECK(std::abs(p[i] - (0.5 + (1 + 0.25 * static_cast<double>(i)) / 3)) <= 16 * epsilon<double>());
}

} // namespace momenta_tests
