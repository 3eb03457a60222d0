// SPDX-License-Identifier: BSL-1.0
// A trajectory as a range of states, one at each point of a time scale, computed during iteration by the memory<S, V> of a method, which
// advances a state in place.
#pragma once

#include <iterator>
#include <optional>

#include "hilger/inlining.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/step/state.hpp"
#include "hilger/trajectory/resuming.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

/// Steps of one length, prepared once by begin. advance_equally throws step_failure itself, so that the state need not be kept in memory
/// for the message.
template <class Memory, class Method, class S, class State>
concept advances_equally = requires(Memory m, Method const& f, State x, S const& h) {
    m.begin(f, x, h);
    m.advance_equally(f, x);
};

/// A point of a trajectory with everything that the steps after it depend on: the state, the memory of the method (first guesses, rounding
/// errors of sums), and the number of the point.
template <class S, class V, class Memory>
struct checkpoint {
    state<S, V> at;
    Memory memory;
    index_type number;
};

namespace detail {
template <class Kept>
constexpr void trajectory_ends_here() {
    static_assert(not std::same_as<Kept, Kept>,
                  "an iterator refers to its trajectory, which ends here: keep the trajectory in a variable first");
}
} // namespace detail

/// A trajectory from one of its checkpoints on.
template <class Path>
class resumed {
public:
    resumed(Path path, typename Path::checkpoint_type from) : path_(std::move(path)), from_(std::move(from)) {}
    [[nodiscard]] auto begin() const& { return typename Path::iterator(path_, from_); }
    template <class Kept = Path>
    typename Kept::iterator begin() const&& {
        detail::trajectory_ends_here<Kept>();
        return {path_, from_};
    }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }
    [[nodiscard]] auto const& scale() const { return path_.scale(); }
    [[nodiscard]] auto const& method() const { return path_.method(); }

private:
    Path path_;
    typename Path::checkpoint_type from_;
};

namespace detail {

/// Whether a step of a method depends on all steps before it: such methods have a member has_history.
template <class Method>
inline constexpr bool has_history = requires {
    requires Method::has_history;
};

} // namespace detail

/// The trajectory of a method on T from (q0, p0), as a range of state<S, V>. @throws error::not_finite, error::mismatch as `along` does
template <class Method, time_scale_like Scale, class V>
class trajectory {
    using S = typename Scale::root_type::scalar_type;
    using memory = typename Method::template memory<S, V>;

public:
    using checkpoint_type = checkpoint<S, V, memory>;
    /// An input iterator; operator++ takes one step. @throws step_failure with the last good state
    class iterator {
    public:
        using iterator_concept = std::input_iterator_tag;
        using value_type = state<S, V>;
        using difference_type = index_type;
        explicit iterator(trajectory const& path)
            : path_(&path), memory_(moved(begun(path))), at_(path.start_), number_(path.T_.first()), last_(path.T_.last()) {}
        iterator(trajectory const& path, checkpoint_type const& from)
            : path_(&path), memory_(moved(begun(path, from))), at_(from.at), number_(from.number), last_(path.T_.last()) {}
        HILGER_ALWAYS_INLINE value_type const& operator*() const { return at_; }
        HILGER_ALWAYS_INLINE value_type const* operator->() const { return &at_; }
        HILGER_ALWAYS_INLINE iterator& operator++() {
            advance();
            return *this;
        }
        HILGER_ALWAYS_INLINE void operator++(int) { advance(); }
        /// The number of the current point of T.
        [[nodiscard]] index_type number() const { return number_; }
        /// The memory of the method there.
        [[nodiscard]] auto const& remembered() const { return memory_; }
        /// The argument of trajectory::resume, which continues bit for bit as if not stopped.
        [[nodiscard]] checkpoint_type checkpoint() const { return {at_, memory_, number_}; }
        friend bool operator==(iterator const& i, std::default_sentinel_t) { return i.number_ > i.last_; }

