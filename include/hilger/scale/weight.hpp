// SPDX-License-Identifier: BSL-1.0
// The weights of sums over a family of points. An adjoint is always the adjoint between two weighted sums, and on a non-uniform
// scale it matters which: Delta_plus and -Delta_minus are adjoint between the nabla sum and the Delta sum.
#pragma once

#include "hilger/scale/base.hpp"

namespace hilger {

/// w(t) = (1 - lambda) mu(t) + lambda nu(t), a missing neighbour counting zero. lambda = 0 gives the Delta integral, 1 the nabla integral,
/// 1/2 the trapezoid rule; on T it is the lambda-integral of the extension f -> f_{o,lambda}.
template <class Lambda>
struct mean_weight {
    static constexpr bool vanishes_first = std::same_as<Lambda, fraction<1>>;
    static constexpr bool vanishes_last = std::same_as<Lambda, fraction<0>>;
    static constexpr auto name() {
        if constexpr (vanishes_last)
            return fixed_text("delta_weight");
        else if constexpr (vanishes_first)
            return fixed_text("nabla_weight");
        else
            return fixed_text("mean");
    }
    template <class Root, class Base>
    static constexpr auto at(Root const& T, Base const& base, index_type i) {
        using S = typename Root::scalar_type;
        S const after = i < base.last(T.steps()) ? S(base.step(T, i)) : S(0);
        S const before = i > 0 ? S(base.step(T, i - 1)) : S(0);
        S const l = Lambda::template as<S>();
        return S((S(1) - l) * after + l * before);
    }
};
using delta_weight = mean_weight<fraction<0>>;
using nabla_weight = mean_weight<fraction<1>>;

/// The graininess of W = delta_weight or nabla_weight with T continued by its own first or last step, nu(t_0) = nu(t_1) and mu(t_N) =
/// mu(t_{N-1}), in a sum without the other end. On equal steps continued_weight<nabla_weight> is delta_weight, and the other way round.
template <class W>
struct continued_weight {
    static constexpr bool vanishes_first = W::vanishes_last;
    static constexpr bool vanishes_last = W::vanishes_first;
    static constexpr auto name() { return "continued<" + W::name() + ">"; }
    /// The number of the step that is the graininess at point i.
    template <class Root>
    static constexpr index_type step_number(Root const& T, index_type i) {
        return W::vanishes_first ? std::max<index_type>(i - 1, 0) : std::min(i, T.steps() - 1);
    }
    template <class Root>
    static constexpr auto at(Root const& T, nodes const&, index_type i) {
        using S = typename Root::scalar_type;
        return i == (vanishes_last ? T.steps() : 0) ? S(0) : S(T.step(step_number(T, i)));
    }
};

/// The weights of the lambda-integral, on T_lambda: t_{i+1} - t_i at t_{i,lambda} (Cresson-Safi (32)); at the nodes of a quadrature those
/// of the quadrature, which add up to it in each step.
struct step_weight {
    static constexpr bool vanishes_first = false;
    static constexpr bool vanishes_last = false;
    static constexpr auto name() { return fixed_text("step_weight"); }
    template <class Root, class Lambda>
    static constexpr auto at(Root const& T, between<Lambda> const&, index_type i) {
        return typename Root::scalar_type(T.step(i));
    }
    template <class Root, class Base>
        requires requires(Root const& T, Base const& base) { base.weight(T, index_type(0)); }
    static constexpr auto at(Root const& T, Base const& base, index_type i) { return base.weight(T, i); }
};

/// On T_{o,lambda}: half of the weight W of T at the points of T, half of the step at those of T_lambda, so that both parts carry
/// the same total.
template <class W>
struct split_weight {
    static constexpr bool vanishes_first = W::vanishes_first;
    static constexpr bool vanishes_last = W::vanishes_last;
    static constexpr auto name() { return fixed_text("split"); }
    template <class Root, class Lambda>
    static constexpr auto at(Root const& T, joined<Lambda> const&, index_type j) {
        using S = typename Root::scalar_type;
        return S((j % 2 == 0 ? S(W::at(T, nodes{}, j / 2)) : S(T.step(j / 2))) / S(2));
    }
};

/// The weight on T in which the lambda-average T -> T_lambda has the simplest adjoint. A lambda known only at run time cannot be in
/// the type of a weight; the Delta weight is used then.
template <class Lambda>
struct natural_weight {
    using type = delta_weight;
};
template <int P, int Q>
struct natural_weight<fraction<P, Q>> {
    using type = mean_weight<fraction<P, Q>>;
};
template <>
struct natural_weight<fraction<0>> {
    using type = delta_weight;
};
template <class Lambda>
using natural_weight_t = typename natural_weight<Lambda>::type;

/// The weight W at point i of the family that f lives on.
template <class W, class F>
constexpr auto weight_at(F const& f, index_type i) {
    return W::at(f.root(), f.domain().base, i);
}

} // namespace hilger
