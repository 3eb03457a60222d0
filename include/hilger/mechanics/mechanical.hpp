// SPDX-License-Identifier: BSL-1.0
// Large systems whose structure is known: L(q, v) = v.Mv / 2 - U(q) with a constant mass M and a potential that is a sum of small terms.
// The sum says which second derivatives there are, so that a step of d = 1000 costs what its terms cost and no d x d matrix is filled.
//   mechanical{mass, chain{energy}}             neighbours in a row between two walls: a tridiagonal Hessian
//   mechanical{mass, pairs<3>{list, energy}}    bodies in space, two at a time
//   mechanical{mass, any generic U(q)}          a dense Hessian, by jets
// Mass is a number, a vector (one mass a component) or a symmetric positive definite matrix.
#pragma once

#include <utility>
#include <vector>

#include "hilger/mechanics/derivatives.hpp"

namespace hilger {

/// How the second derivatives of a potential are stored and solved with.
enum class hessian_pattern { dense, tridiagonal, sparse };

/// U(q) = sum_{k=0..d} energy(k, q_k - q_{k-1}) with q_{-1} = q_d = 0: d particles on a line, the walls at rest. energy(k, r) is generic in
/// r.
template <class Energy>
struct chain {
    [[no_unique_address]] Energy energy;

    explicit constexpr chain(Energy e) : energy(std::move(e)) {}

    template <class X>
    auto operator()(X const& q) const {
        index const d = q.size();
        auto sum = energy(index{0}, plain_t<decltype(q(0))>(q(0)));
        for (index k = 1; k < d; ++k) sum = sum + energy(k, plain_t<decltype(q(0))>(q(k) - q(k - 1)));
        return plain_t<decltype(sum)>(sum + energy(d, plain_t<decltype(q(0))>(-q(d - 1))));
    }
    [[nodiscard]] static hessian_pattern pattern(index) { return hessian_pattern::tridiagonal; }
    void check(index) const {}

    /// g = dU/dq; `tension` is room for d + 1 numbers.
    template <class V, class Room>
    void gradient(V const& q, V& g, Room& tension) const {
        using S = scalar_of<V>;
        index const d = q.size();
        tension(0) = slope<S>(0, q(0));
        for (index k = 1; k < d; ++k) tension(k) = slope<S>(k, q(k) - q(k - 1));
        tension(d) = slope<S>(d, -q(d - 1));
        for (index k = 0; k < d; ++k) g(k) = tension(k) - tension(k + 1);
    }
    /// put(j, k, x) for every entry j >= k of the Hessian, entries of one place adding up.
    template <class V, class Put>
    void hessian(V const& q, Put const& put) const {
        using S = scalar_of<V>;
        using J = jet<S, 0, 1, 2>;
        index const d = q.size();
        for (index k = 0; k <= d; ++k) {
            S const r = k == 0 ? S(q(0)) : k == d ? S(-q(d - 1)) : S(q(k) - q(k - 1));
            S const bend = detail::as_jet<J>(energy(k, J::variable(r, 0, {}))).template by<0, 0>();
            if (k < d) put(k, k, bend);
            if (k > 0) put(k - 1, k - 1, bend);
            if (k > 0 and k < d) put(k, k - 1, S(-bend));
        }
    }

private:
    template <class S>
    [[gnu::always_inline]] S slope(index k, S const& r) const {
        using J = jet<S, 0, 1, 1>;
        return detail::as_jet<J>(energy(k, J::variable(r, 0, {}))).template by<0>();
    }
};

/// U(q) = sum over pairs k = (a, b) of energy(k, q_a - q_b), bodies of Dimension components each: body a has components Dimension * a ...
/// Body -1 is a wall at the origin. energy(k, r) is generic in r: a number for Dimension 1, else an Eigen vector.
template <int Dimension, class Energy>
struct pair_potential {
    std::vector<std::pair<index, index>> list;
    [[no_unique_address]] Energy energy;

