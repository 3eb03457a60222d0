// SPDX-License-Identifier: BSL-1.0
#include "peers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_m4_mclachlan.hpp>

#include "engine/second_degree.hpp"
#include "engine/small_lagrangian.hpp"
#include "hilger/step/separable.hpp"
#include "measure.hpp"
#include "problems/from_file.hpp"
#if PROGRAM_HAS_GSL
#include "peers_gsl.hpp"
#endif

namespace program {

namespace {

namespace odeint = boost::numeric::odeint;

/// q'' = M^-1 dL/dq, of the same formula that hilger steps, in states of D coordinates or, for D = 0, of any number.
template <std::size_t D>
class acceleration {
    using L = std::conditional_t<D == 0, hilger::text::stated_lagrangian, engine::small_lagrangian<double, static_cast<int>(D)>>;
    using V = Eigen::Matrix<double, D == 0 ? Eigen::Dynamic : static_cast<int>(D), 1>;
    using problem = hilger::problem<L, hilger::no_force>;

public:
    acceleration(hilger::text::stated_lagrangian const& of, V const& q)
        : of_{L(of), {}}, parts_(of_, q), q_(q), force_(q), rate_(q), is_there_(parts_.inspect(of_, {0.0, q, q})) {}
    /// Whether L = v.Mv/2 - U(q).
    [[nodiscard]] bool is_there() const { return is_there_; }
    void operator()(double const* q, double* a) {
        std::copy_n(q, q_.size(), q_.data());
        (void)parts_.force(of_, 0.0, q_, force_);
        parts_.solve(force_, rate_);
        std::copy_n(rate_.data(), q_.size(), a);
    }

private:
    problem of_;
    hilger::detail::separable<problem, double, V> parts_;
    V q_, force_, rate_;
    bool is_there_;
};

template <std::size_t D>
class second_order {
    template <std::size_t N>
    using numbers = std::conditional_t<D == 0, std::vector<double>, std::array<double, N>>;
    using vector = numbers<D>;
    using phase = numbers<2 * D>;

public:
    explicit second_order(stated_problem const& of)
        : acceleration_(of.of.lagrangian, numbers_of(of.q)), d_(of.q.size()), q_(taken(numbers_of(of.q))), v_(taken(numbers_of(of.v))) {
        auto const T = points_of(of, 1);
        t1_ = T.step;
    }

    std::vector<peer_run> run() {
        if (not acceleration_.is_there()) return {};
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
                std::pair<vector, vector> x(q_, v_);
                odeint::symplectic_rkn_sb3a_m4_mclachlan<vector> stepper;
                for (int i = 0; i < steps; ++i) stepper.do_step(force(), x, 0.0, t1_ / steps);
                phase both = start();
                std::copy(x.first.begin(), x.first.end(), both.begin());
                return both;
            });
        }
        return std::move(runs_);
    }

private:
    static vector taken(engine::vector<double> const& x) {
        vector y{};
        if constexpr (D == 0) y.resize(static_cast<std::size_t>(x.size()));
        std::copy(x.begin(), x.end(), y.begin());
        return y;
    }
    [[nodiscard]] phase start() const {
        phase x{};
        if constexpr (D == 0) x.resize(2 * d_);
        std::copy(q_.begin(), q_.end(), x.begin());
        std::copy(v_.begin(), v_.end(), x.begin() + static_cast<std::ptrdiff_t>(d_));
        return x;
    }
    [[nodiscard]] auto field() {
        return [this](phase const& x, phase& rate, double) { first_order(x.data(), rate.data()); };
    }
    void first_order(double const* x, double* rate) {
        acceleration_(x, rate + d_);
        std::copy_n(x + d_, d_, rate);
    }
    [[nodiscard]] auto force() {
        return [this](vector const& q, vector& a) { acceleration_(q.data(), a.data()); };
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
            auto const end = x.begin() + static_cast<std::ptrdiff_t>(d_);
            if (std::isfinite(x[0])) runs_.push_back({name, parameter, seconds, std::vector<double>(x.begin(), end)});
        } catch (std::exception const&) { // a tolerance that the method cannot keep
        }
    }
    acceleration<D> acceleration_;
    std::size_t d_;
    vector q_, v_;
    double t1_ = 0;
    std::vector<peer_run> runs_;
};

