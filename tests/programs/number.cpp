// SPDX-License-Identifier: BSL-1.0
// Programs with one degree of freedom.
#include "hilger/variational/legendre_transform.hpp"
#include "programs.hpp"
#include "systems.hpp"

namespace number_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

auto const T = uniform(0.0, 0.05, 60);

constexpr auto bead = [](auto const& q, auto const& v) { return v * v * (1 + q * q) / 2 - q * q / 2; };
/// A spring that is stiffer when it is pressed.
constexpr auto stop = [](auto const& q, auto const& v) {
    if (q > 0) return v * v / 2 - q * q / 2;
    return v * v / 2 - 25 * q * q / 2;
};
constexpr auto driven = [](auto const& t, auto const& q, auto const& v) { return v * v / 2 - q * q / 2 + q * sin(2 * t); };
constexpr auto friction = [](auto const& q, auto const& v) { return -v / 4 - q * q * v / 8; };
constexpr auto push = [](auto const& t, auto const& q, auto const& v) { return cos(t) - v / 4 + 0 * q; };
constexpr auto hamiltonian_pendulum = [](auto const& p, auto const& q) { return p * p / 2 - cos(q); };

template <class L, class How, class Scale>
void is_solved(L const& l, How const& how, Scale const& on, double mass = 1) {
    is_a_solution(embed(l, how).along(on, 1.0, 0.5), mass);
}

struct forced_pendulum {
    template <class S>
    auto path() const {
        return embed(with_force(pendulum, friction), mid_point).along(uniform(S(0), S(S(1) / S(16)), 40), S(1), S(S(1) / S(2)));
    }
};
struct pushed_spring {
    template <class S>
    auto path() const {
        return embed(with_force(driven, push), theta<1, 3>).along(uniform(S(0), S(S(1) / S(16)), 40), S(1), S(S(1) / S(2)));
    }
};
struct spring_with_a_stop {
    template <class S>
    auto path() const {
        return embed(stop, mid_point).along(uniform(S(0), S(S(1) / S(16)), 60), S(1), S(S(1) / S(2)));
    }
};

} // namespace

TEST_CASE("a pendulum") {
    is_solved(pendulum, mid_point, T);
    is_solved(pendulum, order_one, uneven);
    is_a_solution(embed(pendulum, mid_point, compensated).along(uneven, 1.0, 0.5));
}
TEST_CASE("a mass that depends on the position") {
    is_solved(bead, mid_point, T, 4);
    is_solved(bead, order_one_left, T, 4);
    is_solved(bead, theta<1, 3>, uneven, 4);
}
TEST_CASE("a Lagrangian of time") {
    is_solved(driven, mid_point, uneven);
    is_solved(driven, order_one, T);
}
TEST_CASE("a Hamiltonian") { is_solved(lagrangian_of(hamiltonian_pendulum), mid_point, T); }
TEST_CASE("a force that is friction, and one that pushes in time") {
    is_solved(with_force(pendulum, friction), order_one, T);
    is_solved(with_force(bead, friction), mid_point, T, 4);
    is_solved(with_force(driven, push), theta<1, 3>, uneven);
}
TEST_CASE("a spring with a stop: a branch in the Lagrangian") {
    is_solved(stop, mid_point, uneven);
    is_solved(stop, order_one, T);
}
TEST_CASE("the same in 50 digits") {
    is_the_same_in_50_digits(forced_pendulum{});
    is_the_same_in_50_digits(pushed_spring{});
    is_the_same_in_50_digits(spring_with_a_stop{}, 256);
}

} // namespace number_tests
