// SPDX-License-Identifier: BSL-1.0
// u'' + c D^alpha u + u = 1 from rest, 0 < alpha < 1, in closed form: the inverse of U(s) = 1 / (s Q(s)), Q = s^2 + c s^alpha + 1, is the
// residue 1 at 0, the two at the roots of Q, and an integral along the cut, -(1/pi) int_0^infinity e^{-rt} Im U(r e^{i pi}) dr, here by the
// trapezoidal rule in ln r. Independent of the double power series and of any time step.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

namespace hilger::papers {

class oscillator_solution {
public:
    oscillator_solution(double alpha, double c) {
        using std::pow;
        for (int i = 0; i < 50; ++i) root_ -= (root_ * root_ + c * pow(root_, alpha) + 1.0) / slope(alpha, c);
        residue_ = 1.0 / (root_ * slope(alpha, c));
        double const pi = std::acos(-1.0), width = 0.2;
        // The integrand falls like r^alpha to the left and like r^(alpha - 4) to the right.
        for (double x = -36 / alpha; x < 12; x += width) {
            double const r = std::exp(x);
            std::complex<double> const q = r * r + c * pow(r, alpha) * std::polar(1.0, pi * alpha) + 1.0;
            double const weight = (1.0 / (r * q)).imag() / pi * r * width;
            if (r < 1e-19)
                constant_ += weight; // e^{-rt} = 1 for all t < 1000
            else
                terms_.push_back({r, weight});
        }
    }
    double operator()(double t) const {
        double sum = 1 + constant_ + 2 * (std::exp(root_ * t) * residue_).real();
        for (auto const& [rate, weight] : terms_) sum += weight * std::exp(-rate * t);
        return sum;
    }

private:
    struct term {
        double rate, weight;
    };
    [[nodiscard]] std::complex<double> slope(double alpha, double c) const { return 2.0 * root_ + c * alpha * std::pow(root_, alpha - 1); }
    std::complex<double> root_{-0.3, 1.0}, residue_;
    double constant_ = 0;
    std::vector<term> terms_;
};

} // namespace hilger::papers
