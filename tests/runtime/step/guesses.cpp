// SPDX-License-Identifier: BSL-1.0
// A step is guessed from the steps before it. Where such a guess lies beyond what L is defined for, or leads nowhere, and the step does
// not, the step is made.
#include "runtime/step/whole_walks.hpp"

namespace guesses_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

/// A relativistic oscillator: no |v| reaches 1, and the polynomial through velocities near 1 does.
struct relativistic {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if constexpr (requires { q.size(); })
            return -sqrt(1 - v.squaredNorm()) - q.squaredNorm() / 2;
        else
            return -sqrt(1 - v * v) - q * q / 2;
    }
};
/// q comes close to the wall at 0, and no further.
struct at_a_wall {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if constexpr (requires { q.size(); }) {
            auto sum = v.squaredNorm() / 2 + (log(q(0)) - q(0));
            for (int k = 1; k < q.size(); ++k) sum = sum + (log(q(k)) - q(k));
            return sum;
        } else
            return v * v / 2 + log(q) - q;
    }
};

/// The same, and a spring that begins at 3: its force has a branch, and no jump.
struct at_a_wall_and_a_spring {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        auto const stretched = [](auto const& x) { return x < 3 ? 0 * x : (x - 3) * (x - 3) / 64; };
        if constexpr (requires { q.size(); }) {
            auto sum = v.squaredNorm() / 2 + (log(q(0)) - q(0) - stretched(q(0)));
            for (int k = 1; k < q.size(); ++k) sum = sum + (log(q(k)) - q(k) - stretched(q(k)));
            return sum;
        } else
            return v * v / 2 + log(q) - q - stretched(q);
    }
};
/// A mid-point step has one solution up to h = 2.
struct pendula {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if constexpr (requires { q.size(); })
            return v.squaredNorm() / 2 + q.array().cos().sum();
        else
            return v * v / 2 + cos(q);
    }
};

/// All of the walk, and that it solves its equation: what rounding a position does to a difference of momenta over h is
/// epsilon |q| d2L/dv2 / h^2, `mass` the largest d2L/dv2 there is, what rounding a momentum does is epsilon |p| / h, and a position
/// to a force epsilon |q| d2L/dq2, `bend` at most where it counts; and at a point two steps meet.
template <class V, class L, class E>
void goes_all_the_way(L const& l, E const& how, int d, double q0, double p0, double h, double mass, double bend = 0, int steps = 400) {
    CAPTURE(how.name);
    CAPTURE(d);
    CAPTURE(h);
    auto const walk = embed(l, how).along(uniform(0.0, h, steps), all<V>(d, q0), all<V>(d, p0));
    if (auto const most = walked_whole(walk, steps))
        CHECK(largest_residual(walk) <= 16 * epsilon<double>() * (most->q * (mass / (h * h) + bend) + most->p / h));
}

} // namespace

TEST_CASE("a body near the speed of light is not guessed to be faster") {
    double const factor = std::sqrt(1 + 2 * 7.1 * 7.1), mass = std::pow(factor, 3); // no momentum is larger than at the start
    goes_all_the_way<double>(relativistic{}, mid_point, 1, 0, 10, 0.1, mass);
    goes_all_the_way<double>(relativistic{}, theta<1, 3>, 1, 0, 10, 0.1, mass);
    goes_all_the_way<Eigen::Vector2d>(relativistic{}, mid_point, 2, 0, 7, 0.1, mass);
    goes_all_the_way<Eigen::VectorXd>(relativistic{}, mid_point, 2, 0, 7, 0.1, mass);
    goes_all_the_way<double>(relativistic{}, galerkin<2, gauss>, 1, 0, 10, 0.1, mass);
}

