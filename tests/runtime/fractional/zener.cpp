// SPDX-License-Identifier: BSL-1.0
// The viscoelastic cantilever of Galucio, Deue, Dubois (2008), section 4: its matrices, exactly; its motion against the stress form (7)
// mode by mode and against a numerical inversion of the Laplace transform; the misprint in (10); its limit; and what is refused.
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <Eigen/Eigenvalues>
#include <doctest/doctest.h>

#include "../../../examples/beam.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/zener.hpp"
#include "hilger/hilger.hpp"
#include "series.hpp"

namespace fractional_zener_tests {

using namespace hilger;
using namespace hilger::testing;
using namespace beams;

namespace {

// SI units throughout
constexpr double L = 0.15, width = 0.025, thickness = 0.005, relaxed = 1e6, unrelaxed = 50e6, tau = 1e-3, F0 = 0.01;
constexpr double EI = relaxed * width * thickness * thickness * thickness / 12, rhoA = 1000 * width * thickness;
constexpr double static_tip = F0 * L * L * L / (3 * EI);

beam_matrices<double> paper_beam() { return cantilever(L, EI, rhoA, 5); }
/// F(t) of section 4.3 at the tip
struct ramp {
    double t1;
    Eigen::VectorXd operator()(double t) const { return Eigen::VectorXd::Unit(10, 8) * F0 * std::min(t / t1, 1.0); }
};
auto beam_scheme(double relaxation_time, double t1) {
    auto const beam = paper_beam();
    zener_structure const material{beam.mass, beam.stiffness, relaxed, unrelaxed, relaxation_time, 0.5};
    return newmark<bdf<2>>(material, ramp{t1});
}
std::vector<Eigen::VectorXd> walk(double relaxation_time, double t1, double h, int N) {
    std::vector<Eigen::VectorXd> q;
    Eigen::VectorXd const rest = Eigen::VectorXd::Zero(10);
    for (auto const& x : beam_scheme(relaxation_time, t1).along(uniform(0.0, h, N), rest, rest)) q.push_back(x.q);
    return q;
}

/// u'' + s = f with s + tau^a D^a s = k (u + R tau^a D^a u), both histories kept, by accelerations: from rest, f(0) = 0.
std::vector<double> stress_form(double k, double R, double scale, std::vector<double> const& f, double h, double alpha) {
    std::size_t const N = f.size();
    auto const g = first_weights<bdf<2>>(alpha, static_cast<hilger::index_type>(N));
    std::vector<double> u{0}, s{0};
    double v = 0, a = 0;
    for (std::size_t n = 1; n < N; ++n) {
        double past_u = 0, past_s = 0;
        for (std::size_t j = 1; j <= n; ++j) past_u += g[j] * u[n - j], past_s += g[j] * s[n - j];
        // s = k (1 + R scale) / (1 + scale) u + rest
        double const slope = k * (1 + R * scale) / (1 + scale), rest = scale * (k * R * past_u - past_s) / (1 + scale);
        double const predicted = u.back() + h * v + h * h / 4 * a;
        double const next = (f[n] - rest - slope * predicted) / (1 + h * h / 4 * slope);
        u.push_back(predicted + h * h / 4 * next);
        s.push_back(slope * u.back() + rest);
        v += h / 2 * (a + next);
        a = next;
    }
    return u;
}

/// The inverse Laplace transform of F at t > 0 on Talbot's contour with M points: 0.6 M digits, of which the scalar must have M / 2.
template <class Transform>
double inverse_laplace(Transform const& F, double t) {
    using complex = std::complex<long double>;
    int const M = 26;
    long double const r = 2.0L * M / (5 * static_cast<long double>(t)), pi = std::acos(-1.0L);
    long double sum = (F(complex(r)) * std::exp(r * t)).real() / 2;
    for (int k = 1; k < M; ++k) {
        long double const theta = k * pi / M, cot = 1 / std::tan(theta);
        complex const s = r * theta * complex(cot, 1), turn(1, theta + (theta * cot - 1) * cot);
        sum += (std::exp(static_cast<long double>(t) * s) * F(s) * turn).real();
    }
    return static_cast<double>(r / M * sum);
}

} // namespace

TEST_CASE("the matrices of a cantilever: static deflections exactly, its first frequency") {
    for (int const elements : {1, 2, 5}) {
        auto const beam = cantilever(Q(3, 2), Q(2, 7), Q(1), elements);
        CHECK(beam.tip() == 2 * elements - 2);
        CHECK(beam.stiffness == beam.stiffness.transpose());
        CHECK(beam.mass == beam.mass.transpose());
        // w(x) = x^2 (3 L - x) / 6 under EI at the tip
        for (int j = 1; j <= elements; ++j) {
            Eigen::Matrix<Q, Eigen::Dynamic, 1> w(2 * elements);
            for (int i = 1; i <= elements; ++i) {
                Q const x = Q(3, 2) * i / elements;
                w(2 * i - 2) = x * x * (Q(9, 2) - x) / 6;
                w(2 * i - 1) = x * (3 - x) / 2;
            }
            Eigen::Matrix<Q, Eigen::Dynamic, 1> const force = beam.stiffness * w;
            for (int i = 0; i < 2 * elements; ++i) CHECK(force(i) == (i == beam.tip() ? Q(2, 7) : Q(0)));
            // A deflection of 1 at the tip's two components of a rigid rotation about the clamp has the mass moment rho A L^3 / 3.
            Eigen::Matrix<Q, Eigen::Dynamic, 1> rotation(2 * elements);
            for (int i = 1; i <= elements; ++i) {
                rotation(2 * i - 2) = Q(3, 2) * i / elements;
                rotation(2 * i - 1) = 1;
            }
            Q const l = Q(3, 2) / elements;
            // The slope is 1 at the clamp too, whose component the matrices do not have: what is missing lies in the first element.
            Q const first = (2 * (13 * l * l + (-3) * l * l) + 4 * l * l) * l / 420;
            CHECK(rotation.dot(beam.mass * rotation) + first == Q(27, 8) / 3);
        }
    }
    auto const beam = paper_beam();
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> const modes(beam.stiffness, beam.mass);
    double const exact = std::pow(1.8751040687119611, 4) * EI / (rhoA * L * L * L * L);
    CHECK(modes.eigenvalues()(0) > exact); // Rayleigh
    CHECK(modes.eigenvalues()(0) < exact * 1.0001);
}

TEST_CASE("the beam of the paper is ten oscillators whose stress follows (7)") {
    double const h = 0.002, t1 = 0.05;
    int const N = 200;
    auto const made = walk(tau, t1, h, N);
    auto const beam = paper_beam();
    Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> const modes(beam.stiffness, beam.mass);
    std::vector<Eigen::VectorXd> sum(made.size(), Eigen::VectorXd::Zero(10));
    for (int j = 0; j < 10; ++j) {
        Eigen::VectorXd const phi = modes.eigenvectors().col(j); // phi' M phi = 1
        std::vector<double> f;
        for (int n = 0; n <= N; ++n) f.push_back(phi.dot(ramp{t1}(n * h)));
        auto const u = stress_form(modes.eigenvalues()(j), unrelaxed / relaxed, std::pow(1.5 * tau / h, 0.5), f, h, 0.5);
        for (std::size_t n = 0; n < u.size(); ++n) sum[n] += u[n] * phi;
    }
    double worst = 0, largest = 0;
    for (std::size_t n = 0; n < made.size(); ++n) {
        worst = std::max(worst, std::abs(made[n](8) - sum[n](8)));
        largest = std::max(largest, std::abs(made[n](8)));
    }
    CHECK(largest > 0.01); // m
    CHECK(worst < 16 * N * epsilon<double>() * largest);
}

TEST_CASE("order two, for alpha = 1/2 and for the standard solid, against the inverted Laplace transform") {
    double const R = 4, time = 0.5, t1 = 1, end = 2;
    auto const order = [&](auto alpha) {
        double const a = alpha.template as<double>();
        auto const exact = [&](double t) {
            auto const ramp_transform = [&](std::complex<long double> const& s) {
                auto const x = std::pow(s * static_cast<long double>(time), static_cast<long double>(a));
                return 1.0L / (s * s * (s * s + (1.0L + static_cast<long double>(R) * x) / (1.0L + x)));
            };
            return (inverse_laplace(ramp_transform, t) - inverse_laplace(ramp_transform, t - t1)) / t1;
        };
        std::vector<double> errors;
        for (int const N : {256, 512, 1024}) {
            zener_structure const material{1.0, 1.0, 1.0, R, time, alpha};
            double last = 0;
            for (auto const& x :
                 newmark<bdf<2>>(material, [&](double t) { return std::min(t / t1, 1.0); }).along(uniform(interval{0.0, end}, N), 0.0, 0.0))
                last = x.q;
            errors.push_back(std::abs(last - exact(end)));
        }
        CHECK(errors.back() < 1e-5);
        return fitted_slope(errors);
    };
    CHECK(std::abs(order(fraction<1, 2>{}) - 2) < 0.02);
    CHECK(std::abs(order(fraction<3, 4>{}) - 2) < 0.02);
    CHECK(std::abs(order(fraction<1>{}) - 2) < 0.02);
}

TEST_CASE("(10) as printed leaves out (3/2)^alpha: it is the beam whose relaxation time is 2 tau / 3") {
    double const h = 0.002, t1 = 0.05, R = unrelaxed / relaxed, c = std::sqrt(tau) / (std::sqrt(tau) + std::sqrt(h));
    int const N = 100;
    auto const beam = paper_beam();
    auto const g = first_weights<bdf<2>>(0.5, N + 1);
    Eigen::MatrixXd const stiffness = beam.stiffness * (1 + c * (R - 1));
    Eigen::PartialPivLU<Eigen::MatrixXd> const lu(beam.mass + h * h / 4 * stiffness);
    Eigen::VectorXd const zero = Eigen::VectorXd::Zero(10);
    Eigen::VectorXd q = zero, v = zero, a = zero;
    std::vector<Eigen::VectorXd> anelastic{zero}, printed{zero};
    for (int n = 1; n <= N; ++n) {
        Eigen::VectorXd sum = zero;
        for (int k = 1; k <= n; ++k) sum += g[static_cast<std::size_t>(k)] * anelastic[static_cast<std::size_t>(n - k)];
        Eigen::VectorXd const predicted = q + h * v + h * h / 4 * a;
        Eigen::VectorXd const next = lu.solve(ramp{t1}(n * h) - c * R * (beam.stiffness * sum) - stiffness * predicted);
        q = predicted + h * h / 4 * next;
        v += h / 2 * (a + next);
        a = next;
        anelastic.push_back((1 - c) * (R - 1) / R * q - c * sum);
        printed.push_back(q);
    }
    auto const right = walk(tau, t1, h, N), shorter = walk(2 * tau / 3, t1, h, N);
    double to_right = 0, to_shorter = 0;
    for (std::size_t n = 0; n < printed.size(); ++n) {
        to_right = std::max(to_right, std::abs(printed[n](8) - right[n](8)));
        to_shorter = std::max(to_shorter, std::abs(printed[n](8) - shorter[n](8)));
    }
    CHECK(to_shorter < 16 * N * epsilon<double>() * static_tip);
    CHECK(to_right > 0.01 * static_tip);
}

TEST_CASE("after a long time the tip comes to F L^3 / (3 E_o I), as slowly as t^-1/2") {
    double const t1 = 100, t = 1000, h = 0.5;
    double const tip = walk(tau, t1, h, 2000).back()(8);
    // 1 / E(s) = (1 - (R - 1) (tau s)^1/2 + ...) / E_o under a ramp; the next terms are s (nothing after t_1) and s^3/2 (3e-5 here).
    double const R = unrelaxed / relaxed, mean_root = 2 * (std::sqrt(t) - std::sqrt(t - t1)) / t1;
    double const creep = 1 - (R - 1) * std::sqrt(tau) * mean_root / std::sqrt(std::acos(-1.0));
    CHECK(std::abs(tip / static_tip - creep) < 1e-4);
    CHECK(creep > 0.97);
}

TEST_CASE("a material whose moduli are equal is elastic") {
    auto const beam = paper_beam();
    Eigen::VectorXd const rest = Eigen::VectorXd::Zero(10);
    auto const T = uniform(0.0, 0.002, 100);
    auto const viscous = newmark<bdf<2>>(zener_structure{beam.mass, beam.stiffness, 1.0, 1.0, tau, 0.5}, ramp{0.05});
    Eigen::MatrixXd const none = beam.stiffness * 0;
    auto const elastic = newmark<bdf<2>>(fractional_structure{beam.mass, none, beam.stiffness, tau, 0.5}, ramp{0.05});
    std::vector<double> a, b;
    for (auto const& x : viscous.along(T, rest, rest)) a.push_back(x.q(8));
    for (auto const& x : elastic.along(T, rest, rest)) b.push_back(x.q(8));
    for (std::size_t n = 0; n < a.size(); ++n) CHECK(std::abs(a[n] - b[n]) < 16 * 100 * epsilon<double>() * static_tip);
}

TEST_CASE("what is no material or beam is refused in one sentence") {
    double const nan = std::nan("");
    auto const make = [](double relaxed_modulus, double unrelaxed_modulus, double relaxation_time, double alpha) {
        return newmark<bdf<2>>(zener_structure{1.0, 1.0, relaxed_modulus, unrelaxed_modulus, relaxation_time, alpha},
                               [](double) { return 1.0; });
    };
    for (double const alpha : {0.0, 1.25, 2.0, nan}) CHECK_THROWS_AS((void)make(1, 2, 1, alpha), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)make(2, 1, 1, 0.5),
                         "the unrelaxed modulus of a material is not below the relaxed one, and here they are 1 and 2",
                         error::invalid_parameter);
    CHECK_THROWS_AS((void)make(0, 1, 1, 0.5), error::invalid_parameter);
    CHECK_THROWS_AS((void)make(1, nan, 1, 0.5), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)make(1, 2, -1, 0.5), "a relaxation time is positive, and this one is -1", error::invalid_parameter);
    CHECK_THROWS_AS((void)cantilever(L, 0.0, rhoA, 5), error::invalid_parameter);
    CHECK_THROWS_AS((void)cantilever(L, EI, nan, 5), error::invalid_parameter);
    CHECK_THROWS_WITH_AS((void)cantilever(L, EI, rhoA, 0),
                         "length, bending stiffness, mass and number of elements of a beam are positive, and one of them is 0",
                         error::invalid_parameter);
}

} // namespace fractional_zener_tests
