// SPDX-License-Identifier: BSL-1.0
// A time scale that follows the motion: T is made step by step, for a Galerkin flow. The error of a velocity, times the rest of the
// interval, is kept below a tolerance; a step that exceeds it (accuracy/step_shape.hpp) is refused and made again.
#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>
#include <vector>

#include "hilger/accuracy/step_shape.hpp"
#include "hilger/integrator/flow.hpp"

namespace hilger::detail {

/// The states at the points of a scale, and the steps that were made for them, with those refused.
template <class S, class V>
struct walked_states {
    std::vector<S> t;
    std::vector<V> q, p;
    index_type made = 0;
    bool is_rough = false; ///< L has branches, or a force jumps
    void keep(state<S, V> const& x) {
        t.push_back(x.t);
        q.push_back(x.q);
        p.push_back(x.p);
    }
    /// @returns the state before the last
    state<S, V> take_back() {
        t.pop_back();
        q.pop_back();
        p.pop_back();
        return {t.back(), q.back(), p.back()};
    }
    [[nodiscard]] index_type steps() const { return static_cast<index_type>(t.size()) - 1; }
};

/// The points of a walk from number `begin` to `end` divided into half as many steps again, without the first.
template <class S>
std::vector<S> other_points(std::vector<S> const& t, std::size_t begin, std::size_t end) {
    std::size_t const n = end - begin, m = n + n / 2 + 1;
    std::vector<S> made;
    for (std::size_t j = 1; j < m; ++j) {
        std::size_t const i = begin + j * n / m;
        S const x = t[i] + (t[i + 1] - t[i]) * (S(static_cast<double>(j * n % m)) / S(static_cast<double>(m)));
        if ((made.empty() ? t[begin] : made.back()) < x and x < t[end]) made.push_back(x);
    }
    made.push_back(t[end]);
    return made;
}

/// Walks of a Galerkin flow of this degree over the pieces between `ends`, which make their scale. `watch`, called now and then with the
/// number of steps, may end them by an exception.
template <int Degree, class Flow, class S, class V, class Watch>
class adapted_steps {
    using stepper = typename Flow::template stepper<S, V>;
    using walk = walked_states<S, V>;
    using shape_of_step = step_shape<Degree, S, V>;

public:
    adapted_steps(Flow const& flow, std::vector<S> const& ends, initial_velocity<V> const& from, Watch const& watch)
        : flow_(flow), ends_(ends), v_(from.v0),
          watch_(watch), first_{ends.front(), from.q0, flow.momentum(ends.front(), from.q0, from.v0)} {}