TEST_CASE("a body that turns before a wall is not guessed to be behind it") {
    goes_all_the_way<double>(at_a_wall{}, mid_point, 1, 6, 0, 0.05, 1);
    goes_all_the_way<Eigen::Vector3d>(at_a_wall{}, mid_point, 3, 6, 0, 0.05, 1);
    goes_all_the_way<Eigen::VectorXd>(at_a_wall{}, mid_point, 6, 6, 0, 0.05, 1);
    goes_all_the_way<double>(at_a_wall_and_a_spring{}, mid_point, 1, 6, 0, 0.05, 1);
    goes_all_the_way<Eigen::Vector3d>(at_a_wall_and_a_spring{}, mid_point, 3, 6, 0, 0.05, 1);
    goes_all_the_way<Eigen::VectorXd>(at_a_wall_and_a_spring{}, mid_point, 6, 6, 0, 0.05, 1);
    // with a Hessian of its own, and no force but that of the wall
    auto const wall_of_the_first = [](index_type k, auto const& r) { return k == 0 ? r - log(r) : 0 * r; };
    goes_all_the_way<Eigen::VectorXd>(mechanical(1.0, chain{wall_of_the_first}), mid_point, 2, 6, 0, 0.05, 1);
}

TEST_CASE("steps that are nearly too long are made where the guess of them leads nowhere") {
    for (auto const& [h, q0] : {std::pair{1.5, 3.0}, {1.7, 1.0}, {1.9, 1.0}}) {
        goes_all_the_way<double>(pendula{}, mid_point, 1, q0, 0, h, 1, 1, 3000);
        goes_all_the_way<Eigen::Vector2d>(pendula{}, mid_point, 2, q0, 0, h, 1, 1, 3000);
        goes_all_the_way<Eigen::VectorXd>(pendula{}, mid_point, 3, q0, 0, h, 1, 1, 3000);
        auto const first_alone = [](index_type k, auto const& r) { return k == 0 ? -cos(r) : 0 * r; };
        goes_all_the_way<Eigen::VectorXd>(mechanical(1.0, chain{first_alone}), mid_point, 2, q0, 0, h, 1, 1, 3000);
    }
}

TEST_CASE("a solution far away is not taken where one is near") {
    auto const double_pendulum = [](auto const& q, auto const& v) {
        return v(0) * v(0) + v(1) * v(1) / 2 + v(0) * v(1) * cos(q(0) - q(1)) + 2 * cos(q(0)) + cos(q(1));
    };
    double fastest = 0;
    for (auto const& x :
         embed(double_pendulum, mid_point)
             .along(uniform(0.0, 0.1, 300), Eigen::VectorXd(Eigen::Vector2d(2, 0)), Eigen::VectorXd(Eigen::Vector2d(0.2, 0))))
        fastest = std::max(fastest, magnitude(x.p));
    CHECK(fastest < 20); // guesses lead to momenta of thousands
    auto const changing_mass = [](auto const& q, auto const& v) { return (1 + q * q) * (1 + q * q) * v * v / 2 - 5 * q * q; };
    auto const few = embed(changing_mass, mid_point).along(uniform(0.0, 0.1, 9), {.q0 = 1.81, .v0 = -0.92});
    double before = 0, mean = 0; // of eight steps; the equation of the eighth has the roots -18.84, -5.679 and 22.04
    int number = 0;
    for (auto const& x : few) {
        if (number == 8) mean = (x.q - before) / 0.1;
        before = x.q;
        ++number;
    }
    CHECK(std::abs(mean + 5.679) < 0.001);
}

TEST_CASE("a body that friction lets fall into a centre is not thrown out of it") {
    auto const kepler = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); };
    double most = -1, last = 0;
    CHECK_THROWS_AS(
        [&] {
            for (auto const& x : embed(with_fractional_damping(kepler, 0.1, fraction<1>{}), mid_point)
                                     .along(uniform(0.0, 0.01, 1000), Eigen::Vector2d(0.4, 0), Eigen::Vector2d(0, 2))) {
                most = std::max(most, x.p.squaredNorm() / 2 - 1 / x.q.norm());
                last = x.t;
            }
        }(),
        error::no_convergence);
    CHECK(most <= -0.5); // at the start; the equation of the last step has a solution with 30
    CHECK(last > 9);
}

