// SPDX-License-Identifier: BSL-1.0
// Programs whose potential has two branches of very different stiffness, in states of every kind: a step is one whose equation holds on the
// branch that it ends on.
#include "hilger/models/mechanical.hpp"
#include "programs.hpp"

namespace branches_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

/// U = r^2 / 2 between neighbours that are pulled apart, k r^2 / 2 between those that are pressed; the first one is held by a spring.
template <int K>
struct contacts {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        auto L = v(0) * v(0) / 2 - q(0) * q(0) / 2;
        for (int k = 1; k < q.size(); ++k) {
            auto const r = q(k) - q(k - 1);
            L = L + v(k) * v(k) / 2;
            L = L - (r > 0 ? 1 : K) * r * r / 2;
        }
        return L;
    }
};
template <int K>
struct stop {
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if (q > 0) return v * v / 2 - q * q / 2;
        return v * v / 2 - K * q * q / 2;
    }
};
template <class V>
V at_rest(int d = V::SizeAtCompileTime) {
    V q(d);
    for (int k = 0; k < d; ++k) q(k) = k % 2 == 0 ? 1 : -0.5;
    return q;
}
template <class V>
void hit(int d = V::SizeAtCompileTime) {
    is_a_solution(embed(contacts<25>{}, mid_point).along(uniform(0.0, 0.1, 200), at_rest<V>(d), V(V::Zero(d))), 1);
    is_a_solution(embed(contacts<400>{}, mid_point).along(uniform(0.0, 0.05, 200), at_rest<V>(d), V(V::Zero(d))), 1);
}

} // namespace

TEST_CASE("a number") {
    is_a_solution(embed(stop<25>{}, mid_point).along(uniform(0.0, 0.1, 200), 1.0, 0.0));
    is_a_solution(embed(stop<400>{}, mid_point).along(uniform(0.0, 0.05, 200), 1.0, 0.0));
    is_a_solution(embed(stop<400>{}, order_one).along(uniform(0.0, 0.05, 200), 1.0, 0.0));
}
TEST_CASE("vectors of two") { hit<Eigen::Vector2d>(); }
TEST_CASE("vectors of three") { hit<Eigen::Vector3d>(); }
TEST_CASE("vectors of dynamic size") { hit<Eigen::VectorXd>(4); }
TEST_CASE("a chain") {
    auto const wall = [](index_type, auto const& r) { return (r > 0 ? 1 : 400) * r * r / 2; };
    is_a_solution(embed(mechanical(1.0, chain(wall)), mid_point)
                      .along(uniform(0.0, 0.05, 200), at_rest<Eigen::VectorXd>(4), Eigen::VectorXd(Eigen::VectorXd::Zero(4))));
}

} // namespace branches_tests
