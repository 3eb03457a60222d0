// SPDX-License-Identifier: BSL-1.0
// Section 3 of A. C. Galucio, J.-F. Deue and F. Dubois (2008): the fractionally damped oscillator (3), stepped by the G^alpha- and the
// GL-Newmark scheme, and the norm (4) of their errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "../table.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/scale/uniform.hpp"
#include "oscillator_solution.hpp"

namespace hilger::papers {

/// (3) with m = k = tau = f = 1, by Newmark's method (5), (6); G is bdf<2> for the G^alpha-scheme, grunwald_letnikov for GL.
template <generating_function G, class S, class Beta = fraction<1, 4>>
auto oscillator(S const& alpha, S const& c, Beta beta = {}) {
    return newmark<G>(
        fractional_structure{S(1), c, S(1), S(1), alpha}, [](S const&) { return S(1); }, beta);
}
/// u(T) after so many steps from rest.
template <class Scheme, class S>
S last_position(Scheme const& scheme, S const& T, int steps) {
    S last(0);
    for (auto const& x : scheme.along(uniform(interval<S>{S(0), T}, steps), S(0), S(0))) last = x.q;
    return last;
}
/// The time that all computations of the paper end at.
inline constexpr double final_time = 15;
/// The meshes final_time / 2^m that are looked at. "7-9 meshes", with which the rates of tables 2 and 3 are computed, are m = 7, 8, 9 of
/// them: all twelve rates have their printed digits for these, and for no other range.
inline constexpr int coarsest_mesh = 3, finest_mesh = 12;
/// The norm (4) of the errors of the meshes T / 2^m, m = first ... last.
template <generating_function G>
std::vector<double> largest_errors(double alpha, double c, int first = coarsest_mesh, int last = finest_mesh, double T = final_time) {
    oscillator_solution const exact(alpha, c);
    std::vector<double> solution; // at the points of the finest mesh
    for (int j = 0; j <= 1 << last; ++j) solution.push_back(exact(T * j / (1 << last)));
    std::vector<double> errors;
    for (int m = first; m <= last; ++m) {
        double worst = 0;
        std::size_t const stride = std::size_t(1) << (last - m);
        std::size_t j = 0;
        for (auto const& x : oscillator<G>(alpha, c).along(uniform(interval<double>{0.0, T}, 1 << m), 0.0, 0.0)) {
            worst = std::max(worst, std::abs(x.q - solution[j]));
            j += stride;
        }
        errors.push_back(worst);
    }
    return errors;
}
/// Meshes m = first, ..., last.
struct mesh_range {
    int first, last;
    friend bool operator==(mesh_range, mesh_range) = default;
};
/// The slope through the errors of a range, errors[0] being that of coarsest_mesh.
inline double fitted_rate(std::vector<double> const& errors, mesh_range range) {
    return fitted_slope(
        std::vector<double>(errors.begin() + (range.first - coarsest_mesh), errors.begin() + (range.last - coarsest_mesh + 1)));
}
/// The ranges of three meshes or more, m = coarsest_mesh ... finest_mesh, for which the fitted rate of the errors of every row is the
/// printed one to its digits.
inline std::vector<mesh_range> ranges_with_rates(std::vector<std::vector<double>> const& errors, std::vector<std::string> const& printed) {
    std::vector<mesh_range> all;
    for (int first = coarsest_mesh; first <= finest_mesh; ++first)
        for (int last = first + 2; last <= finest_mesh; ++last) {
            std::size_t agree = 0;
            for (std::size_t row = 0; row < errors.size(); ++row)
                agree += std::abs(difference_in_units(fitted_rate(errors[row], {first, last}), printed[row])) <= 0.5 ? 1 : 0;
            if (agree == errors.size()) all.push_back({first, last});
        }
    return all;
}

} // namespace hilger::papers
