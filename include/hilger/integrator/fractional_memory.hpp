// SPDX-License-Identifier: BSL-1.0
// The fractional derivative of a trajectory that starts at t_0 with position x_0 and velocity v_0, at each of its points as they come:
//   h^-beta omega(0)^beta sum_{n=0..k} w_n y_{k-n},   0 < beta < 2.
// What y is, decides what the sum approximates, and for x_0 != 0 that is not the same:
//   riemann_liouville   y = x. The curve is taken to be 0 before t_0, so that it jumps there: Jimenez, Ober-Bloebaum (15), (20) as printed.
//   caputo              y = x - x_0 for beta < 1, y = x - x_0 - (t - t_0) v_0 for beta > 1: a constant is not damped, nor is, for beta > 1,
//                       uniform motion. For beta = 1 the curve is continued before t_0 by its tangent: the derivative at t_0 is v_0.
// Only components with a coefficient keep a history, and none of a whole order does: the differences of Jimenez, Ober-Bloebaum (22) need
// as many values as omega has powers of z.
#pragma once

#include <optional>
#include <vector>

#include "hilger/fixed_text.hpp"
#include "hilger/history/direct.hpp"
#include "hilger/mechanics/shape.hpp"

namespace hilger {

/// How a fractional derivative reads the time before the first point.
enum class initial_history { caputo, riemann_liouville };

namespace detail {

/// The number of values before the present one that the whole power omega(z)^1 needs; -1 where it needs all.
template <class G>
inline constexpr int terms_of = -1;
template <>
inline constexpr int terms_of<grunwald_letnikov> = 1;
template <int K>
inline constexpr int terms_of<bdf<K>> = K;

template <class Order>
inline constexpr bool is_fraction = false;
template <int P, int Q>
inline constexpr bool is_fraction<fraction<P, Q>> = true;

/// Whether an order is known to be 1 by its type.
template <class Order>
inline constexpr bool is_one = false;
template <int P>
inline constexpr bool is_one<fraction<P, P>> = true;

/// Whether an order is known to be below 1 by its type: no velocity is then asked for.
template <class Order>
inline constexpr bool is_below_one = false;
template <int P, int Q>
inline constexpr bool is_below_one<fraction<P, Q>> = P < Q;

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

/// There is no trajectory on steps of different lengths, and no single step.
template <class Scale>
auto uneven_steps() {
    return does_not_compile<"fractional damping lives on a uniform T, and this one has steps of different lengths", Scale>{};
}
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

/// The last Terms values of a difference of order 1, with the interface of a history.
template <generating_function G, int Terms, class S, class V>
class last_values {
public:
    explicit last_values(V const& like)
        : w_(first_weights<G>(S(1), Terms + 1)), zero_(zero_like(like)), sum_(zero_), x_(static_cast<std::size_t>(Terms), zero_) {}
    V const& past() {
        sum_ = x_[0] * w_[1];
        for (std::size_t n = 1; n < x_.size(); ++n) sum_ = sum_ + x_[n] * w_[n + 1];
        return sum_;
    }
    void push(V const& x) {
        for (std::size_t n = x_.size() - 1; n > 0; --n) x_[n] = x_[n - 1];
        x_[0] = x;
        ++count_;
    }
    [[nodiscard]] index_type count() const { return count_; }
    void reset() {
        for (V& x : x_) x = zero_;
        count_ = 0;
    }
    /// Everything that later differences depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("values", count_);
        for (V& x : x_) memory::visit_components("value", x, each);
    }

private:
    std::vector<S> w_;
    V zero_, sum_;
    std::vector<V> x_;
    index_type count_ = 0;
};

/// Does not exist: where the order is 1 by its type, there is no engine.
struct no_history {};

template <generating_function G, class Policy, class S, class V, bool One>
struct engine_of {
    using type = decltype(make_history<G>(std::declval<Policy const&>(), std::declval<S const&>(), std::declval<V const&>()));
};
template <generating_function G, class Policy, class S, class V>
struct engine_of<G, Policy, S, V, true> {
    using type = no_history;
};

/// The derivative of one trajectory of values V (numbers or vectors, in which all components have one).
template <generating_function G, class Order, class Policy, class S, class V>
class fractional_memory {
    static constexpr int terms = terms_of<G>;
    static constexpr bool always_local = is_one<Order> and terms > 0;
    using engine = typename engine_of<G, Policy, S, V, always_local>::type;
    using local = last_values<G, (terms > 0 ? terms : 1), S, V>;

public:
    /// @throws error::invalid_parameter for an order outside ]0, 2[, or a power of h that the scalar does not have
    fractional_memory(Order const& order, Policy const& policy, initial_history initial, S const& h, V const& like)
        : beta_(order.template as<S>()), h_(h), initial_(initial), x0_(zero_like(like)), v0_(x0_), y_(x0_), derivative_(x0_) {
        require_order(beta_);
        scale_ = leading_weight<G>(beta_) / power(h, beta_);
        if constexpr (always_local)
            local_.emplace(like);
        else if (terms > 0 and beta_ == S(1))
            local_.emplace(like);
        else
            engine_.emplace(make_history<G>(policy, beta_, like));
    }
    /// Whether v_0 will be asked for.
    [[nodiscard]] bool needs_velocity() const { return initial_ == initial_history::caputo and not(beta_ < S(1)); }
    /// h^-beta omega(0)^beta, the weight of the present value.
    [[nodiscard]] S const& present_weight() const { return scale_; }
    /// The number of values that are kept.
    [[nodiscard]] index_type kept() const {
        if (local_) return terms;
        if constexpr (not always_local) return engine_->count();
        return 0;
    }
    /// The number of components with a history: none where the order is whole.
    [[nodiscard]] index_type histories() const { return local_ ? 0 : shape<V>::dimension(x0_); }
    /// What their engine takes. The local values of a whole order are not counted.
    [[nodiscard]] std::size_t bytes() const {
        if constexpr (not always_local)
            if (engine_) return engine_->bytes();
        return 0;
    }
    void begin(V const& x0, V const& v0) {
        if (initial_ == initial_history::caputo) {
            if (local_)
                for (int k = terms; k > 0; --k) local_->push(V(x0 - v0 * S(S(k) * h_)));
            else {
                x0_ = x0;
                if (S(1) < beta_) v0_ = v0;
            }
        }
    }
    /// The derivative at the next point if the value there is x.
    V const& at_next(V const& x) {
        measure_from_start(x);
        if (local_)
            derivative_ = (y_ + local_->past()) * scale_;
        else if constexpr (not always_local)
            derivative_ = (y_ + engine_->past()) * scale_;
        return derivative_;
    }
    /// Takes x as the value at the next point. @returns the derivative there
    V const& arrive(V const& x) {
        at_next(x);
        // Into the history at once: nothing waits for its sums until the next value is there, and the processor makes them meanwhile.
        if (local_)
            local_->push(y_);
        else if constexpr (not always_local)
            engine_->push(y_);
        return derivative_;
    }

    /// Everything that later derivatives depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        memory::visit_components("start", x0_, each);
        memory::visit_components("slope", v0_, each);
        if (local_) local_->visit(each);
        if constexpr (not always_local)
            if (engine_) engine_->visit(each);
    }

private:
    void measure_from_start(V const& x) {
        y_ = x - x0_;
        if constexpr (not always_local)
            if (not local_ and S(1) < beta_) y_ = y_ - v0_ * S(h_ * S(static_cast<long long>(engine_->count())));
    }
    S beta_, h_, scale_{};
    initial_history initial_;
    V x0_, v0_, y_, derivative_;
    std::optional<local> local_;
    [[no_unique_address]] std::conditional_t<always_local, no_history, std::optional<engine>> engine_;
};

} // namespace detail
} // namespace hilger
