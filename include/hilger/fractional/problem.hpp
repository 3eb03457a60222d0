// SPDX-License-Identifier: BSL-1.0
// The fractional embedding of a Lagrangian (Bourdin, Cresson, Greff, Inizan 2013, section 3): on a uniform T the functional (12)
//   h sum_{k=1..N} L(Q_k, (Delta_-^alpha Q)_k, t_k),   (Delta_-^alpha Q)_k = h^-alpha sum_{r=0..k} alpha_r Q_{k-r},
// whose critical points for variations that vanish at both ends solve (EL_h^alpha),
//   dL/dx_k + (Delta_+^alpha dL/dv)_k = 0,  k = 1..N-1.
// Velocities and momenta exist for k = 1..N only: the sums of Delta_+^alpha end at N, and k = 0 is never asked for. alpha = 1 is the
// order-one embedding with Delta_-.
#pragma once

#include "hilger/function/function.hpp"
#include "hilger/history/convolution.hpp"
#include "hilger/operator/weights.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/variational/lagrangian.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger {

namespace detail {

/// The order of a problem as a scalar. @throws error::invalid_parameter outside ]0, 1].
template <class S, class Order>
S fractional_order(Order const& alpha) {
    S result(0);
    if constexpr (requires { alpha.template as<S>(); })
        result = alpha.template as<S>();
    else
        result = S(alpha);
    if (not(S(0) < result) or not(result <= S(1)))
        error::raise<error::invalid_parameter>("the order alpha of a fractional Lagrangian problem is in ]0, 1], and this one is ", result);
    return result;
}
/// h^alpha; an exact scalar has it for alpha = 1 and for h = 1. @throws error::invalid_parameter
template <class S>
S power_of_step(S const& h, S const& alpha) {
    return power_or(h, alpha, [&] {
        error::raise<error::invalid_parameter>("h^alpha is no rational number for h = ", h, " and alpha = ", alpha,
                                               ": exact scalars take alpha = 1 or h = 1");
    });
}

enum class direction { forward, backward };

/// A triangular Toeplitz matrix on values of type V, component by component; backward: its transpose.
template <class V>
std::vector<V> apply_triangle(toeplitz_triangle<scalar_of<V>> const& triangle, std::vector<V> const& x, scalar_of<V> const& factor,
                              direction to) {
    using s = shape<V>;
    std::vector<V> y = x;
    std::size_t const n = x.size();
    for (int c = 0; c < s::dimension(x.front()); ++c) {
        std::vector<scalar_of<V>> row(n, scalar_of<V>(0));
        for (std::size_t k = 0; k < n; ++k) row[to == direction::forward ? k : n - 1 - k] = s::component(x[k], c);
        row = triangle(row);
        for (std::size_t k = 0; k < n; ++k) s::component(y[k], c) = factor * row[to == direction::forward ? k : n - 1 - k];
    }
    return y;
}

} // namespace detail

/// L(x, v) or L(t, x, v), and the order alpha of its velocity: a scalar, or a fraction<P, Q>, which is exact in every scalar. States are
/// scalars or Eigen vectors. All members take x in C(T), T uniform with at least one step.
template <class F, class Order>
class fractional_problem {
public:
    fractional_problem(F lagrangian, Order alpha) : lagrangian_(std::move(lagrangian)), alpha_(std::move(alpha)) {}

