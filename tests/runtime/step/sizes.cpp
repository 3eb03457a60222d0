// SPDX-License-Identifier: BSL-1.0
// Components of very different sizes, as an angle beside a distance in metres: each has its own digits. What moves alone moves as it would
// without the others, whatever they are.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace sizes_tests {

using namespace hilger;

namespace {

constexpr auto angle = [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
constexpr auto angle_with_mass = [](auto const& q, auto const& v) { return (2 + sin(q)) * v * v / 2 + cos(q); };
constexpr auto angle_with_powers = [](auto const& q, auto const& v) { return v * v / 2 + v * v * v * v / 40 + cos(q); };

/// Beside the angle a distance of 1e11 at a speed of 1e9, in a field of its own.
template <int Size, class L>
auto beside_a_distance(L const& of_angle) {
    return [of_angle](auto const& q, auto const& v) {
        auto sum = of_angle(q(0), v(0)) + v(1) * v(1) / 2 - sin(q(1) / 1e9) * 1e16;
        for (int k = 2; k < Size; ++k) sum = sum + v(k) * v(k) / 2 - q(k) * q(k) / 2;
        return sum;
    };
}
template <int Size, class E, class L>
double distance_from_alone(E const& how, L const& of_angle) {
    using V = Eigen::Matrix<double, Size, 1>;
    auto const T = uniform(0.0, 0.1, 200);
    V q = V::Constant(0.5), p = V::Zero();
    q(0) = 1;
    p(0) = 0.2;
    q(1) = 1e11;
    p(1) = 1e9;
    auto const alone = embed(of_angle, how).along(T, 1.0, 0.2);
    auto const both = embed(beside_a_distance<Size>(of_angle), how).along(T, q, p);
    double far = 0;
    auto x = alone.begin();
    for (auto const& y : both) {
        far = std::max(far, std::abs(y.q(0) - x->q));
        ++x;
    }
    return far;
}
/// 200 steps, each with a few roundings of a number of the size of 1, which a pendulum keeps to some tens of times.
constexpr double rounding = 200 * 64 * std::numeric_limits<double>::epsilon();

template <int Size, class E>
void keeps_the_digits_of_each(E const& how) {
    CAPTURE(how.name);
    CAPTURE(Size);
    CHECK(distance_from_alone<Size>(how, angle) <= rounding);
    CHECK(distance_from_alone<Size>(how, angle_with_mass) <= rounding);
    CHECK(distance_from_alone<Size>(how, angle_with_powers) <= rounding);
}

} // namespace

TEST_CASE("small components beside large ones keep their digits") {
    keeps_the_digits_of_each<2>(mid_point);
    keeps_the_digits_of_each<2>(theta<1, 3>);
    keeps_the_digits_of_each<2>(order_one);
    keeps_the_digits_of_each<2>(order_one_left);
    keeps_the_digits_of_each<2>(galerkin<2, gauss>);
    keeps_the_digits_of_each<2>(galerkin<3, lobatto>);
    keeps_the_digits_of_each<4>(mid_point);
    keeps_the_digits_of_each<6>(mid_point);
    keeps_the_digits_of_each<6>(galerkin<2, gauss>);
}

} // namespace sizes_tests
