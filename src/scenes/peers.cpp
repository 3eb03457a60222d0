// SPDX-License-Identifier: BSL-1.0
#include "peers.hpp"

#include <array>
#include <cmath>
#include <sstream>

#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>

#include "measure.hpp"
#include "outer_solar_system_data.hpp"
#if PROGRAM_HAS_GSL
#include "peers_gsl.hpp"
#endif
#include "solar_system.hpp"

namespace program {

namespace {

namespace odeint = boost::numeric::odeint;

template <std::size_t D>
using vector = std::array<double, D>;

/// q'' = acceleration(q), with everything that a hand-written program would do.
template <std::size_t D, class Acceleration>
class second_order {
    using phase = vector<2 * D>;

public:
    second_order(Acceleration a, vector<D> const& q, vector<D> const& v, double t1) : acceleration_(a), q_(q), v_(v), t1_(t1) {}

    std::vector<peer_run> run() {
        for (int half_digits = 6; half_digits <= 30; ++half_digits) {
            double const tolerance = std::pow(10.0, -half_digits / 2.0);
            adaptive("dopri5", tolerance,
                     [=] { return odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_dopri5<phase>()); });
            adaptive("fehlberg78", tolerance,
                     [=] { return odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<phase>()); });
            adaptive("bulirsch-stoer", tolerance, [=] { return odeint::bulirsch_stoer<phase>(tolerance, tolerance); });
#if PROGRAM_HAS_GSL
            for (auto const& method : gsl_methods())
                fixed(method.name, tolerance, [&] {
                    return by_gsl(
                        method, tolerance, [this](double const* x, double* rate) { first_order(x, rate); }, start(), t1_);
                });
#endif
        }
        for (int steps = 128; steps <= 1 << 17; steps = static_cast<int>(next_number(steps, 4))) {
            fixed("runge-kutta-4", steps, [&, steps] {
                phase x = start();
                odeint::runge_kutta4<phase> stepper;
                odeint::integrate_n_steps(stepper, field(), x, 0.0, t1_ / steps, static_cast<std::size_t>(steps));
                return x;
            });
            fixed("mclachlan-sb3a-4", steps, [&, steps] {
                std::pair<vector<D>, vector<D>> x(q_, v_);
                odeint::symplectic_rkn_sb3a_m4_mclachlan<vector<D>> stepper;
                for (int i = 0; i < steps; ++i) stepper.do_step(force(), x, 0.0, t1_ / steps);
                phase both;
                std::copy(x.first.begin(), x.first.end(), both.begin());
                return both;
            });
        }
        return std::move(runs_);
    }

private:
    [[nodiscard]] phase start() const {
        phase x;
        std::copy(q_.begin(), q_.end(), x.begin());
        std::copy(v_.begin(), v_.end(), x.begin() + D);
        return x;
    }
    [[nodiscard]] auto field() const {
        return [this](phase const& x, phase& rate, double) { first_order(x.data(), rate.data()); };
    }
    void first_order(double const* x, double* rate) const {
        vector<D> q, a;
        std::copy_n(x, D, q.begin());
        acceleration_(q, a);
        std::copy_n(x + D, D, rate);
        std::copy(a.begin(), a.end(), rate + D);
    }
    [[nodiscard]] auto force() const {
        return [this](vector<D> const& q, vector<D>& a) { acceleration_(q, a); };
    }
    template <class Make>
    void adaptive(char const* name, double tolerance, Make const& make) {
        fixed(name, tolerance, [&] {
            phase x = start();
            odeint::integrate_adaptive(make(), field(), x, 0.0, t1_, t1_ / 1000);
            return x;
        });
    }
    template <class Run>
    void fixed(char const* name, double parameter, Run const& run) {
        phase x{};
        try {
            double const seconds = fastest([&] { x = run(); });
            if (std::isfinite(x[0])) runs_.push_back({name, parameter, seconds, std::vector<double>(x.begin(), x.begin() + D)});
        } catch (std::exception const&) { // a tolerance that the method cannot keep
        }
    }
    Acceleration acceleration_;
    vector<D> q_, v_;
    double t1_;
    std::vector<peer_run> runs_;
};
template <std::size_t D, class Acceleration>
std::vector<peer_run> run_all(Acceleration a, vector<D> const& q, vector<D> const& v, double t1) {
    return second_order<D, Acceleration>(a, q, v, t1).run();
}

