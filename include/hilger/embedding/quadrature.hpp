// SPDX-License-Identifier: BSL-1.0
// Quadratures, and their nodes as a family of points: T_{G_n}, T_{L_n} have the n nodes of one in every step of T, and int f over them is
//   sum_i h_i sum_k w_k f(t_i + c_k h_i).
// Nodes that coincide, as the last one of a step and the first one of the next in Lobatto's, remain two: a function there may jump, as the
// derivative of a piecewise polynomial does. Nodes and weights are computed with more digits than the scalar has, so that results are
// rounded once.
//   quadrature_nodes<gauss, n>     Gauss, exact up to degree 2n - 1; one node is T_half
//   quadrature_nodes<lobatto, n>   Lobatto, both ends among them, exact up to degree 2n - 3
//   quadrature_nodes<radau, n>     Radau IIA, the end of the step among them, exact up to degree 2n - 2
// A user's quadrature has a name, `on_unit_interval<S>(n)`, a quadrature<S> or one in more digits, and is_symmetric, true for symmetric
// nodes.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "hilger/adjoint/normal_form.hpp"
#include "hilger/error.hpp"
#include "hilger/operator/double_double.hpp"

namespace hilger {

namespace detail {

/// P_0(x), ..., P_n(x), Legendre.
template <class W>
std::vector<W> legendre(int n, W const& x) {
    std::vector<W> p{W(1), x};
    for (int k = 2; k <= n; ++k) {
        auto const last = static_cast<std::size_t>(k - 1);
        p.push_back((W(2 * k - 1) * (x * p[last]) - W(k - 1) * p[last - 1]) / W(k));
    }
    return p;
}
/// P_n'(x) from P_n(x) and P_{n-1}(x), |x| < 1.
template <class W>
W legendre_slope(int n, W const& x, std::vector<W> const& p) {
    auto const last = static_cast<std::size_t>(n);
    return W(n) * (x * p[last] - p[last - 1]) / (x * x - W(1));
}
/// Newton's iteration from a start with two right digits: they double in every iteration, and 2^9 exceed any scalar. Step maps x to f(x) /
/// f'(x). @throws error::invalid_parameter where an exact scalar does not reach the root
template <class S, class Step>
typename wider<S>::type polished(double start, Step const& step) {
    using W = typename wider<S>::type;
    W x = W(S(start));
    if constexpr (std::numeric_limits<S>::is_exact) {
        for (int k = 0; k < 2; ++k) x = x - step(x);
        if (not(step(x) == W(0))) error::raise<error::invalid_parameter>("these nodes are irrational: take a scalar that is not exact");
    } else
        for (int k = 0; k < 8; ++k) x = x - step(x);
    return x;
}

} // namespace detail

/// Nodes and weights on [0, 1], the nodes increasing, the weights with the sum 1.
template <class W>
struct quadrature {
    std::vector<W> node, weight;
};

/// Gauss-Legendre quadrature, all nodes inside of the step.
struct gauss {
    static constexpr char const* name = "Gauss";
    static constexpr fixed_text letter{"G"};
    static constexpr bool is_symmetric = true;
    static constexpr int degree(int stages) { return stages; } ///< of the polynomials of galerkin<stages, gauss>
    static constexpr int exact_up_to(int n) { return 2 * n - 1; }
    /// n nodes, exact up to degree 2n - 1, for numbers S.
    template <class S>
    static auto on_unit_interval(int n) {
        using W = typename detail::wider<S>::type;
        quadrature<W> q;
        for (int i = 0; i < n; ++i) {
            W const x = detail::polished<S>(-std::cos(3.14159265358979 * (i + 0.75) / (n + 0.5)), [n](W const& y) {
                auto const p = detail::legendre(n, y);
                return W(p[static_cast<std::size_t>(n)] / detail::legendre_slope(n, y, p));
            });
            W const d = detail::legendre_slope(n, x, detail::legendre(n, x));
            q.node.push_back((W(1) + x) / W(2));
            q.weight.push_back(W(1) / ((W(1) - x * x) * (d * d)));
        }
        return q;
    }
};

/// Lobatto quadrature, with nodes at both ends of the step.
struct lobatto {
    static constexpr char const* name = "Lobatto";
    static constexpr fixed_text letter{"L"};
    static constexpr bool is_symmetric = true;
    static constexpr int degree(int stages) { return stages - 1; }
    static constexpr int exact_up_to(int n) { return 2 * n - 3; }
    /// n >= 2 nodes, both ends among them, exact up to degree 2n - 3, for numbers S.
    template <class S>
    static auto on_unit_interval(int n) {
        using W = typename detail::wider<S>::type;
        quadrature<W> q;
        int const m = n - 1;
        for (int i = 0; i < n; ++i) {
            // The inner nodes are the roots of P_m'; (1 - x^2) P_m'' = 2 x P_m' - m (m + 1) P_m.
            W x(i == 0 ? -1 : 1);
            if (i > 0 and i < m)
                x = detail::polished<S>(-std::cos(3.14159265358979 * i / m), [m](W const& y) {
                    auto const p = detail::legendre(m, y);
                    W const first = detail::legendre_slope(m, y, p);
                    W const second = (W(2) * (y * first) - W(m * (m + 1)) * p[static_cast<std::size_t>(m)]) / (W(1) - y * y);
                    return W(first / second);
                });
            W const p = detail::legendre(m, x)[static_cast<std::size_t>(m)];
            q.node.push_back((W(1) + x) / W(2));
            q.weight.push_back(W(1) / (W(n * m) * (p * p)));
        }
        return q;
    }
};

/// Radau quadrature, with a node at the end of the step: that of the Radau IIA methods.
struct radau {
    static constexpr char const* name = "Radau";
    static constexpr fixed_text letter{"R"};
    static constexpr bool is_symmetric = false;
    static constexpr int degree(int stages) { return stages; }
    static constexpr int exact_up_to(int n) { return 2 * n - 2; }
    /// n nodes, the last one 1, exact up to degree 2n - 2, for numbers S.
    template <class S>
    static auto on_unit_interval(int n) {
        using W = typename detail::wider<S>::type;
        quadrature<W> q;
        auto const last = static_cast<std::size_t>(n);
        for (int i = 0; i < n; ++i) {
            // The inner nodes are the roots of f = (P_n - P_{n-1}) / (x - 1), and (x - 1) f' = P_n' - P_{n-1}' - f.
            W x(1);
            if (i + 1 < n)
                x = detail::polished<S>(std::cos(3.14159265358979 * (n - i - 0.75) / n), [n, last](W const& y) {
                    auto const p = detail::legendre(n, y);
                    W const f = (p[last] - p[last - 1]) / (y - W(1));
                    W const slope = (detail::legendre_slope(n, y, p) - detail::legendre_slope(n - 1, y, p) - f) / (y - W(1));
                    return W(f / slope);
                });
            W const p = detail::legendre(n, x)[last - 1];
            q.node.push_back((W(1) + x) / W(2));
            q.weight.push_back((W(1) + x) / (W(2 * n * n) * (p * p)));
        }
        return q;
    }
};

namespace detail {

/// A quadrature of this file.
template <class Quadrature>
concept known_quadrature = std::same_as<Quadrature, gauss> or std::same_as<Quadrature, lobatto> or std::same_as<Quadrature, radau>;

/// Nodes and weights of a quadrature as residues: rational ones exactly, irrational ones as generic elements, which suffices: an identity
/// for any numbers holds for these.
template <class Quadrature, int Count>
constexpr auto residues_of_quadrature() {
    struct {
        std::array<prime_field, static_cast<std::size_t>(Count)> node{}, weight{};
    } q;
    if constexpr (std::same_as<Quadrature, gauss> and Count == 1) {
        q.node[0] = prime_field(1) / prime_field(2);
        q.weight[0] = prime_field(1);
    } else if constexpr (std::same_as<Quadrature, lobatto> and Count <= 3) {
        for (int k = 0; k < Count; ++k) {
            q.node[static_cast<std::size_t>(k)] = prime_field(k) / prime_field(Count - 1);
            q.weight[static_cast<std::size_t>(k)] =
                k == 1 and Count == 3 ? prime_field(2) / prime_field(3) : prime_field(1) / prime_field(Count == 2 ? 2 : 6);
        }
    } else if constexpr (std::same_as<Quadrature, radau> and Count <= 2) {
        for (int k = 0; k < Count; ++k) { // 1; 1/3 and 1
            bool const inner = k + 1 < Count;
            q.node[static_cast<std::size_t>(k)] = prime_field(1) / prime_field(inner ? 3 : 1);
            q.weight[static_cast<std::size_t>(k)] = prime_field(inner ? 3 : 1) / prime_field(Count == 1 ? 1 : 4);
        }
    } else {
        std::uint64_t letter = 0;
        for (char const* c = Quadrature::name; *c != '\0'; ++c) letter = 31 * letter + static_cast<std::uint64_t>(*c);
        prime_field rest(1);
        for (int k = 0; k < Count; ++k) {
            std::uint64_t const name = (letter * 64 + Count) * 64 + static_cast<std::uint64_t>(2 * k);
            q.node[static_cast<std::size_t>(k)] = random_element(name);
            q.weight[static_cast<std::size_t>(k)] = k + 1 < Count ? random_element(name + 1) : rest;
            rest = rest - q.weight[static_cast<std::size_t>(k)];
        }
    }
    return q;
}

/// The n nodes and weights in wider<S> numbers. @throws error::mismatch where the quadrature gives another number of them
template <class S, class Quadrature>
auto wide_quadrature(int n) {
    using W = typename wider<S>::type;
    auto const given = Quadrature::template on_unit_interval<S>(n);
    if (given.node.size() != static_cast<std::size_t>(n) or given.weight.size() != given.node.size())
        error::raise<error::mismatch>("the quadrature ", Quadrature::name, " was asked for ", n, " nodes and weights, and gives ",
                                      given.node.size(), " and ", given.weight.size());
    quadrature<W> wide;
    for (auto const& c : given.node) wide.node.push_back(W(c));
    for (auto const& w : given.weight) wide.weight.push_back(W(w));
    return wide;
}

/// c_1, ..., c_n and w_1, ..., w_n in numbers S.
template <class S, class Quadrature, int Count>
struct quadrature_numbers {
    std::array<S, static_cast<std::size_t>(Count)> node{}, weight{};
    static quadrature_numbers const& here() {
        static quadrature_numbers const numbers = [] {
            auto const wide = wide_quadrature<S, Quadrature>(Count);
            quadrature_numbers q;
            for (std::size_t k = 0; k < Count; ++k) {
                q.node[k] = S(wide.node[k]);
                q.weight[k] = S(wide.weight[k]);
            }
            return q;
        }();
        return numbers;
    }
};
template <class Quadrature, int Count>
struct quadrature_numbers<prime_field, Quadrature, Count> {
    static constexpr auto numbers = residues_of_quadrature<Quadrature, Count>();
    static constexpr auto const& here() { return numbers; }
};

/// The family of all nodes: number n i + k is node k of step i.
template <class Quadrature, int Count>
struct nodes_of_quadrature {
    static constexpr auto name() {
        if constexpr (requires { Quadrature::letter; })
            return "T_" + Quadrature::letter + digits<Count>();
        else
            return fixed_text("T_Q") + digits<Count>();
    }
    /// The subscript of T in print.
    static constexpr auto foot() {
        if constexpr (requires { Quadrature::letter; })
            return "_" + Quadrature::letter + digits<Count>();
        else
            return fixed_text("_Q") + digits<Count>();
    }
    static constexpr index_type last(index_type steps) { return Count * steps - 1; }
    template <class Root>
    constexpr auto point(Root const& T, index_type i) const {
        using S = typename Root::scalar_type;
        auto const& c = quadrature_numbers<S, Quadrature, Count>::here().node[static_cast<std::size_t>(i % Count)];
        return c == S(1) ? S(T.point(i / Count + 1)) : S(T.point(i / Count) + c * T.step(i / Count));
    }
    /// From a node to the next, 0 where they coincide.
    template <class Root>
    constexpr auto step(Root const& T, index_type i) const {
        using S = typename Root::scalar_type;
        auto const& q = quadrature_numbers<S, Quadrature, Count>::here();
        std::size_t const k = static_cast<std::size_t>(i % Count);
        if (k + 1 < Count) return S((q.node[k + 1] - q.node[k]) * T.step(i / Count));
        return S((S(1) - q.node[k]) * T.step(i / Count) + q.node[0] * T.step(i / Count + 1));
    }
    /// The weight of a node in the integral.
    template <class Root>
    constexpr auto weight(Root const& T, index_type i) const {
        using S = typename Root::scalar_type;
        return S(quadrature_numbers<S, Quadrature, Count>::here().weight[static_cast<std::size_t>(i % Count)] * T.step(i / Count));
    }
    friend constexpr bool operator==(nodes_of_quadrature, nodes_of_quadrature) = default;
};
template <class Quadrature, int Count>
struct family_of_quadrature {
    using type = nodes_of_quadrature<Quadrature, Count>;
};
template <>
struct family_of_quadrature<gauss, 1> {
    using type = between<fraction<1, 2>>;
};

} // namespace detail

/// The family of the n nodes of a quadrature in every step.
template <class Quadrature, int Count>
using quadrature_nodes = typename detail::family_of_quadrature<Quadrature, Count>::type;
/// The nodes of T as a scale, to integrate over: integral(f, at_nodes<gauss, 3>(T)).
template <class Quadrature, int Count, time_scale_like Scale>
constexpr auto at_nodes(Scale const& T) {
    detail::require_nodes<typename Scale::domain_type>();
    return detail::derive(T, domain<quadrature_nodes<Quadrature, Count>>{});
}

} // namespace hilger
