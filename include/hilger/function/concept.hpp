// SPDX-License-Identifier: BSL-1.0
// A discrete function f in C(T~, R^d) is anything with a domain (its family of points, in the type), a root (the scale T of that family)
// and a value at each point. The same operators act on functions that have values and on symbols that do not; a symbolic function has a
// domain and no root.
#pragma once

#include "hilger/scale/derived.hpp"

namespace hilger {

/// The nested name marks a type as a discrete function. Expressions declare it themselves and do not derive from the tag: two subobjects of
/// one empty class may not share an address, and Delta_o_plus[extend[q]] should be as small as q.
struct discrete_function_tag {
    using function_type = void;
};

/// Has a domain in its type; may be symbolic.
template <class F>
concept function_expression = requires {
    typename F::function_type;
    typename F::domain_type;
};

/// Has values too: get(i) is the value at the point with number i.
template <class F>
concept discrete_function = function_expression<F> and requires(F const& f) {
    typename F::root_type;
    f.root();
    f.domain();
    f.get(index_type{});
};

template <class F>
concept symbolic_function = function_expression<F> and not discrete_function<F>;

/// The type of a function's values.
template <class F>
using value_of = plain_t<decltype(std::declval<F const&>().get(0))>;

namespace detail {
/// How many components an Eigen type has by its type; -1 when dynamic, 0 for other values.
template <class V>
inline constexpr int fixed_size = 0;
template <class V>
    requires requires { V::SizeAtCompileTime; }
inline constexpr int fixed_size<V> = V::SizeAtCompileTime;
} // namespace detail

/// The value zero in the shape of f's values. @throws error::outside_domain when f has no value and vectors of dynamic size.
template <class F>
constexpr value_of<F> zero_of(F const& f) {
    using value = value_of<F>;
    auto const d = f.domain();
    if (d.size(f.root()) > 0) return zero_like(f.get(d.first(f.root())));
    if constexpr (std::constructible_from<value, int> and not requires { value::Zero(); })
        return value(0);
    else if constexpr (detail::fixed_size<value> > 0)
        return value(value::Zero());
    else
        error::raise<error::outside_domain>("a sum over no points of vectors has no dimension: the function lives on an empty scale");
}

template <class F>
using base_of = typename F::domain_type::base_type;

namespace detail {
template <class Domain>
constexpr auto takes_a_number() {
    return does_not_compile<"f[i] takes the number i of a point of " + Domain::name() + "; the value at t is f(t)">{};
}
} // namespace detail

/// Evaluation and iteration, common to all functions that have values. A function is a random-access range of its values.
template <class Derived>
class function_interface {
public:
    using function_type = void;

    /// The value at the point with number i: f[i] is f(t_i), or f(t_{i+1/2}) on T_half. @throws error::outside_domain
    [[nodiscard]] constexpr auto operator[](index_type i) const {
        scale().require(i);
        return element(i);
    }
    template <std::floating_point S>
    constexpr auto operator[](S) const {
        return detail::takes_a_number<typename Derived::domain_type>();
    }
    /// The value at t. @throws error::outside_domain when t is not a point of the function's scale.
    template <class S>
    [[nodiscard]] constexpr auto operator()(S const& t) const {
        return element(scale().number_of(t));
    }
    /// The scale the function lives on, as a view.
    [[nodiscard]] constexpr auto scale() const { return derived_scale(self().root(), self().domain()); }
    /// f[i], unchecked.
    [[nodiscard]] constexpr auto element(index_type i) const { return plain_t<decltype(self().get(i))>(self().get(i)); }
    [[nodiscard]] constexpr index_type first() const { return self().domain().first(self().root()); }
    [[nodiscard]] constexpr index_type last() const { return self().domain().last(self().root()); }
    [[nodiscard]] constexpr index_type size() const { return self().domain().size(self().root()); }
    [[nodiscard]] constexpr auto begin() const { return element_iterator<Derived>(self(), first()); }
    [[nodiscard]] constexpr auto end() const { return element_iterator<Derived>(self(), first() + size()); }

private:
    [[nodiscard]] constexpr Derived const& self() const { return static_cast<Derived const&>(*this); }
};

namespace detail {
/// Refers to a function for the length of one evaluation.
template <discrete_function F>
struct borrowed : discrete_function_tag {
    using domain_type = typename F::domain_type;
    using root_type = typename F::root_type;
    F const* f;
    constexpr explicit borrowed(F const& g) : f(&g) {}
    constexpr decltype(auto) root() const { return f->root(); }
    constexpr auto domain() const { return f->domain(); }
    constexpr auto get(index_type i) const { return f->get(i); }
};
} // namespace detail

} // namespace hilger