    private:
        HILGER_ALWAYS_INLINE void advance() {
            if (number_ >= last_) {
                ++number_;
                return;
            }
            if constexpr (equal_steps)
                memory_.advance_equally(path_->method_, at_);
            else {
                S const h = path_->step(number_);
                saying_where(at_, h, [&] { memory_.advance(path_->method_, at_, h); });
            }
            ++number_;
            at_.t = path_->T_.element(number_);
        }
        static constexpr bool equal_steps = Scale::root_type::is_uniform and
                                            detail::has_equal_steps<typename Scale::domain_type::base_type> and
                                            advances_equally<memory, Method, S, value_type>;
        // The preparation of the first step stays out of the user's loop: calls there would keep the state out of registers.
        [[gnu::noinline]] static memory begun(trajectory const& path) {
            index_type const first = path.T_.first();
            checkpoint_type from{path.start_, memory(path.method_, path.step(first), path.start_.q), first};
            if constexpr (requires(V const& v) { from.memory.start_with(path.method_, from.at, v); })
                if (path.velocity_)
                    saying_where(from.at, path.step(first), [&] { from.memory.start_with(path.method_, from.at, *path.velocity_); });
            return begun(path, std::move(from));
        }
        [[gnu::noinline]] static memory begun(trajectory const& path, checkpoint_type from) {
            if constexpr (equal_steps)
                if (from.number < path.T_.last()) {
                    S const h = path.step(from.number);
                    saying_where(from.at, h, [&] { from.memory.begin(path.method_, from.at, h); });
                }
            return std::move(from.memory);
        }
        /// A copy whose address has not escaped.
        HILGER_ALWAYS_INLINE static memory moved(memory&& begun) { return std::move(begun); }
        trajectory const* path_;
        memory memory_;
        value_type at_;
        index_type number_, last_;
    };

    trajectory(Method method, Scale T, V q0, V p0)
        : method_(std::move(method)), T_(std::move(T)), start_{T_.min(), std::move(q0), std::move(p0)} {
        if (not detail::all_finite(start_.q) or not detail::all_finite(start_.p))
            error::raise<error::not_finite>("the initial position and momentum are finite numbers, and these contain NaN or infinity");
        detail::require_same_dimension(start_.q, start_.p, "the initial position and momentum");
    }
    /// The velocity of the initial momentum, or one near it, where several have that momentum (L = v^4 - v^2).
    void starts_with(V velocity) { velocity_ = std::move(velocity); }
    [[nodiscard]] std::optional<V> const& starting_velocity() const { return velocity_; }
    [[nodiscard]] iterator begin() const& { return iterator(*this); }
    template <class Kept = trajectory>
    iterator begin() const&& {
        detail::trajectory_ends_here<Kept>();
        return iterator(*this);
    }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }
    [[nodiscard]] Scale const& scale() const { return T_; }
    [[nodiscard]] Method const& method() const { return method_; }
    /// The rest of the trajectory, beginning with the checkpoint's own state; T may extend beyond that of the checkpoint.
    /// @throws error::mismatch when the checkpoint's point is not the one of that number in T, or its memory is another problem's.
    [[nodiscard]] resumed<trajectory> resume(checkpoint_type from) const {
        if (from.number < T_.first() or T_.last() < from.number or not(T_.element(from.number) == from.at.t))
            error::raise<error::mismatch>("a trajectory on ", T_, " resumes from one of its points, and point ", from.number,
                                          " at t = ", from.at.t, " is none");
        detail::require_same_dimension(start_.q, from.at.q, "a trajectory and the checkpoint that it resumes from");
        if (from.number < T_.last()) {
            S const h = step(from.number);
            auto own = detail::transfer_memory(from.memory, method_, h, from.at.q);
            if constexpr (detail::has_history<Method>) // the other memory has its own orders and coefficients
                detail::require_same_step(
                    own, [&](auto const&, auto const&) { return from.memory; }, method_, from.at, h);
            else
                detail::require_its_own(own, method_, from.at, h);
            from.memory = std::move(own);
        }
        return {*this, std::move(from)};
    }

private:
    HILGER_ALWAYS_INLINE S step(index_type i) const { return T_.domain().base.step(T_.root(), i); }
    Method method_;
    Scale T_;
    state<S, V> start_;
    std::optional<V> velocity_;
};

} // namespace hilger