    /// Steps of at most `longest` for a tolerance of the position, a function of its largest magnitude so far. @throws step_failure, with
    /// the last state, where no step is short enough
    template <class Tolerance>
    walk adapted_to(Tolerance const& tolerance, S const& longest) const {
        walk all;
        all.keep(first_);
        state<S, V> x = first_;
        S const whole = ends_.back() - ends_.front();
        S h = std::min(longest, S((ends_[1] - ends_[0]) / S(1024))), size = magnitude(x.q), fastest(0);
        branch_watch const branches;
        auto by = stepper_from_start(h);
        noise_of_velocity<S> noise;
        S farthest = x.t; // from where a step was taken back
        int backs = 0;    // up to there
        for (std::size_t k = 1; k < ends_.size(); ++k)
            for (std::optional<shape_of_step> last{}; x.t < ends_[k];) {
                count(all);
                S const to = end_of_step(x.t, h, ends_[k]);
                // In less than this no time, or no position, changes.
                S const unit = epsilon<S>() * std::max({S(magnitude(x.t)), S(epsilon<S>() * whole), time_of(S(magnitude(x.q)), fastest)});
                h = to - x.t;
                state<S, V> next = x;
                if (auto const failure = advance(by, next, h)) {
                    if (h <= S(16) * unit) no_shorter(x, h, failure);
                    h = h / S(4);
                    continue;
                }
                size = std::max(size, S(magnitude(next.q)));
                shape_of_step const shape([&](int m) { return by.inside(m); }, x.q, h, S(noise.level * h));
                S const allowed = tolerance(size) * (h / whole), error = shape.error();
                if (not(error <= allowed) and not noise.is_seen(shape, h <= S(16) * unit)) {
                    if (h <= S(16) * unit) no_shorter(x, h, {});
                    h = h * std::min(change_of_length(error, allowed), S(S(1) / S(2)));
                } else if (last and backs < 24 and S(1024) * unit < last->h and allowed < shape_of_step::hidden_between(*last, shape)) {
                    ++backs;
                    farthest = std::max(farthest, x.t);
                    h = last->h / S(4);
                    last.reset();
                    x = all.take_back();
                    all.is_rough = true;
                } else {
                    fastest = std::max(fastest, S(magnitude(V(next.q - x.q)) / h));
                    x = {to, next.q, next.p};
                    all.keep(x);
                    all.is_rough = all.is_rough or shape.is_rough();
                    last = shape;
                    h = std::min(longest, S(h * change_of_length(error, allowed)));
                    h = std::max(h, noise.step_is_taken());
                    if (farthest < x.t) backs = 0;
                }
            }
        all.is_rough = all.is_rough or branches.saw_any();
        return all;
    }
    /// Half as many steps again, at other points but for the ends of pieces; `beside` becomes the positions at the points of the given
    /// walk, each by a step aside. @throws step_failure
    walk at_other_points(walk const& given, std::vector<V>& beside) const {
        walk all;
        all.keep(first_);
        beside.assign(1, first_.q);
        state<S, V> x = first_;
        auto by = stepper_from_start(S(given.t[1] - given.t[0])), aside = by;
        std::size_t begin = 0, i = 1;
        for (std::size_t k = 1; k < ends_.size(); ++k) {
            auto const end = static_cast<std::size_t>(std::lower_bound(given.t.begin(), given.t.end(), ends_[k]) - given.t.begin());
            for (S const& to : other_points(given.t, begin, end)) {
                for (; given.t[i] < to; ++i) {
                    state<S, V> there = x;
                    if (auto const failure = advance(aside, there, S(given.t[i] - x.t))) std::rethrow_exception(failure);
                    beside.push_back(there.q);
                }
                count(all);
                if (auto const failure = advance(by, x, S(to - x.t))) std::rethrow_exception(failure);
                x.t = to;
                all.keep(x);
                if (given.t[i] == to) {
                    beside.push_back(x.q);
                    ++i;
                }
            }
            begin = end;
        }
        return all;
    }

private:
    stepper stepper_from_start(S const& h) const {
        stepper by(flow_, h, first_.q);
        by.do_not_search();
        by.start_with(flow_, first_, v_);
        return by;
    }
    static S time_of(S const& length, S const& velocity) { return velocity > S(0) ? S(length / velocity) : S(0); }
    void count(walk& all) const {
        if (all.made % 256 == 0) watch_(all.made);
        ++all.made;
    }
    /// A step that would leave a short rest ends where the piece does, or half way there.
    static S end_of_step(S const& t, S const& h, S const& end) {
        S const left = end - t;
        if (left <= h * (S(1) + S(1) / S(64))) return end;
        return left < S(2) * h ? S(t + left / S(2)) : S(t + h);
    }
    /// What ended the step, if anything did.
    std::exception_ptr advance(stepper& by, state<S, V>& x, S const& h) const {
        try {
            saying_where(x, h, [&] { by.advance(flow_, x, h); });
        } catch (error::no_convergence const&) {
            return std::current_exception();
        } catch (error::not_finite const&) {
            return std::current_exception();
        } catch (error::singular const&) {
            return std::current_exception();
        }
        return {};
    }
    /// What ended the shortest step is said unless it was Newton's method, for which a shorter one would do.
    [[noreturn]] static void no_shorter(state<S, V> const& x, S const& h, std::exception_ptr const& failure) {
        try {
            if (failure) std::rethrow_exception(failure);
        } catch (error::no_convergence const&) {}
        stop_at(x, h, error::no_convergence("no step is short enough: a position, a velocity or a force grows without bound"));
    }
    /// The next length as a part of this one.
    static S change_of_length(S const& error, S const& allowed) {
        if (error == S(0)) return S(2);
        if (not is_finite(error)) return S(1) / S(4);
        return S(std::clamp(0.8 * std::pow(static_cast<double>(S(allowed / error)), 1.0 / (2 * Degree - 1)), 0.125, 2.0));
    }

    Flow const& flow_;
    std::vector<S> const& ends_; ///< of the pieces
    V v_;
    Watch const& watch_;
    state<S, V> first_;
};

} // namespace hilger::detail
