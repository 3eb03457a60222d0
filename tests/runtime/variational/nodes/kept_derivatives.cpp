// SPDX-License-Identifier: BSL-1.0
// Who asks for derivatives at many arguments traces a formula once: residuals, energies, slopes between states, equations between ends.
// Counted, and the same numbers as those of a formula of each argument's own.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace kept_derivatives_tests {

using namespace hilger;

namespace {

constexpr unknown q;
long long calls = 0;
/// A row whose mass depends on the position; with a wall that acts on one side.
struct row {
    bool has_wall = false;
    auto operator()(auto const& x, auto const& v) const {
        ++calls;
        auto L = v.dot(v) / 2 - x.dot(x) / 2;
        for (int k = 1; k < x.size(); ++k) L = L + x(k) * x(k) * v(k) * v(k - 1) / 8;
        if (has_wall and x(0) > 0) L = L - x(0) * x(0) * x(0);
        return L;
    }
};
/// One whose formula is another one at every time, and one that is generic in it.
constexpr auto driven = [](double t, auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) * std::exp(-t) + q(0) * v(5); };
struct generic_in_time {
    static constexpr bool is_generic_in_time = true;
    auto operator()(auto const& t, auto const& q, auto const& v) const { return v.dot(v) / 2 - t * q.dot(q) * q(1) + q(0) * v(5); }
};
template <class Work>
long long calls_of(Work const& work) {
    calls = 0;
    work();
    return calls;
}
template <class V>
V numbers(int d, int first) {
    using S = typename V::Scalar;
    V x(d);
    for (int k = 0; k < d; ++k) x(k) = S((k * k + first) % 7 - 3) / S(8);
    return x;
}
using dynamic = Eigen::VectorXd;
using six = Eigen::Matrix<Q, 6, 1>;

/// At many arguments what is asked for at each of them anew; the callable is its own formula there.
template <class V, class L, class Force = no_force>
void gives_what_each_has(L const& lagrangian, Force const& force = {}) {
    using S = typename V::Scalar;
    problem<L, Force> const what{lagrangian, force};
    detail::kept_derivatives const kept(what);
    for (int k = 0; k < 12; ++k) {
        CAPTURE(k);
        S const t = S(k % 5) / S(4);
        V const q = numbers<V>(6, k), v = numbers<V>(6, 3 * k + 1);
        auto const alone = detail::expand_at(what, t, q, v);
        auto const all = kept.expand(t, q, v);
        CHECK(kept.by_q(t, q, v) == alone.e.by_q);
        CHECK(kept.by_v(t, q, v) == alone.e.by_v);
        CHECK(all.e.by_q == alone.e.by_q);
        CHECK(all.e.by_v == alone.e.by_v);
        CHECK(all.e.qq == alone.e.qq);
        CHECK(all.e.qv == alone.e.qv);
        CHECK(all.vq_ == alone.vq_);
        CHECK(all.e.vv == alone.e.vv);
    }
}

} // namespace

TEST_CASE("a formula that is kept says at any argument what it says where it is traced") {
    gives_what_each_has<six>(row{});
    gives_what_each_has<six>(row{true}); // on both sides of the wall
    gives_what_each_has<dynamic>(row{true});
    gives_what_each_has<dynamic>(driven);
    gives_what_each_has<six>(generic_in_time{});
    gives_what_each_has<dynamic>(row{}, [](auto const& t, auto const& q, auto const& v) { return (t - 1) * v - q(1) * q; });
}

TEST_CASE("one thing keeps a formula for each kind of state that it is asked with, one after the other") {
    detail::kept_derivatives const kept(problem<row>{{}, {}});
    dynamic const q = numbers<dynamic>(6, 1), v = numbers<dynamic>(6, 2);
    six const x = numbers<six>(6, 1), y = numbers<six>(6, 2);
    for (int round = 0; round < 2; ++round) {
        CHECK(kept.by_v(0.0, q, v) == gradient_second(row{}, q, v));
        CHECK(kept.by_v(Q(0), x, y) == gradient_second(row{}, x, y));
        dynamic const longer = numbers<dynamic>(9, 1), its_velocity = numbers<dynamic>(9, 2);
        CHECK(kept.by_q(0.0, longer, its_velocity) == gradient_first(row{}, longer, its_velocity));
    }
    auto const E = energy(row{});
    for (int const d : {6, 9, 5}) {
        state<double, dynamic> const at{0, numbers<dynamic>(d, 3), numbers<dynamic>(d, 4)};
        CHECK(E(at) == energy(row{})(at));
    }
    // who asks while it is being asked has a formula of its own
    kept.at(0.0, q, v, detail::wanted::forces_only, [&](auto const& node) {
        CHECK(kept.by_q(0.0, dynamic(2 * q), v) == gradient_first(row{}, dynamic(2 * q), v));
        CHECK(node.by_q(2) == gradient_first(row{}, q, v)(2));
        CHECK(node.by_q(2) != 0);
        return 0;
    });
}

TEST_CASE("more points are no more calls of the Lagrangian") {
    dynamic const q0 = numbers<dynamic>(7, 1), v0 = numbers<dynamic>(7, 2) / 4;
    auto const work = [&](auto const& what) { return std::pair(calls_of([&] { what(10); }), calls_of([&] { what(30); })); };
    auto const path = [&](int steps) { return embed(row{}, mid_point).along(uniform(0.0, 0.05, steps), initial_velocity{q0, v0}); };
    auto const same = [&](auto const& what) {
        auto const [few, many] = work(what);
        CHECK(0 < few);
        CHECK(few == many);
    };
    auto const action = [](auto const& T) { return variation(integral(lagrangian{row{}}(extend[q], Delta_o_plus[extend[q]]), half(T))); };
    same([&](int n) { CHECK(largest_residual(path(n)) <= 1e-12); });
    same([&](int n) { (void)dense_output(path(n)); });
    same([&](int n) {
        for (auto const& x : events(path(n), [](auto const& x) { return sin(8 * x.t); })) (void)x;
    });
    same([&](int n) {
        auto const T = uniform(0.0, 0.5 / n, n);
        CHECK(largest_residual(action(T), solve(action(T), T, boundary_values{q0, v0})) <= 1e-12 * n * n);
    });
    same([&](int n) {
        auto const T = uniform(0.0, 0.05, n);
        CHECK(largest_residual(action(T), solve(action(T), T, std::vector{q0, dynamic(q0 + v0 / 20)})) <= 1e-12);
    });
    // The value of L is asked for at each state; its derivatives are not.
    auto const [few, many] = work([&](int n) { (void)drift_along(path(n), energy(row{})); });
    CHECK(many - few == 20);
}

TEST_CASE("the energy without mass at rest, and where the Legendre map has no inverse") {
    auto const quartic = [](auto const& q, auto const& v) { return v.cwiseProduct(v).squaredNorm() / 4 - q.dot(q) / 2; };
    dynamic const q = numbers<dynamic>(5, 1), v = numbers<dynamic>(5, 6).array() + 0.875;
    dynamic const p = v.array().cube();
    double const E = energy(quartic)(state<double, dynamic>{0, q, p});
    CHECK(std::abs(E - (3 * v.array().pow(4).sum() / 4 + q.dot(q) / 2)) <= 64 * epsilon<double>() * E);
    auto const massless = [](auto const& x, auto const& y) { return x.dot(y); };
    CHECK_THROWS_AS((void)energy(massless)(state<double, dynamic>{0, q, p}), error::singular);
}

} // namespace kept_derivatives_tests
