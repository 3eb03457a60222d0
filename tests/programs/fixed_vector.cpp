// SPDX-License-Identifier: BSL-1.0
// Programs whose states are Eigen vectors of fixed size, 2 to 6.
#include "programs.hpp"
#include "systems.hpp"

namespace fixed_vector_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

auto const T = uniform(0.0, 0.05, 60);

template <class V, class L>
void is_solved(L const& l, double mass = 1) {
    is_a_solution(embed(l, mid_point).along(T, place<V>(), push<V>()), mass);
}

struct pulled_in_the_plane {
    template <class S>
    auto path() const {
        using V = Eigen::Matrix<S, 2, 1>;
        return embed(with_force(pulled, wind), mid_point).along(uniform(S(0), S(S(1) / S(16)), 40), place<V>(), push<V>());
    }
};

} // namespace

TEST_CASE("in the plane") {
    using V = Eigen::Vector2d;
    is_solved<V>(row_of_contacts);
    is_solved<V>(with_force(heavy_outside, drag), 4);
    is_a_solution(embed(heavy_outside, order_one).along(T, place<V>(), push<V>()), 4);
    is_a_solution(embed(with_force(pulled, wind), theta<1, 3>, compensated).along(T, place<V>(), push<V>()));
}
TEST_CASE("in space") { is_solved<Eigen::Vector3d>(row_of_contacts); }
TEST_CASE("in four dimensions") { is_solved<Eigen::Vector4d>(row_of_contacts); }
TEST_CASE("in five") { is_solved<Eigen::Matrix<double, 5, 1>>(row_of_contacts); }
TEST_CASE("in six") { is_solved<Eigen::Matrix<double, 6, 1>>(row_of_contacts); }
TEST_CASE("the same in 50 digits") { is_the_same_in_50_digits(pulled_in_the_plane{}); }

} // namespace fixed_vector_tests
