// SPDX-License-Identifier: BSL-1.0
// What a small step evaluates by jets of L and of a force is what the table of derivatives says, and forced steps solve their equation.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace node_tests {

using namespace hilger;

namespace {

template <class S, int N>
using vector = Eigen::Matrix<S, N, 1>;

constexpr auto bending = [](auto const& t, auto const& q, auto const& v) {
    return (2 + q.squaredNorm()) * v.squaredNorm() / 2 + q(0) * v(1) / 3 - t * q(1) * q(1) * q(0);
};
constexpr auto pulling = [](auto const& t, auto const& q, auto const& v) {
    auto f = (q * v(1) - v * q(0) / 2).eval(); // depends on which component of which
    f(0) = f(0) + t * v(0) * v(0) * q(1);
    return f;
};
/// Entries of both at the same place, exactly.
template <int N>
void check_entries() {
    using V = vector<Q, N>;
    problem<decltype(bending), decltype(pulling)> const what{bending, pulling};
    V q, v;
    std::array<Q, N> a, b;
    for (int k = 0; k < N; ++k) {
        a[static_cast<std::size_t>(k)] = q(k) = Q(k + 1, 3);
        b[static_cast<std::size_t>(k)] = v(k) = Q(2 - 3 * k, 5);
    }
    auto const fast = detail::evaluate<false>(what, Q(1, 7), a, b, std::make_integer_sequence<int, N>{});
    auto const table = detail::expand_at(what, Q(1, 7), q, v);
    [&]<int... M>(std::integer_sequence<int, M...>) {
        auto const one = [&]<int J, int K>(std::integer_sequence<int, J, K>) {
            CHECK(fast.template by_q<J>() == table.template by_q<J>());
            CHECK(fast.template by_v<J>() == table.template by_v<J>());
            CHECK(fast.template qq<J, K>() == table.template qq<J, K>());
            CHECK(fast.template qv<J, K>() == table.template qv<J, K>());
            CHECK(fast.template vq<J, K>() == table.template vq<J, K>());
            CHECK(fast.template vv<J, K>() == table.template vv<J, K>());
        };
        (one(std::integer_sequence<int, M / N, M % N>{}), ...);
    }
    (std::make_integer_sequence<int, N * N>{});
}
template <class L, class Force, class V>
void solves_exactly(L const& of, Force const& force, V const& q0, V const& v0) {
    auto const T = uniform(Q(0), Q(1, 8), 5);
    auto const check = [&](auto const& how) {
        CHECK(largest_residual(embed(with_force(lagrangian{of}, force), how).along(T, initial_velocity<V>{q0, v0})) == 0);
    };
    check(mid_point);
    check(order_one);
    check(order_one_left);
    check(theta<1, 3>);
}
template <class Force>
dependence degrees(Force const& force) {
    constexpr auto L = [](auto const& x, auto const& v) { return v * v / 2 - x * x * x; };
    problem<decltype(L), Force> const what{L, force};
    return detail::evaluate<true>(what, 0.0, std::array{0.5}, std::array{0.25}, std::make_integer_sequence<int, 1>{}).on();
}

} // namespace

TEST_CASE("a force stands beside dL/dq, its derivatives beside those of dL/dq, and nowhere else") {
    check_entries<2>();
    check_entries<3>();
    check_entries<4>();
}
TEST_CASE("steps with forces that are linear in v solve their equation in rational numbers") {
    auto const oscillator = [](auto const& x, auto const& v) { return v * v / 2 - x * x / 2; };
    auto const plane = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + v(0) * v(1) / 5 - x.squaredNorm() / 2; };
    solves_exactly(
        oscillator, [](auto const&, auto const& v) { return -v / 3; }, Q(1), Q(1, 2));
    solves_exactly(
        oscillator, [](auto const&, auto const&) { return Q(2); }, Q(1), Q(1, 2));
    solves_exactly(
        oscillator, [](auto const& t, auto const& x, auto const& v) { return t * x - v + 1; }, Q(1), Q(1, 2));
    vector<Q, 2> const q0{Q(1), Q(0)}, v0{Q(1, 2), Q(-1, 3)};
    solves_exactly(
        plane, [](auto const&, auto const& v) { return -v / 3; }, q0, v0);
    auto const turning = [](auto const& t, auto const& x, auto const& v) {
        auto f = v.eval(); // gyroscopic, and not symmetric
        f(0) = v(1) / 2 - x(0) / 7;
        f(1) = t - v(0);
        return f;
    };
    solves_exactly(plane, turning, q0, v0);
}
TEST_CASE("degrees: a force is the derivative of something of a degree more") {
    CHECK(degrees([](auto const&, auto const& v) { return -v; }) == dependence{3, 2, false});
    CHECK(degrees([](auto const&, auto const& v) { return -(v * v); }) == dependence{3, 3, false});
    CHECK(degrees([](auto const& x, auto const&) { return x * x * x; }) == dependence{4, 2, false});
    CHECK(degrees([](auto const& x, auto const& v) { return x * v; }) == dependence{3, 2, true});
    CHECK(degrees([](auto const& x, auto const& v) { return cos(x) - v; }).q > 4);
}

} // namespace node_tests
