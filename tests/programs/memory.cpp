// SPDX-License-Identifier: BSL-1.0
// Programs with fractional damping: their equation holds with sums over all of the past, whatever engine makes them.
#include "hilger/fractional/of_variation.hpp"
#include "hilger/fractional/residual.hpp"
#include "hilger/history/history.hpp"
#include "hilger/trajectory/recording.hpp"
#include "programs.hpp"
#include "systems.hpp"

namespace memory_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

auto const T = uniform(0.0, 0.0625, 80);

constexpr auto friction = [](auto const& q, auto const& v) { return -v / 4 - q * q * v / 8; };

struct damped_pendulum {
    template <class S>
    auto path() const {
        auto const damped = with_fractional_damping(with_force(pendulum, friction), S(S(1) / S(4)), fraction<1, 2>{}, direct{});
        return embed(damped, mid_point).along(uniform(S(0), S(S(1) / S(16)), 40), S(1), S(S(1) / S(2)));
    }
};
/// Larger than h |F|, which is added to p at both ends of each step.
template <class L>
void is_solved(L const& l) {
    is_a_solution(embed(l, mid_point).along(T, 1.0, 0.5), 2);
}

} // namespace

TEST_CASE("a mean over each step, of every order, every history and every start") {
    is_solved(with_fractional_damping(pendulum, 0.25, fraction<1, 2>{}, exponentials{}));
    is_solved(with_fractional_damping<bdf<2>>(pendulum, 0.25, 0.75, blocks{}));
    for (double const beta : {0.25, 1.0, 1.5, 1.75}) {
        CAPTURE(beta);
        is_solved(with_fractional_damping<bdf<2>>(pendulum, 0.25, beta));
    }
    is_solved(with_fractional_damping(with_force(pendulum, friction), {{0.25, 0.5}, {0.125, 1.5}}));
}
TEST_CASE("impulses at the points") {
    for (auto const at : {damping_at::start, damping_at::end, damping_at::both})
        for (double const beta : {0.5, 1.0, 1.25}) {
            CAPTURE(beta);
            is_solved(with_fractional_impulses(pendulum, 0.25, beta, direct{}, {.at = at}));
        }
}
TEST_CASE("a restricted principle: the equation that it has is the one that is walked") {
    constexpr unknown q;
    constexpr unknown<"y"> y;
    constexpr lagrangian L{pendulum};
    auto const EL = variation(integral(L(extend[q], Delta_o_plus[extend[q]]), half(T)) -
                              0.25 * integral(Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y], T));
    auto const path = flow_of(EL, blocks{}).along(T, 1.0, 0.5);
    is_a_solution(path, 2);
    CHECK(largest_residual(EL, record(path).positions()) <= rounding_along(path, 2));
}
TEST_CASE("vectors, one component of which is damped") {
    using V = Eigen::VectorXd;
    V rho = V::Zero(3);
    rho(1) = 0.5;
    is_a_solution(embed(with_fractional_damping(row_of_contacts, rho, 0.5), mid_point).along(T, place<V>(3), push<V>(3)), 2);
    using W = Eigen::Vector2d;
    is_a_solution(embed(with_fractional_damping(with_force(row_of_contacts, drag), 0.5, 0.5), order_one).along(T, place<W>(), push<W>()),
                  2);
}
TEST_CASE("the same in 50 digits") { is_the_same_in_50_digits(damped_pendulum{}, 16, 2); }

} // namespace memory_tests
