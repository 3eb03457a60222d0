// SPDX-License-Identifier: BSL-1.0
// The value of an operator at one generic function (adjoint/normal_form.hpp), kept at run time, so that printing can compare it with many
// others, up to a rational factor.
#pragma once

#include <optional>
#include <vector>

#include "hilger/adjoint/normal_form.hpp"
#include "hilger/operator/fractional.hpp"

namespace hilger::detail {

/// p/q with small numbers.
struct small_ratio {
    long long numerator = 0, denominator = 1;
};
/// By Euclid's algorithm, stopped half-way: the quotient is the only one with both numbers below 10^4, if there is one. A random residue is
/// such a quotient with probability below 1e-10.
inline std::optional<small_ratio> ratio_of_residue(prime_field x) {
    constexpr std::int64_t small = 10'000;
    std::int64_t r0 = static_cast<std::int64_t>(prime_field::prime), r1 = static_cast<std::int64_t>(x.value()), s0 = 0, s1 = 1;
    while (r1 > small) {
        std::int64_t const quotient = r0 / r1, r = r0 - quotient * r1, s = s0 - quotient * s1;
        r0 = r1, s0 = s1;
        r1 = r, s1 = s;
    }
    if (s1 == 0 or s1 > small or s1 < -small) return std::nullopt;
    return s1 < 0 ? small_ratio{-r1, -s1} : small_ratio{r1, s1};
}

/// True when an operator works over a finite field: all of it is known at compile time, and it has no fractional power of the step.
template <class A>
inline constexpr bool is_algebraic = true;
template <class G, class Order, side Side, class W>
inline constexpr bool is_algebraic<fractional_difference<G, Order, Side, W>> = (weights_end<G, Order> > 0);
template <class C, class A>
inline constexpr bool is_algebraic<multiple<C, A>> = is_algebraic<A>;
template <class A, class B>
inline constexpr bool is_algebraic<composition<A, B>> = is_algebraic<A>and is_algebraic<B>;
template <class A, class B>
inline constexpr bool is_algebraic<operator_sum<A, B>> = is_algebraic<A>and is_algebraic<B>;
template <class A>
inline constexpr bool has_residues = known_by_type<A>and is_algebraic<A>;

/// The points that an operator acts on, with the lambda that it carries.
template <class A>
auto base_of_argument(A const& a) {
    using from = typename A::from;
    if constexpr (std::is_empty_v<from>)
        return from{};
    else if constexpr (requires { a.b; })
        return base_of_argument(a.b);
    else if constexpr (requires { a.a; })
        return base_of_argument(a.a);
    else if constexpr (requires { from{a.lambda}; })
        return from{a.lambda};
    else
        return from{};
}

/// A function on a scale of generic steps, given by its random values: one type for all, so that an operator is compiled once.
template <bool Uniform, class Base>
struct residues : discrete_function_tag {
    using root_type = generic_scale<Uniform, 16>;
    using domain_type = hilger::domain<Base>;
    Base base{};
    std::vector<prime_field> values{};

    explicit residues(Base b) : base(b), values(static_cast<std::size_t>(Base::last(16)) + 1) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = random_element(2 * i + 1'000'002);
    }
    static constexpr root_type root() { return {}; }
    [[nodiscard]] constexpr domain_type domain() const { return {base}; }
    [[nodiscard]] prime_field get(index_type i) const { return values[static_cast<std::size_t>(i)]; }
};
/// The domain of A[f].
template <class A>
auto image_of(A const& a) {
    return a.image(domain<typename A::from>{base_of_argument(a)});
}
/// The values of A[f].
template <bool Uniform, class A>
std::vector<prime_field> values_of(A const& a, residues<Uniform, typename A::from> const& f) {
    auto const image = image_of(a);
    std::vector<prime_field> values;
    for (index_type i = image.first(f.root()); i <= image.last(f.root()); ++i) values.push_back(a.evaluate(f, i));
    return values;
}

/// The values of A[f] for a generic f, and the number of points that A loses.
struct fingerprint {
    int front = 0, back = 0;
    std::vector<prime_field> values{};
};
template <bool Uniform, class A>
fingerprint fingerprint_of(A const& a) {
    using D = std::remove_cvref_t<decltype(image_of(a))>;
    return {D::front, D::back, values_of<Uniform>(a, residues<Uniform, typename A::from>(base_of_argument(a)))};
}
/// c with a = c b, when there is one.
inline std::optional<small_ratio> times(fingerprint const& a, fingerprint const& b) {
    if (a.front != b.front or a.back != b.back or a.values.size() != b.values.size()) return std::nullopt;
    prime_field const zero(0);
    std::size_t k = 0;
    while (k < b.values.size() and b.values[k] == zero) ++k;
    if (k == b.values.size()) return std::nullopt;
    prime_field const c = a.values[k] / b.values[k];
    for (k = 0; k < b.values.size(); ++k)
        if (not(a.values[k] == c * b.values[k])) return std::nullopt;
    auto const ratio = ratio_of_residue(c);
    return ratio and ratio->numerator == 0 ? std::nullopt : ratio;
}

} // namespace hilger::detail
