// SPDX-License-Identifier: BSL-1.0
// The fractional derivative of a trajectory from position x_0 and velocity v_0 at t_0, at one point after the other:
//   h^-beta omega(0)^beta sum_{n=0..k} w_n y_{k-n},   0 < beta < 2.
// The choice of y decides what the sum approximates where x_0 != 0:
//   riemann_liouville   y = x. The curve is taken to be 0 before t_0, so that it jumps there: Jimenez, Ober-Bloebaum (15), (20) as printed.
//   caputo              y = x - x_0 for beta < 1, y = x - x_0 - (t - t_0) v_0 for beta > 1: a constant is not damped, nor is, for beta > 1,
//                       uniform motion. For beta = 1 the curve is continued before t_0 by its tangent: the derivative at t_0 is v_0.
// Differences of order beta of positions would enlarge their rounding, and that of the weights, by h^-beta. So the sum is made of
// increments: omega(z)^beta = omega(z)^m omega(z)^(beta - m), m the whole number next to beta; the m differences of order one need as many
// values as omega has powers of z (Jimenez, Ober-Bloebaum (22)), and only the rest, of an order in ]-1/2, 1/2], needs a history. Components
// without a coefficient and whole orders have none.
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "hilger/fixed_text.hpp"
#include "hilger/history/direct.hpp"
#include "hilger/history/whole_difference.hpp"
#include "hilger/shape.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

/// The values before the first point in a fractional derivative.
enum class initial_history { caputo, riemann_liouville };

