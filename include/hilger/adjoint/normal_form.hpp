// SPDX-License-Identifier: BSL-1.0
// Equality of operators, decided at compile time. The normal form of a linear operator is its value at one generic function on one generic
// scale: values are fixed random elements of a field with 2^60 elements, and steps random squares there, so that they have roots.
// Operators that are equal have equal normal forms. Different ones differ by a non-zero rational function of values and steps, or of roots
// of steps for fractional powers, and a random point is a zero of it with probability below degree / 2^59 (Schwartz and Zippel): for a
// composition of ten operators, less than 1e-15.
//   A == B             on every scale
//   uniformly(A) == B  on every uniform scale
#pragma once

#include <array>

#include "hilger/adjoint/prime_field.hpp"
#include "hilger/function/function.hpp"
#include "hilger/operator/integral.hpp"

namespace hilger {

namespace detail {

constexpr prime_field random_element(std::uint64_t n) { // splitmix64
    std::uint64_t z = (n + 1) * 0x9e3779b97f4a7c15ULL;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return prime_field::residue((z ^ (z >> 31)) >> 3);
}

/// x^n.
constexpr prime_field field_power(prime_field x, int n) {
    if (n < 0) return prime_field(1) / field_power(x, -n);
    prime_field y(1);
    for (; n > 0; n /= 2, x = x * x)
        if (n % 2 == 1) y = y * x;
    return y;
}
/// The steps of generic scales are powers of other elements with an exponent that many numbers divide, so that they have roots, which
/// multiply as roots do. These powers are all squares: the exponent and prime - 1 have the common divisor 2.
inline constexpr int root_exponent = 27720;
template <bool Uniform>
constexpr prime_field root_of_step(index_type i) {
    return random_element(Uniform ? 1 : 2 * static_cast<std::uint64_t>(i) + 3);
}
template <bool Uniform, index_type Steps>
inline constexpr auto steps_with_roots = [] {
    std::array<prime_field, static_cast<std::size_t>(Steps + 2)> steps{}; // families between the points ask for one or two more
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = field_power(root_of_step<Uniform>(static_cast<index_type>(i)), root_exponent);
    return steps;
}();
template <int Q>
constexpr int exponent_of_root() {
    static_assert(root_exponent % Q == 0, "operators are compared for orders whose denominators divide 27720");
    return root_exponent / Q;
}

/// A scale without order whose steps are independent variables, or one variable when it is uniform.
template <bool Uniform, index_type Steps>
struct generic_scale {
    using scalar_type = prime_field;
    static constexpr bool is_uniform = Uniform;
    static constexpr index_type steps() { return Steps; }
    static constexpr prime_field step(index_type i) { return steps_with_roots<Uniform, Steps>[static_cast<std::size_t>(i)]; }
    /// omega(0)^alpha h^-alpha of the uniform scale. Roots of omega(0) are formal: they multiply as roots do, and whole powers are exact.
    template <class G, int P, int Q>
    static constexpr prime_field leading_factor(fraction<P, Q>) {
        constexpr int exponent = exponent_of_root<Q>() * P;
        constexpr prime_field base = G::template numerator<prime_field>()[0] / G::template denominator<prime_field>()[0];
        prime_field const leading = Q == 1                   ? field_power(base, P)
                                    : base == prime_field(1) ? base
                                                             : field_power(random_element(3) + base, exponent);
        return leading / field_power(root_of_step<true>(0), exponent);
    }
    /// The weight of point j in the value at k of the power P/Q of the difference with the graininess of W (operator/power.hpp).
    template <class W, int P, int Q>
        requires(not Uniform)
    static constexpr prime_field power_entry(fraction<P, Q>, index_type k, index_type j);
    static constexpr bool same_points(generic_scale) { return true; }
};

/// The entries of the power P/Q divided by w_j, by Opitz's divided differences of z^{P/Q} at z_m = 1/w_m: the same for both sides.
template <index_type Steps, class W, int P, int Q>
inline constexpr auto generic_power = [] {
    constexpr auto size = static_cast<std::size_t>(Steps + 1);
    std::array<std::array<prime_field, size>, size> entries{};
    std::array<prime_field, size> z{}, difference{}; // difference[i]: [z_i, ..., z_n]
    for (std::size_t n = 0; n < size; ++n) {
        auto const at = continued_weight<W>::step_number(generic_scale<false, Steps>{}, static_cast<index_type>(n));
        z[n] = prime_field(1) / generic_scale<false, Steps>::step(at);
        difference[n] = prime_field(1) / field_power(root_of_step<false>(at), exponent_of_root<Q>() * P);
        prime_field before(0), product = z[n];
        entries[n][n] = difference[n] * product;
        for (std::size_t i = n; i-- > 0;) {
            std::swap(before, difference[i]);
            // T continues with its first or last step: only there two neighbours are equal, and the difference is a derivative.
            difference[i] = z[i] == z[n] ? fraction<P, Q>::template as<prime_field>() * difference[n] / z[n]
                                         : (difference[i + 1] - before) / (z[n] - z[i]);
            product = -product * z[i];
            entries[n][i] = entries[i][n] = product * difference[i];
        }
    }
    return entries;
}();
template <bool Uniform, index_type Steps>
template <class W, int P, int Q>
    requires(not Uniform)
constexpr prime_field generic_scale<Uniform, Steps>::power_entry(fraction<P, Q>, index_type k, index_type j) {
    return generic_power<Steps, W, P, Q>[static_cast<std::size_t>(k)][static_cast<std::size_t>(j)] *
           step(continued_weight<W>::step_number(generic_scale{}, j));
}

template <bool Uniform, index_type Steps, class Base>
struct generic_function : discrete_function_tag {
    using root_type = generic_scale<Uniform, Steps>;
    using domain_type = hilger::domain<Base>;
    Base base{};
    static constexpr root_type root() { return {}; }
    constexpr domain_type domain() const { return {base}; }
    static constexpr prime_field get(index_type i) { return random_element(2 * static_cast<std::uint64_t>(i) + 1'000'002); }
};

/// Enough steps for both operators to have inner points and both ends.
template <class A>
consteval index_type steps_for() {
    using image = decltype(std::declval<A const&>().image(std::declval<domain<typename A::from>>()));
    return image::front + image::back + 5;
}

template <class A, bool Uniform, index_type Steps>
constexpr auto normal_form(A const& a) {
    constexpr generic_function<Uniform, Steps, typename A::from> f{};
    using image = decltype(a.image(f.domain()));
    constexpr auto size = static_cast<std::size_t>(image::size(f.root()));
    std::array<prime_field, size> values{};
    for (std::size_t k = 0; k < size; ++k) values[k] = a.evaluate(f, static_cast<index_type>(k) + image::front);
    return values;
}

template <bool Uniform, class A, class B>
constexpr bool equal(A const& a, B const& b) {
    if constexpr (std::same_as<typename A::from, typename B::from> and std::same_as<typename A::to, typename B::to>) {
        constexpr index_type n = std::max(steps_for<A>(), steps_for<B>());
        using image_a = decltype(a.image(domain<typename A::from>{}));
        using image_b = decltype(b.image(domain<typename B::from>{}));
        constexpr bool uniform = Uniform or A::needs_uniform or B::needs_uniform;
        if constexpr (std::same_as<image_a, image_b>) return normal_form<A, uniform, n>(a) == normal_form<B, uniform, n>(b);
    }
    return false;
}

} // namespace detail

/// An operator on uniform scales only, where more operators are equal: reweighting is the identity and step_mean a plain mean.
template <linear_map A>
struct on_uniform {
    A op;
};
/// A, to be compared on uniform scales: uniformly(A) == B.
template <linear_map A>
constexpr auto uniformly(A a) {
    return on_uniform<A>{std::move(a)};
}

/// An operator that can be compared: all of it is known at compile time.
template <class A>
concept comparable_operator = linear_map<A> and known_by_type<A>;

/// A f = B f for every function f on every scale, and A and B lose the same points at the ends.
template <comparable_operator A, comparable_operator B>
constexpr bool operator==(A const& a, B const& b) {
    return detail::equal<false>(a, b);
}
template <comparable_operator A, comparable_operator B>
constexpr bool operator==(on_uniform<A> const& a, B const& b) {
    return detail::equal<true>(a.op, b);
}
template <comparable_operator A, comparable_operator B>
constexpr bool operator==(on_uniform<A> const& a, on_uniform<B> const& b) {
    return detail::equal<true>(a.op, b.op);
}

} // namespace hilger
