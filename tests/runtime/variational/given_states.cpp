// SPDX-License-Identifier: BSL-1.0
// What is given as a state, an initial value or a boundary value, and becomes one without losing a digit: the same trajectory as from the
// state itself, bit for bit.
#include <doctest/doctest.h>

#include <array>
#include <span>
#include <vector>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/two_sided.hpp"

namespace given_states_tests {

using namespace hilger;

namespace {

struct oscillator {
    auto operator()(auto const& q, auto const& v) const {
        if constexpr (requires { q.dot(q); })
            return v.dot(v) / 2 - q.dot(q) / 2;
        else
            return v * v / 2 - q * q / 2;
    }
};
auto const flow_of_it = embed(oscillator{}, mid_point);
auto const T = uniform(0.0, 0.125, 8);

template <class Path>
auto end_of(Path const& path) {
    auto last = *path.begin();
    for (auto const& x : path) last = x;
    return last;
}
using vector = Eigen::Vector2d;
vector const x0(1, -2), p0(0.5, 3);

} // namespace

TEST_CASE("whole numbers and floats become doubles") {
    auto const right = end_of(flow_of_it.along(T, 1.0, 2.0));
    static_assert(std::same_as<decltype(right), state<double, double> const>);
    CHECK(end_of(flow_of_it.along(T, 1, 2)) == right);
    CHECK(end_of(flow_of_it.along(T, 1.0, 2)) == right);
    CHECK(end_of(flow_of_it.along(T, 1U, 2.0F)) == right);
    CHECK(end_of(flow_of_it.along(T, initial_velocity{1, 2.0})) == right); // p = v
    CHECK(end_of(flow_of_it.along(T, {.q0 = 1, .v0 = 2.0F})) == right);
}

TEST_CASE("whole numbers that double does not have are an error, and the largest that it has are not") {
    long long const last = 1LL << 53;
    CHECK(end_of(flow_of_it.along(T, last, 0)).t == 1);
    CHECK(end_of(flow_of_it.along(T, -last, 0)).t == 1);
    CHECK_THROWS_AS((void)flow_of_it.along(T, last + 1, 0), error::invalid_parameter);
    CHECK_THROWS_AS((void)flow_of_it.along(T, 0, -last - 1), error::invalid_parameter);
}

TEST_CASE("doubles become rationals and wide floats, exactly") {
    auto const exact = uniform(Q(0), Q(1, 8), 3);
    auto const x = end_of(flow_of_it.along(exact, 0.1, 2));
    CHECK(x == end_of(flow_of_it.along(exact, Q(3602879701896397, 36028797018963968), Q(2))));
    auto const fine = embed(oscillator{}, mid_point).along(uniform(float50(0), float50(1) / 8, 3), 0.1, 2);
    CHECK((*fine.begin()).q == float50(3602879701896397) / float50(36028797018963968));
}

TEST_CASE("expressions, rows, arrays and spans become columns") {
    auto const right = end_of(flow_of_it.along(T, x0, p0));
    static_assert(std::same_as<decltype(right), state<double, vector> const>);
    CHECK(end_of(flow_of_it.along(T, 2 * x0 - x0, p0 + 0 * x0)) == right);
    CHECK(end_of(flow_of_it.along(T, x0.transpose(), Eigen::RowVector2f(0.5F, 3))) == right);
    CHECK(end_of(flow_of_it.along(T, std::array<double, 2>{1, -2}, std::array<float, 2>{0.5, 3})) == right);
    double const q[] = {1, -2};
    int const whole[] = {1, -2};
    CHECK(end_of(flow_of_it.along(T, q, p0)) == right);
    CHECK(end_of(flow_of_it.along(T, whole, p0)) == right);
    CHECK(end_of(flow_of_it.along(T, x0, std::vector<double>{0.5, 3})) == right); // of the kind that q0 is
    auto const dynamic = end_of(flow_of_it.along(T, std::vector<double>{1, -2}, std::span<double const>(p0.data(), 2)));
    static_assert(std::same_as<decltype(dynamic), state<double, Eigen::VectorXd> const>);
    CHECK(dynamic.q == right.q);
    CHECK_THROWS_AS((void)flow_of_it.along(T, x0, std::vector<double>{1, 2, 3}), error::mismatch);
}

TEST_CASE("parts of different lengths are an error, whichever of them has its length in its type") {
    Eigen::VectorXd const three = Eigen::VectorXd::Ones(3), two = Eigen::VectorXd::Ones(2);
    CHECK_THROWS_AS(end_of(flow_of_it.along(T, initial_velocity{x0, three})), error::mismatch);
    CHECK_THROWS_AS(end_of(flow_of_it.along(T, initial_velocity{three, x0})), error::mismatch);
    CHECK_THROWS_AS(end_of(flow_of_it.along(T, initial_positions{x0, three})), error::mismatch);
    CHECK_THROWS_AS(solve(equation_of(flow_of_it, T), T, boundary_values{x0, three}), error::mismatch);
    auto const mixed = end_of(flow_of_it.along(T, initial_velocity{x0, two}));
    auto const right = end_of(flow_of_it.along(T, initial_velocity{x0, vector(1, 1)}));
    CHECK((mixed.q - right.q).norm() <= 8 * epsilon<double>() * right.q.norm());
}

TEST_CASE("in braces the kind of the state is that of its parts") {
    auto const right = end_of(flow_of_it.along(T, x0, p0));
    CHECK(end_of(flow_of_it.along(T, {.q0 = x0, .v0 = p0})) == right);
    CHECK(end_of(flow_of_it.along(T, {.q0 = 2 * x0 - x0, .v0 = p0.transpose()})) == right);
    CHECK(end_of(flow_of_it.along(T, {.q0 = {1, -2}, .v0 = {0.5, 3}})) == right);
    CHECK(end_of(flow_of_it.along(T, {.q0 = Eigen::VectorXd(x0), .v0 = Eigen::VectorXd(p0)})).q == right.q);
    auto const path = flow_of_it.along(T, 1.0, 2.0);
    auto at = path.begin();
    ++at;
    double const second = at->q;
    CHECK(std::abs(end_of(flow_of_it.along(T, {.q0 = 1, .q1 = second})).q - end_of(path).q) < 1e-14);

    constexpr unknown q;
    constexpr lagrangian L = oscillator{};
    auto const EL = variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T)));
    auto const x = solve(EL, T, {.q0 = x0, .v0 = p0});
    static_assert(std::same_as<std::remove_cvref_t<decltype(x[0])>, vector>);
    CHECK(x[8] == right.q);
    CHECK(solve(EL, T, {.q0 = {1, -2}, .v0 = p0})[8] == right.q);
    CHECK(solve(EL, T, {.q0 = 1, .v0 = 2})[8] == end_of(flow_of_it.along(T, 1.0, 2.0)).q);
    CHECK(solve(EL, T, initial_velocity{x0, p0.transpose()})[8] == right.q);
    CHECK((solve(EL, T, {.q0 = x0, .q1 = x[1]})[8] - right.q).norm() < 1e-14);
}

