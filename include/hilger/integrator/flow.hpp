// SPDX-License-Identifier: BSL-1.0
// The flow (q_i, p_i) -> (q_{i+1}, p_{i+1}) of an embedded Lagrangian, in position-momentum form: p_i = -d_1 L_h(q_i, q_{i+1}) is
// solved for q_{i+1}, and p_{i+1} = d_2 L_h(q_i, q_{i+1}) follows (Cresson-Safi (95), (96) for mid-point, definition 12 for p). The same
// p serves every embedding; for order one it is the p^sigma of Cresson-Safi (15): p_{i+1} = dL/dv(q_i, Delta_plus[q]_i).
//   auto flow = embed(L, midpoint);
//   for (auto [t, q, p] : flow.along(T, q0, p0)) ...        one state at a time, nothing stored
#pragma once

#include <optional>

#include "hilger/embedding/embedding.hpp"
#include "hilger/mechanics/interval.hpp"
#include "hilger/mechanics/legendre.hpp"
#include "hilger/mechanics/variation.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"

namespace hilger {

/// A point of a trajectory: time, position, momentum.
template <class S, class V>
struct state {
    S t;
    V q;
    V p;
};

/// Where a trajectory stopped: the states up to `last` are right.
template <class S, class V>
struct interrupted {
    state<S, V> last;
};

/// A step that could not be made, as the error that it met (no_convergence, singular, not_finite) and as interrupted<S, V>.
template <class Cause, class S, class V>
struct step_failure : Cause, interrupted<S, V> {
    step_failure(std::string const& what, state<S, V> reached) : Cause(what), interrupted<S, V>{std::move(reached)} {}
};

template <class F, linear_map A, linear_map B, class W>
class flow {
public:
    constexpr flow(F lagrangian, A position, B velocity)
        : lagrangian_(std::move(lagrangian)), position_(std::move(position)), velocity_(std::move(velocity)) {}

    /// One step of length h. `guess` is a first estimate of the next position.
    /// @throws error::no_convergence, error::singular, error::not_finite
    template <class S, class V>
    state<S, V> step(state<S, V> const& from, S const& h, V const& guess) const {
        interval_lagrangian<F, A, B, W, S> const Lh{lagrangian_, position_, velocity_, {h}};
        auto const equation = [&](V const& y) {
            auto const d = mixed_second(Lh, from.q, y);
            return newton_system<V>{V(d.first + from.p), d.mixed};
        };
        V const q = newton(equation, guess, "the step p = -d_1 L_h(q, y)");
        return {S(from.t + h), q, gradient_second(Lh, from.q, q)};
    }
    template <class S, class V>
    state<S, V> step(state<S, V> const& from, S const& h) const {
        return step(from, h, V(from.q + velocity_of(lagrangian_, from.q, from.p) * h));
    }

    /// The states at the points of T, from (q0, p0) at its first one, computed one at a time as the range is walked.
    /// @throws error::not_finite at once when q0 or p0 is not finite; while walking, a step_failure with the last good state.
    template <time_scale_like Scale, class V>
    auto along(Scale const& T, V q0, V p0) const {
        return trajectory<Scale, V>(*this, T, std::move(q0), std::move(p0));
    }

    template <time_scale_like Scale, class V>
    class trajectory {
        using S = typename Scale::root_type::scalar_type;

    public:
        class iterator {
        public:
            using iterator_concept = std::input_iterator_tag;
            using value_type = state<S, V>;
            using difference_type = index;
            explicit iterator(trajectory const& path) : path_(&path), at_(path.start_), number_(path.T_.first()), last_(path.T_.last()) {}
            value_type const& operator*() const { return at_; }
            value_type const* operator->() const { return &at_; }
            iterator& operator++() {
                advance();
                return *this;
            }
            void operator++(int) { advance(); }
            friend bool operator==(iterator const& i, std::default_sentinel_t) { return i.number_ > i.last_; }

        private:
            void advance() {
                if (number_++ >= last_) return;
                S const h = path_->T_.domain().base.step(path_->T_.root(), number_ - 1);
                try {
                    // The last displacement, scaled to this step, is the guess; the first one comes from the velocity.
                    value_type next = displacement_ ? path_->flow_.step(at_, h, V(at_.q + *displacement_ * S(h / last_step_)))
                                                    : path_->flow_.step(at_, h);
                    next.t = path_->T_.element(number_);
                    displacement_ = V(next.q - at_.q);
                    last_step_ = h;
                    at_ = std::move(next);
                } catch (error::no_convergence const& cause) {
                    stop(cause, h);
                } catch (error::singular const& cause) {
                    stop(cause, h);
                } catch (error::not_finite const& cause) {
                    stop(cause, h);
                }
            }
            template <class Cause>
            [[noreturn]] void stop(Cause const& cause, S const& h) const {
                std::ostringstream message;
                message << "the step from t = " << at_.t << " with h = " << h << " failed: " << cause.what();
                throw step_failure<Cause, S, V>(message.str(), at_);
            }
            trajectory const* path_;
            value_type at_;
            std::optional<V> displacement_;
            S last_step_{1};
            index number_, last_;
        };

        trajectory(flow f, Scale T, V q0, V p0) : flow_(std::move(f)), T_(std::move(T)), start_{T_.min(), std::move(q0), std::move(p0)} {
            if (not detail::all_finite(start_.q) or not detail::all_finite(start_.p))
                error::raise<error::not_finite>("the initial position and momentum are finite numbers, and these contain NaN or infinity");
        }
        [[nodiscard]] iterator begin() const { return iterator(*this); }
        [[nodiscard]] std::default_sentinel_t end() const { return {}; }

    private:
        flow flow_;
        Scale T_;
        state<S, V> start_;
    };

private:
    [[no_unique_address]] F lagrangian_;
    [[no_unique_address]] A position_;
    [[no_unique_address]] B velocity_;
};

/// The flow of L under an embedding: embed(L, midpoint).
template <class F, linear_map A, linear_map B, class W>
constexpr auto embed(lagrangian<F> const& L, embedding<A, B, W> const& how) {
    return flow<F, A, B, W>(L.function, how.position, how.velocity);
}
template <class F, linear_map A, linear_map B, class W>
    requires(not function_expression<F>)
constexpr auto embed(F const& L, embedding<A, B, W> const& how) { return embed(lagrangian(L), how); }
/// The flow of a discrete Euler-Lagrange equation.
template <class F, linear_map A, linear_map B, class W, class Root>
constexpr auto flow_of(euler_lagrange<action<F, A, B, W, Root>> const& equation) {
    auto const& S = equation.action();
    return flow<F, A, B, W>(S.function, S.position, S.velocity);
}

} // namespace hilger
