// SPDX-License-Identifier: BSL-1.0
// The demonstration: the outer solar system by variational integrators. Equations, identities, integration, pictures. A separate program,
// built in a minute.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <sstream>

#include <CLI/CLI.hpp>
#include <boost/numeric/odeint.hpp>
#include <boost/numeric/odeint/external/eigen/eigen.hpp>

#include "hilger/hilger.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/variational/print.hpp"
#include "outer_solar_system_data.hpp"
#include "plot.hpp"
#include "progress.hpp"
#include "prove.hpp"
#include "solar_system.hpp"

namespace program {

namespace {

namespace odeint = boost::numeric::odeint;
using hilger::index_type;

struct demo_options {
    double days = 200'000;
    double step = 100; ///< days
    std::string data;  ///< a CSV file; empty for the built-in one
    std::string out = "out";
};

/// Observes invariants along a run, and writes them to a file.
class observer {
public:
    observer(solar_system const& system, std::string const& path, bool orbits)
        : system_(system), L_(system.lagrangian()), E0_(system.energy(L_, system.q, momenta())),
          L0_(system.angular_momentum(system.q, momenta())), orbits_(orbits), out_(path) {
        if (not out_) hilger::error::raise<hilger::error::unreadable>("cannot write '", path, "'");
        out_ << "# t in days, relative errors of energy and angular momentum";
        if (orbits_)
            for (auto const& name : system.names) out_ << ", " << name << " x y z in au, seen from the Sun";
        out_ << '\n' << std::setprecision(12);
    }
    [[nodiscard]] positions momenta() const { return system_.mass.cwiseProduct(system_.v); }

