// SPDX-License-Identifier: BSL-1.0
// What is const can be shared: one flow, one trajectory, one equation and one operator, used from two threads at once. With
// -fsanitize=thread every race of theirs is seen; without, that both threads have the same bits.
#include <array>
#include <thread>

#include "hilger/composition/methods.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/residual.hpp"
#include "hilger/history/history.hpp"
#include "hilger/models/mechanical.hpp"
#include "hilger/trajectory/checkpoint.hpp"
#include "programs.hpp"
#include "systems.hpp"

namespace thread_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

constexpr auto push_up = [](double t) { return 1 - t / 8; };
auto const T = uniform(0.0, 0.0625, 200);

/// What `use` makes in two threads at once, and whether it is the same.
template <class Use>
void in_two_threads(Use const& use) {
    std::array<decltype(use()), 2> result{};
    std::thread first([&] { result[0] = use(); }), second([&] { result[1] = use(); });
    first.join();
    second.join();
    CHECK(result[0] == result[1]);
}
/// A trajectory of a shared flow each, and the shared trajectory.
template <class Flow, class V>
void walks_twice(Flow const& flow, V const& q, V const& p) {
    auto const end = [](auto const& path) {
        auto last = *path.begin();
        for (auto const& x : path) last = x;
        return last;
    };
    in_two_threads([&] { return end(flow.along(T, q, p)); });
    auto const path = flow.along(T, q, p);
    in_two_threads([&] { return end(path); });
    in_two_threads([&] {
        std::stringstream text;
        write_checkpoint(text, path, path.begin().checkpoint());
        return text.str();
    });
}
template <class Policy>
void remembers_twice(Policy const& policy) {
    walks_twice(embed(with_fractional_damping<bdf<2>>(pendulum, 0.25, 0.5, policy), mid_point), 1.0, 0.5);
    walks_twice(newmark<bdf<2>>(fractional_structure{1.0, 0.5, 2.0, 1.0, 0.5}, push_up, average_acceleration, policy), 1.0, 0.5);
}

} // namespace

TEST_CASE("flows") {
    walks_twice(embed(pendulum, mid_point, compensated), 1.0, 0.5);
    walks_twice(embed(pendulum, galerkin<4, gauss>), 1.0, 0.5);
    walks_twice(compose(suzuki<4>, stoermer_verlet(pendulum)), 1.0, 0.5);
    walks_twice(embed(mechanical(1.0, chain([](index_type, auto const& r) { return r * r / 2 + r * r * r * r; })), mid_point),
                place<Eigen::VectorXd>(5), push<Eigen::VectorXd>(5));
}
TEST_CASE("histories") {
    remembers_twice(direct{});
    remembers_twice(blocks{});
    remembers_twice(exponentials{0, 300});
}
TEST_CASE("operators and equations") {
    auto const f = function_on(T, [](double t) { return std::sin(t); });
    in_two_threads([&] { return double(Delta_minus_alpha<1, 2>[f][150]); });
    in_two_threads([&] { return integral(Delta_plus[f], T); });
    auto const flow = embed(pendulum, mid_point);
    auto const equation = equation_of(flow, T);
    in_two_threads([&] { return largest_residual(equation, f); });
    // of vectors that L is traced for: one formula, kept by the residual and by the energy
    constexpr auto six = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) * q(1) * q(4); };
    auto const in_space = function_on(T, [](double t) { return Eigen::VectorXd(Eigen::VectorXd::LinSpaced(6, t, 1)); });
    auto const equation_in_space = equation_of(embed(six, mid_point), T);
    in_two_threads([&] { return largest_residual(equation_in_space, in_space); });
    auto const E = energy(six);
    in_two_threads([&] {
        double sum = 0;
        for (auto const& x : in_space) sum += E(state<double, Eigen::VectorXd>{0.0, x, x});
        return sum;
    });
    auto const damped = embed(with_fractional_damping(pendulum, 0.25, fraction<1, 2>{}), mid_point).along(T, 1.0, 0.5);
    in_two_threads([&] { return largest_residual(damped); });
}

} // namespace thread_tests
