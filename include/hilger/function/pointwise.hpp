// SPDX-License-Identifier: BSL-1.0
// Pointwise arithmetic and application, lazy. An expression owns its operands (copying a table is copying a pointer), so none
// dangles. It lives on the common points of its operands: Delta_o_plus[f] * g lives on T_o^+. Operands on different families
// (T and T_o) do not compile; operands on different scales of one type throw error::mismatch when they are combined.
#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "hilger/function/concept.hpp"

namespace hilger {

namespace detail {

template <class F, class G>
inline constexpr bool same_family =
    std::conjunction_v<std::is_same<base_of<F>, base_of<G>>, std::is_same<typename F::root_type, typename G::root_type>>;

struct a_sum {
    static constexpr auto name() { return fixed_text("a sum"); }
};
struct a_difference {
    static constexpr auto name() { return fixed_text("a difference"); }
};
struct a_product {
    static constexpr auto name() { return fixed_text("a product"); }
};
struct a_quotient {
    static constexpr auto name() { return fixed_text("a quotient"); }
};
struct a_euclidean_product {
    static constexpr auto name() { return fixed_text("a Euclidean product"); }
};
struct pointwise_application {
    static constexpr auto name() { return fixed_text("apply_pointwise"); }
};
template <class What, class Domain, class Other>
constexpr auto live_on_two() {
    return does_not_compile<What::name() + " needs both functions on one scale, and they live on " + Domain::name() + " and on " +
                            Other::name()>{};
}
template <class What, class Root, class Other>
constexpr auto live_on_two_kinds() {
    return does_not_compile<What::name() + " needs both functions on one scale, and one lives on " + Root::kind() + ", the other on " +
                            Other::kind() + " of another type">{};
}
/// The error for operands on two scales, as one sentence.
template <class What, class F, class G>
constexpr auto apart() {
    if constexpr (not std::same_as<base_of<F>, base_of<G>>)
        return live_on_two<What, typename F::domain_type, typename G::domain_type>();
    else
        return live_on_two_kinds<What, typename F::root_type, typename G::root_type>();
}

/// A template in the types of scales: those of functions are many more. @throws error::mismatch
template <class Root, class D, class E>
constexpr void require_same_points(Root const& root, D const& domain, Root const& other_root, E const& other) {
    if (not(domain.base == other.base) or not root.same_points(other_root))
        error::raise<error::mismatch>("functions combine on one scale, and these live on ", derived_scale(root, domain), " and on ",
                                      derived_scale(other_root, other));
}

template <class D>
constexpr D common_domain(D const& d) {
    return d;
}
template <class D, class E, class... Ds>
constexpr auto common_domain(D const& d, E const& e, Ds const&... rest) {
    return common_domain(intersect(d, e), rest...);
}

} // namespace detail

// Not in detail, where unqualified calls with a function would then look too.
template <std::size_t I, class F>
struct operand {
    [[no_unique_address]] F value;
};
/// A map and its operands, each of them in a base class with its number. std::tuple checks how each may be converted, assigned and
/// compared, which is most of the compile time of nested expressions.
template <class Indices, class Map, class F, class... Gs>
struct map_of_operands;
template <std::size_t... I, class Map, class F, class... Gs>
struct map_of_operands<std::index_sequence<0, I...>, Map, F, Gs...> : operand<0, F>, operand<I, Gs>... {
    using root_type = typename F::root_type;
    using domain_type =
        decltype(detail::common_domain(std::declval<typename F::domain_type>(), std::declval<typename Gs::domain_type>()...));
    [[no_unique_address]] Map map;

