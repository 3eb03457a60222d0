// SPDX-License-Identifier: BSL-1.0
// A linear operator maps functions on one family of points to functions on another. Its type knows both (from, to), how many
// points it loses at each end (image), the weighted sums in which it has its adjoint, and that adjoint. Brackets act:
// Delta_plus[f] is the function, lazy; Delta_minus[Delta_plus] and Delta_minus * Delta_plus are the composition.
//
// Minimal definition of an operator A, derived from linear_operator<A>:
//   using from, to                  families of points: nodes, between<lambda>, joined<lambda>
//   using from_weight, to_weight    the weights of the two sums between which adjoint() is the adjoint
//   image(domain)                   where A[f] lives when f lives on domain
//   evaluate(f, i)                  the value of A[f] at point i
//   adjoint()                       the operator with <A f, g> = <f, adjoint(A) g> up to the end points
//   name()                          its C++ name, as text
//   reads                           its reach (operator/reach.hpp); without it the operator counts as one that reads everything
#pragma once

#include "hilger/function/concept.hpp"
#include "hilger/operator/reach.hpp"

namespace hilger {

template <class A, class B>
struct composition;

template <class A>
concept linear_map = requires {
    typename A::operator_type;
    typename A::from;
    typename A::to;
};

template <class A, class F>
concept acts_on = linear_map<A> and function_expression<F> and requires {
    requires std::same_as < base_of<F>,
    typename A::from > ;
};

template <class A, class B>
concept composes_with = linear_map<A> and linear_map<B> and std::same_as<typename A::from, typename B::to>;

namespace detail {
/// A forms each value from the one before: all of them cost as much as the last.
template <class A, class F, class Use>
concept in_order = requires(A const& a, F const& f, Use const& use) {
    a.evaluate_all(f, use);
};
} // namespace detail

/// A[f], evaluated at each access.
template <linear_map A, function_expression F>
struct applied {
    using function_type = void;
    using domain_type = decltype(std::declval<A const&>().image(std::declval<typename F::domain_type>()));
    [[no_unique_address]] A op;
    [[no_unique_address]] F f;

    constexpr applied(A a, F g) : op(std::move(a)), f(std::move(g)) {}
};

template <linear_map A, discrete_function F>
struct applied<A, F> : function_interface<applied<A, F>> {
    using domain_type = decltype(std::declval<A const&>().image(std::declval<typename F::domain_type>()));
    using root_type = typename F::root_type;
    [[no_unique_address]] A op;
    [[no_unique_address]] F f;

    constexpr applied(A a, F g) : op(std::move(a)), f(std::move(g)) {}
    [[nodiscard]] constexpr decltype(auto) root() const { return f.root(); }
    [[nodiscard]] constexpr auto domain() const { return op.image(f.domain()); }
    [[nodiscard]] constexpr auto get(index_type i) const {
        using value = plain_t<decltype(op.evaluate(f, i))>;
        return value(op.evaluate(f, i));
    }
    template <class Use>
    constexpr void for_each_value(Use const& use) const requires detail::in_order<A, F, Use> {
        op.evaluate_all(f, use);
    }
};

template <class A, class F>
applied(A, F) -> applied<A, F>;

namespace detail {

// Separate functions, so that a message names these types and not their derivation.
template <class A, class From, class Domain>
constexpr auto acts_elsewhere() {
    return does_not_compile<A::name() + " acts on functions on " + From::name() + ", and this one lives on " + Domain::name()>{};
}
template <class A, class Root>
constexpr auto needs_one_step() {
    return does_not_compile<A::name() + " has the weights of one step h, and this function lives on " + Root::kind()>{};
}

} // namespace detail

/// The base of every operator: application and composition by brackets. The nested name marks an operator; a common base class would give
/// compositions of empty operators a size.
template <class A>
struct linear_operator {
    using operator_type = void;
    static constexpr bool needs_uniform = false; ///< acts on functions on uniform scales only
    static constexpr reach reads = reach::everywhere();

    template <function_expression F>
    constexpr auto operator[](F f) const {
        if constexpr (not acts_on<A, F>)
            return detail::acts_elsewhere<A, typename A::from, typename F::domain_type>();
        else if constexpr (lacks_uniform<F>())
            return detail::needs_one_step<A, typename F::root_type>();
        else
            return applied<A, F>(self(), std::move(f));
    }
    template <linear_map B>
    constexpr auto operator[](B b) const {
        return self() * std::move(b);
    }

private:
    [[nodiscard]] constexpr A const& self() const { return static_cast<A const&>(*this); }
    template <class F>
    static consteval bool lacks_uniform() {
        if constexpr (discrete_function<F> and A::needs_uniform)
            return not F::root_type::is_uniform;
        else
            return false;
    }
};

} // namespace hilger
