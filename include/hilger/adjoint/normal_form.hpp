// SPDX-License-Identifier: BSL-1.0
// Equality of operators, decided at compile time. The normal form of a linear operator is its value at one generic function on one generic
// scale: steps and values are fixed random elements of a field with 2^60 elements. Operators that are equal have equal normal forms.
// Different ones differ by a non-zero rational function of the steps and values, and a random point is a zero of it with probability below
// degree / 2^60 (Schwartz and Zippel): for a composition of ten operators, less than 1e-15.
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

/// A scale without order whose steps are independent variables, or one variable when it is uniform.
template <bool Uniform, index_type Steps>
struct generic_scale {
    using scalar_type = prime_field;
    static constexpr bool is_uniform = Uniform;
    static constexpr index_type steps() { return Steps; }
    static constexpr prime_field step(index_type i) {
        return Uniform ? power(root_of_step, whole) : random_element(2 * static_cast<std::uint64_t>(i) + 3);
    }
    /// omega(0)^alpha h^-alpha. The step h of the uniform scale is a power of another element, so that it has roots; roots of omega(0) are
    /// formal: they multiply as roots do, and whole powers are exact.
    template <class G, int P, int Q>
    static constexpr prime_field leading_factor(fraction<P, Q>) {
        static_assert(whole % Q == 0, "operators are compared for orders whose denominators divide 27720");
        constexpr prime_field base = G::template numerator<prime_field>()[0] / G::template denominator<prime_field>()[0];
        prime_field const leading = Q == 1                   ? power(base, P)
                                    : base == prime_field(1) ? base
                                                             : power(random_element(3) + base, static_cast<std::uint64_t>(whole / Q * P));
        return leading / power(root_of_step, static_cast<std::uint64_t>(whole / Q * P));
    }
    static constexpr bool same_points(generic_scale) { return true; }

private:
    static constexpr int whole = 27720;
    static constexpr prime_field root_of_step = random_element(1);
    static constexpr prime_field power(prime_field x, std::uint64_t n) {
        prime_field y(1);
        for (; n > 0; n /= 2, x = x * x)
            if (n % 2 == 1) y = y * x;
        return y;
    }
};

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
