// SPDX-License-Identifier: BSL-1.0
// Work and precision: Galerkin steps of orders 4 to 24 beside adaptive Runge-Kutta-Fehlberg 7(8) and Bulirsch-Stoer of Boost.odeint, and
// composed Stoermer-Verlet. Errors are those of the positions at the end, against a run in long double. The force by hand is odeint's.
#include <array>
#include <sstream>

#include <boost/numeric/odeint.hpp>

#include "hilger/hilger.hpp"
#include "outer_solar_system_data.hpp"
#include "solar_system.hpp"
#include "timing.hpp"

namespace bench {
namespace {

namespace odeint = boost::numeric::odeint;

struct contestant {
    std::string name, setting;
    std::function<double(long&)> run; ///< makes the run, says how many steps it took, and returns its error
    double seconds = std::numeric_limits<double>::infinity(), error = 0;
    long steps = 0;
};

/// Takes turns, as race (timing.hpp) does.
void compare(std::string const& title, std::vector<contestant> all) {
    for (int round = 0; round < 15; ++round)
        for (auto& c : all) {
            auto const begin = std::chrono::steady_clock::now();
            c.error = c.run(c.steps);
            c.seconds = std::min(c.seconds, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
        }
    std::cout << title << "\n    " << std::left << std::setw(34) << "" << std::setw(12) << "" << std::right << std::setw(10) << "error"
              << std::setw(12) << "run (us)" << std::setw(12) << "step (ns)" << '\n';
    for (auto const& c : all)
        std::cout << "    " << std::left << std::setw(34) << c.name << std::setw(12) << c.setting << std::right << std::scientific
                  << std::setprecision(1) << std::setw(10) << c.error << std::fixed << std::setw(12) << c.seconds * 1e6 << std::setw(12)
                  << c.seconds / static_cast<double>(c.steps) * 1e9 << '\n'
                  << std::defaultfloat;
    std::cout << '\n';
}

/// One system of dimension D from (q0, v0) to t = end: L, and by hand its masses and its force.
template <int D, class L, class Force>
class system_to_compare {
    using position = Eigen::Matrix<double, D, 1>;
    using phase = std::array<double, 2 * static_cast<std::size_t>(D)>;

public:
    template <class Wide>
    system_to_compare(L l, Wide const& wide, Force force, position mass, position q0, position v0, double end)
        : L_(std::move(l)), force_(std::move(force)), inverse_mass_(mass.cwiseInverse()), q0_(q0), v0_(v0), p0_(mass.cwiseProduct(v0)),
          end_(end) {
        using vector = Eigen::Matrix<long double, D, 1>;
        vector const q = q0.template cast<long double>(), p = p0_.template cast<long double>();
        for (auto const& x :
             embed(wide, hilger::galerkin<12, hilger::gauss>).along(hilger::uniform(hilger::interval<long double>{0, end}, 800), q, p))
            reference_ = x.q.template cast<double>();
    }
    template <class Flow>
    void add(std::string const& name, Flow const& flow, std::initializer_list<long> counts) {
        for (long const n : counts)
            all.push_back({name, "N = " + std::to_string(n), [this, flow, n](long& steps) {
                               position q = q0_;
                               for (auto const& x : flow.along(hilger::uniform(hilger::interval{0.0, end_}, n), q0_, p0_)) q = x.q;
                               steps = n;
                               return (q - reference_).norm();
                           }});
    }
    template <int S>
    void add_gauss(std::initializer_list<long> counts) {
        add("galerkin<" + std::to_string(S) + ", gauss>", embed(L_, hilger::galerkin<S, hilger::gauss>), counts);
    }
    template <class Make>
    void add_adaptive(std::string const& name, Make const& make) {
        for (int digits = 8; digits <= 14; digits += 2)
            all.push_back({name, "1e-" + std::to_string(digits), [this, make, digits](long& steps) {
                               phase x;
                               for (int k = 0; k < D; ++k) at(x, k) = q0_(k), at(x, D + k) = v0_(k);
                               auto const field = [this](phase const& y, phase& to, double) {
                                   position g;
                                   force_(Eigen::Map<position const>(y.data()), g);
                                   for (int k = 0; k < D; ++k) at(to, k) = at(y, D + k), at(to, D + k) = g(k) * inverse_mass_(k);
                               };
                               auto stepper = make(std::pow(10.0, -digits));
                               steps = static_cast<long>(odeint::integrate_adaptive(stepper, field, x, 0.0, end_, end_ / 1000));
                               return (Eigen::Map<position const>(x.data()) - reference_).norm();
                           }});
    }
    void compare_all(std::string const& title) {
        add_gauss<2>({2000, 8000});
        add_gauss<4>({500, 1000, 2000});
        add_gauss<6>({250, 500, 1000});
        add_gauss<8>({100, 200, 300, 400});
        add_gauss<12>({60, 120, 180, 240});
        add("kahan_li<8> of Stoermer-Verlet", hilger::compose(hilger::kahan_li<8>, hilger::stoermer_verlet(L_)), {1000, 2000, 4000});
        add_adaptive("odeint: Fehlberg 7(8)", [](double tolerance) {
            return odeint::make_controlled(tolerance, tolerance, odeint::runge_kutta_fehlberg78<phase>());
        });
        add_adaptive("odeint: Bulirsch-Stoer", [](double tolerance) { return odeint::bulirsch_stoer<phase>(tolerance, tolerance); });
        compare(title, all);
    }

private:
    template <class X>
    static auto& at(X& x, int k) {
        return x[static_cast<std::size_t>(k)];
    }
    L L_;
    Force force_;
    position inverse_mass_, q0_, v0_, p0_, reference_;
    double end_;
    std::vector<contestant> all;
};

void kepler() {
    auto const L = [](auto const& x, auto const& v) { return v.squaredNorm() / 2 + 1 / x.norm(); };
    auto const force = [](auto const& q, auto& g) {
        double const r2 = q[0] * q[0] + q[1] * q[1], i3 = 1 / (r2 * std::sqrt(r2));
        g[0] = -q[0] * i3;
        g[1] = -q[1] * i3;
    };
    using V = Eigen::Vector2d;
    system_to_compare<2, decltype(L), decltype(force)>(L, L, force, V(1, 1), V(0.4, 0), V(0, 2), 50).compare_all("Kepler, e = 0.6, t = 50");
}
void henon_heiles() {
    auto const L = [](auto const& x, auto const& v) {
        return v.squaredNorm() / 2 - (x.squaredNorm() / 2 + x(0) * x(0) * x(1) - x(1) * x(1) * x(1) / 3);
    };
    auto const force = [](auto const& q, auto& g) {
        g[0] = -q[0] - 2 * q[0] * q[1];
        g[1] = -q[1] - q[0] * q[0] + q[1] * q[1];
    };
    using V = Eigen::Vector2d;
    system_to_compare<2, decltype(L), decltype(force)>(L, L, force, V(1, 1), V(0, 0.1), V(0.49, 0), 100)
        .compare_all("Henon-Heiles, E = 0.1247, t = 100");
}
void planets() {
    std::istringstream data(outer_solar_system_csv);
    auto const system = program::read_solar_system(data, "the built-in data");
    std::array<double, 15> strength;
    std::size_t n = 0;
    for (auto const& [a, b] : hilger::all_pairs(program::bodies)) strength[n++] = system.gravity * system.mass(3 * a) * system.mass(3 * b);
    auto const force = [strength](program::positions const& q, program::positions& g) {
        g.setZero();
        std::size_t k = 0;
        for (int a = 0; a < program::bodies; ++a)
            for (int b = 0; b < a; ++b, ++k) {
                double const x = q(3 * a) - q(3 * b), y = q(3 * a + 1) - q(3 * b + 1), z = q(3 * a + 2) - q(3 * b + 2);
                double const r2 = x * x + y * y + z * z, f = strength[k] / (r2 * std::sqrt(r2));
                g(3 * a) -= f * x, g(3 * a + 1) -= f * y, g(3 * a + 2) -= f * z;
                g(3 * b) += f * x, g(3 * b + 1) += f * y, g(3 * b + 2) += f * z;
            }
    };
    auto const energy = [strength](hilger::index k, auto const& r) { return -strength[static_cast<std::size_t>(k)] / r.norm(); };
    auto const potential = hilger::pairs<3>(hilger::all_pairs(program::bodies), energy);
    auto const L = hilger::mechanical(system.mass, potential);
    auto const wide = hilger::mechanical(system.mass.cast<long double>().eval(), potential);
    system_to_compare<program::dimension, std::remove_const_t<decltype(L)>, decltype(force)>(L, wide, force, system.mass, system.q,
                                                                                             system.v, 50000)
        .compare_all("Outer solar system, 50 000 days");
}

} // namespace

void galerkin() {
    kepler();
    henon_heiles();
    planets();
}

} // namespace bench
