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

/// Beside the angle a distance of 1e11 at a speed of 1e9, in a field of its own, of a body as heavy as a star in kilograms or not.
template <int Size, class L>
auto beside_a_distance(L const& of_angle, double mass) {
    return [of_angle, mass](auto const& q, auto const& v) {
        auto sum = of_angle(q(0), v(0)) + mass * (v(1) * v(1) / 2 - sin(q(1) / 1e9) * 1e16);
        for (int k = 2; k < Size; ++k) sum = sum + v(k) * v(k) / 2 - q(k) * q(k) / 2;
        return sum;
    };
}
template <int Size, class E, class L>
double distance_from_alone(E const& how, L const& of_angle, double mass) {
    using V = Eigen::Matrix<double, Size, 1>;
    auto const T = uniform(0.0, 0.1, 200);
    V q = V::Constant(0.5), p = V::Zero();
    q(0) = 1;
    p(0) = 0.2;
    q(1) = 1e11;
    p(1) = 1e9 * mass;
    auto const alone = embed(of_angle, how).along(T, 1.0, 0.2);
    auto const both = embed(beside_a_distance<Size>(of_angle, mass), how).along(T, q, p);
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
    for (double const mass : {1.0, 1e30}) {
        CAPTURE(mass);
        CHECK(distance_from_alone<Size>(how, angle, mass) <= rounding);
        CHECK(distance_from_alone<Size>(how, angle_with_mass, mass) <= rounding);
        CHECK(distance_from_alone<Size>(how, angle_with_powers, mass) <= rounding);
    }
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

TEST_CASE("a step whose equation is beyond the largest number is refused, not stood still") {
    lagrangian const spring{[](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; }};
    lagrangian const springs{[](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; }};
    auto const check = [](auto const& f, auto const& q) {
        using V = std::remove_cvref_t<decltype(q)>;
        V const at_rest = q - q;
        for (double const h : {1e150, 1e160, 1e200, 1e300}) { // h^2 is beyond it from 1e155 on
            CAPTURE(h);
            try {
                auto const end = f.step(state<double, V>{0, q, at_rest}, h);
                CHECK(magnitude(V(end.q + q)) <= 1e-12); // q_1 = (4 - h^2) / (4 + h^2)
            } catch (error::exception const&) {
                CHECK(h > 1e155);
            }
        }
    };
    check(embed(spring, mid_point), 1.0);
    check(embed(springs, mid_point), Eigen::Vector2d(1, 0.5));
    check(embed(springs, mid_point), Eigen::Vector4d(1, 0.5, -1, 0));
    check(embed(springs, mid_point), Eigen::VectorXd(Eigen::Vector4d(1, 0.5, -1, 0)));
    check(embed(with_force(spring, [](auto const& q, auto const&) { return 0 * q; }), mid_point), 1.0);
}

/// A quartic oscillator with lengths in units of 2^length and times in units of 2^time: in binary numbers all its steps are those of the
/// units 1, or beyond the numbers there are.
struct in_units {
    double length, time;
    auto operator()(auto const& q, auto const& v) const {
        auto const x = q / length;
        auto const y = v * time / length;
        return y * y / 2 - x * x / 2 - x * x * x * x / 4;
    }
};

TEST_CASE("in units of any size a step is the same, or refused") {
    auto const check = [](auto const& method) {
        auto const positions = [&](double length, double time) {
            std::vector<double> q;
            for (auto const& x :
                 method(lagrangian{in_units{length, time}}).along(uniform(0.0, time / 8, 10), initial_velocity{length, 0.0}))
                q.push_back(x.q / length);
            return q;
        };
        auto const known = positions(1, 1);
        int same = 0;
        for (int length = -480; length <= 480; length += 80)
            for (int time = -640; time <= 640; time += 160) {
                if (std::abs(time - length) > 500) continue; // the mass is no normal number
                CAPTURE(length);
                CAPTURE(time);
                try {
                    auto const q = positions(std::ldexp(1.0, length), std::ldexp(1.0, time));
                    CHECK(q == known);
                    ++same;
                } catch (error::exception const& why) {
                    CAPTURE(why.what());
                    CHECK(std::abs(length) + std::abs(time) > 500);
                }
            }
        CHECK(same > 40);
    };
    check([](auto const& L) { return embed(L, order_one); });
    check([](auto const& L) { return embed(L, mid_point); });
    check([](auto const& L) { return embed(L, theta<1, 3>); });
    check([](auto const& L) { return embed(L, galerkin<2, gauss>); });
    check([](auto const& L) { return embed(L, galerkin<4, gauss>); });
    check([](auto const& L) { return embed(L, galerkin<3, lobatto>); });
}

} // namespace sizes_tests
