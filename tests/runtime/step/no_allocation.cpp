// SPDX-License-Identifier: BSL-1.0
// Scales derived from a scale, and operators applied to functions, are views: making one and evaluating it allocates nothing, however many
// points there are. allocations.hpp counts, Eigen's allocations too.
#include <doctest/doctest.h>

#include <new>

#include "hilger/composition/methods.hpp"
#include "hilger/hilger.hpp"
#include "runtime/allocations.hpp"

namespace no_allocation_tests {

using namespace hilger;

namespace {

constexpr hilger::index_type N = 100'000;

/// How often memory was asked for while the work was done.
template <class Work>
long allocations_in(Work const& work) {
    long const before = allocations_until_now();
    work();
    return allocations_until_now() - before;
}

/// Everything the calculus makes of a function on T, evaluated at every point.
template <class F>
double visit_all(F const& q) {
    auto const& T = q.root();
    auto const T_half = half(T);
    auto const T_o = circ(T);
    auto const T_third = at_lambda<1, 3>(T);
    auto const q_o = extend[q];
    auto const v = Delta_o_plus[q_o];
    auto const laplacian = Delta_minus[Delta_plus[q]];
    auto const energy = on_half[v * v] / 2 + on_half[q_o * q_o] / 2;
    double sum = integral(energy, T_half) + integral(q_o, T_o) + integral(q, T) + T_third.max();
    for (double x : laplacian) sum += x;
    for (double x : v) sum += x;
    for (double t : T_o) sum += t;
    for (double x : mean_o[q_o]) sum += x;
    for (double x : extend_at(0.3)[q]) sum += x;
    for (hilger::index_type i = 1; i < N; i += 1000)
        sum += q(T.point(i)) + T.sigma(T.point(i)) + step_mean[on_half[q_o]][i] + q_o(T_o.point(2 * i + 1));
    sum += boundary(q) + integral(q, T.point(N / 2), T.point(N / 4));
    return sum;
}

auto const square = [](double t) { return t * t; };

} // namespace

TEST_CASE("the counter counts") {
    static void* volatile memory; // seen from outside, so that no compiler leaves the allocation out
    CHECK(allocations_in([] {
              memory = ::operator new(8);
              ::operator delete(memory);
          }) == 1);
    CHECK(allocations_in([] {}) == 0);
    if (counts_malloc) CHECK(allocations_in([] { memory = Eigen::VectorXd(8).data(); }) == 1);
}

TEST_CASE("a formula on a uniform scale of many points allocates nothing") {
    double result = 0;
    CHECK(allocations_in([&] { result = visit_all(function_on(uniform(0.0, 1e-3, N), square)); }) == 0);
    CHECK(result > 0);
}

TEST_CASE("nor does a formula on given points, once they are given") {
    auto const T = time_scale(uniform(0.0, 1e-3, N));
    double result = 0;
    CHECK(allocations_in([&] { result = visit_all(function_on(T, square)); }) == 0);
    CHECK(result == doctest::Approx(visit_all(function_on(uniform(0.0, 1e-3, N), square))).epsilon(1e-9));
    CHECK(allocations_in([&] { return time_scale<double>(T); }) == 0); // copies share
}

TEST_CASE("nor does a table, once it is made") {
    auto const T = time_scale(uniform(0.0, 1e-3, N));
    auto const on_points = tabulate(function_on(T, square));
    auto const on_uniform = tabulate(function_on(uniform(0.0, 1e-3, N), square));
    double result = 0;
    CHECK(allocations_in([&] { result = visit_all(on_points); }) == 0);
    CHECK(allocations_in([&] { result = visit_all(on_uniform); }) == 0);
    CHECK(result > 0);
    CHECK(allocations_in([&] { auto const copy = on_points; }) == 0);
    CHECK(allocations_in([&] { (void)tabulate(function_on(uniform(0.0, 1.0, 10), square)); }) == 2); // the values, and the handle to them
}

TEST_CASE("integration by parts allocates nothing") {
    auto const f = tabulate(function_on(uniform(0.0, 1e-3, 1000), square));
    CHECK(allocations_in([&] {
              auto const parts = by_parts(on_half * Delta_o_plus * extend, f, on_half[extend[f]]);
              if (not(parts.left > 0)) throw 0;
          }) == 0);
}

TEST_CASE("nor do the steps of composed flows, once their memories are made") {
    lagrangian const kepler{[](auto const& x, auto const& v) {
        using std::sqrt;
        return v.dot(v) / 2 + 1 / sqrt(x.dot(x));
    }};
    auto const steps = [](auto const& flow) {
        auto const path = flow.along(uniform(0.0, 0.01, 1000), Eigen::Vector2d(1, 0), Eigen::Vector2d(0, 1));
        auto at = path.begin();
        long const count = allocations_in([&] {
            for (int i = 0; i < 1000; ++i) ++at;
        });
        CHECK(at->q.norm() == doctest::Approx(1).epsilon(1e-4));
        return count;
    };
    CHECK(steps(stoermer_verlet(kepler)) == 0);
    CHECK(steps(compose(kahan_li<6>, embed(kepler, mid_point))) == 0);
    CHECK(steps(compose(suzuki<4>, stoermer_verlet(kepler, compensated))) == 0);
}

namespace {
/// Allocations while a trajectory of a thousand steps is walked, its first two points aside.
template <class Path>
long allocations_along(Path const& path) {
    auto i = path.begin();
    ++i;
    ++i;
    return allocations_in([&] {
        for (; not(i == std::default_sentinel); ++i) (void)*i;
    });
}
} // namespace

TEST_CASE("no step allocates: small systems, a chain of 128, bodies in space, friction") {
    auto const T = uniform(0.0, 0.01, 1000);
    Eigen::Vector2d const q(0.4, 0.0), p(0.0, 2.0);
    auto const kepler = [](auto const& x, auto const& v) { return v.dot(v) / 2 + 1 / x.norm(); };
    CHECK(allocations_along(embed(kepler, mid_point).along(T, q, p)) == 0);
    CHECK(allocations_along(embed(kepler, mid_point, compensated).along(T, q, p)) == 0);
    CHECK(allocations_along(embed(kepler, order_one).along(T, q, p)) == 0);
    CHECK(allocations_along(embed(with_force(kepler, [](auto const&, auto const& v) { return (-v).eval(); }), mid_point).along(T, q, p)) ==
          0);
    CHECK(allocations_along(embed(kepler, galerkin<2, gauss>).along(T, q, p)) == 0);

    Eigen::VectorXd const x = Eigen::VectorXd::LinSpaced(128, -1, 1), y = Eigen::VectorXd::Zero(128);
    auto const chain_of_128 = mechanical(1.0, chain([](hilger::index_type, auto const& r) { return r * r / 2 + r * r * r / 12; }));
    CHECK(allocations_along(embed(chain_of_128, mid_point).along(T, x, y)) == 0);
    CHECK(allocations_along(embed(chain_of_128, order_one).along(T, x, y)) == 0);
    CHECK(allocations_along(embed(chain_of_128, mid_point).along(uniform(0.0, 1.0, 1000), x, y)) == 0); // by Newton
    auto const bodies = mechanical(1.0, pairs<3>(all_pairs(4), [](hilger::index_type, auto const& r) { return r.dot(r) / 2; }));
    Eigen::VectorXd const z = Eigen::VectorXd::LinSpaced(12, -1, 1);
    CHECK(allocations_along(embed(bodies, mid_point).along(T, z, z)) == 0);
    CHECK(allocations_along(embed(bodies, galerkin<2, gauss>).along(T, z, z)) == 0);
}

TEST_CASE("nor does fractional damping: of order 1, by exponentials, of structures and materials") {
    auto const T = uniform(0.0, 0.01, 1000);
    exponentials const history{1e-10, 1000};
    auto const kepler = [](auto const& x, auto const& v) { return v.dot(v) / 2 + 1 / x.norm(); };
    Eigen::Vector2d const q(0.4, 0.0), p(0.0, 2.0);
    // more of it, and the body falls into the centre before the end
    CHECK(allocations_along(embed(with_fractional_damping(kepler, 0.05, fraction<1>{}), mid_point).along(T, q, p)) == 0);
    CHECK(allocations_along(embed(with_fractional_damping(kepler, 0.1, fraction<1, 2>{}, history), mid_point).along(T, q, p)) == 0);
    auto const one = [](double t) { return t; };
    CHECK(allocations_along(
              newmark<bdf<2>>(fractional_structure{1.0, 1.0, 1.0, 1.0, 0.5}, one, average_acceleration, history).along(T, 1.0, 0.0)) == 0);
    CHECK(allocations_along(
              newmark<bdf<2>>(zener_structure{1.0, 1.0, 1.0, 2.0, 1.0, 0.5}, one, average_acceleration, history).along(T, 1.0, 0.0)) == 0);
    Eigen::Matrix2d const M = Eigen::Matrix2d::Identity();
    auto const load = [](double t) { return Eigen::Vector2d(t, 1); };
    CHECK(allocations_along(newmark<bdf<2>>(fractional_structure{M, M, M, 1.0, 0.5}, load, average_acceleration, history).along(T, q, p)) ==
          0);
}

} // namespace no_allocation_tests