TEST_CASE("small components are solved beside large ones") {
    auto const beside = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + cos(q(1)); };
    auto const alone = [](auto const& q, auto const& v) { return v * v / 2 + cos(q); };
    auto const T = uniform(0.0, 1.7, 20);
    auto const same = [&]<class V>(std::type_identity<V>, double speed) {
        auto const right = record(embed(alone, mid_point).along(T, 2.0, 0.3)).states;
        std::size_t i = 0;
        for (auto const& x : embed(beside, mid_point).along(T, V(Eigen::Vector2d(0, 2)), V(Eigen::Vector2d(speed, 0.3))))
            CHECK(std::abs(x.q(1) - right[i++].q) <= 1e-11);
    };
    for (double const speed : {1.0, 1e4, 1e7}) {
        same(std::type_identity<Eigen::Vector2d>{}, speed);
        same(std::type_identity<Eigen::VectorXd>{}, speed);
    }
}

TEST_CASE("a velocity at which L is not defined is not taken where the position is known") {
    // p_1 = p_0 - h q_0, q_1 = q_0 + h p_1 / sqrt(1 + p_1^2)
    double q = 10, p = 0;
    for (auto const& x : embed(relativistic{}, order_one).along(uniform(0.0, 0.1, 100), 10.0, 0.0)) {
        CHECK(std::abs(x.q - q) <= 1e-11);
        p -= 0.1 * q;
        q += 0.1 * p / std::sqrt(1 + p * p);
    }
}

TEST_CASE("small corrections near the speed of light are no proof: the momentum of a step is") {
    // the first correction from (0, 3) to (-1, 3) ends at a velocity of length 1 but for rounding
    auto const beside = [](auto const& how, auto const& q0, auto const& p0) {
        auto const walk = embed(relativistic{}, how).along(uniform(0.0, 0.1, 100), q0, p0);
        double const mass = 53 * 53 * 53; // of the energy that there is in q0
        CHECK(largest_residual(walk) <= 16 * epsilon<double>() * 10 * mass / (0.1 * 0.1));
    };
    Eigen::Vector2d const q0(10, 0), p0(0, 3);
    beside(order_one, q0, p0);
    beside(order_one, Eigen::VectorXd(q0), Eigen::VectorXd(p0));
    beside(order_one_left, Eigen::VectorXd(q0), Eigen::VectorXd(p0));
    beside(mid_point, Eigen::VectorXd(q0), Eigen::VectorXd(p0));
    for (double const h : {0.1, 0.5}) { // dL/dv = p - h q has one solution
        auto const walk = embed(relativistic{}, order_one).along(uniform(0.0, h, 60), Eigen::Vector3d(2, 0, 0), Eigen::Vector3d(0, 1, 0));
        CHECK_NOTHROW([&] {
            for ([[maybe_unused]] auto const& x : walk) continue;
        }());
    }
}

TEST_CASE("a motion that runs away is not found again on the other side") {
    auto const ends_in_time = [](auto const& l, auto const& q0, double h) {
        auto const p0 = q0; // of this type
        double farthest = 0, least = 1;
        CHECK_THROWS_AS(
            [&] {
                for (auto const& x : embed(l, mid_point).along(uniform(0.0, h, static_cast<index_type>(10 / h)), q0, p0)) {
                    farthest = std::max(farthest, magnitude(x.q));
                    least = std::min(least, detail::shape<std::remove_cvref_t<decltype(q0)>>::component(x.q, 0));
                }
            }(),
            error::no_convergence);
        CHECK(farthest > 0.1 / h);
        CHECK(least == 1); // the cubic equation of a step has a root there too
    };
    auto const runs_away = [](auto const& q, auto const& v) {
        if constexpr (requires { q.size(); })
            return v.squaredNorm() / 2 + q(0) * q(0) * q(0) * q(0) - q(1) * q(1);
        else
            return v * v / 2 + q * q * q * q;
    };
    for (double const h : {0.2, 0.15, 0.03, 0.01}) {
        ends_in_time(runs_away, 1.0, h);
        ends_in_time(runs_away, Eigen::Vector2d(1, 1), h);
        ends_in_time(runs_away, Eigen::VectorXd(Eigen::Vector2d(1, 1)), h);
    }
    auto const quartic = [](index_type k, auto const& r) { return k == 0 ? -(r * r * r * r) : 0 * r; };
    ends_in_time(mechanical(1.0, chain{quartic}), Eigen::VectorXd(Eigen::Vector2d(1, 1)), 0.01);
}

} // namespace guesses_tests