    [[nodiscard]] F const& lagrangian() const { return lagrangian_; }
    /// @throws error::invalid_parameter outside ]0, 1].
    template <class S>
    [[nodiscard]] S order() const {
        return detail::fractional_order<S>(alpha_);
    }
    /// Delta_-^alpha x on T^- (B (7), and 0 for k = 0 left out).
    template <discrete_function X>
    [[nodiscard]] auto velocity(X const& x) const {
        return function_on(without_first(x.root()), velocities(triangle<X>(x.root()), x));
    }
    /// dL/dv(x, Delta_-^alpha x, t) on T^-.
    template <discrete_function X>
    [[nodiscard]] auto momentum(X const& x) const {
        return function_on(without_first(x.root()), momenta(x, velocities(triangle<X>(x.root()), x)));
    }
    /// Delta_+^alpha y on T^+- for y on T^- (B (8)).
    template <discrete_function Y>
    [[nodiscard]] auto right_difference(Y const& y) const {
        return function_on(interior(y.root()), right_differences(triangle<Y>(y.root()), y.root(), values_of(y)));
    }
    /// The functional (12).
    template <discrete_function X>
    [[nodiscard]] auto action(X const& x) const {
        using S = typename X::root_type::scalar_type;
        auto const values =
            along(x, velocities(triangle<X>(x.root()), x), [](auto const& L, auto const& q, auto const& v) { return S(L(q, v)); });
        S sum(0);
        for (S const& value : values) sum = sum + value;
        return S(x.root().h() * sum);
    }
    /// The left-hand side of (EL_h^alpha) on T^+-. Its rounding error is of the size of epsilon h^(-2 alpha) |x|, as that of a second
    /// difference is.
    template <discrete_function X>
    [[nodiscard]] auto residual(X const& x) const {
        auto const difference = triangle<X>(x.root());
        auto const v = velocities(difference, x);
        auto rest = right_differences(difference, x.root(), momenta(x, v));
        auto const force = along(x, v, [](auto const& L, auto const& q, auto const& u) { return gradient_first(L, q, u); });
        for (std::size_t k = 0; k < rest.size(); ++k) rest[k] = rest[k] + force[k];
        return function_on(interior(x.root()), std::move(rest));
    }

private:
    /// The weights of Delta_-^alpha for all of T, without h^-alpha.
    template <class X>
    [[nodiscard]] auto triangle(typename X::root_type const& T) const {
        static_assert(X::root_type::is_uniform, "a fractional difference is a convolution: it needs a uniform scale");
        using S = typename X::root_type::scalar_type;
        return toeplitz_triangle<S>(first_weights<grunwald_letnikov>(order<S>(), T.size()));
    }
    template <class Root>
    [[nodiscard]] auto steepness(Root const& T) const {
        using S = typename Root::scalar_type;
        return S(S(1) / detail::power_of_step(T.h(), order<S>()));
    }
    template <class X>
    static auto values_of(X const& x) {
        std::vector<value_of<X>> values;
        values.reserve(static_cast<std::size_t>(x.size()) + 1);
        for (index_type k = x.first(); k <= x.last(); ++k) values.push_back(x.get(k));
        return values;
    }
    template <class Triangle, class X>
    [[nodiscard]] auto velocities(Triangle const& difference, X const& x) const {
        auto v = detail::apply_triangle(difference, values_of(x), steepness(x.root()), detail::direction::forward);
        v.erase(v.begin());
        return v;
    }
    /// From the values for k = 1..N to those for k = 1..N-1.
    template <class Triangle, class Root, class V>
    [[nodiscard]] auto right_differences(Triangle const& difference, Root const& T, std::vector<V> y) const {
        y.insert(y.begin(), zero_like(y.front())); // as many as the triangle has rows; what is for k = 0 is not asked for
        y = detail::apply_triangle(difference, y, steepness(T), detail::direction::backward);
        y.erase(y.begin());
        y.pop_back();
        return y;
    }
    template <class X, class V>
    [[nodiscard]] auto momenta(X const& x, std::vector<V> const& v) const {
        return along(x, v, [](auto const& L, auto const& q, auto const& u) { return gradient_second(L, q, u); });
    }
    /// what(L at t_k, Q_k, v_k) for k = 1..N.
    template <class X, class V, class What>
    [[nodiscard]] auto along(X const& x, std::vector<V> const& v, What const& what) const {
        using S = typename X::root_type::scalar_type;
        std::vector<std::remove_cvref_t<decltype(what(detail::at_time{lagrangian_, std::declval<S const&>()}, v[0], v[0]))>> result;
        result.reserve(v.size());
        for (index_type k = 1; k <= x.last(); ++k) {
            S const t = x.root().element(k);
            result.push_back(what(detail::at_time{lagrangian_, t}, V(x.get(k)), v[static_cast<std::size_t>(k) - 1]));
        }
        return result;
    }
    [[no_unique_address]] F lagrangian_;
    [[no_unique_address]] Order alpha_;
};

} // namespace hilger