namespace detail {

template <class Order>
inline constexpr bool is_fraction = false;
template <int P, int Q>
inline constexpr bool is_fraction<fraction<P, Q>> = true;

/// h^beta. @throws error::invalid_parameter where it is no number of type S
template <class S>
S power(S const& h, S const& beta) {
    if (beta == S(1)) return h;
    if constexpr (std::numeric_limits<S>::is_exact)
        error::raise<error::invalid_parameter>("h^beta is no rational number for the order beta = ", beta, ": exact scalars have order 1");
    else {
        using std::pow;
        return S(pow(h, beta));
    }
}

/// Differences of fractional order are defined for one h.
template <class Scale>
constexpr void require_equal_steps() {
    static_assert(Scale::root_type::is_uniform and has_equal_steps<typename Scale::domain_type::base_type>,
                  "fractional damping lives on a uniform T, and this one has steps of different lengths");
}
/// The result of a refused single step, which has no history.
template <class S>
auto no_single_step() {
    return does_not_compile<"a step with fractional damping depends on all steps before it: walk along(T, q0, p0)", S>{};
}

/// @throws error::invalid_parameter
template <class S>
void require_order(S const& beta) {
    if (not is_finite(beta) or not(S(0) < beta and beta < S(2)))
        error::raise<error::invalid_parameter>("the order of a fractional damping lies in ]0, 2[, and this one is ", beta);
}

/// fraction<P, Q> as it is, a number as run_time. @throws error::invalid_parameter outside ]0, 2[
template <class Order>
auto checked_order(Order const& order) {
    if constexpr (is_fraction<Order>) {
        static_assert(0 < Order::numerator and Order::numerator < 2 * Order::denominator,
                      "the order of a fractional damping lies in ]0, 2[");
        return reduced<Order::numerator, Order::denominator>{};
    } else {
        require_order(order);
        return run_time<Order>{order};
    }
}

/// The number m of whole orders in beta, taken as differences of increments: the nearest one, so that the rest is in ]-1/2, 1/2].
template <class S>
int whole_part(S const& beta) {
    return S(2) * beta <= S(1) ? 0 : S(2) * beta <= S(3) ? 1 : 2;
}

/// The derivative of one trajectory of values V (numbers or vectors, in which all components have one).
template <generating_function G, class Order, class Policy, class S, class V>
class fractional_memory {
    using engine = decltype(make_history<G>(std::declval<Policy const&>(), std::declval<S const&>(), std::declval<V const&>()));
    using difference = whole_difference<G, S, V>;

public:
    /// @throws error::invalid_parameter for an order outside ]0, 2[, or a power of h that the scalar does not have
    fractional_memory(Order const& order, Policy const& policy, initial_history initial, S const& h, V const& like)
        : beta_(order.template as<S>()), h_(h), initial_(initial), start_(zero_like(like)), last_(start_), step_(start_), drift_(start_),
          later_drift_(start_), increment_(start_), first_(start_), change_(start_), derivative_(start_) {
        require_order(beta_);
        (void)weight_sequence<G, S>(beta_); // which checks the generating function
        scale_ = leading_weight<G>(beta_) / power(h, beta_);
        int const whole = whole_part(beta_);
        whole_.assign(static_cast<std::size_t>(whole), difference(like));
        if (S const rest = beta_ - S(whole); not(rest == S(0))) engine_.emplace(make_history<G>(policy, rest, like));
    }
    /// Whether v_0 is needed.
    [[nodiscard]] bool needs_velocity() const { return initial_ == initial_history::caputo and not(beta_ < S(1)); }
    /// h^-beta omega(0)^beta, the weight of the present value.
    [[nodiscard]] S const& present_weight() const { return scale_; }
    void begin(V const& x0, V const& v0) {
        if (initial_ == initial_history::riemann_liouville) return;
        start_ = x0;
        last_ = x0;
        if (beta_ == S(1)) { // the tangent's increments before t_0, and at it
            whole_[0].begin(V(v0 * h_));
            drift_ = v0 * S(-h_);
        } else if (S(1) < beta_)
            later_drift_ = v0 * h_;
    }
    /// The derivative at the next point if the value there is x.
    V const& at_next(V const& x) {
        step_ = x - last_;
        return at_next(x, step_);
    }
    /// The same with the increment from the last value to x, which is more exact than their difference.
    V const& at_next(V const& x, V const& increment) {
        derivative_ = term_at_next(x, increment);
        if (engine_) derivative_ = derivative_ + engine_->past();
        derivative_ = derivative_ * scale_;
        return derivative_;
    }
    /// Takes x as the value at the next point. @returns the derivative there
    V const& arrive(V const& x) {
        step_ = x - last_;
        return arrive(x, step_);
    }
    V const& arrive(V const& x, V const& increment) {
        at_next(x, increment);
        // Into the history at once: its sums are not needed before the next value, and the processor computes them meanwhile.
        if (engine_) engine_->push(value());
        if (whole_.size() > 1) {
            first_ = whole_[0].value();
            whole_[1].push(change_);
        }
        if (not whole_.empty()) whole_[0].push(increment_);
        last_ = x;
        drift_ = later_drift_;
        return derivative_;
    }

    /// Everything that later derivatives depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        memory::visit_components("start", start_, each);
        memory::visit_components("last", last_, each);
        memory::visit_components("drift", drift_, each);
        memory::visit_components("drift", later_drift_, each);
        memory::visit_components("difference", first_, each);
        for (difference& d : whole_) d.visit(each);
        if (engine_) engine_->visit(each);
    }

private:
    V const& value() const { return whole_.empty() ? increment_ : whole_.back().value(); }
    /// The argument of the rest of the order: the value less the start, or its difference of the whole part of the order.
    V const& term_at_next(V const& x, V const& increment) {
        if (whole_.empty()) {
            increment_ = x - start_;
            return increment_;
        }
        increment_ = increment - drift_;
        if (whole_.size() == 1) return whole_[0].at_next(increment_);
        change_ = whole_[0].at_next(increment_) - first_;
        return whole_[1].at_next(change_);
    }
    S beta_, h_, scale_{};
    initial_history initial_;
    V start_, last_, step_, drift_, later_drift_; // drift_: the part of the start in each increment
    V increment_, first_, change_, derivative_;
    std::vector<difference> whole_;
    std::optional<engine> engine_; ///< of an order that is not whole
};

} // namespace detail
} // namespace hilger
