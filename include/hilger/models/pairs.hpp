// SPDX-License-Identifier: BSL-1.0
// A potential of bodies that interact in pairs.
//   pairs<3>(all_pairs(n), energy)                        every two of n bodies in space
//   pairs<1>({{0, 1}, {1, 2}, {2, -1}}, energy)           those of a list, on a line; body -1 is a wall at the origin
#pragma once

#include <iterator>
#include <utility>
#include <vector>

#include "hilger/differentiation/derivatives.hpp"
#include "hilger/differentiation/jet/vector.hpp"
#include "hilger/error.hpp"
#include "hilger/inlining.hpp"

namespace hilger {

/// The range of all pairs of n bodies: (1, 0), (2, 0), (2, 1), (3, 0), ...
class every_two {
public:
    class iterator {
    public:
        using value_type = std::pair<index_type, index_type>;
        using difference_type = index_type;
        constexpr iterator() = default;
        constexpr iterator(index_type a, index_type b) : a_(a), b_(b) {}
        constexpr value_type operator*() const { return {a_, b_}; }
        constexpr iterator& operator++() {
            if (++b_ == a_) {
                ++a_;
                b_ = 0;
            }
            return *this;
        }
        constexpr iterator operator++(int) {
            iterator const old = *this;
            ++*this;
            return old;
        }
        friend constexpr bool operator==(iterator const&, iterator const&) = default;

    private:
        index_type a_ = 1, b_ = 0;
    };
    constexpr explicit every_two(index_type bodies) : bodies_(bodies) {}
    [[nodiscard]] constexpr iterator begin() const { return {1, 0}; }
    [[nodiscard]] constexpr iterator end() const { return {std::max<index_type>(bodies_, 1), 0}; }

private:
    index_type bodies_;
};
/// All pairs of so many bodies. @throws error::invalid_parameter for a negative number
constexpr every_two all_pairs(index_type bodies) {
    if (bodies < 0) error::raise<error::invalid_parameter>("a number of bodies is not negative, and this one is ", bodies);
    return every_two(bodies);
}

/// U(q) = sum over pairs k = (a, b) of energy(k, q_a - q_b), bodies of Dimension components each: body a has components Dimension * a ...
/// Body -1 is a wall at the origin. energy(k, r) is generic in r: a number for Dimension 1, else an Eigen vector.
template <int Dimension, class List, class Energy>
struct pair_potential {
    List list; ///< a range of pairs
    [[no_unique_address]] Energy energy;

