// SPDX-License-Identifier: BSL-1.0
// What remembers all of its past is resumed bit for bit, with every history, before its first step and after many.
#include "hilger/fractional/flow.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/zener.hpp"
#include "hilger/history/history.hpp"
#include "resuming.hpp"

namespace checkpoint_memory_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto push = []<class S>(S const& t) { return S(1) - t / S(16); };
constexpr auto friction = [](auto const& q, auto const& v) { return -v / 8 + 0 * q; };
constexpr auto push_two = [](double const& t) { return Eigen::VectorXd(Eigen::Vector2d(1 - t, t / 2)); };
auto const T = uniform(0.0, 1.0 / 16, 160);

/// Before the first step, inside the first block, at the end of one, after many.
template <class Path>
void goes_on(Path const& path) {
    for (hilger::index_type const first : {0, 1, 31, 64, 133, 160}) {
        CAPTURE(first);
        CHECK(differences(path, first) == 0);
    }
}
template <generating_function G, class Order, class Policy>
void oscillator_goes_on(Order order, Policy const& policy) {
    goes_on(newmark<G>(fractional_structure{1.0, 0.5, 2.0, 1.0, order}, push, average_acceleration, policy).along(T, 1.0, 0.5));
}

} // namespace

TEST_CASE("an oscillator, with every history") {
    oscillator_goes_on<bdf<2>>(0.5, direct{});
    oscillator_goes_on<bdf<2>>(0.5, blocks{});
    oscillator_goes_on<bdf<2>>(1.5, exponentials{0, 200});
    oscillator_goes_on<bdf<2>>(fraction<1>{}, direct{});
    oscillator_goes_on<grunwald_letnikov>(1.0, direct{});
}
TEST_CASE("structures of two degrees of freedom, one of them damped; and of a viscoelastic material") {
    Eigen::MatrixXd const M = Eigen::Matrix2d::Identity(), C = Eigen::Vector2d(0.5, 0).asDiagonal(), K = 2 * M;
    Eigen::VectorXd const q = Eigen::Vector2d(1, 0.5), p = Eigen::Vector2d(0, -1);
    goes_on(newmark<bdf<2>>(fractional_structure{M, C, K, 1.0, 0.5}, push_two, average_acceleration, blocks{}).along(T, q, p));
    goes_on(
        newmark<bdf<2>>(zener_structure{M, K, 1.0, 5.0, 0.25, 0.5}, push_two, average_acceleration, exponentials{0, 200}).along(T, q, p));
}
TEST_CASE("damped flows: a mean over the step with one term and two, and impulses at each end") {
    goes_on(embed(with_fractional_damping<bdf<2>>(pendulum, 0.3, fraction<1, 2>{}, exponentials{0, 200}), mid_point).along(T, 1.0, 0.5));
    goes_on(embed(with_fractional_damping(pendulum, {{0.3, 0.5}, {0.1, 1.5}}), mid_point, compensated).along(T, 1.0, 0.5));
    goes_on(embed(with_fractional_damping(with_force(pendulum, friction), 0.3, 1.0), mid_point).along(T, 1.0, 0.5));
    for (auto const at : {damping_at::start, damping_at::end, damping_at::both})
        goes_on(embed(with_fractional_impulses(pendulum, 0.3, 0.75, blocks{}, {.at = at}), mid_point).along(T, 1.0, 0.5));
    impulse_options const jump{.history = initial_history::riemann_liouville};
    goes_on(embed(with_fractional_impulses(pendulum, 0.3, 0.75, direct{}, jump), mid_point).along(T, 1.0, 0.5));
    Eigen::VectorXd const rho = Eigen::Vector2d(0.25, 0), q = Eigen::Vector2d(1, 0.5), p = Eigen::Vector2d(0.5, -1);
    auto const springs = [](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2 - x(0) * x(1) / 4; };
    goes_on(embed(with_fractional_damping(springs, rho, 0.5, direct{}), mid_point).along(T, q, p));
}
TEST_CASE("a checkpoint of one history is not resumed with another, nor with another order or coefficient") {
    auto const damped = [](double rho, double beta, auto const& policy) {
        return embed(with_fractional_damping(pendulum, rho, beta, policy), mid_point).along(T, 1.0, 0.5);
    };
    auto const refused = [](auto const& from, auto const& to, char const* sentence) {
        auto at = from.begin();
        while (at.number() < 100) ++at;
        auto const checkpoint = at.checkpoint();
        CHECK_NOTHROW((void)from.resume(checkpoint));
        CHECK_THROWS_WITH_AS((void)to.resume(checkpoint), doctest::Contains(sentence), error::mismatch);
    };
    char const *const others = "remembers another number of values", *const elsewhere = "leads elsewhere";
    refused(damped(0.3, 0.5, exponentials{0, 2000}), damped(0.3, 0.5, exponentials{0, 200}), others);
    refused(damped(0.3, 0.5, exponentials{0, 200}), damped(0.3, 0.5, exponentials{0, 2000}), others);
    refused(damped(0.3, 0.5, exponentials{}), damped(0.3, 0.5, exponentials{1e-6}), others);
    refused(damped(0.3, 0.45, direct{}), damped(0.3, 0.3, direct{}), elsewhere);
    refused(damped(0.3, 0.5, direct{}), damped(0.4, 0.5, direct{}), elsewhere);
    auto const driven = [](double C) {
        return newmark<bdf<2>>(fractional_structure{1.0, C, 2.0, 1.0, 0.5}, push, average_acceleration, direct{}).along(T, 1.0, 0.5);
    };
    refused(driven(0.5), driven(0.6), elsewhere);
}
TEST_CASE("a checkpoint of one history does not read into another") {
    auto const with = [](auto const& policy) {
        return newmark<bdf<2>>(fractional_structure{1.0, 0.5, 2.0, 1.0, 0.5}, push, average_acceleration, policy).along(T, 1.0, 0.5);
    };
    auto const all = with(direct{});
    auto const some = with(exponentials{0, 200});
    auto at = all.begin();
    for (int i = 0; i < 40; ++i) ++at;
    std::stringstream text;
    write_checkpoint(text, all, at.checkpoint());
    CHECK_THROWS_AS((void)read_checkpoint(text, some), error::unreadable);
}

} // namespace checkpoint_memory_tests