    void operator()(double t, positions const& q, positions const& p) {
        double const energy = std::abs((system_.energy(L_, q, p) - E0_) / E0_);
        double const angular = (system_.angular_momentum(q, p) - L0_).norm() / L0_.norm();
        worst_energy_ = std::max(worst_energy_, energy);
        worst_angular_ = std::max(worst_angular_, angular);
        out_ << t << ',' << energy << ',' << angular;
        if (orbits_)
            for (int i = 0; i < bodies; ++i)
                for (int c = 0; c < 3; ++c) out_ << ',' << q(3 * i + c) - q(c);
        out_ << '\n';
    }
    [[nodiscard]] double worst_energy() const { return worst_energy_; }
    [[nodiscard]] double worst_angular_momentum() const { return worst_angular_; }

private:
    solar_system const& system_;
    decltype(std::declval<solar_system const&>().lagrangian()) L_;
    double E0_;
    Eigen::Vector3d L0_;
    bool orbits_;
    std::ofstream out_;
    double worst_energy_ = 0, worst_angular_ = 0;
};

void say_row(std::string const& name, double step, observer const& seen, double seconds) {
    std::cout << "  " << std::left << std::setw(34) << name << std::right << std::setw(6) << step << std::scientific << std::setprecision(2)
              << std::setw(15) << seen.worst_energy() << std::setw(15) << seen.worst_angular_momentum() << std::defaultfloat
              << std::setprecision(6) << std::fixed << std::setprecision(1) << std::setw(9) << seconds << " s\n"
              << std::defaultfloat << std::setprecision(6);
}

class stopwatch {
public:
    [[nodiscard]] double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count(); }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

template <class Scale, class Embedding>
void run_embedding(solar_system const& system, Scale const& T, Embedding const& how, std::string const& path) {
    observer watch(system, path, true);
    progress_bar bar(how.name, T.size());
    stopwatch const clock;
    for (auto const& [t, q, p] : hilger::embed(system.lagrangian(), how).along(T, system.q, watch.momenta())) {
        watch(t, q, p);
        bar.advance();
    }
    say_row(std::string("hilger, ") + how.name, T.h(), watch, clock.seconds());
}

/// The same system as an ordinary differential equation for a stepper of Boost.odeint.
template <class Stepper, class Scale, class State>
void run_baseline(solar_system const& system, Scale const& T, Stepper stepper, State, char const* name, std::string const& path) {
    observer watch(system, path, false);
    progress_bar bar(name, T.size());
    stopwatch const clock;
    auto const L = system.lagrangian();
    auto const field = [&](State const& x, State& rate, double) {
        positions const q = x.template head<dimension>(), v = x.template tail<dimension>().cwiseQuotient(system.mass);
        rate.template head<dimension>() = v;
        rate.template tail<dimension>() = hilger::gradient_first(L, q, v);
    };
    State x;
    x << system.q, watch.momenta();
    for (index_type i = T.first(); i <= T.last(); ++i) {
        watch(T.element(i), x.template head<dimension>(), x.template tail<dimension>());
        bar.advance();
        if (i < T.last()) stepper.do_step(field, x, T.element(i), T.step(i));
    }
    say_row(name, T.h(), watch, clock.seconds());
}

template <class Scale>
void say_equations(solar_system const& system, Scale const& T) {
    constexpr hilger::unknown q;
    constexpr auto q_o = hilger::extend[q];
    hilger::lagrangian const L(system.lagrangian());
    auto const right = variation(integral(L(q, hilger::Delta_plus[q]), T));
    auto const mid = variation(integral(L(q_o, hilger::Delta_o_plus[q_o]), half(T)));
    std::cout << "Order-one embedding: discrete Euler-Lagrange equation and discrete Hamiltonian system\n  " << right << "  "
              << hilger::text_lines(hilger::hamiltonian_form(right), "  ") << "\nMid-point embedding\n  " << mid << "  "
              << hilger::text_lines(hilger::hamiltonian_form(mid), "  ") << '\n';
}

/// Returns the exit code.
int run_demo(demo_options const& options) {
    std::istringstream built_in(outer_solar_system_csv);
    std::ifstream given(options.data);
    if (not options.data.empty() and not given)
        hilger::error::raise<hilger::error::unreadable>("cannot open '", options.data, "' to read initial data from it");
    solar_system const system =
        options.data.empty() ? read_solar_system(built_in, "the built-in data") : read_solar_system(given, "'" + options.data + "'");

    double const count = options.days / options.step;
    if (not(options.step > 0) or not(count >= 1) or not(count <= 1e9))
        hilger::error::raise<hilger::error::invalid_scale>(
            "--step is a positive number of days and --days at least one step, and these are ", options.step, " and ", options.days);
    auto const T = hilger::uniform(0.0, options.step, static_cast<index_type>(std::floor(count)));

    std::filesystem::create_directories(options.out);
    auto const file = [&](char const* name) { return (std::filesystem::path(options.out) / name).string(); };

    std::cout << "Outer solar system from 5 September 1994: Sun with inner planets, Jupiter, Saturn, Uranus, Neptune, Pluto; d = 18\n"
              << "T = " << T.steps() << " steps of " << T.h() << " days\n\n";
    say_equations(system, T);

    std::cout << "Identities, in exact rational arithmetic\n";
    if (not prove_identities(std::cout)) return 1;

    std::cout << "\nIntegration\n  " << std::left << std::setw(34) << "scheme" << std::right << std::setw(6) << "h/day" << std::setw(15)
              << "energy error" << std::setw(15) << "ang. momentum" << std::setw(11) << "time\n";
    run_embedding(system, T, hilger::order_one, file("order_one.csv"));
    run_embedding(system, T, hilger::mid_point, file("midpoint.csv"));
    using phase = Eigen::Matrix<double, 2 * dimension, 1>;
    using algebra = odeint::vector_space_algebra;
    run_baseline(system, T, odeint::euler<phase, double, phase, double, algebra>{}, phase{}, "explicit Euler", file("euler.csv"));
    run_baseline(system, T, odeint::runge_kutta4<phase, double, phase, double, algebra>{}, phase{}, "Runge-Kutta of order 4",
                 file("runge_kutta.csv"));

    std::string const picture = plot_solar_system(options.out, system.names);
    std::cout << "\nWritten: " << options.out << "/{order_one,midpoint,euler,runge_kutta}.csv and " << picture << '\n';
    return 0;
}

} // namespace
} // namespace program

int main(int argc, char** argv) {
    CLI::App app{"the outer solar system: equations, identities, 200 000 days, drift and a picture"};
    program::demo_options options;
    app.add_option("--days", options.days, "length of the integration in days")->capture_default_str();
    app.add_option("--step", options.step, "step h in days")->capture_default_str();
    app.add_option("--data", options.data, "initial data, a CSV file like src/data/outer_solar_system.csv");
    app.add_option("--out", options.out, "directory for the CSV files and the picture")->capture_default_str();
    CLI11_PARSE(app, argc, argv);
    try {
        return program::run_demo(options);
    } catch (std::exception const& e) {
        std::fprintf(stderr, "hilger demo: %s\n", e.what());
        return 1;
    }
}