TEST_CASE("a momentum is no velocity") {
    constexpr lagrangian L{[](auto const& x, auto const& v) { return 3 * v * v / 2 + x * v - x * x / 2; }}; // p = 3 v + x at h = 0
    auto const exact = uniform(Q(0), Q(1, 4), 3);
    constexpr unknown q;
    auto const EL = variation(integral(L(q, Delta_plus[q]), exact));
    auto const x = solve(EL, exact, {.q0 = 2, .p0 = Q(1, 3)});
    index_type i = 0;
    for (auto const& s : flow_of(EL).along(exact, Q(2), Q(1, 3))) CHECK(x[i++] == s.q);
    // p_0 = -d L_h(q_0, q_1) / d q_0 = 3 w + x - h (w - x), where w is the first difference
    CHECK(3 * (x[1] - x[0]) * 4 + x[0] - (x[1] - x[0]) + x[0] / 4 == Q(1, 3));
    CHECK(solve(EL, exact, initial_momentum{Q(2), Q(1, 3)})[3] == x[3]);
    auto const path = flow_of_it.along(T, {.q0 = x0, .p0 = {0.5, 3}});
    CHECK(end_of(path) == end_of(flow_of_it.along(T, x0, p0)));
    CHECK_THROWS_AS(end_of(flow_of_it.along(T, {.q0 = Eigen::VectorXd::Ones(2), .p0 = Eigen::VectorXd::Ones(3)})), error::mismatch);
}

TEST_CASE("to a wanted accuracy, and between two given ends") {
    auto const x = solve(oscillator{}, interval{0.0, 1.0}, {.q0 = {1, -2}, .v0 = p0}, accuracy{1e-6});
    CHECK((x.end.q - (x0 * std::cos(1.0) + p0 * std::sin(1.0))).norm() < 1e-6);

    auto const D = uniform(0.0, 0.125, 8);
    auto const EL = testing::two_sided(oscillator{}, fraction<3, 4>{}, D);
    CHECK(solve(EL, D, boundary_values{0, 1})[4] == solve(EL, D, {.q0 = 0.0, .qN = 1.0})[4]);
    CHECK(solve(EL, D, boundary_values{0 * x0, p0.transpose()})[4] == solve(EL, D, boundary_values{vector(0, 0), p0})[4]);
}

} // namespace given_states_tests