    [[nodiscard]] constexpr auto const& root() const { return operand<0, F>::value.root(); }
    [[nodiscard]] constexpr auto domain() const {
        return detail::common_domain(operand<0, F>::value.domain(), operand<I, Gs>::value.domain()...);
    }
    [[nodiscard]] constexpr auto get(index_type i) const {
        using raw = decltype(map(operand<0, F>::value.get(i), operand<I, Gs>::value.get(i)...));
        using value = value_on<raw, typename root_type::scalar_type>;
        return value(map(operand<0, F>::value.get(i), operand<I, Gs>::value.get(i)...));
    }
    constexpr void require_common_points() const {
        (detail::require_same_points(root(), operand<0, F>::value.domain(), operand<I, Gs>::value.root(), operand<I, Gs>::value.domain()),
         ...);
    }
};

/// map(f(t), g(t), ...) at each common point.
template <class Map, discrete_function F, discrete_function... Gs>
class pointwise : public function_interface<pointwise<Map, F, Gs...>>,
                  public map_of_operands<std::index_sequence_for<F, Gs...>, Map, F, Gs...> {
    using operands = map_of_operands<std::index_sequence_for<F, Gs...>, Map, F, Gs...>;

public:
    constexpr explicit pointwise(Map m, F f, Gs... gs) : operands{{std::move(f)}, {std::move(gs)}..., std::move(m)} {
        if constexpr (sizeof...(Gs) > 0) operands::require_common_points();
    }
};

namespace detail {
template <class What, class F, class G, class... Gs>
constexpr auto first_apart() {
    if constexpr (not same_family<F, G>)
        return apart<What, F, G>();
    else
        return first_apart<What, F, Gs...>();
}

/// An object and not a function template: std::apply is found by argument-dependent lookup as soon as a type with a standard allocator
/// is part of f, as in exact rationals, and would be taken for apply(map, f).
struct apply_to_values {
    template <class Map, discrete_function F, discrete_function... Gs>
    constexpr auto operator()(Map map, F f, Gs... gs) const {
        if constexpr ((same_family<F, Gs> and ...))
            return pointwise<Map, F, Gs...>(std::move(map), std::move(f), std::move(gs)...);
        else
            return first_apart<pointwise_application, F, Gs...>();
    }
};
} // namespace detail

/// map applied to the values of functions on one scale: apply_pointwise([](auto x) { return x * x; }, f). @throws error::mismatch
inline constexpr detail::apply_to_values apply_pointwise{};

namespace detail {
template <class Map, class What, class F, class G>
constexpr auto combined(F f, G g) {
    if constexpr (same_family<F, G>)
        return pointwise<Map, F, G>({}, std::move(f), std::move(g));
    else
        return apart<What, F, G>();
}
} // namespace detail

/// f + g, f - g, f g, f / g and -f at the common points. @throws error::mismatch when f and g live on different scales
template <discrete_function F, discrete_function G>
constexpr auto operator+(F f, G g) {
    return detail::combined<std::plus<>, detail::a_sum>(std::move(f), std::move(g));
}
template <discrete_function F, discrete_function G>
constexpr auto operator-(F f, G g) {
    return detail::combined<std::minus<>, detail::a_difference>(std::move(f), std::move(g));
}
template <discrete_function F, discrete_function G>
constexpr auto operator*(F f, G g) {
    return detail::combined<std::multiplies<>, detail::a_product>(std::move(f), std::move(g));
}
template <discrete_function F, discrete_function G>
constexpr auto operator/(F f, G g) {
    return detail::combined<std::divides<>, detail::a_quotient>(std::move(f), std::move(g));
}
template <discrete_function F>
constexpr auto operator-(F f) {
    return pointwise<std::negate<>, F>({}, std::move(f));
}
/// The Euclidean product at each point: f(t) . g(t).
template <discrete_function F, discrete_function G>
constexpr auto dot(F f, G g) {
    if constexpr (detail::same_family<F, G>)
        return apply_pointwise([](auto const& x, auto const& y) { return dot_product(x, y); }, std::move(f), std::move(g));
    else
        return detail::apart<detail::a_euclidean_product, F, G>();
}

/// A constant that multiplies: a number, or a fraction in the type.
template <class C, class S>
constexpr auto as_factor(C const& c) {
    if constexpr (requires { c.template as<S>(); })
        return c.template as<S>();
    else if constexpr (std::is_arithmetic_v<C>)
        return S(c);
    else
        return c;
}

template <class C>
concept factor = not function_expression<C> and not requires {
    typename C::operator_type;
};

/// c f, f c and f / c for a constant c.
template <factor C, discrete_function F>
constexpr auto operator*(C const& c, F f) {
    return apply_pointwise([k = as_factor<C, typename F::root_type::scalar_type>(c)](auto const& x) { return k * x; }, std::move(f));
}
template <discrete_function F, factor C>
constexpr auto operator*(F f, C const& c) {
    return apply_pointwise([k = as_factor<C, typename F::root_type::scalar_type>(c)](auto const& x) { return x * k; }, std::move(f));
}
template <discrete_function F, factor C>
constexpr auto operator/(F f, C const& c) {
    return apply_pointwise([k = as_factor<C, typename F::root_type::scalar_type>(c)](auto const& x) { return x / k; }, std::move(f));
}

} // namespace hilger
