// SPDX-License-Identifier: BSL-1.0
// Integration by parts, for any operator: <A f, g> = <f, adjoint(A) g> + boundary_form(A, f, g), where <.,.> are the sums with the
// operator's own weights. The adjoint is an operator again, on the inner points; the terms of the end points are the boundary form, never
// dropped. Cresson-Safi (9), lemma 2, lemma 3 and every user's formula are instances.
#pragma once

#include "hilger/adjoint/normal_form.hpp"
#include "hilger/operator/fractional.hpp"

namespace hilger {

/// The operator with <A f, g> = <f, adjoint(A) g> for all f that vanish at the end points.
template <linear_map A>
constexpr auto adjoint(A const& a) {
    return a.adjoint();
}

/// The sum of W(t) f(t).g(t) over the common points of f and g.
template <class W, discrete_function F, discrete_function G>
constexpr auto inner_product(F f, G g) {
    return weighted_sum<W>(dot(std::move(f), std::move(g)));
}

namespace detail {

/// g restricted to the points where A f has values: only there the two are paired.
template <linear_map A, discrete_function F, discrete_function G>
constexpr auto paired(A const& a, F const& f, G const& g) {
    return restrict_to(g, intersect(a.image(f.domain()), g.domain()));
}

/// 1 at point j, 0 elsewhere.
template <discrete_function F>
struct indicator : discrete_function_tag {
    using domain_type = typename F::domain_type;
    using root_type = typename F::root_type;
    F const* f;
    index_type j;
    constexpr indicator(F const& g, index_type at) : f(&g), j(at) {}
    constexpr decltype(auto) root() const { return f->root(); }
    constexpr auto domain() const { return f->domain(); }
    constexpr auto get(index_type i) const { return typename root_type::scalar_type(i == j ? 1 : 0); }
};

/// sum of W f.g over the points of f o g that are not points of `inner`.
template <class W, discrete_function F, discrete_function G, class Domain>
constexpr auto sum_outside(F const& f, G const& g, Domain const& inner) {
    auto const both = intersect(f.domain(), g.domain());
    using S = typename F::root_type::scalar_type;
    S total(0);
    for (index_type j = both.first(f.root()); j <= both.last(f.root()); ++j)
        if (j < inner.first(f.root()) or j > inner.last(f.root())) total = total + weight_at<W>(f, j) * dot_product(f.get(j), g.get(j));
    return total;
}

template <class A, class Image, class Domain>
constexpr auto unpaired() {
    return does_not_compile<"the end terms of " + A::name() + " need g where A f lives, on " + Image::name() + ", and it lives on " +
                            Domain::name()>{};
}
/// The rows of the transposed operator at the points that the adjoint leaves out.
template <linear_map A, discrete_function F, discrete_function G>
constexpr auto boundary_rows(A const& a, F const& f, G const& g) {
    using S = typename F::root_type::scalar_type;
    using image_type = decltype(a.image(f.domain()));
    using G_domain = typename G::domain_type;
    if constexpr (G_domain::front < image_type::front or G_domain::back < image_type::back)
        // adjoint(A) would use values of g that <A f, g> does not have
        return unpaired<A, image_type, G_domain>();
    else {
        auto const& T = f.root();
        auto const inner = intersect(a.adjoint().image(g.domain()), f.domain());
        S total(0);
        for (index_type j = f.domain().first(T); j <= f.domain().last(T); ++j) {
            if (inner.first(T) <= j and j <= inner.last(T)) continue;
            indicator<F> const e(f, j);
            for (index_type i = g.domain().first(T); i <= g.domain().last(T); ++i) {
                S const entry = a.evaluate(e, i);
                if (not(entry == S(0))) total = total + weight_at<typename A::to_weight>(g, i) * entry * dot_product(f.get(j), g.get(i));
            }
        }
        return total;
    }
}

} // namespace detail

/// The terms that the end points add to <f, adjoint(A) g>. g lives on the points of A f or a part of them; by_parts restricts g itself.
template <linear_map A, discrete_function F, discrete_function G>
constexpr auto boundary_form(A const& a, F const& f, G const& g) {
    return detail::boundary_rows(a, f, g);
}
template <class C, linear_map A, discrete_function F, discrete_function G>
constexpr auto boundary_form(multiple<C, A> const& a, F const& f, G const& g) {
    using S = typename F::root_type::scalar_type;
    return S(as_factor<C, S>(a.c) * boundary_form(a.a, f, g));
}
template <linear_map A, linear_map B, discrete_function F, discrete_function G>
constexpr auto boundary_form(composition<A, B> const& ab, F const& f, G const& g) {
    // <A B f, g> = <B f, A* g> + (end terms of A), then the same for B; between them the sum may change its weights.
    auto const Bf = ab.b[f];
    auto const A_g = ab.a.adjoint()[g];
    auto const inner = detail::paired(ab.b, f, A_g);
    auto const ends_of_a = boundary_form(ab.a, Bf, g);
    using P = typename A::from_weight;
    using To = typename B::to_weight;
    auto const with_ends_of_b = [&](auto const& reweighted, auto const& not_paired) {
        auto const ends = ends_of_a + boundary_form(ab.b, f, reweighted);
        if constexpr (std::same_as<typename decltype(inner)::domain_type, typename decltype(A_g)::domain_type>)
            return ends;
        else { // f is known on a part of its scale: B* A* g takes values of A* g where B f has none
            using W = typename B::from_weight;
            auto const adjoint_of_b = ab.b.adjoint();
            return ends + inner_product<W>(f, adjoint_of_b[reweighted]) - inner_product<W>(f, adjoint_of_b[not_paired]);
        }
    };
    if constexpr (std::same_as<P, To>)
        return with_ends_of_b(inner, A_g);
    else {
        constexpr reweight<typename A::from, P, To> R{};
        auto const reweighted = R[inner];
        return with_ends_of_b(reweighted, R[A_g]) + detail::sum_outside<P>(Bf, inner, reweighted.domain());
    }
}

template <linear_map A, linear_map B, discrete_function F, discrete_function G>
constexpr auto boundary_form(operator_sum<A, B> const& ab, F const& f, G const& g) {
    // The two adjoints are defined on different points; the sum keeps the common ones, and the rest joins the end terms.
    auto const common = ab.adjoint()[g].domain();
    auto const one = [&](auto const& op, auto const& h) {
        using from = typename std::remove_cvref_t<decltype(op)>::from_weight;
        auto const inner = op.adjoint()[h];
        return boundary_form(op, f, h) + detail::sum_outside<from>(f, inner, common);
    };
    using To = typename A::to_weight;
    using Bq = typename B::to_weight;
    if constexpr (std::same_as<To, Bq>)
        return one(ab.a, g) + one(ab.b, g);
    else
        return one(ab.a, g) + one(ab.b, reweight<typename A::to, To, Bq>{}[g]) +
               detail::sum_outside<To>(ab.b[f], g, reweight<typename A::to, To, Bq>{}[g].domain());
}

/// Gruenwald-Letnikov and its siblings: their adjoint lives on the end points too, where the two sums have different weights. The boundary
/// form has those terms: on all of T, nu^(1-alpha) omega(0)^alpha f g at b minus at a for the side minus.
template <class G, class Order, side Side, class W, discrete_function F, discrete_function H>
constexpr auto boundary_form(fractional_difference<G, Order, Side, W> const& a, F const& f, H const& g) {
    using A = fractional_difference<G, Order, Side, W>;
    using S = typename F::root_type::scalar_type;
    auto const b = a.adjoint();
    auto const& T = f.root();
    auto const inner = intersect(b.image(g.domain()), f.domain());
    S total(0);
    for (index_type j : {f.domain().first(T), f.domain().last(T)}) {
        detail::indicator<F> const e(f, j);
        for (index_type i = g.domain().first(T); i <= g.domain().last(T); ++i)
            total = total + weight_at<typename A::to_weight>(g, i) * S(a.evaluate(e, i)) * dot_product(f.get(j), g.get(i));
        if (inner.first(T) <= j and j <= inner.last(T))
            total = total - weight_at<typename A::from_weight>(f, j) * dot_product(f.get(j), b.evaluate(g, j));
    }
    return total;
}
/// f(a) and its sum with g.
template <class Base, class W, discrete_function F, discrete_function G>
constexpr auto boundary_form(from_start_on<Base, W> const&, F const& f, G const& g) {
    using S = typename F::root_type::scalar_type;
    S total(0);
    for (index_type i = g.domain().first(g.root()); i <= g.domain().last(g.root()); ++i)
        total = total - weight_at<W>(g, i) * dot_product(f.get(f.domain().first(f.root())), g.get(i));
    return total;
}

/// The three terms of <A f, g> = <f, adjoint(A) g> + boundary.
template <class S>
struct by_parts_result {
    S left;     ///< <A f, g>, with A's to_weight
    S interior; ///< <f, adjoint(A) g>, with A's from_weight
    S boundary; ///< boundary_form(A, f, g)
};

/// Both sides of the integration by parts of A. f lives on A's from, g on A's to. @throws error::mismatch when they are on different scales
template <linear_map A, discrete_function F, discrete_function G>
constexpr auto by_parts(A const& a, F const& f, G const& g) {
    using S = typename F::root_type::scalar_type;
    auto const h = detail::paired(a, f, g);
    return by_parts_result<S>{inner_product<typename A::to_weight>(a[f], h), inner_product<typename A::from_weight>(f, a.adjoint()[h]),
                              boundary_form(a, f, h)};
}

} // namespace hilger
