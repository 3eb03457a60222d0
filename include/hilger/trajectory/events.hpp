// SPDX-License-Identifier: BSL-1.0
// The zeros of a real function g of the state along a trajectory: Poincare sections, periods, impacts. A change of sign between two points
// is located to the scalar's epsilon (Alefeld, Potra, Shi, algorithm 748) by shorter steps of the method from the first of them
// (partial_step.hpp), so that events are as accurate as the points; with a history on the cubic of dense_output.hpp. Nothing is stored.
//   for (auto const& x : events(path, g, crossing::rising)) ...        the states where g passes zero
//   for (auto const& x : until(path, g)) ...                           the states up to there, and that one last
// The events of a g that is true or false are its changes, rising where it becomes true. An event is where g, not zero before, reaches or
// passes zero within a step: g = 0 at the start is none. Two within one step are not seen.
#pragma once

#include <algorithm>
#include <limits>

#include <boost/math/tools/toms748_solve.hpp>

#include "hilger/trajectory/dense_output.hpp"

namespace hilger {

/// The direction of events: g from negative to positive, from positive to negative, or both.
enum class crossing { any, rising, falling };

namespace detail {

/// The first fraction of a step at or behind the zero of g, whose values at its ends have different signs.
template <class S, class G>
S fraction_at_zero(G const& g, S const& was, S const& now) {
    auto const near_enough = [](S const& left, S const& right) { return right - left <= epsilon<S>(); };
    std::uintmax_t most = 1000; // bisection alone would need one iteration for each binary digit
    return boost::math::tools::toms748_solve(g, S(0), S(1), was, now, near_enough, most).second;
}

/// Advances along a trajectory and detects sign changes of g.
template <class Path, class G>
class crossing_search {
    using walk = decltype(std::declval<Path const&>().begin());

public:
    using state_type = typename walk::value_type;
    using S = decltype(state_type::t);
    static_assert(not std::numeric_limits<S>::is_exact, "events are located by root finding, which an exact scalar has not");

