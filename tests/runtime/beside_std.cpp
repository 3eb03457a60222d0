// SPDX-License-Identifier: BSL-1.0
// Programs of the first day: everything of std and of POSIX is visible without a prefix, and so is hilger, beside globals with everyday
// names. One name is in both: std::integral is a concept, so a block that integrates says `using hilger::integral`.
#include <bits/stdc++.h>
#include <strings.h>
#include <unistd.h>

using namespace std;

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

using namespace hilger;

const double pi = 3.14159265358979323846;
const int steps = 200;
const double delta = 0.05;
double sum = 0, drift = 0;
string text = "pendulum";
namespace mine {
double index = 0, midpoint = 0, identity = 0, minus = 0, plus = 0, function = 0;
}

namespace {
struct pendulum {
    auto operator()(auto const& q, auto const& v) const { return v * v / 2 - (1 - cos(q)); }
};
} // namespace

TEST_CASE("the pendulum of the first page, with std and hilger open") {
    using hilger::integral;
    auto const T = uniform(0.0, delta, steps);
    constexpr unknown q;
    constexpr auto q_o = extend[q];
    constexpr lagrangian L{pendulum{}};
    auto const S = integral(L(q_o, Delta_o_plus[q_o]), half(T));
    auto const EL = variation(S);
    static_assert(EL.force() == mean_h_minus and EL.momentum() == -Delta_h_minus);
    auto const x = solve(EL, T, {.q0 = pi / 2, .v0 = 0.0});
    auto const residual = EL.residual(x);
    for (auto const& r : residual) sum = max(sum, abs(r));
    CHECK(sum < 1e-9);
    CHECK(text == "pendulum");
    CHECK(getpid() > 0);                          // unistd.h
    CHECK(::index(text.c_str(), 'd') != nullptr); // strings.h
}

TEST_CASE("a flow, its energy and a vector, with std and hilger open") {
    auto const T = uniform(0.0, delta, steps);
    auto const path = embed(pendulum{}, mid_point).along(T, 1.0, 0.0);
    drift = drift_along(path, energy(pendulum{})).largest;
    CHECK(drift < 1e-3);
    vector<double> positions;
    for (auto const& [t, q, p] : path) positions.push_back(q);
    auto const f = function_on(T, positions);
    CHECK(f[0] == 1.0);
    CHECK(f.size() == steps + 1);
    mine::index = mine::midpoint + mine::identity + mine::minus + mine::plus + mine::function;
    CHECK(mine::index == 0);
}

TEST_CASE("integration by parts in rationals, with std and hilger open") {
    using hilger::integral;
    time_scale<Q> const T{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2), Q(9, 4)};
    auto const f = function_on(circ(T), [](Q t) { return t * t * t; });
    auto const g = function_on(circ(T), [](Q t) { return 1 / (1 + t); });
    Q const lhs = integral(Delta_o_plus[f] * g, circ(T));
    Q const rhs = boundary(f * g) - integral(sigma_o[f] * Delta_o_plus[g], circ(T));
    CHECK(lhs == rhs);
}

TEST_CASE("a fractional difference, with std and hilger open") {
    auto const T = uniform(0.0, delta, steps);
    auto const f = function_on(T, [](double t) { return t; });
    auto const d = Delta_minus_alpha<1, 2>[f];
    double const t = delta * steps; // D^(1/2) t = 2 sqrt(t / pi), to first order in the step
    CHECK(abs(d[steps] - 2 * sqrt(t / pi)) < delta);
}
