// SPDX-License-Identifier: BSL-1.0
// Lagrangians with branches under every way of stepping. A step that solves its equation is undone by its adjoint, and a step taken alone
// is the one taken along a trajectory, whatever either was guessed from.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"

namespace branches_of_steps_tests {

using namespace hilger;

namespace {

using vector = Eigen::Vector2d;

/// A spring between two masses that pulls only, walls that the first one runs into, and a mass that is larger in one direction.
template <class R>
auto spring(R const& r) {
    return 50 * pow(max(r, 0.0), 2);
}
struct springs_and_walls {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return v.squaredNorm() / 2 - spring(q(1) - q(0)) - 100 * pow(max(abs(q(0)) - 0.5, 0.0), 2);
    }
};
struct one_way_mass {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return v.squaredNorm() / 2 + (v(0) > 0 ? 0.5 : 0.0) * v(0) * v(0) - spring(q(1) - q(0)) - q.squaredNorm();
    }
};
struct mass_that_grows {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return (1 + max(q(0), 0.0)) * v.squaredNorm() / 2 - q.squaredNorm();
    }
};
struct mass_of_the_place {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        return (q(0) > 0.1 ? 2 : 1) * v.squaredNorm() / 2 - q.squaredNorm();
    }
};
/// The largest distance from where a step began after the step and its adjoint back, and from the trajectory's own step.
struct misses {
    double back = 0, apart = 0;
};
template <class Flow, class V>
misses walk(Flow const& flow, double h, V const& q0, V const& p0) {
    auto const there = adjoint(flow);
    misses m;
    state<double, V> before{0.0, q0, p0};
    auto const path = flow.along(uniform(0.0, h, 60), q0, p0);
    for (auto at = ++path.begin(); not(at == path.end()); ++at) {
        auto const alone = flow.step(before, h);
        m.apart = std::max({m.apart, magnitude(V(alone.q - at->q)), magnitude(V(alone.p - at->p))});
        m.back = std::max(m.back, reversibility_error(flow, there, before, h));
        before = *at;
    }
    return m;
}
template <class L, class E>
void check(L const& l, E const& how, double h = 0.07) {
    auto const m = walk(embed(l, how), h, vector(0, 0.5), vector(1, -0.5));
    CHECK(m.back < 1e-11);
    CHECK(m.apart < 1e-11);
}

} // namespace

TEST_CASE("steps with one node") {
    check(springs_and_walls{}, mid_point);
    check(springs_and_walls{}, order_one_left);
    check(one_way_mass{}, mid_point);
    check(one_way_mass{}, order_one);
    check(mass_that_grows{}, order_one);
}
TEST_CASE("steps with several nodes") {
    check(springs_and_walls{}, galerkin<2, lobatto>);
    check(springs_and_walls{}, galerkin<2, gauss>);
    check(one_way_mass{}, galerkin<2, gauss>);
}
TEST_CASE("kicks and drifts") {
    auto const m = walk(stoermer_verlet(springs_and_walls{}), 0.02, vector(0, 0.5), vector(1, -0.5));
    CHECK(m.back < 1e-12);
    // with a mass that depends on the place they are none: the two halves of the step, taken one after the other
    auto const verlet = stoermer_verlet(mass_of_the_place{});
    auto const first = embed(mass_of_the_place{}, order_one);
    auto const second = adjoint(first);
    state<double, vector> x{0.0, vector(0, 0.5), vector(1, -0.5)};
    double apart = 0;
    for (int i = 0; i < 200; ++i) {
        auto const y = second.step(first.step(x, 0.01), 0.01);
        auto const z = verlet.step(x, 0.02);
        apart = std::max({apart, magnitude(vector(y.q - z.q)), magnitude(vector(y.p - z.p))});
        x = y;
    }
    CHECK(apart < 1e-13);
}

/// U(r) of the springs of a chain, and of pairs.
struct one_sided {
    double k;
    template <class R>
    auto operator()(index_type, R const& r) const {
        return (r > 0 ? 1 : k) * r * r / 2;
    }
};
struct pull_of_the_origin {
    template <class X>
    auto operator()(X const& q) const {
        return 200 * pow(max(abs(q(0)) - 0.25, 0.0), 2) + q.squaredNorm() / 2;
    }
};
TEST_CASE("systems with a structure, by iteration and by Newton's method") {
    Eigen::VectorXd const q0 = Eigen::Vector3d(0.5, 0.25, -0.5), p0 = Eigen::Vector3d(1, 0, -2);
    for (double const k : {25.0, 4e3}) {
        auto const chained = walk(embed(mechanical(1.0, chain{one_sided{k}}), mid_point), 0.05, q0, p0);
        CHECK(chained.back < 1e-11);
        CHECK(chained.apart < 1e-11);
        std::vector<std::pair<index_type, index_type>> const list{{0, 1}, {1, 2}, {2, -1}};
        auto const paired = walk(embed(mechanical(1.0, pairs<1>(list, one_sided{k})), mid_point), 0.05, q0, p0);
        CHECK(paired.back < 1e-11);
        CHECK(paired.apart < 1e-11);
    }
    for (double const h : {0.02, 0.3}) {
        auto const dense = walk(embed(mechanical(1.0, pull_of_the_origin{}), mid_point), h, q0, p0);
        CHECK(dense.back < 1e-10);
        CHECK(dense.apart < 1e-10);
        auto const gauss_2 = walk(embed(mechanical(1.0, pull_of_the_origin{}), galerkin<2, gauss>), h / 2, q0, p0);
        CHECK(gauss_2.back < 1e-10);
        CHECK(gauss_2.apart < 1e-10);
    }
}

TEST_CASE("a force that jumps between the last corrections of a step is that of the side where the step ends, or there is none") {
    Eigen::VectorXd const q0 = Eigen::VectorXd::Constant(1, 0.5), p0 = Eigen::VectorXd::Constant(1, 1);
    double const h = 1.0 / 1024; // the forces of -q^2/2 approach their limit from one side
    auto const end =
        embed(mechanical(1.0, [](auto const& q) { return -q.dot(q) / 2; }), mid_point).step(state<double, Eigen::VectorXd>{0.0, q0, p0}, h);
    double const middle = (q0(0) + end.q(0)) / 2;
    int solved = 0;
    for (int quarters = 51; quarters <= 56; ++quarters)
        for (double const sign : {-1.0, 1.0})
            for (double const jump : {-1.0, 1.0}) {
                double const at = middle + sign * std::pow(10.0, -quarters / 4.0);
                auto const pull = [=](double x) { return (x > at ? jump : 0.0) - x; };
                auto const U = [=](auto const& q) { return jump * max(q(0) - at, 0.0) - q.dot(q) / 2; };
                CAPTURE(at);
                CAPTURE(jump);
                try {
                    auto const x = embed(mechanical(1.0, U), mid_point).step(state<double, Eigen::VectorXd>{0.0, q0, p0}, h);
                    double const v = (x.q(0) - q0(0)) / h;
                    CHECK(std::abs(p0(0) - v - h / 2 * pull((q0(0) + x.q(0)) / 2)) <= 1e-12);
                    ++solved;
                } catch (error::no_convergence const&) { // both sides lead across the jump
                }
            }
    CHECK(solved >= 8);
}

} // namespace branches_of_steps_tests
