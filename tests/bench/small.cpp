// SPDX-License-Identifier: BSL-1.0
// Pendulum, Henon-Heiles and Kepler: mid-point, order one and Stoermer-Verlet, without friction and with it.
#include <boost/numeric/odeint.hpp>

#include "hilger/composition/composition.hpp"
#include "hilger/hilger.hpp"
#include "small_by_hand.hpp"
#include "timing.hpp"

namespace bench {
namespace {

namespace odeint = boost::numeric::odeint;

template <class P, class Flow>
double by_hilger(Flow const& flow, long n) {
    double s = 0;
    auto const T = hilger::uniform(0.0, P::h, n);
    if constexpr (P::d == 1) {
        for (auto const& x : flow.along(T, P::q0[0], P::p0[0])) s += x.q;
    } else {
        using V = Eigen::Matrix<double, P::d, 1>;
        for (auto const& x : flow.along(T, V(P::q0.data()), V(P::p0.data()))) s += x.q(0);
    }
    return s;
}
template <class P, class Stepper>
double by_odeint(long n) {
    Stepper stepper;
    vector<P> q = P::q0, p = P::p0;
    double s = 0;
    auto const force = [](vector<P> const& x, vector<P>& g) { P::force(x, g); };
    for (long i = 0; i < n; ++i) {
        s += q[0];
        stepper.do_step(force, q, p, static_cast<double>(i) * P::h, P::h);
    }
    return s + q[0];
}

template <class P>
void race_all(std::string const& name) {
    using hilger::embed;
    long const n = 10'000; // well below what a scheduler gives at a time, or a busy machine makes it twice as long
    int const rounds = 400;
    race(name + ", mid-point", n, rounds,
         {{"hand: Newton, linear guess", [](long m) { return midpoint_by_hand<P, 2>(m); }, true},
          {"hand: Newton, guess through 7 velocities", [](long m) { return midpoint_by_hand<P, 7>(m); }, true},
          {"hilger: embed(L, mid_point)", [](long m) { return by_hilger<P>(embed(P::L, hilger::mid_point), m); }},
          {"hilger: embed(L, mid_point, compensated)",
           [](long m) { return by_hilger<P>(embed(P::L, hilger::mid_point, hilger::compensated), m); }},
          {"odeint: symplectic_rkn_sb3a_mclachlan, order 4", by_odeint<P, odeint::symplectic_rkn_sb3a_mclachlan<vector<P>>>}});
    race(name + ", order one", n, rounds,
         {{"hand: symplectic Euler", [](long m) { return order_one_by_hand<P>(m); }, true},
          {"hilger: embed(L, order_one)", [](long m) { return by_hilger<P>(embed(P::L, hilger::order_one), m); }},
          {"odeint: symplectic_euler", by_odeint<P, odeint::symplectic_euler<vector<P>>>}});
    race(name + ", Stoermer-Verlet", n, rounds,
         {{"hand: kick, drift, kick", [](long m) { return verlet_by_hand<P>(m); }, true},
          {"hilger: stoermer_verlet(L)", [](long m) { return by_hilger<P>(hilger::stoermer_verlet(P::L), m); }}});
    auto const rubbing = with_force(hilger::lagrangian{P::L}, [](auto const&, auto const& v) { return -friction<1> * v; });
    race(name + " with friction, mid-point", n, rounds,
         {{"hand: Newton, linear guess", [](long m) { return midpoint_by_hand<P, 2, 1>(m); }, true},
          {"hand: Newton, guess through 7 velocities", [](long m) { return midpoint_by_hand<P, 7, 1>(m); }, true},
          {"hilger: embed(with_force(L, f), mid_point)", [&](long m) { return by_hilger<P>(embed(rubbing, hilger::mid_point), m); }}});
    race(name + " with friction, order one", n, rounds,
         {{"hand: symplectic Euler, the friction solved for", [](long m) { return order_one_by_hand<P, 1>(m); }, true},
          {"hilger: embed(with_force(L, f), order_one)", [&](long m) { return by_hilger<P>(embed(rubbing, hilger::order_one), m); }}});
}

} // namespace

void small_systems() {
    race_all<pendulum>("Pendulum");
    race_all<henon_heiles>("Henon-Heiles");
    race_all<kepler>("Kepler");
}

} // namespace bench