/// m u'' + rho D^(1/2) u + k u = f as the system D^(1/2) y_1 = y_2, ..., D^(1/2) y_4 = (f - k y_1 - rho y_2) / m (u = y_1, u' = y_3), by
/// the predictor-corrector of Diethelm, Ford and Freed, with sums over all of the past.
double predictor_corrector(stated_problem const& what, int steps) {
    constexpr double alpha = 0.5;
    auto const parts = engine::second_degree_of<double>(what.of.lagrangian, 1);
    double const m = parts.mass(0, 0), k = parts.stiffness(0, 0), load = parts.load(0), rho = static_cast<double>(what.of.damping[0].rho);
    double const h = points_of(what, steps).step, predict = std::pow(h, alpha) / std::tgamma(alpha + 1),
                 correct = std::pow(h, alpha) / std::tgamma(alpha + 2);
    auto const n_max = static_cast<std::size_t>(steps);
    std::vector<std::array<double, 4>> f(n_max + 1);
    std::vector<double> a(n_max + 2), b(n_max + 2), low(n_max + 2), high(n_max + 2);
    for (std::size_t n = 0; n < n_max + 2; ++n)
        low[n] = std::pow(static_cast<double>(n), alpha), high[n] = std::pow(static_cast<double>(n), alpha + 1);
    for (std::size_t n = 1; n < n_max + 1; ++n) b[n] = low[n] - low[n - 1], a[n] = high[n + 1] - 2 * high[n] + high[n - 1];
    auto const rate = [=](std::array<double, 4> const& y) {
        return std::array<double, 4>{y[1], y[2], y[3], (load - k * y[0] - rho * y[1]) / m};
    };
    std::array<double, 4> const start{numbers_of(what.q)(0), 0, numbers_of(what.v)(0), 0};
    std::array<double, 4> y = start;
    f[0] = rate(y);
    for (std::size_t n = 1; n <= n_max; ++n) {
        std::array<double, 4> p{}, c{};
        double const first = high[n - 1] - (static_cast<double>(n) - 1 - alpha) * low[n];
        for (std::size_t i = 0; i < 4; ++i) c[i] = first * f[0][i], p[i] = b[n] * f[0][i];
        for (std::size_t j = 1; j < n; ++j)
            for (std::size_t i = 0; i < 4; ++i) c[i] += a[n - j] * f[j][i], p[i] += b[n - j] * f[j][i];
        for (std::size_t i = 0; i < 4; ++i) y[i] = start[i] + predict * p[i];
        auto const g = rate(y);
        for (std::size_t i = 0; i < 4; ++i) y[i] = start[i] + correct * (c[i] + g[i]);
        f[n] = rate(y);
    }
    return y[0];
}

} // namespace

std::vector<peer_run> run_peers(scene const& what) {
    auto const& one = *what.stated;
    if (one.of.force or one.of.time_transformation or not one.last.empty()) return {};
    if (not one.of.has_memory())
        return engine::with_small_size(what.dimension, [&]<int D>(std::integral_constant<int, D>) { return second_order<D>(one).run(); });
    std::vector<peer_run> runs;
    if (what.dimension == 1 and one.of.damping.size() == 1 and one.of.damping[0].alpha == 0.5 and
        std::find(what.embeddings.begin(), what.embeddings.end(), "g-alpha-newmark") != what.embeddings.end())
        for (int steps = 128; steps <= 1 << 14; steps *= 2) {
            double u = 0;
            double const seconds = fastest([&] { u = predictor_corrector(one, steps); });
            runs.push_back({"predictor-corrector", static_cast<double>(steps), seconds, {u}});
        }
    return runs;
}

} // namespace program