    template <class X>
    auto operator()(X const& q) const {
        using number = plain_t<decltype(q(0))>;
        using result = plain_t<decltype(energy(index{0}, between<number>(q, 0)))>;
        result sum(0);
        for (std::size_t k = 0; k < list.size(); ++k) sum = result(sum + energy(static_cast<index>(k), between<number>(q, k)));
        return sum;
    }
    [[nodiscard]] static hessian_pattern pattern(index d) { return d <= 64 ? hessian_pattern::dense : hessian_pattern::sparse; }
    /// @throws error::outside_domain when a pair names a body that the state does not have.
    void check(index d) const {
        for (auto const& [a, b] : list)
            if (a < -1 or b < -1 or a == b or Dimension * (std::max(a, b) + 1) > d)
                error::raise<error::outside_domain>("a pair takes two different bodies from -1 (the origin) to ", d / Dimension - 1,
                                                    ", and one is (", a, ", ", b, ")");
    }
    template <class V, class Room>
    void gradient(V const& q, V& g, Room&) const {
        if constexpr (std::is_floating_point_v<scalar_of<V>>)
            flat_gradient(q, g);
        else
            add_up(q, g);
    }
    template <class V, class Put>
    void hessian(V const& q, Put const& put) const {
        using S = scalar_of<V>;
        for (std::size_t k = 0; k < list.size(); ++k) {
            auto const e = term<2, S>(q, k);
            index const a = list[k].first, b = list[k].second;
            index const high = std::max(a, b), low = std::min(a, b);
            for_component([&]<int C>(std::integral_constant<int, C> c) {
                for_component([&]<int E>(std::integral_constant<int, E>) {
                    S const x = e.template by<std::max(c.value, E), std::min(c.value, E)>();
                    if (a >= 0 and c.value >= E) put(Dimension * a + c.value, Dimension * a + E, x);
                    if (b >= 0 and c.value >= E) put(Dimension * b + c.value, Dimension * b + E, x);
                    if (low >= 0) put(Dimension * high + c.value, Dimension * low + E, S(-x));
                });
            });
        }
    }

private:
    // Flattened for the processor's own numbers, as flat_jets_of is and for its reasons.
    template <class V>
    [[gnu::flatten]] void flat_gradient(V const& q, V& g) const {
        add_up(q, g);
    }
    template <class V>
    [[gnu::always_inline]] void add_up(V const& q, V& g) const {
        using S = scalar_of<V>;
        g.setZero();
        for (std::size_t k = 0; k < list.size(); ++k) {
            auto const e = term<1, S>(q, k);
            index const a = list[k].first, b = list[k].second;
            for_component([&]<int C>(std::integral_constant<int, C>) {
                S const f = e.template by<C>();
                if (a >= 0) g(Dimension * a + C) += f;
                if (b >= 0) g(Dimension * b + C) -= f;
            });
        }
    }
    template <class F>
    [[gnu::always_inline]] static void for_component(F const& f) {
        [&]<int... C>(std::integer_sequence<int, C...>) { (f(std::integral_constant<int, C>{}), ...); }
        (std::make_integer_sequence<int, Dimension>{});
    }
    template <class Number, class X>
    auto between(X const& q, std::size_t k) const {
        auto const at = [&](index body, int c) { return body < 0 ? Number(0) : Number(q(Dimension * body + c)); };
        index const a = list[k].first, b = list[k].second;
        if constexpr (Dimension == 1)
            return Number(at(a, 0) - at(b, 0));
        else {
            Eigen::Matrix<Number, Dimension, 1> r;
            for (int c = 0; c < Dimension; ++c) r(c) = at(a, c) - at(b, c);
            return r;
        }
    }
    template <int Order, class S, class V>
    [[gnu::always_inline]] auto term(V const& q, std::size_t k) const {
        using J = jet<S, 0, Dimension, Order>;
        auto const r = between<S>(q, k);
        if constexpr (Dimension == 1)
            return detail::as_jet<J>(energy(static_cast<index>(k), J::variable(r, 0, {})));
        else
            return spatial_term<J, S>(static_cast<index>(k), r);
    }
    template <class J, class S, class R>
    [[gnu::always_inline]] J spatial_term(index k, R const& r) const {
        if constexpr (std::is_floating_point_v<S>)
            return flat_spatial<J>(k, r, components{});
        else
            return spatial<J>(k, r, components{});
    }
    using components = std::make_integer_sequence<int, Dimension>;
    template <class J, class R, int... C>
    [[gnu::flatten]] J flat_spatial(index k, R const& r, std::integer_sequence<int, C...>) const {
        Eigen::Matrix<J, Dimension, 1> x;
        ((x(C) = J::variable(r(C), C, {})), ...);
        if constexpr (std::same_as<decltype(energy(k, x)), J>)
            return energy(k, x);
        else
            return detail::as_jet<J>(energy(k, x));
    }
    template <class J, class R, int... C>
    J spatial(index k, R const& r, std::integer_sequence<int, C...>) const {
        Eigen::Matrix<J, Dimension, 1> x;
        ((x(C) = J::variable(r(C), C, {})), ...);
        return detail::as_jet<J>(energy(k, x));
    }
};
template <int Dimension, class Energy>
auto pairs(std::vector<std::pair<index, index>> list, Energy energy) {
    return pair_potential<Dimension, Energy>{std::move(list), std::move(energy)};
}
/// Every two of n bodies.
inline std::vector<std::pair<index, index>> all_pairs(index n) {
    std::vector<std::pair<index, index>> list;
    for (index a = 0; a < n; ++a)
        for (index b = 0; b < a; ++b) list.emplace_back(a, b);
    return list;
}

namespace detail {
/// Any U(q).
template <class U>
struct dense_potential {
    [[no_unique_address]] U function;
    template <class X>
    auto operator()(X const& q) const {
        return function(q);
    }
    [[nodiscard]] static hessian_pattern pattern(index) { return hessian_pattern::dense; }
    void check(index) const {}
    template <class V, class Room>
    void gradient(V const& q, V& g, Room&) const {
        g = gradient_by(q, function);
    }
    template <class V, class Put>
    void hessian(V const& q, Put const& put) const {
        auto const e = hilger::expand([this](auto const& x, auto const&) { return function(x); }, q, q);
        for (index j = 0; j < q.size(); ++j)
            for (index k = 0; k <= j; ++k) put(j, k, e.qq(j, k));
    }
};
template <class U>
concept structured_potential = requires(U const& u) {
    { u.pattern(index{}) } -> std::same_as<hessian_pattern>;
};
} // namespace detail

/// L(q, v) = v.Mv / 2 - U(q).
template <class Mass, class Potential>
class mechanical {
    using wrapped = std::conditional_t<detail::structured_potential<Potential>, Potential, detail::dense_potential<Potential>>;

public:
    mechanical(Mass m, Potential u) : mass_(std::move(m)), potential_{std::move(u)} {
        bool positive = true;
        if constexpr (not is_matrix) {
            if constexpr (requires { mass_.minCoeff(); })
                positive = mass_.minCoeff() > typename Mass::Scalar(0);
            else
                positive = mass_ > Mass(0);
        }
        if (not positive) error::raise<error::singular>("a mass is positive, and one of these is not");
    }
    static constexpr bool is_matrix = requires { requires Mass::ColsAtCompileTime != 1; };

    /// In any number type, as every Lagrangian.
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        if constexpr (is_matrix)
            return v.dot(mass_ * v) / 2 - potential_(q);
        else if constexpr (requires { mass_.size(); })
            return v.dot(mass_.cwiseProduct(v)) / 2 - potential_(q);
        else
            return v.dot(v) * mass_ / 2 - potential_(q);
    }
    [[nodiscard]] Mass const& mass() const { return mass_; }
    [[nodiscard]] wrapped const& potential() const { return potential_; }

private:
    Mass mass_;
    wrapped potential_;
};

template <class F>
inline constexpr bool is_mechanical = false;
template <class M, class U>
inline constexpr bool is_mechanical<mechanical<M, U>> = true;

} // namespace hilger
