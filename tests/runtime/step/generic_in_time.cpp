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

} // namespace

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
