// SPDX-License-Identifier: BSL-1.0
// Programs whose states are Eigen vectors of dynamic size, with a structure that is said and without.
#include "hilger/models/mechanical.hpp"
#include "programs.hpp"
#include "systems.hpp"

namespace dynamic_vector_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

auto const T = uniform(0.0, 0.05, 40);

constexpr auto contact = [](hilger::index_type, auto const& r) { return r < 0 ? 3 * r * r : 0 * r; };
constexpr auto gravity = [](hilger::index_type, auto const& r) { return -1 / sqrt(1 + r.squaredNorm()); };

template <class L>
void is_solved(L const& l, int d, double mass = 1) {
    is_a_solution(embed(l, mid_point).along(T, place<Eigen::VectorXd>(d), push<Eigen::VectorXd>(d)), mass);
}

struct forced_row {
    template <class S>
    auto path() const {
        using V = Eigen::Matrix<S, Eigen::Dynamic, 1>;
        return embed(with_force(row_of_contacts, wind), mid_point).along(uniform(S(0), S(S(1) / S(16)), 20), place<V>(5), push<V>(5));
    }
};

} // namespace

TEST_CASE("plain lambdas, of any number of degrees of freedom") {
    for (int const d : {1, 2, 4, 7}) is_solved(row_of_contacts, d);
    is_a_solution(embed(heavy_outside, order_one).along(uneven, place<Eigen::VectorXd>(6), push<Eigen::VectorXd>(6)), 4);
}
TEST_CASE("with forces") { is_solved(with_force(row_of_contacts, wind), 5); }
TEST_CASE("a structure that is said") {
    is_solved(mechanical(1.0, chain(contact)), 9);
    Eigen::VectorXd const masses = Eigen::VectorXd::LinSpaced(9, 1, 2);
    is_solved(mechanical(masses, pairs<3>(all_pairs(3), gravity)), 9, 2);
    Eigen::MatrixXd const mass = Eigen::MatrixXd::Identity(3, 3) + Eigen::MatrixXd::Constant(3, 3, 0.25);
    is_solved(with_force(mechanical(mass, [](auto const& q) { return q.dot(q) / 2; }), drag), 3, 2);
}
TEST_CASE("the same in 50 digits") { is_the_same_in_50_digits(forced_row{}); }

} // namespace dynamic_vector_tests
