// SPDX-License-Identifier: BSL-1.0
// The piecewise polynomial through the values of a function on T/d, which has d - 1 points inside each step of T: on each step it is the
// polynomial of degree d through d + 1 values, continuous on T. Read at the nodes of a quadrature, its value and its derivative are two
// operators,
//   polynomial_value<d, Q, n>   (A f)_ik = sum_m l_m(c_k) f_im
//   polynomial_slope<d, Q, n>   (B f)_ik = 1/h_i sum_m l_m'(c_k) f_im
// with l_m the polynomial that is 1 at m/d and 0 at the other points. Their adjoints, between the sum over the nodes and the trapezoid rule
// of T/d, distribute the values at the nodes of a step over its points; at a point of T two steps add up.
#pragma once

#include "hilger/embedding/quadrature.hpp"

namespace hilger {

namespace detail {

/// l_m(c_k) and l_m'(c_k), in numbers S.
template <class S, int Degree, class Quadrature, int Count>
struct polynomial_table {
    std::array<std::array<S, static_cast<std::size_t>(Degree + 1)>, static_cast<std::size_t>(Count)> value{}, slope{};

    template <class W, class Nodes>
    [[gnu::noinline, gnu::cold]] static constexpr polynomial_table of(Nodes const& node) {
        polynomial_table t;
        for (int m = 0; m <= Degree; ++m) {
            W scale(1);
            for (int j = 0; j <= Degree; ++j)
                if (j != m) scale = scale * W(m - j);
            scale = W(1) / scale;
            for (std::size_t k = 0; k < Count; ++k) {
                W const c = W(Degree) * node[k]; // on 0, 1, ..., Degree
                W product(1), slope(0);
                for (int j = 0; j <= Degree; ++j) {
                    if (j == m) continue;
                    slope = slope * (c - W(j)) + product; // (x y)' = x' y + x y', a factor after the other
                    product = product * (c - W(j));
                }
                t.value[k][static_cast<std::size_t>(m)] = S(product * scale);
                t.slope[k][static_cast<std::size_t>(m)] = S(W(Degree) * slope * scale);
            }
        }
        return t;
    }
};
template <class S, int Degree, class Quadrature, int Count>
struct polynomial_numbers {
    using table = polynomial_table<S, Degree, Quadrature, Count>;
    static table const& here() {
        static table const numbers = table::template of<typename wider<S>::type>(wide_quadrature<S, Quadrature>(Count).node);
        return numbers;
    }
};
template <int Degree, class Quadrature, int Count>
struct polynomial_numbers<prime_field, Degree, Quadrature, Count> {
    using table = polynomial_table<prime_field, Degree, Quadrature, Count>;
    static constexpr table numbers = table::template of<prime_field>(residues_of_quadrature<Quadrature, Count>().node);
    static constexpr table const& here() { return numbers; }
};

/// The adjoint of a value or a slope.
template <int Degree, class Quadrature, int Count, bool IsSlope>
struct polynomial_spread;

template <int Degree, class Quadrature, int Count, bool IsSlope>
struct polynomial_reading : linear_operator<polynomial_reading<Degree, Quadrature, Count, IsSlope>> {
    static_assert(Degree >= 1, "a polynomial on a step passes through both ends: its degree is one or more");
    static_assert(Count >= 1, "a polynomial is read at one node of a step or more");
    using from = subdivided<Degree>;
    using to = quadrature_nodes<Quadrature, Count>;
    using from_weight = natural_weight_t<fraction<1, 2>>;
    using to_weight = step_weight;
    static constexpr int degree = Degree, count = Count;
    using quadrature = Quadrature;

    static constexpr reach reads{{}, reach::local(0.5, 0.5).between};
    static constexpr auto name() { return fixed_text("polynomial_") + (IsSlope ? "slope<" : "value<") + digits<Degree>() + ">"; }
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const&) const {
        return domain<to, Count*((F + Degree - 1) / Degree), Count*((B + Degree - 1) / Degree)>{};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type i) const {
        using S = typename F::root_type::scalar_type;
        using value = value_of<F>;
        auto const& numbers = polynomial_numbers<S, Degree, Quadrature, Count>::here();
        index_type const step = i / Count;
        auto const k = static_cast<std::size_t>(i % Count);
        value sum = zero_of(f);
        if constexpr (IsSlope) { // differences: the slope of constants is zero in spite of rounding
            value const first(f.get(Degree * step));
            for (int m = 1; m <= Degree; ++m)
                sum = value(sum + (value(f.get(Degree * step + m)) - first) * numbers.slope[k][static_cast<std::size_t>(m)]);
            return value(sum / S(f.root().step(step)));
        } else {
            for (int m = 0; m <= Degree; ++m)
                if (S const& c = numbers.value[k][static_cast<std::size_t>(m)]; not(c == S(0)))
                    sum = value(sum + value(f.get(Degree * step + m)) * c);
            return sum;
        }
    }
    constexpr auto adjoint() const { return polynomial_spread<Degree, Quadrature, Count, IsSlope>{}; }
};

template <int Degree, class Quadrature, int Count, bool IsSlope>
struct polynomial_spread : linear_operator<polynomial_spread<Degree, Quadrature, Count, IsSlope>> {
    using reading = polynomial_reading<Degree, Quadrature, Count, IsSlope>;
    using from = typename reading::to;
    using to = typename reading::from;
    using from_weight = step_weight;
    using to_weight = typename reading::from_weight;

    static constexpr reach reads = reach(reach::local(0.5, 0.5).on_T, reach::local(0, 0).between).template at<to>();
    static constexpr auto name() { return fixed_text("adjoint(") + reading::name() + ")"; }
    template <int F, int B>
    constexpr auto image(domain<from, F, B> const&) const {
        return domain<to, Degree*((F + Count - 1) / Count) + 1, Degree*((B + Count - 1) / Count) + 1>{};
    }
    template <class F>
    constexpr auto evaluate(F const& f, index_type j) const {
        using S = typename F::root_type::scalar_type;
        using value = value_of<F>;
        auto const& numbers = polynomial_numbers<S, Degree, Quadrature, Count>::here();
        auto const& weight = quadrature_numbers<S, Quadrature, Count>::here().weight;
        value sum = zero_of(f);
        auto const add = [&](index_type step, int m) {
            S const h(f.root().step(step));
            for (std::size_t k = 0; k < Count; ++k) {
                auto const at = static_cast<std::size_t>(m);
                S const c = IsSlope ? S(weight[k] * numbers.slope[k][at]) : S(h * (weight[k] * numbers.value[k][at]));
                sum = value(sum + value(f.get(Count * step + static_cast<index_type>(k))) * c);
            }
        };
        if (j % Degree == 0) add(j / Degree - 1, Degree);
        add(j / Degree, static_cast<int>(j % Degree));
        return value(sum / S(to_weight::at(f.root(), to{}, j)));
    }
    constexpr auto adjoint() const { return reading{}; }
};

} // namespace detail

template <int Degree, class Quadrature, int Count>
using polynomial_value = detail::polynomial_reading<Degree, Quadrature, Count, false>;
template <int Degree, class Quadrature, int Count>
using polynomial_slope = detail::polynomial_reading<Degree, Quadrature, Count, true>;

} // namespace hilger