    /// U(q) of a vector q, in any number type. @throws as check
    template <class X>
    auto operator()(X const& q) const {
        using number = plain_t<decltype(q(0))>;
        using result = plain_t<decltype(energy(index_type{0}, between<number>(q, 0, 0)))>;
        check(q.size());
        result sum(0);
        index_type k = 0;
        for (auto const& [a, b] : list) sum = result(sum + energy(k++, between<number>(q, a, b)));
        return sum;
    }
    /// @throws error::mismatch if d is no multiple of Dimension; error::outside_domain if a pair names a body that the state does not have
    void check(index_type d) const {
        if (d % Dimension != 0)
            error::raise<error::mismatch>("bodies of ", Dimension, " components each make states of a multiple of ", Dimension,
                                          ", and this one has ", d);
        for (auto const& [a, b] : list)
            if (a < -1 or b < -1 or a == b or Dimension * (std::max(a, b) + 1) > d)
                error::raise<error::outside_domain>("a pair takes two different bodies from -1 (the origin) to ", d / Dimension - 1,
                                                    ", and one is (", a, ", ", b, ")");
    }
    /// g = dU/dq.
    template <class V, class Room>
    void gradient(V const& q, V& g, Room&) const {
        if constexpr (std::is_floating_point_v<scalar_of<V>>)
            flat_gradient(q, g);
        else
            add_up(q, g);
    }
    /// Calls put(j, k, x) for every entry j >= k of the Hessian; entries of one place add up.
    template <class V, class Put>
    void hessian(V const& q, Put const& put) const {
        using S = scalar_of<V>;
        index_type k = 0;
        for (auto const& [first, second] : list) {
            index_type const a = first, b = second, high = std::max(a, b), low = std::min(a, b);
            auto const e = term<2>(k++, between<S>(q, a, b));
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
    static constexpr bool has_walls = not std::same_as<List, every_two>;
    using components = std::make_integer_sequence<int, Dimension>;
    // In the sum over many pairs g++ 12 optimises Eigen's sums over components better than ours; clang++ needs ours.
#ifdef __clang__
    template <class J>
    using jets = detail::jet_vector<J, Dimension>;
#else
    template <class J>
    using jets = Eigen::Matrix<J, Dimension, 1>;
#endif
    template <class S>
    using vector = Eigen::Matrix<S, Dimension, 1>;

    // Flattened for built-in floating-point types, for the reasons of flat_jets_of.
    template <class V>
    HILGER_FLATTEN void flat_gradient(V const& q, V& g) const {
        add_up(q, g);
    }
    template <class V>
    HILGER_ALWAYS_INLINE void add_up(V const& q, V& g) const {
        using S = scalar_of<V>;
        g.setZero();
        index_type k = 0;
        for (auto const& [a, b] : list) {
            auto const f = by_component(term<1>(k++, between<S>(q, a, b)), components{});
            if (not has_walls or a >= 0) part(g, a) += f;
            if (not has_walls or b >= 0) part(g, b) -= f;
        }
    }
    /// The components of a body.
    template <class X>
    HILGER_ALWAYS_INLINE static auto part(X& q, index_type body) {
        return q.template segment<Dimension>(Dimension * body);
    }
    /// q_a - q_b, a number or a vector
    template <class Number, class X>
    HILGER_ALWAYS_INLINE static auto between(X const& q, index_type a, index_type b) {
        auto const difference = [&] {
            if (has_walls and b < 0) return vector<Number>(part(q, a));
            if (has_walls and a < 0) return vector<Number>(-part(q, b));
            return vector<Number>(part(q, a) - part(q, b));
        };
        if constexpr (Dimension == 1)
            return Number(difference()(0));
        else
            return difference();
    }
    template <class Jet, int... C>
    HILGER_ALWAYS_INLINE static auto by_component(Jet const& e, std::integer_sequence<int, C...>) {
        return vector<typename Jet::scalar_type>{e.template by<C>()...};
    }
    template <class F>
    HILGER_ALWAYS_INLINE static void for_component(F const& f) {
        [&]<int... C>(std::integer_sequence<int, C...>) { (f(std::integral_constant<int, C>{}), ...); }
        (components{});
    }
    template <int Order, class R>
    HILGER_ALWAYS_INLINE auto term(index_type k, R const& r) const {
        using S = scalar_of<R>;
        using J = jet<S, 0, Dimension, Order>;
        if constexpr (Dimension == 1)
            return detail::as_jet<J>(energy(k, J::variable(r, 0, {})));
        else if constexpr (std::is_floating_point_v<S>)
            return flat_spatial<J>(k, r, components{});
        else
            return spatial<J>(k, r, components{});
    }
    template <class J, class R, int... C>
    HILGER_FLATTEN J flat_spatial(index_type k, R const& r, std::integer_sequence<int, C...>) const {
        jets<J> x;
        ((x(C) = J::variable(r(C), C, {})), ...);
        if constexpr (std::same_as<decltype(energy(k, x)), J>)
            return energy(k, x);
        else
            return detail::as_jet<J>(energy(k, x));
    }
    template <class J, class R, int... C>
    J spatial(index_type k, R const& r, std::integer_sequence<int, C...>) const {
        Eigen::Matrix<J, Dimension, 1> x;
        ((x(C) = J::variable(r(C), C, {})), ...);
        return detail::as_jet<J>(energy(k, x));
    }
};
/// The pair_potential of a range of pairs, or of a list of them.
template <int Dimension, class List, class Energy>
auto pairs(List list, Energy energy) {
    return pair_potential<Dimension, List, Energy>{std::move(list), std::move(energy)};
}
template <int Dimension, class Energy>
auto pairs(std::vector<std::pair<index_type, index_type>> list, Energy energy) {
    return pair_potential<Dimension, std::vector<std::pair<index_type, index_type>>, Energy>{std::move(list), std::move(energy)};
}

} // namespace hilger
