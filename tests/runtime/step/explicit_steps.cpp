// SPDX-License-Identifier: BSL-1.0
// Order one of L = v.Mv/2 + a.v - U(q) written as a plain lambda, in any dimension: one force, one solve with constant factors, and what is
// returned solves the equation. Where the formula of L has other parts, or the node is not at an end of the step, there are rounds.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "support/requirements.hpp"
#include "support/systems.hpp"

namespace explicit_steps_tests {

using namespace hilger;

namespace {

template <class S, int D>
using vector = Eigen::Matrix<S, D, 1>;

/// Masses that differ, a magnetic term that is linear in v, quartic neighbours.
constexpr auto separable = [](auto const& q, auto const& v) {
    auto L = v(0) * v(0) * 3 / 2 + v(1) / 3;
    for (int k = 1; k < q.size(); ++k) {
        auto const r = q(k) - q(k - 1);
        L = L + v(k) * v(k) / (k + 1) - r * r / 2 - r * r * r * r / 4;
    }
    return L - q(0) * q(0);
};
/// Masses that are coupled.
constexpr auto coupled_masses = [](auto const& q, auto const& v) { return separable(q, v) + v(0) * v(2) / 5 + v(1) * v(2) / 7; };

template <class S, int D>
struct start {
    vector<S, D> q, p;
    explicit start(int d) : q(d), p(d) {
        for (int k = 0; k < d; ++k) {
            q(k) = S(1) / S(k + 3);
            p(k) = S(1) / S(5 - k) - S(k % 2);
        }
    }
};
template <int D, class L, class T>
void solves_its_equation(L const& l, T const& scale) {
    start<Q, D> const x(5);
    CHECK(largest_residual(embed(l, order_one).along(scale, x.q, x.p)) == 0);
    CHECK(largest_residual(embed(l, order_one_left).along(scale, x.q, x.p)) == 0);
}
/// Of a Lagrangian with a cosine: a force makes one sine, a second derivative one cosine. What stands beside it is `more`.
template <class How, class L, class V, class More = std::identity>
testing::requirements asked(How const& how, L const& l, V const& q, V const& p, More const& more = {}) {
    auto const with_cosine = [l](auto const& x, auto const& v) { return l(x, v) + cos(x(1)) / 4; };
    return testing::requirements_of(embed(more(with_cosine), how).along(uniform(0.0, 0.05, 40), q, p));
}
/// One force, and no second derivative of L, so that there are no rounds.
void looks_once(testing::requirements const& r) {
    CHECK(r.sines == 1);
    CHECK(r.cosines == 0);
    CHECK(r.growth_in_bytes == 0);
}

} // namespace

TEST_CASE("explicit steps solve the derived equation, exactly") {
    solves_its_equation<Eigen::Dynamic>(separable, uniform(Q(0), Q(1, 10), 3));
    solves_its_equation<5>(coupled_masses, time_scale<Q>{Q(0), Q(1, 3), Q(1, 2), Q(1, 2) + Q(1, 7)});
}

TEST_CASE("of many components whose values stand together, and of those that stand apart, the equation is solved") {
    auto const many = [](auto const& q, auto const& v) {
        auto L = v.dot(v) / 2 - q(0) * q(0);
        for (int k = 1; k < q.size(); ++k) {
            auto const r = q(k) - q(k - 1);
            L = L - r * r / 2 - r * r * r * r / 4;
            if (k == 20) L = L - q(k) * q(k) * q(k) / 3; // what breaks the row
        }
        return L;
    };
    int const d = 40;
    vector<Q, Eigen::Dynamic> q(d), p(d);
    for (int k = 0; k < d; ++k) q(k) = Q(k % 7, 8), p(k) = Q(3 - k % 5, 4);
    auto const friction = [](auto const& q_, auto const& v) { return plain_t<decltype(q_ + v)>(-v / 4 + 0 * q_); };
    auto const T = uniform(Q(0), Q(1, 4), 2);
    for (auto const& r :
         {largest_residual(embed(many, order_one).along(T, q, p)), largest_residual(embed(many, order_one_left).along(T, q, p)),
          largest_residual(embed(with_force(many, friction), order_one).along(T, q, p)),
          largest_residual(embed(with_force(many, friction), order_one_left).along(T, q, p))})
        CHECK(r == 0);
    Eigen::VectorXd const x = q.cast<double>(), y = p.cast<double>();
    double const h = 0.125, rounding = 16 * std::numeric_limits<double>::epsilon() / (h * h);
    CHECK(largest_residual(embed(many, mid_point).along(uniform(0.0, h, 40), x, y)) <= rounding);
    CHECK(largest_residual(embed(many, galerkin<2, gauss>).along(uniform(0.0, h, 20), x, y)) <= 4 * rounding); // points at h/2
}

TEST_CASE("explicit steps take forces, exactly") {
    auto const T = time_scale<Q>{Q(0), Q(1, 3), Q(1, 2), Q(1, 2) + Q(1, 7)};
    auto const of_position = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(q.cwiseProduct(q) / 3 + 0 * v); };
    auto const friction = [](auto const& q, auto const& v) {
        plain_t<decltype(q + v)> f = -v / 4 - q.cwiseProduct(q) / 7;
        f(1) = f(1) + v(3) / 5;
        f(4) = f(4) - v(0) / 9;
        return f;
    };
    auto const each_by_its_own = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(-v / 4 - q / 5); };
    auto const solves = [&](auto const& force) {
        solves_its_equation<5>(with_force(separable, force), T);
        solves_its_equation<Eigen::Dynamic>(with_force(coupled_masses, force), T);
    };
    solves(of_position);
    solves(friction);
    solves(each_by_its_own);
    auto const quadratic = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(q / 5 - v.cwiseProduct(v) / 4); };
    start<Q, 5> const x(5);
    CHECK(largest_residual(embed(with_force(coupled_masses, quadratic), order_one_left).along(T, x.q, x.p)) == 0);
}

