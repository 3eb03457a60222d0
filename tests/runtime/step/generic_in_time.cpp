// SPDX-License-Identifier: BSL-1.0
// A Lagrangian and a force that say they are generic in the time, in states that are traced: one formula for all times, and the same steps
// as of one that is told each time anew.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace generic_in_time_tests {

using namespace hilger;

namespace {

/// Driven, and stiffer until t = 1: a branch of the time alone.
template <bool Generic>
struct driven {
    static constexpr bool is_generic_in_time = Generic;
    int* calls;
    template <class T, class X>
    auto operator()(T const& t, X const& q, X const& v) const {
        ++*calls;
        auto const k = t < 1 ? q(0) * q(0) : q(0) * q(0) / 2;
        return (v.squaredNorm() - q.squaredNorm() - k) / 2 + q(0) * q(1) / (8 * (1 + t));
    }
};
template <bool Generic>
struct fading {
    static constexpr bool is_generic_in_time = Generic;
    template <class T, class X>
    X operator()(T const& t, X const&, X const& v) const {
        return X(v * (T(-1) / (1 + t * t)));
    }
};
template <class S>
auto ones() {
    return Eigen::Matrix<S, Eigen::Dynamic, 1>(Eigen::Matrix<S, Eigen::Dynamic, 1>::Ones(5));
}
template <class S, bool Generic, class E>
auto last_of(E const& how, int steps, int& calls) {
    auto const flow = embed(with_force(driven<Generic>{&calls}, fading<Generic>{}), how);
    auto const path = flow.along(uniform(S(0), S(1) / 8, steps), ones<S>(), ones<S>());
    auto last = *path.begin();
    for (auto const& x : path) last = x;
    if constexpr (std::same_as<S, Q>) CHECK(largest_residual(path) == 0);
    return last;
}
template <class S, class E>
void are_the_same(E const& how, int steps, S const& bound) {
    CAPTURE(how.name);
    int generic = 0, told = 0;
    auto const x = last_of<S, true>(how, steps, generic);
    auto const y = last_of<S, false>(how, steps, told);
    CHECK(S((x.q - y.q).cwiseAbs().maxCoeff()) <= bound);
    CHECK(S((x.p - y.p).cwiseAbs().maxCoeff()) <= bound);
}
/// A mass of the place that no body has any more after t = 1.
struct switched_off {
    template <class X, class Y>
    auto operator()(double t, X const& q, Y const& v) const {
        auto L = v.squaredNorm() / 2 - q.squaredNorm() / 2;
        if (t < 1) L = L + v.squaredNorm() * sin(q(0)) / 4;
        return L;
    }
};
/// Until t = 1 a free or a falling body; then a field that couples position and velocity, a stiffer spring and a mass of the place.
template <bool Generic>
struct switched_on {
    static constexpr bool is_generic_in_time = Generic;
    int weight; ///< 0 where it is free
    template <class T, class X, class Y>
    auto operator()(T const& t, X const& q, Y const& v) const {
        if constexpr (requires { q.size(); }) {
            auto L = v.squaredNorm() / 2 + (q(0) - weight * q(1));
            if (t > 1)
                L = L + (q(0) * v(1) - q(1) * v(0)) - 2 * (q.squaredNorm() + q(0) * q(0) * q(1) * q(1)) + v.squaredNorm() * sin(q(0)) / 4;
            return L;
        } else {
            auto L = v * v / 2 - weight * q;
            if (t > 1) L = L + q * v - 10 * q * q + v * v * sin(q) / 4;
            return L;
        }
    }
};
/// A damping with a name for what it computes first, as forces often have one.
struct fading_with_a_name {
    template <class X, class Y>
    auto operator()(double t, X const& q, Y const& v) const {
        auto force = -v / (1 + t);
        force = force - q / 8;
        return force;
    }
};
/// The equation at all points, to what rounding positions of the size of 1 does to a difference of momenta over h.
template <class L, class E, class V>
void holds(L const& l, E const& how, V const& q0, V const& p0) {
    CAPTURE(how.name);
    double const h = 0.05;
    auto const path = embed(l, how).along(uniform(0.0, h, 60), q0, p0);
    CHECK(largest_residual(path) <= 32 * epsilon<double>() / (h * h));
}
template <class E>
void holds_all_the_time(E const& how) {
    holds(switched_on<false>{0}, how, 0.4, 0.1);
    holds(switched_on<false>{1}, how, 0.4, 0.1);
    Eigen::Vector2d const q0(0.4, -0.2), p0(0.1, 0.3);
    Eigen::VectorXd const x0 = q0, y0 = p0;
    holds(switched_on<false>{0}, how, q0, p0);
    holds(switched_on<false>{1}, how, q0, p0);
    holds(switched_off{}, how, q0, p0);
    holds(switched_on<false>{0}, how, x0, y0);
    holds(switched_on<false>{1}, how, x0, y0);
    holds(switched_on<true>{0}, how, x0, y0);
    holds(switched_off{}, how, x0, y0);
}

} // namespace

TEST_CASE("what comes with the time is not missed") {
    holds_all_the_time(mid_point);
    holds_all_the_time(order_one_left);
    holds_all_the_time(galerkin<1, gauss>);
    holds_all_the_time(galerkin<2, gauss>);
    holds_all_the_time(galerkin<2, lobatto>);
}
TEST_CASE("a force that is told the time may name what it computes") {
    auto const oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    auto const T = uniform(0.0, 0.05, 40);
    for (auto const& x : embed(with_force(oscillator, fading_with_a_name{}), galerkin<2, gauss>).along(T, 1.0, 0.0)) CHECK(is_finite(x.q));
    for (auto const& x : embed(with_force(oscillator, fading_with_a_name{}), mid_point).along(T, 1.0, 0.0)) CHECK(is_finite(x.q));
}
TEST_CASE("generic or told, the steps are the same") {
    are_the_same<Q>(mid_point, 10, Q(0)); // over the branch at t = 1
    are_the_same<Q>(order_one, 10, Q(0));
    are_the_same<Q>(galerkin<2, lobatto>, 9, Q(0));
    double const rounding = 400 * 16 * epsilon<double>(); // a few roundings a step, of numbers of the size of 4
    are_the_same<double>(mid_point, 400, rounding);
    are_the_same<double>(order_one_left, 400, rounding);
}
TEST_CASE("a formula that is generic in the time is made once for each branch") {
    auto const calls_in = [](int steps) {
        int calls = 0;
        last_of<double, true>(mid_point, steps, calls);
        return calls;
    };
    int const before_the_branch = calls_in(6), after = calls_in(20);
    CHECK(before_the_branch < after);
    CHECK(after < 2 * before_the_branch + 2);
    CHECK(calls_in(2000) == after);
}

} // namespace generic_in_time_tests
