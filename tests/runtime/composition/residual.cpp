// SPDX-License-Identifier: BSL-1.0
// Compositions and adjoints solve the equations of their parts: exactly in the rationals, to rounding elsewhere; and what does not is seen.
#include <doctest/doctest.h>

#include "hilger/composition/methods.hpp"
#include "hilger/composition/residual.hpp"
#include "support/systems.hpp"

namespace residuals_of_compositions_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {

constexpr auto cubic = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2 - q * v * v / 3; };
constexpr auto coupled = [](auto const& q, auto const& v) {
    auto const last = q.size() - 1;
    return v.dot(v) / 2 - q.dot(q) / 2 - q(0) * q(0) * q(last) * q(last);
};
constexpr auto friction = [](auto const& t, auto const&, auto const& v) { return -v / 8 + sin(t); };

/// What rounding leaves where numbers are of this size: epsilon |dp/dv| |q| / h^2, of parts that are this much shorter.
constexpr double rounding(double h, double shorter) { return 64 * epsilon<double>() * shorter * (1 + shorter) / (h * h); }

/// A flow whose steps end a little beside where they should.
template <class Flow>
struct beside : stepping<beside<Flow>> {
    using problem_type = typename Flow::problem_type;
    Flow of;
    double off;
    beside(Flow f, double by) : of(std::move(f)), off(by) {}
    [[nodiscard]] auto const& mechanics() const { return of.mechanics(); }
    template <class S, class V>
    struct memory : Flow::template memory<S, V> {
        using base = typename Flow::template memory<S, V>;
        memory(beside const& f, S const& h, V const& like) : base(f.of, h, like) {}
        void advance(beside const& f, state<S, V>& x, S const& h) {
            base::advance(f.of, x, h);
            x.q = x.q + f.off;
        }
    };
};

} // namespace

TEST_CASE("nothing is left in the rationals") {
    auto const harmonic = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
    time_scale<Q> const T{Q(0), Q(1, 3), Q(1), Q(5, 4)};
    CHECK(largest_residual(stoermer_verlet(harmonic).along(T, Q(1), Q(1, 7))) == 0);
    CHECK(largest_residual(position_verlet(harmonic).along(T, Q(1), Q(1, 7))) == 0);
    CHECK(largest_residual(adjoint(embed(harmonic, order_one)).along(T, Q(1), Q(1, 7))) == 0);
    CHECK(largest_residual(compose(shares<fraction<1, 3>, fraction<2, 3>>{}, embed(harmonic, mid_point), embed(harmonic, theta<1, 3>))
                               .along(T, Q(1), Q(1, 7))) == 0);
}

TEST_CASE("and rounding elsewhere: kicks and drifts, turns, forces, the time, vectors, uneven steps") {
    auto const T = uniform(0.0, 0.125, 100);
    CHECK(largest_residual(stoermer_verlet(pendulum).along(T, 1.0, 0.25)) < rounding(0.125, 2));
    CHECK(largest_residual(stoermer_verlet(cubic).along(T, 0.5, 0.25)) < rounding(0.125, 2));
    CHECK(largest_residual(stoermer_verlet(with_force(pendulum, friction)).along(T, 1.0, 0.25)) < rounding(0.125, 2));
    CHECK(largest_residual(compose(kahan_li<8>, embed(pendulum, mid_point)).along(T, 1.0, 0.25)) < rounding(0.125, 16));
    CHECK(largest_residual(compose_with_adjoint(halves, embed(pendulum, order_one, compensated)).along(T, 1.0, 0.25)) < rounding(0.125, 2));
    time_scale<double> const uneven{0.0, 0.125, 0.1875, 0.5, 0.625};
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(6, 0, 0.5), p = Eigen::VectorXd::Constant(6, 0.25);
    CHECK(largest_residual(stoermer_verlet(coupled).along(uneven, q, p)) < rounding(0.0625, 2));
    CHECK(largest_residual(symmetrized(symmetrized(embed(coupled, theta<1, 3>))).along(uneven, q, p)) < rounding(0.0625, 8));
}

TEST_CASE("a step that leads elsewhere is seen") {
    auto const verlet = stoermer_verlet(pendulum);
    auto const T = uniform(0.0, 0.125, 10);
    beside const wrong(verlet, 1e-9);
    // 1e-9 in the position is 1e-9 / (h/2) in the velocity of half a step, and over h in the residual
    double const seen = largest_residual(verlet, record(wrong.along(T, 1.0, 0.25)));
    CHECK(seen > 1e-9 / 0.125);
    CHECK(seen < 1e-9 * 4 / (0.125 * 0.125));
    CHECK(largest_residual(verlet, record(stoermer_verlet(with_force(pendulum, friction)).along(T, 1.0, 0.25))) > 1e-2);
}

TEST_CASE("states that were kept are judged as the walk is, and moved ones are seen") {
    auto const verlet = stoermer_verlet(pendulum);
    auto const left = adjoint(embed(pendulum, order_one));
    auto const check = [](auto const& f, auto const& path) {
        auto run = record(path);
        CHECK(largest_residual(f, run) == largest_residual(path));
        auto const kept = run.states;
        for (auto const part : {&state<double, double>::q, &state<double, double>::p})
            for (std::size_t i : {std::size_t(1), std::size_t(5), kept.size() - 1}) {
                run.states[i].*part += 1e-9;
                CHECK(largest_residual(f, run) > 1e-9);
                run.states = kept;
            }
        CHECK_THROWS_AS((void)largest_residual(f, record(path, 2)), error::mismatch);
    };
    check(verlet, verlet.along(uniform(0.0, 0.125, 10), 1.0, 0.25));
    check(left, left.along(time_scale<double>{0.0, 0.125, 0.1875, 0.5, 0.625, 0.75, 1.0}, 1.0, 0.25));
}

} // namespace residuals_of_compositions_tests
