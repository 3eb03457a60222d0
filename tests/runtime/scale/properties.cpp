// SPDX-License-Identifier: BSL-1.0
// What holds for every time scale, on scales that RapidCheck makes: exact ones with any steps, and floating ones whose steps differ by many
// orders of magnitude.
#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <cmath>

#include "support/values.hpp"

namespace scale_properties_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// 2 to 12 increasing rationals.
time_scale<Q> any_scale() {
    auto const steps = *rc::gen::suchThat(
        rc::gen::container<std::vector<std::pair<int, int>>>(rc::gen::pair(rc::gen::inRange(1, 50), rc::gen::inRange(1, 12))),
        [](auto const& s) { return not s.empty() and s.size() <= 11; });
    std::vector<Q> points{Q(*rc::gen::inRange(-20, 20), *rc::gen::inRange(1, 9))};
    for (auto const& [p, q] : steps) points.push_back(points.back() + Q(p, q));
    return time_scale<Q>(std::move(points));
}

/// Increasing doubles, with steps from 1e-12 to 1e3 that are not lost.
time_scale<double> any_floating_scale() {
    auto const n = *rc::gen::inRange(1, 30);
    std::vector<double> points{*rc::gen::inRange(-1000, 1000) / 7.0};
    for (int i = 0; i < n; ++i) {
        double const step = std::ldexp(1.0 + *rc::gen::inRange(0, 1000) / 1000.0, *rc::gen::inRange(-40, 10));
        double const next = points.back() + step;
        points.push_back(next > points.back() ? next : std::nextafter(points.back(), 1e300));
    }
    return time_scale<double>(std::move(points));
}

template <class Scale>
auto any_function(Scale const& scale) {
    using S = typename Scale::scalar_type;
    std::vector<S> values;
    for (hilger::index_type i = 0; i < scale.size(); ++i) values.push_back(S(*rc::gen::inRange(-100, 100)) / S(*rc::gen::inRange(1, 10)));
    return function_on(scale, std::move(values));
}

} // namespace

TEST_CASE("rho undoes sigma, mu is the distance to the next point, and sizes add up") {
    CHECK(rc::check([] {
        auto const T = any_scale();
        for (auto const& t : without_last(T)) {
            RC_ASSERT(T.rho(T.sigma(t)) == t);
            RC_ASSERT(t < T.sigma(t));
            RC_ASSERT(t + T.mu(t) == T.sigma(t));
        }
        RC_ASSERT(circ(T).size() == T.size() + half(T).size());
        RC_ASSERT(half(T).size() == without_last(T).size());
        RC_ASSERT(std::ranges::is_sorted(circ(T).begin(), circ(T).end()));
        for (auto const& t : T) RC_ASSERT(circ(T).contains(t));
        for (auto const& t : half(T)) RC_ASSERT(circ(T).contains(t) and not T.contains(t));
    }));
}

TEST_CASE("every point of a floating scale is found under its own number, and the middle of a gap is no point") {
    CHECK(rc::check([] {
        auto const T = any_floating_scale();
        for (auto i = T.first(); i <= T.last(); ++i) {
            RC_ASSERT(T.number_of(T.point(i)) == i);
            if (i == T.last()) break;
            double const middle = T.point(i) + (T.point(i + 1) - T.point(i)) / 2;
            if (middle != T.point(i) and middle != T.point(i + 1)) RC_ASSERT(not T.contains(middle));
        }
    }));
}

TEST_CASE("integration undoes differentiation and the other way round") {
    CHECK(rc::check([] {
        auto const T = any_scale();
        auto const f = any_function(T);
        RC_ASSERT(integral(Delta_plus[f], T) == boundary(f));
        RC_ASSERT(nabla_integral(Delta_minus[f], T) == boundary(f));
        RC_ASSERT(values(Delta_plus[antiderivative[f]]) == values(restrict_to(f, without_last(T))));
        for (auto const& s : T)
            for (auto const& t : T) {
                RC_ASSERT(integral(f, s, t) == -integral(f, t, s));
                RC_ASSERT(integral(Delta_plus[f], s, t) == f(t) - f(s));
            }
    }));
}

TEST_CASE("what does not need a uniform scale does not use one: a uniform scale and the same points given agree") {
    CHECK(rc::check([] {
        auto const U = uniform(Q(*rc::gen::inRange(-9, 9)), Q(*rc::gen::inRange(1, 9), *rc::gen::inRange(1, 9)), *rc::gen::inRange(1, 9));
        auto const T = time_scale(U);
        RC_ASSERT(U == T);
        RC_ASSERT(circ(U) == circ(T));
        auto const f = any_function(U);
        auto const g = function_on(T, std::vector<Q>(f.begin(), f.end()));
        RC_ASSERT(values(Delta_plus[f]) == values(Delta_plus[g]));
        RC_ASSERT(values(Delta_o_minus[extend[f]]) == values(Delta_o_minus[extend[g]]));
        RC_ASSERT(values(mean_h_minus[on_half[extend[f]]]) == values(mean_h_minus[on_half[extend[g]]]));
        RC_ASSERT(values(step_mean[on_half[extend[f]]]) == values(step_mean[on_half[extend[g]]]));
        RC_ASSERT(values(Delta_h_plus[on_half[extend[f]]]) == values(Delta_h_plus[on_half[extend[g]]]));
        RC_ASSERT(integral(extend[f], circ(U)) == integral(extend[g], circ(T)));
        RC_ASSERT(values(adjoint(extend)[extend[f]]) == values(adjoint(extend)[extend[g]]));
    }));
}

} // namespace scale_properties_tests
