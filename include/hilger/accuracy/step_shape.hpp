// SPDX-License-Identifier: BSL-1.0
// What a Galerkin step of degree s shows of its error. The coefficients c_k of its positions in Legendre polynomials fall like rho^k, and
// at its end the step errs by about rho^s times the last of them: rho is measured on the last four, as Jorba and Zou (2005) measure the
// radius of convergence of a Taylor series. Over a kink or a jump rho is near 1, and what remains is the last coefficient itself.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "hilger/embedding/quadrature.hpp"
#include "hilger/shape.hpp"

namespace hilger::detail {

/// Of the polynomial through 0 and values at the parts m / s of a step, m = 1, ..., s: its coefficients of degrees s - 3 to s, and h^2
/// times its second derivative at the start and at the end.
template <class S, int Degree>
struct numbers_of_polynomial {
    static_assert(Degree >= 4, "the decay of the coefficients is measured on four of them");
    std::array<std::array<S, static_cast<std::size_t>(Degree)>, 6> row;
    /// h^2 times the second derivative of the last Legendre polynomial at the end.
    static constexpr int last_bend = (Degree - 1) * Degree * (Degree + 1) * (Degree + 2) / 2;
    static numbers_of_polynomial const& here() {
        static numbers_of_polynomial const table;
        return table;
    }

private:
    [[gnu::noinline, gnu::cold]] numbers_of_polynomial() {
        Eigen::Matrix<S, Degree + 1, Degree + 1> values;
        for (int m = 0; m <= Degree; ++m) {
            auto const P = legendre(Degree, S(S(2 * m) / S(Degree) - S(1)));
            for (int k = 0; k <= Degree; ++k) values(m, k) = P[static_cast<std::size_t>(k)];
        }
        auto const coefficient = values.partialPivLu().inverse().eval();
        for (int m = 1; m <= Degree; ++m) {
            auto const at = [&](int j) -> S& { return row[static_cast<std::size_t>(j)][static_cast<std::size_t>(m - 1)]; };
            for (int j = 0; j < 4; ++j) at(j) = coefficient(Degree - 3 + j, m);
            at(4) = at(5) = S(0);
            for (int k = 2; k <= Degree; ++k) {
                S const bend = S((k - 1) * k * (k + 1) * (k + 2) / 2) * coefficient(k, m); // P_k''(1) = (k - 1) k (k + 1) (k + 2) / 8
                at(4) = k % 2 == 0 ? S(at(4) + bend) : S(at(4) - bend);
                at(5) = at(5) + bend;
            }
        }
    }
};

/// The length of a step and the numbers of the polynomial of its positions.
template <int Degree, class S, class V>
struct step_shape {
    using s = shape<V>;
    using numbers = numbers_of_polynomial<S, Degree>;
    S h;
    S floor; ///< below it coefficients are rounding
    std::array<V, 6> of;

    /// Of a step of length h, with inside(m) its positions at the parts m / s less the first one, and with this rounding of the positions,
    /// if it is more than that of displacements.
    template <class Inside>
    step_shape(Inside const& inside, V const& like, S const& length, S const& noise) : h(length), floor(noise) {
        auto const& table = numbers::here();
        of.fill(zero_like(like));
        for (int m = 1; m <= Degree; ++m) {
            V const value = inside(m);
            floor = std::max(floor, S(S(64) * epsilon<S>() * magnitude(value)));
            for (std::size_t j = 0; j < of.size(); ++j) of[j] = of[j] + value * table.row[j][static_cast<std::size_t>(m - 1)];
        }
    }
    /// The larger of two coefficients, component c.
    [[nodiscard]] S larger_of(std::size_t j, int c) const {
        return std::max(S(magnitude(s::component(of[j], c))), S(magnitude(s::component(of[j + 1], c))));
    }
    [[nodiscard]] S tail() const {
        S most(0);
        for (int c = 0; c < s::dimension(of[0]); ++c) most = std::max(most, larger_of(2, c));
        return most;
    }
    /// The error of a step, as h times that of a velocity. Coefficients of the size of rounding say nothing.
    [[nodiscard]] S error() const {
        S worst(0);
        for (int c = 0; c < s::dimension(of[0]); ++c) {
            S const before = larger_of(0, c), end = larger_of(2, c);
            if (end <= floor) continue;
            double const fall = static_cast<double>(S(end / before));                                    // rho^2
            worst = std::max(worst, fall < 0.125 ? S(end * S(std::pow(fall, Degree / 2))) : S(8) * end); // of a jump the nodes see a part
        }
        return S(4 * Degree - 2) * worst;
    }
    /// Whether the last coefficients hardly fall, as over a kink.
    [[nodiscard]] bool is_rough() const {
        for (int c = 0; c < s::dimension(of[0]); ++c)
            if (floor < larger_of(2, c) and larger_of(0, c) <= S(8) * larger_of(2, c)) return true;
        return false;
    }
    /// The same of what jumps between the last node of one step and the first of the next, which neither sees: from their second
    /// derivatives at the point between them.
    static S hidden_between(step_shape const& x, step_shape const& y) {
        S worst(0);
        S const longer = std::max(x.h, y.h), part = y.h / longer;
        for (int c = 0; c < s::dimension(x.of[0]); ++c) {
            auto const bend = [&](step_shape const& z, std::size_t j) {
                return S(s::component(z.of[j], c) * ((longer / z.h) * (longer / z.h)));
            };
            auto const noise = [&](step_shape const& z) {
                return S(S(2 * numbers::last_bend) * (z.larger_of(2, c) + z.floor) * ((longer / z.h) * (longer / z.h)));
            };
            S const jump = magnitude(S(bend(y, 4) - bend(x, 5)));
            if (noise(x) + noise(y) < jump) worst = std::max(worst, jump);
        }
        return worst * part * (S(3) / S(Degree * Degree)); // twice the distance from the last node to the end
    }
};

/// Velocities may have more rounding than the displacement shows, where a small mass moves with a large one. It is seen where the last
/// coefficients are small and fall like the step alone, in three steps that are refused one after the other.
template <class S>
struct noise_of_velocity {
    S level{0}, before{-1}, earlier{-1};
    S first{0}, wasted{0}; ///< the first length that was refused; that length where the refusals were for nothing
    template <class Shape>
    bool is_seen(Shape const& shape, bool is_shortest) {
        S const now = shape.tail() / shape.h;
        bool const seen = (is_shortest or (earlier >= S(0) and earlier < S(2) * now)) and shape.tail() < S(1 << 14) * shape.floor;
        if (before < S(0)) first = shape.h;
        earlier = std::exchange(before, now);
        if (seen) {
            level = std::max(level, S(S(4) * now));
            wasted = first;
        }
        return seen;
    }
    /// @returns the least length of the next step
    S step_is_taken() {
        before = earlier = S(-1);
        level = level * S(3) / S(4);
        return std::exchange(wasted, S(0));
    }
};

} // namespace hilger::detail