std::vector<peer_run> planets() {
    std::istringstream built_in(outer_solar_system_csv);
    solar_system const s = read_solar_system(built_in, "the built-in data");
    vector<dimension> q, v;
    for (int k = 0; k < dimension; ++k) q[static_cast<std::size_t>(k)] = s.q(k), v[static_cast<std::size_t>(k)] = s.v(k);
    std::array<double, bodies> m;
    for (std::size_t i = 0; i < bodies; ++i) m[i] = solar_system::gravity * s.mass(3 * static_cast<int>(i));
    auto const acceleration = [m](vector<dimension> const& x, vector<dimension>& a) {
        a.fill(0);
        for (std::size_t i = 0; i < bodies; ++i)
            for (std::size_t j = i + 1; j < bodies; ++j) {
                double const dx = x[3 * j] - x[3 * i], dy = x[3 * j + 1] - x[3 * i + 1], dz = x[3 * j + 2] - x[3 * i + 2];
                double const r2 = dx * dx + dy * dy + dz * dz, i3 = 1 / (r2 * std::sqrt(r2));
                double const mi = m[i] * i3, mj = m[j] * i3;
                a[3 * i] += mj * dx, a[3 * i + 1] += mj * dy, a[3 * i + 2] += mj * dz;
                a[3 * j] -= mi * dx, a[3 * j + 1] -= mi * dy, a[3 * j + 2] -= mi * dz;
            }
    };
    return run_all<dimension>(acceleration, q, v, 20'000);
}

/// u'' + D^(1/2) u + u = 1 as the system D^(1/2) y_1 = y_2, ..., D^(1/2) y_4 = 1 - y_1 - y_2 (u = y_1, u' = y_3), by the
/// predictor-corrector of Diethelm, Ford and Freed, whose sums go over all of the past.
double predictor_corrector(int steps, double t1) {
    constexpr double alpha = 0.5;
    double const h = t1 / steps, predict = std::pow(h, alpha) / std::tgamma(alpha + 1),
                 correct = std::pow(h, alpha) / std::tgamma(alpha + 2);
    auto const n_max = static_cast<std::size_t>(steps);
    std::vector<std::array<double, 4>> f(n_max + 1);
    std::vector<double> a(n_max + 2), b(n_max + 2), low(n_max + 2), high(n_max + 2);
    for (std::size_t n = 0; n < n_max + 2; ++n)
        low[n] = std::pow(static_cast<double>(n), alpha), high[n] = std::pow(static_cast<double>(n), alpha + 1);
    for (std::size_t n = 1; n < n_max + 1; ++n) b[n] = low[n] - low[n - 1], a[n] = high[n + 1] - 2 * high[n] + high[n - 1];
    auto const rate = [](std::array<double, 4> const& y) { return std::array<double, 4>{y[1], y[2], y[3], 1 - y[0] - y[1]}; };
    std::array<double, 4> y{0, 0, 0, 0};
    f[0] = rate(y);
    for (std::size_t n = 1; n <= n_max; ++n) {
        auto const m = static_cast<double>(n);
        std::array<double, 4> p{}, c{};
        double const first = high[n - 1] - (m - 1 - alpha) * low[n];
        for (std::size_t k = 0; k < 4; ++k) c[k] = first * f[0][k], p[k] = b[n] * f[0][k];
        for (std::size_t j = 1; j < n; ++j)
            for (std::size_t k = 0; k < 4; ++k) c[k] += a[n - j] * f[j][k], p[k] += b[n - j] * f[j][k];
        for (std::size_t k = 0; k < 4; ++k) y[k] = predict * p[k];
        auto const g = rate(y);
        for (std::size_t k = 0; k < 4; ++k) y[k] = correct * (c[k] + g[k]);
        f[n] = rate(y);
    }
    return y[0];
}

} // namespace

std::vector<peer_run> run_peers(std::string const& scene) {
    if (scene == "pendulum") return run_all<1>([](vector<1> const& q, vector<1>& a) { a[0] = -std::sin(q[0]); }, {1.5}, {0}, 100);
    if (scene == "kepler")
        return run_all<2>(
            [](vector<2> const& q, vector<2>& a) {
                double const r2 = q[0] * q[0] + q[1] * q[1], i3 = 1 / (r2 * std::sqrt(r2));
                a[0] = -q[0] * i3, a[1] = -q[1] * i3;
            },
            {0.4, 0}, {0, 2}, 50);
    if (scene == "henon-heiles")
        return run_all<2>(
            [](vector<2> const& q, vector<2>& a) { a[0] = -q[0] - 2 * q[0] * q[1], a[1] = -q[1] - q[0] * q[0] + q[1] * q[1]; }, {0, 0.1},
            {0.49, 0}, 100);
    if (scene == "outer-solar-system") return planets();
    std::vector<peer_run> runs;
    if (scene == "fractional-oscillator")
        for (int steps = 128; steps <= 1 << 14; steps *= 2) {
            double u = 0;
            double const seconds = fastest([&] { u = predictor_corrector(steps, 15); });
            runs.push_back({"predictor-corrector", static_cast<double>(steps), seconds, {u}});
        }
    return runs;
}

} // namespace program
