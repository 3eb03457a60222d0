// SPDX-License-Identifier: BSL-1.0
// Derivatives by jets: powers, squares, products and functions of one variable, of the same and of different ones, in every way that one
// writes them, equal what the rules of calculus give; exactly in rationals.
#include <cmath>

#include <doctest/doctest.h>

#include "hilger/differentiation/derivatives.hpp"
#include "hilger/multiprecision.hpp"

namespace derivatives_tests {

using namespace hilger;

namespace {

/// by_q, by_v, qq, qv, vv at q = 3/2, v = -5/4.
template <class F>
void check(F const& f, Q by_q, Q by_v, Q qq, Q qv, Q vv) {
    auto const same = [&](auto const& e, auto const& of, double tolerance) {
        auto const near = [&](auto const& x, Q const& y) { return magnitude(x - of(y)) <= tolerance * (1 + magnitude(of(y))); };
        CHECK(near(e.by_q, by_q));
        CHECK(near(e.by_v, by_v));
        CHECK(near(e.qq, qq));
        CHECK(near(e.qv, qv));
        CHECK(near(e.vv, vv));
    };
    same(
        expand(f, Q(3, 2), Q(-5, 4)), [](Q const& y) { return y; }, 0);
    same(
        expand(f, 1.5, -1.25), [](Q const& y) { return static_cast<double>(y); }, 8 * epsilon<double>());
}
Q const q(3, 2), v(-5, 4);

} // namespace

TEST_CASE("powers of one variable, however they are written") {
    check([](auto const& x, auto const&) { return x * x; }, 2 * q, 0, 2, 0, 0);
    check([](auto const& x, auto const&) { return x * x * x; }, 3 * q * q, 0, 6 * q, 0, 0);
    check([](auto const& x, auto const&) { return x * (x * x); }, 3 * q * q, 0, 6 * q, 0, 0);
    check([](auto const& x, auto const&) { return (x * x) * (x * x); }, 4 * q * q * q, 0, 12 * q * q, 0, 0);
    check(
        [](auto const& x, auto const&) {
            auto const y = x * x;
            return y * y;
        },
        4 * q * q * q, 0, 12 * q * q, 0, 0);
    check([](auto const& x, auto const&) { return 7 * x * x * x * x / 2 * x; }, Q(35, 2) * q * q * q * q, 0, 70 * q * q * q, 0, 0);
    check([](auto const& x, auto const&) { return -(x * x) * (3 * x); }, -9 * q * q, 0, -18 * q, 0, 0);
    check([](auto const& x, auto const&) { return pow(x, 3) * x; }, 4 * q * q * q, 0, 12 * q * q, 0, 0);
    check([](auto const& x, auto const&) { return pow(x * x, 2) * pow(x, -1); }, 3 * q * q, 0, 6 * q, 0, 0);
}

TEST_CASE("what is a power no longer is not taken for one") {
    check([](auto const& x, auto const&) { return (x * x + 1) * x; }, 3 * q * q + 1, 0, 6 * q, 0, 0);
    check([](auto const& x, auto const&) { return x * (x - 1) * x; }, 3 * q * q - 2 * q, 0, 6 * q - 2, 0, 0);
    check([](auto const& x, auto const&) { return (1 - x * x) * (x + x); }, 2 - 6 * q * q, 0, -12 * q, 0, 0);
    check(
        [](auto const& x, auto const&) {
            auto y = x;
            y += 2;
            y *= x;
            y -= 1;
            return y * y * x; // (x^2 + 2 x - 1)^2 x
        },
        (q * q + 2 * q - 1) * (q * q + 2 * q - 1) + 4 * q * (q * q + 2 * q - 1) * (q + 1), 0,
        8 * (q * q + 2 * q - 1) * (q + 1) + 8 * q * (q + 1) * (q + 1) + 4 * q * (q * q + 2 * q - 1), 0, 0);
    check(
        [](auto const& x, auto const&) {
            auto const r = x / 3 - 2;
            return r * r * r / 2 + r * r; // the same expression, which is no variable
        },
        (q / 3 - 2) * (q / 3 - 2) / 2 + (q / 3 - 2) * 2 / 3, 0, (q / 3 - 2) / 3 + Q(2, 9), 0, 0);
    check([](auto const& x, auto const&) { return x * x / x * x; }, 2 * q, 0, 2, 0, 0);
}

TEST_CASE("a power of a sum of squares at its bottom") {
    auto const cubic = [](auto const& x, auto const&) { return pow(x.dot(x), 1.5); }; // |x|^3
    auto const drag = [](auto const& x, auto const&) { return pow(x.dot(x), 0.5) * x(0); };
    Eigen::Vector2d const zero(0, 0);
    for (auto const& e : {expand(cubic, zero, zero), expand(drag, zero, zero)}) {
        CHECK(e.by_q == zero);
        CHECK(e.qq == Eigen::Matrix2d::Zero());
    }
    double const none = 0;
    auto const slope = expand([](auto const& x, auto const&) { return pow(x, 1.5); }, none, none);
    CHECK(slope.by_q == 0);
    CHECK(not std::isfinite(slope.qq)); // of x itself it is infinite
    auto const steep = expand([](auto const& x, auto const&) { return pow(x, 0.5); }, none, none);
    CHECK(not std::isfinite(steep.by_q));
}

TEST_CASE("powers of one variable beside powers of another") {
    check([](auto const& x, auto const& y) { return x * x * x * y; }, 3 * q * q * v, q * q * q, 6 * q * v, 3 * q * q, 0);
    check([](auto const& x, auto const& y) { return x * y * x * y * y; }, 2 * q * v * v * v, 3 * q * q * v * v, 2 * v * v * v,
          6 * q * v * v, 6 * q * q * v);
    check([](auto const& x, auto const& y) { return (x * x + y * y) * (x * x + y * y); }, 4 * q * (q * q + v * v), 4 * v * (q * q + v * v),
          12 * q * q + 4 * v * v, 8 * q * v, 4 * q * q + 12 * v * v);
    check([](auto const& x, auto const& y) { return y * y * y / 3 - 2 * x * x * y; }, -4 * q * v, v * v - 2 * q * q, -4 * v, -4 * q, 2 * v);
    check([](auto const& x, auto const& y) { return 1 / (x * x * y); }, -2 / (q * q * q * v), -1 / (q * q * v * v), 6 / (q * q * q * q * v),
          2 / (q * q * q * v * v), 2 / (q * q * v * v * v));
}

TEST_CASE("functions of functions of powers") {
    // d/dq exp(sin(q^3)), d2/dq2
    auto const f = [](auto const& x, auto const& y) { return exp(sin(x * x * x)) * y; };
    float50 const x(1.5), y(-1.25);
    auto const e = expand(f, x, y);
    float50 const cube = x * x * x, g = exp(sin(cube)), c = cos(cube), s = sin(cube);
    auto const near = [](float50 const& a, float50 const& b) { return abs(a - b) <= 64 * epsilon<float50>() * (1 + abs(b)); };
    CHECK(near(e.by_q, 3 * x * x * c * g * y));
    CHECK(near(e.by_v, g));
    CHECK(near(e.qq, (9 * x * x * x * x * (c * c - s) + 6 * x * c) * g * y));
    CHECK(near(e.qv, 3 * x * x * c * g));
    CHECK(e.vv == 0);
}

TEST_CASE("components of a vector are different variables") {
    using vector = Eigen::Matrix<Q, 3, 1>;
    auto const f = [](auto const& x, auto const& y) { return x(0) * x(1) * x(0) * x(2) + y(2) * y(2) * y(2) * x(1) + x.dot(y); };
    vector const a(2, Q(-1, 3), 5), b(Q(1, 2), 7, -3);
    auto const e = expand(f, a, b);
    CHECK(e.by_q == vector(2 * a(0) * a(1) * a(2) + b(0), a(0) * a(0) * a(2) + b(2) * b(2) * b(2) + b(1), a(0) * a(0) * a(1) + b(2)));
    CHECK(e.by_v == vector(a(0), a(1), 3 * b(2) * b(2) * a(1) + a(2)));
    CHECK(e.qq(0, 0) == 2 * a(1) * a(2));
    CHECK(e.qq(1, 0) == 2 * a(0) * a(2));
    CHECK(e.qq(0, 2) == 2 * a(0) * a(1));
    CHECK(e.qq(1, 1) == 0);
    CHECK(e.qv(1, 2) == 3 * b(2) * b(2));
    CHECK(e.qv(2, 1) == 0);
    CHECK(e.vv(2, 2) == 6 * b(2) * a(1));
    CHECK(e.vv(0, 0) == 0);
    // and of first order alone, which gradients of large states are made of
    CHECK(gradient_first(f, a, b) == e.by_q);
    CHECK(gradient_second(f, a, b) == e.by_v);
}

TEST_CASE("the value of a quotient is the one of plain numbers, to the bit, so that comparisons come out alike") {
    using number = jet<double, 0, 2, 2>;
    int others = 0;
    for (double x = 1; x < 60; ++x)
        for (double y = 1; y < 60; ++y) {
            auto const a = number::variable(x, 0, {1, 0}), b = number::variable(y, 1, {0, 1});
            others +=
                (a / b).value == x / y and (x / b).value == x / y and (a / y).value == x / y and (number(x) / number(y)).value == x / y ? 0
                                                                                                                                        : 1;
        }
    CHECK(others == 0);
}

TEST_CASE("sums over the components of a vector are those that are written out") {
    auto const check = []<int N>(std::integral_constant<int, N>) {
        using vector = Eigen::Matrix<Q, N, 1>;
        vector a, b, c;
        for (int k = 0; k < N; ++k) {
            a(k) = Q(2 * k + 1, 3);
            b(k) = Q(5 - 3 * k, 7);
            c(k) = Q(k * k - 2, 5);
        }
        auto const written = [&](auto const& x, auto const& y) {
            auto squares = x(0) * x(0);
            auto sum = 1 * y(0);
            auto products = x(0) * y(0);
            auto known = x(0) * c(0);
            auto other = x(0) * (x(0) + y(0));
            for (int k = 1; k < N; ++k) {
                squares = squares + x(k) * x(k);
                sum = sum + y(k);
                products = products + x(k) * y(k);
                known = known + x(k) * c(k);
                other = other + x(k) * (x(k) + y(k));
            }
            return squares * sum + products * known * sum + other * squares;
        };
        auto const called = [&](auto const& x, auto const& y) {
            return x.squaredNorm() * y.sum() + x.dot(y) * x.dot(c) * y.sum() + x.dot(x + y) * x.dot(x);
        };
        auto const e = expand(called, a, b), f = expand(written, a, b);
        CHECK(called(a, b) == written(a, b));
        CHECK(e.by_q == f.by_q);
        CHECK(e.by_v == f.by_v);
        CHECK(e.qq == f.qq);
        CHECK(e.qv == f.qv);
        CHECK(e.vv == f.vv);
    };
    check(std::integral_constant<int, 1>{});
    check(std::integral_constant<int, 2>{});
    check(std::integral_constant<int, 3>{});
    check(std::integral_constant<int, 4>{});
    // |x|, and a product that Eigen/Core declares alone
    Eigen::Vector3d const a(3, 0, 4), b(1, 2, -1);
    auto const e = expand([](auto const& x, auto const& y) { return x.norm() + x.cross(y).z(); }, a, b);
    CHECK((e.by_q - Eigen::Vector3d(3.0 / 5 + 2, -1, 4.0 / 5)).norm() <= 4 * epsilon<double>());
    CHECK(e.by_v == Eigen::Vector3d(0, 3, 0));
}

} // namespace derivatives_tests