TEST_CASE("explicit steps ask for one force and solve nothing") {
    start<double, 5> const x(5);
    auto const right = asked(order_one, separable, x.q, x.p), coupled = asked(order_one, coupled_masses, x.q, x.p);
    looks_once(right);
    looks_once(asked(order_one_left, separable, x.q, x.p));
    looks_once(coupled);
    CHECK(right.divisions == 0);
    CHECK(coupled.arithmetic <= right.arithmetic + 2 * 5 * 5); // the factors of the masses are made once
}

TEST_CASE("explicit steps with a force ask for one force, and solve with what it changes by with the velocity") {
    start<double, 5> const x(5);
    auto const friction = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(-v / 4 - q / 5); };
    auto const drag = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(-v.cwiseProduct(v) / 4 - q / 5); };
    auto const asked_with = [&](auto const& how, auto const& force) {
        return asked(how, separable, x.q, x.p, [&](auto const& l) { return with_force(l, force); });
    };
    looks_once(asked_with(order_one, friction));
    looks_once(asked_with(order_one_left, friction));
    looks_once(asked_with(order_one_left, drag));
    CHECK(asked_with(order_one, drag).arithmetic > 2 * asked_with(order_one, friction).arithmetic); // rounds
}

TEST_CASE("what has other parts is solved for") {
    start<double, 5> const x(5);
    double const h = 0.05;
    auto const solved = [&](auto const& l, auto const& how) {
        double const far = largest_residual(embed(l, how).along(uniform(0.0, h, 40), x.q, x.p));
        CHECK(far <= 4 * std::numeric_limits<double>::epsilon() / (h * h)); // masses to 3 times differences of differences of rounded q
    };
    solved([](auto const& q, auto const& v) { return separable(q, v) + q(1) * v(3) / 3; }, order_one);
    solved([](auto const& q, auto const& v) { return separable(q, v) + q(0) * q(0) * v(0) * v(0) / 4; }, order_one_left);
    solved([](auto const& q, auto const& v) { return separable(q, v) + v(0) * v(0) * v(0) * v(0) / 50; }, order_one);
    solved([](auto const& q, auto const& v) { return separable(q, v) - max(q(0) - q(3), 0.0) * max(q(0) - q(3), 0.0) * 3; },
           order_one_left);
    solved([](auto const& t, auto const& q, auto const& v) { return separable(q, v) * (1 + t); }, order_one);
    solved([](auto const& q, auto const& v) { return separable(q, v) * (q(0) > 0.3 ? 1 : 2); }, order_one); // masses of a branch
    solved(separable, mid_point);
    auto const drag = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(-v.cwiseProduct(v) / 4 - q / 5); };
    solved(with_force(separable, drag), order_one);
    auto const rougher_there = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(v * (q(0) > 0.3 ? -1 : -2) + 0 * q); };
    solved(with_force(separable, rougher_there), order_one);
    auto const on_one_side = [](auto const& q, auto const& v) { return plain_t<decltype(q + v)>(max(v(0), 0.0) * q); };
    solved(with_force(separable, on_one_side), order_one);
    solved(with_force(separable, on_one_side), order_one_left);
    solved(with_force(separable, [](auto const& t, auto const& q, auto const& v) { return plain_t<decltype(q + v)>(t * q - t * v); }),
           order_one);
}

TEST_CASE("what says that it is mechanical is solved for where it has no step of its own") {
    start<Q, Eigen::Dynamic> const x(5);
    auto const L = mechanical(Q(2), [](auto const& q) { return q.dot(q) / 2 - q(0) * q(3); });
    auto const stretched =
        make_embedding<step_weight>(fraction<3, 2>{} * mid_point.position, mid_point.velocity, "stretched", inconsistent);
    CHECK(largest_residual(embed(L, stretched).along(uniform(Q(0), Q(1, 10), 3), x.q, x.p)) == 0);
}

TEST_CASE("compensated sums keep what explicit steps round off, of positions and of momenta") {
    start<double, 5> const x(5);
    start<float50, 5> const y(5);
    int const steps = 8192;
    double const h = 1.0 / 2048;
    auto const run = [&](auto const& how) {
        auto const right = record(embed(separable, how).along(uniform(float50(0), float50(h), steps), y.q, y.p)).states.back();
        auto const end = [&](auto const& flow) { return record(flow.along(uniform(0.0, h, steps), x.q, x.p)).states.back(); };
        auto const far = [&](auto const& of, auto const& from) {
            return magnitude(vector<float50, 5>(of.template cast<float50>() - from)) / std::numeric_limits<double>::epsilon();
        };
        auto const kept = end(embed(separable, how, compensated)), plain = end(embed(separable, how));
        // The sums, up to 1, are right to half an epsilon of themselves. The roundings of the increments, whose sizes add up to 4, remain.
        CHECK(far(kept.q, right.q) <= 2);
        CHECK(far(kept.p, right.p) <= 2);
        CHECK(far(plain.q, right.q) > 4);
        CHECK(far(plain.p, right.p) > 4);
    };
    run(order_one);
    run(order_one_left);
}

} // namespace explicit_steps_tests
