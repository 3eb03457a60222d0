// SPDX-License-Identifier: BSL-1.0
// The Lagrangian in a transformed time: in rationals its equation at E = energy is that of L in the new time; with g = 1 it is L, to the
// bit.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "support/systems.hpp"

namespace time_transformation_tests {

using namespace hilger;

namespace {

using plane = Eigen::Matrix<Q, 2, 1>;

/// Not separable, with a magnetic term.
constexpr auto in_line = [](auto const& x, auto const& v) { return v * v * (1 + x * x) / 2 + v * x * x / 3 - x * x * x; };
constexpr auto in_plane = [](auto const& x, auto const& v) {
    return v.dot(v) * (1 + x(0) * x(1)) / 2 + x.dot(x) * v(1) / 3 - x(0) * x(0) * x(1);
};
constexpr auto rate_in_line = [](auto const& x) { return (2 + x) / (1 + x * x); };
constexpr auto rate_in_plane = [](auto const& x) { return (2 + x(1)) / (1 + x.dot(x)); };

Q transposed(Q const& x) { return x; }
Eigen::Matrix<Q, 2, 2> transposed(Eigen::Matrix<Q, 2, 2> const& x) { return x.transpose(); }

template <class V>
V gradient_of_rate(auto const& g, V const& x) {
    return gradient_first([&](auto const& y, auto const&) { return g(y); }, x, x);
}

/// Whether every derivative is that of g (L + E) with q' = g v, and the equation with any acceleration is g times that of L.
template <class V, class L, class G>
void check_equation(L const& l, G const& g, V const& q, V const& v, V const& acceleration) {
    auto const of_L = expand(l, q, v);
    Q const E = dot_product(of_L.by_v, v) - l(q, v), rate = g(q);
    V const slope = gradient_of_rate(g, q);
    V const w = v * rate;
    auto const at = expand(transform_time(l, g, E), q, w);
    CHECK(at.by_v == of_L.by_v);
    CHECK(at.by_q == V(of_L.by_q * rate));
    CHECK(evaluated(at.vv * rate) == of_L.vv);
    // w' = d(g v)/dtau = g (g v)' in the time of L
    V const w_slope = (v * dot_product(slope, v) + acceleration * rate) * rate;
    V const equation = at.vv * w_slope + transposed(at.qv) * w - at.by_q;
    V const plain = of_L.vv * acceleration + transposed(of_L.qv) * v - of_L.by_q;
    CHECK(equation == V(plain * rate));
    // another energy is another system: the first term is what remains
    auto const above = expand(transform_time(l, g, Q(E + 1)), q, w);
    CHECK(above.by_q == V(at.by_q + slope));
    CHECK(above.by_v == at.by_v);
}
/// Whether walks from q and p have the same states, and move.
template <class Plain, class Transformed, class V>
bool are_same(Plain const& plain, Transformed const& transformed, V const& q, V const& p) {
    auto const T = uniform(0.0, 0.0625, 40);
    auto const a = record(plain.along(T, q, p)).states, b = record(transformed.along(T, q, p)).states;
    return a == b and not(a.back().q == q);
}
/// With g = 1, under an embedding.
template <class L, class V>
bool changes_nothing(L const& l, V const& q, V const& p) {
    auto const one = [](auto const&) { return 1; };
    auto const same = transform_time(l, one, 0.25);
    return are_same(embed(l, mid_point), embed(same, mid_point), q, p) and are_same(embed(l, order_one), embed(same, order_one), q, p) and
           are_same(embed(l, galerkin<3, gauss>), embed(same, galerkin<3, gauss>), q, p) and
           are_same(embed(l, mid_point, compensated), embed(same, mid_point, compensated), q, p) and
           are_same(stoermer_verlet(l), stoermer_verlet(same), q, p);
}

} // namespace

TEST_CASE("at the energy of the motion the equation is that of L in the new time: numbers") {
    check_equation(in_line, rate_in_line, Q(1, 3), Q(2, 5), Q(7, 4));
    check_equation(in_line, rate_in_line, Q(-5, 4), Q(3), Q(-1, 9));
}
TEST_CASE("and vectors") {
    check_equation(in_plane, rate_in_plane, plane(Q(1, 3), Q(3, 2)), plane(Q(2, 5), Q(-1)), plane(Q(7, 4), Q(1, 6)));
    check_equation(in_plane, rate_in_plane, plane(Q(-1, 2), Q(1, 5)), plane(Q(4), Q(3, 7)), plane(Q(0), Q(-2)));
}

TEST_CASE("g = 1 is the plain time, to the bit") {
    CHECK(changes_nothing(testing::pendulum, 1.0, 0.5));
    CHECK(changes_nothing(in_line, 0.5, 0.25));
    CHECK(changes_nothing(testing::kepler, Eigen::Vector2d(1, 0.25), Eigen::Vector2d(0.1, 0.75)));
    CHECK(changes_nothing(in_plane, Eigen::Vector2d(0.5, 0.25), Eigen::Vector2d(0.1, 0.75)));
    Eigen::VectorXd q(6), p(6);
    q << 1, 0.5, 0.25, 0.125, 0.75, -0.5;
    p << 0, 0.25, -0.5, 1, 0.5, 0.25;
    CHECK(changes_nothing(testing::kepler, q, p));
}

TEST_CASE("the Legendre map of L passes through, and a Hamiltonian is transformed as its Lagrangian") {
    auto const U = [](auto const& x) { return x.dot(x) * x.dot(x) / 4; };
    auto const g = [](auto const& x) { return 1 + x.dot(x); };
    Eigen::Vector2d const q(0.5, 1), w(2.25, 4.5); // g = 9/4
    auto const of_model = transform_time(mechanical(2.0, U), g, 0.5);
    CHECK(of_model.momentum(q, w) == Eigen::Vector2d(2, 4));
    CHECK(of_model.velocity(q, Eigen::Vector2d(2, 4)) == w);

    auto const H = [U](auto const& p, auto const& x) { return p.dot(p) / 4 + U(x); };
    auto const of_H = expand(transform_time(lagrangian_of(H), g, 0.5), q, w), of_L = expand(of_model, q, w);
    double const rounding = 64 * epsilon<double>();
    CHECK(magnitude(evaluated(of_H.by_q - of_L.by_q)) <= rounding);
    CHECK(magnitude(evaluated(of_H.by_v - of_L.by_v)) <= rounding);
    CHECK(magnitude(evaluated(of_H.qq - of_L.qq)) <= rounding);
    CHECK(magnitude(evaluated(of_H.qv - of_L.qv)) <= rounding);
    CHECK(magnitude(evaluated(of_H.vv - of_L.vv)) <= rounding);
}

TEST_CASE("rates by name") {
    Eigen::Vector2d const q(3, 4);
    CHECK(sundman(1)(q) == 5);
    CHECK(sundman(2)(q) == 25);
    CHECK(sundman(-1)(q) == doctest::Approx(0.2));
    CHECK(sundman(1.5)(q) == doctest::Approx(std::pow(5.0, 1.5)));
    CHECK(sundman(3)(-2.0) == 8);
    CHECK(sundman(2, [](auto const& x) { return x(0) - x(1); })(q) == 1);
    CHECK(inverse_potential(testing::kepler)(q) == 5);
    CHECK(inverse_potential([](auto const& x, auto const& v) { return v * v - x; })(-4.0) == 0.25);
}

TEST_CASE("with the time and the energy as coordinates: t' = g, e' = -g dL/dt, and the equations of q are those of L") {
    using vector = Eigen::Matrix<Q, 3, 1>;
    auto const L = [](auto const& t, auto const& x, auto const& v) {
        return v(0) * v(0) * (1 + x(0) * x(0)) / 2 + t * v(0) * x(0) - t * t * x(0);
    };
    auto const g = [](auto const& x) { return (2 + x(0)) / (1 + x(0) * x(0)); };
    Q const t(1, 2), q(1, 3), v(2, 5), rate = g(Eigen::Matrix<Q, 1, 1>(q));
    auto const at_t = [&](auto const& x, auto const& y) { return y * y * (1 + x * x) / 2 + t * y * x - t * t * x; };
    auto const plain = expand(at_t, q, v);
    Q const H = plain.by_v * v - at_t(q, v), by_t = v * q - 2 * t * q;
    vector const x(q, t, H), w(Q(rate * v), rate, Q(-rate * by_t));
    auto const found = expand(transform_time(L, g), x, w);
    CHECK(found.by_v == vector(plain.by_v, Q(-H), Q(0)));
    CHECK(found.by_q == vector(Q(rate * plain.by_q), Q(rate * by_t), Q(0))); // dL^/de = g - t' = 0
    auto const of_t = transform_time(L, g);
    CHECK(of_t.momentum(x, w) == found.by_v);
    CHECK(of_t.velocity(x, of_t.momentum(x, w)) == vector(w(0), w(1), Q(0)));

    // a force adds its power to the equation of t: d(-e)/dtau = g dL/dt - g f v
    auto const forced = transform_time(with_force(L, [](auto const& s, auto const& y, auto const& u) { return evaluated(s * y - u); }), g);
    Q const f = t * q - v;
    auto const force = detail::force_at(forced.force, Q(0), x, w);
    CHECK(force == vector(Q(rate * f), Q(-rate * f * v), Q(0)));
}

} // namespace time_transformation_tests
