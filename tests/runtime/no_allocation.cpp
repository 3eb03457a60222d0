// SPDX-License-Identifier: BSL-1.0
// Scales derived from a scale, and operators applied to functions, are views: making one and evaluating it allocates nothing, however many
// points there are. The global operator new is replaced here by one that counts.
#include <doctest/doctest.h>

#include <cstdlib>
#include <new>

#include "hilger/hilger.hpp"

namespace {
long allocations = 0;
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* const memory = std::malloc(size == 0 ? 1 : size)) return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

using namespace hilger;

namespace {

constexpr hilger::index N = 1'000'000;

/// How often memory was asked for while the work was done.
template <class Work>
long allocations_in(Work const& work) {
    long const before = allocations;
    work();
    return allocations - before;
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
    for (hilger::index i = 1; i < N; i += 1000)
        sum += q(T.point(i)) + T.sigma(T.point(i)) + step_mean[on_half[q_o]][i] + q_o(T_o.point(2 * i + 1));
    sum += boundary(q) + integral(q, T.point(N / 2), T.point(N / 4)) + interpolate(q)(T.point(3)) + steps_of(on_half[q_o])(T.point(3));
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
}

TEST_CASE("a formula on a uniform scale of a million points allocates nothing") {
    double result = 0;
    CHECK(allocations_in([&] { result = visit_all(function(uniform(0.0, 1e-3, N), square)); }) == 0);
    CHECK(result > 0);
    CHECK(allocations_in([&] { result = visit_all(function(uniform<N>(0.0, 1e-3), square)); }) == 0);
}

TEST_CASE("nor does a formula on given points, once they are given") {
    auto const T = time_scale(uniform(0.0, 1e-3, N));
    double result = 0;
    CHECK(allocations_in([&] { result = visit_all(function(T, square)); }) == 0);
    CHECK(result == doctest::Approx(visit_all(function(uniform(0.0, 1e-3, N), square))).epsilon(1e-9));
    CHECK(allocations_in([&] { return time_scale<double>(T); }) == 0); // copies share
}

TEST_CASE("nor does a table, once it is made") {
    auto const T = time_scale(uniform(0.0, 1e-3, N));
    auto const on_points = tabulate(function(T, square));
    auto const on_uniform = tabulate(function(uniform(0.0, 1e-3, N), square));
    double result = 0;
    CHECK(allocations_in([&] { result = visit_all(on_points); }) == 0);
    CHECK(allocations_in([&] { result = visit_all(on_uniform); }) == 0);
    CHECK(result > 0);
    CHECK(allocations_in([&] { auto const copy = on_points; }) == 0);
    CHECK(allocations_in([&] { (void)tabulate(function(uniform(0.0, 1.0, 10), square)); }) == 2); // the values, and the handle to them
}

TEST_CASE("integration by parts allocates nothing") {
    auto const f = tabulate(function(uniform(0.0, 1e-3, 1000), square));
    CHECK(allocations_in([&] {
              auto const parts = by_parts(on_half * Delta_o_plus * extend, f, on_half[extend[f]]);
              if (not(parts.left > 0)) throw 0;
          }) == 0);
}