    crossing_search(Path const& path, G const& g, crossing which)
        : method_(&path.method()), kept_(derivatives_of(*method_)), g_(&g), which_(which), walk_(path.begin()), before_(*walk_),
          now_(value(before_)) {}
    [[nodiscard]] bool ended() const { return walk_ == std::default_sentinel; }
    [[nodiscard]] state_type const& state() const { return *walk_; }
    /// One step; true when there was an event in it, unless that step would lead beyond the end. A pole, where |g| is larger than at both
    /// ends of the step, is none.
    bool step() {
        before_ = *walk_;
        was_ = now_;
        ++walk_;
        if (ended()) return false;
        now_ = value(*walk_);
        S const zero(0);
        bool const rising = was_ < zero and not(now_ < zero), falling = zero < was_ and not(zero < now_);
        if (not((rising and which_ != crossing::falling) or (falling and which_ != crossing::rising))) return false;
        auto const inside = states_inside();
        S const largest = std::max(S(magnitude(was_)), S(magnitude(now_)));
        bool const stays = now_ == zero;
        // At a pole g may be infinite, with the sign of its side. Where it stays zero, as a penetration does, its first zero is located.
        auto const below_infinity = [&](S const& x) {
            S const y = number(inside(x)), most = (std::numeric_limits<S>::max)();
            if (stays and y == zero) return S(-was_);
            return most < y ? most : y < -most ? S(-most) : finite(y, S(before_.t + x * (walk_->t - before_.t)));
        };
        located_ = inside(fraction_at_zero(below_infinity, was_, stays ? S(-was_) : now_));
        return magnitude(number(located_)) <= largest;
    }
    /// The first state at or behind the zero of g that step() found.
    [[nodiscard]] state_type const& located() const { return located_; }

private:
    using method = std::remove_cvref_t<decltype(std::declval<Path const&>().method())>;
    /// The states at fractions of the last step.
    auto states_inside() const {
        if constexpr (has_history<method>) {
            auto const near = mean_velocity(before_, *walk_);
            return [cubic = dense_step(before_, slopes_on(walk_, kept_, before_, near, true), *walk_,
                                       slopes_on(walk_, kept_, *walk_, near, false))](S const& x) { return cubic.at_fraction(x); };
        } else
            return [this](S const& x) {
                return x == S(1) ? *walk_ : partial_step(*method_, walk_.remembered(), before_, S(x * (walk_->t - before_.t)));
            };
    }
    S number(state_type const& x) const {
        if constexpr (std::same_as<std::remove_cvref_t<decltype((*g_)(x))>, bool>)
            return S((*g_)(x) ? 1 : -1);
        else
            return S((*g_)(x));
    }
    /// @throws error::not_finite
    static S finite(S const& y, S const& t) {
        if (not is_finite(y)) error::raise<error::not_finite>("the function whose zeros are events is NaN or infinite at t = ", t);
        return y;
    }
    S value(state_type const& x) const { return finite(number(x), x.t); }
    method const* method_;
    [[no_unique_address]] decltype(derivatives_of(std::declval<method const&>())) kept_;
    G const* g_;
    crossing which_;
    walk walk_;
    state_type before_, located_{before_};
    S now_, was_{0};
};

template <class Path, class G>
constexpr void require_function_of_a_state() {
    static_assert(std::invocable<G const&, typename crossing_search<Path, G>::state_type const&>,
                  "events are where a function of a state passes zero, as [](auto const& x) { return x.q; } does");
}
/// The states at the events (Until: the states up to the first event, which is the last of them).
template <class Path, class G, bool Until>
class event_range {
    using search = crossing_search<Path, G>;

public:
    class iterator {
    public:
        using iterator_concept = std::input_iterator_tag;
        using value_type = typename search::state_type;
        using difference_type = index_type;
        explicit iterator(event_range const& range) : search_(range.path_, range.g_, range.which_), at_(search_.state()) {
            if constexpr (not Until) advance();
        }
        value_type const& operator*() const { return at_; }
        value_type const* operator->() const { return &at_; }
        iterator& operator++() {
            advance();
            return *this;
        }
        void operator++(int) { advance(); }
        friend bool operator==(iterator const& i, std::default_sentinel_t) { return i.done_; }

    private:
        void advance() {
            if constexpr (Until) {
                if (not stopped_) {
                    stopped_ = search_.step();
                    done_ = search_.ended();
                    if (not done_) at_ = stopped_ ? search_.located() : search_.state();
                } else
                    done_ = true;
            } else {
                while (not search_.step())
                    if (search_.ended()) {
                        done_ = true;
                        return;
                    }
                at_ = search_.located();
            }
        }
        search search_;
        value_type at_;
        bool stopped_ = false, done_ = false;
    };
    event_range(Path path, G g, crossing which) : path_(std::move(path)), g_(std::move(g)), which_(which) {}
    [[nodiscard]] iterator begin() const& { return iterator(*this); }
    template <class Kept = Path>
    iterator begin() const&& {
        trajectory_ends_here<Kept>();
        return iterator(*this);
    }
    [[nodiscard]] std::default_sentinel_t end() const { return {}; }
    [[nodiscard]] auto const& scale() const { return path_.scale(); }

private:
    Path path_;
    G g_;
    crossing which_;
};

} // namespace detail

/// A range of the states at which g(state), a number or bool, passes zero, found during iteration. @throws error::not_finite when g is NaN
/// or infinite, and as the trajectory does
template <class Path, class G>
auto events(Path path, G g, crossing which = crossing::any) {
    detail::require_function_of_a_state<Path, G>();
    return detail::event_range<Path, G, false>(std::move(path), std::move(g), which);
}
/// The states of the trajectory up to the first event, with the state at that event as the last one; all of them when there is none.
/// @throws as events does
template <class Path, class G>
auto until(Path path, G g, crossing which = crossing::any) {
    detail::require_function_of_a_state<Path, G>();
    return detail::event_range<Path, G, true>(std::move(path), std::move(g), which);
}

} // namespace hilger
