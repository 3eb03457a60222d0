// SPDX-License-Identifier: BSL-1.0
// Some rows of an equation for the values at their points: those inside a step, or all between two ends.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hilger/integrator/flow.hpp"
#include "hilger/linear/condensed_matrix.hpp"
#include "hilger/newton/stop.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/step/action_of_step.hpp"
#include "hilger/variational/relative_residual.hpp"

namespace hilger::detail {

/// Puts a straight line between the values with the numbers `begin` - 1 and `end`.
template <class V>
void put_straight_line(std::vector<V>& x, index_type begin, index_type end) {
    using S = scalar_of<V>;
    auto const at = [&](index_type j) -> V& { return x[static_cast<std::size_t>(j)]; };
    V const first = at(begin - 1), displacement = at(end) - first;
    for (index_type j = begin; j < end; ++j) at(j) = first + displacement * (S(j - begin + 1) / S(end - begin + 1));
}
/// T with its steps in proportion, so that it ends after a part of the time. @throws error::invalid_scale where no step is left
template <class S>
uniform_scale<S> shortened(uniform_scale<S> const& T, S const& part) {
    S const a = T.element(0);
    return {a, S(T.h() * part), S(a + (T.element(T.steps()) - a) * part), T.steps()};
}
template <class S>
time_scale<S> shortened(time_scale<S> const& T, S const& part) {
    S const a = T.element(0);
    std::vector<S> points;
    for (S const& t : T) points.push_back(S(a + (t - a) * part));
    return time_scale<S>(std::move(points));
}

/// The rows inside the steps from `begin` to `end` - 1 and between them, as an equation (newton/newton.hpp) for the values there, which are
/// some of x, the values at all points of the equation of a flow, in order. Each row is the derivative of the action by one value.
template <class Flow, class Root, class V>
class rows_of_equation {
    using s = shape<V>;
    using S = scalar_of<V>;
    using embedding_type = std::remove_cvref_t<decltype(std::declval<Flow const&>().embedding())>;
    static constexpr int parts = controls_of<embedding_type> - 1;

public:
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

    rows_of_equation(Flow const& flow, Root const& T, std::vector<V>& x, index_type begin, index_type end, int most_work, char const* what,
                     std::stop_token stop)
        : flow_(flow), problem_(flow.mechanics()), T_(T), on_(T), x_(x), what_(what), stop_(std::move(stop)), begin_(begin), end_(end),
          work_left_(most_work), n_(static_cast<int>(parts * (end - begin)) - 1), d_(s::dimension(x[0])), step_(x[0]), K_(end - begin, d_) {
        most_ = std::max(S(magnitude(at(-1))), S(magnitude(at(n_))));
    }
    rows_of_equation(rows_of_equation const&) = delete;
    rows_of_equation& operator=(rows_of_equation const&) = delete;

    /// The values with the numbers of the rows.
    [[nodiscard]] vector unknown(std::vector<V> const& of) const {
        vector y(n_ * d_);
        for (int m = 0; m < n_; ++m)
            for (int c = 0; c < d_; ++c) y(m * d_ + c) = s::component(of[number(m)], c);
        return y;
    }
    void put(vector const& y) {
        for (int m = 0; m < n_; ++m)
            for (int c = 0; c < d_; ++c) s::component(at(m), c) = y(m * d_ + c);
    }
    /// The part of the time interval: the smaller it is, the nearer a straight line is to the root. 1 is the equation itself.
    void set_share(S const& part) {
        on_ = part == S(1) ? T_ : shortened(T_, part);
        is_regular_ = false;
    }
    S evaluate(vector const& y, vector& r) {
        put(y);
        r.setZero();
        --work_left_;
        for_each_step(wanted::first_order, [&](index_type, int first, int from, int to) {
            step_.put_residual();
            for (int k = from; k < to; ++k) r(first + k) += step_.residual(k);
        });
        return S(K_.largest() * std::max(most_, S(magnitude(y))));
    }
    /// Factorizes the derivative at the last values, or keeps the factors at values that are nearly the same. @returns false if it is
    /// singular, or where all work is done
    bool linearize() { return 0 < work_left_ and (is_nearly_linearized() or factorize()); }
    void correct(vector const& r, vector& d) const {
        d = -r;
        K_.solve(d);
    }
    /// The residual at y, into r, in roundings of the terms of its rows (variational/relative_residual.hpp), which is returned.
    S roundings_at(vector const& y, vector& r) {
        evaluate(y, r);
        factorize();
        return roundings_of(r);
    }
    /// Corrects y as long as this halves its residual in roundings, which is returned: where the derivative is nearly singular, a small
    /// correction does not prove that the equation is solved; and one more correction makes elimination as exact in each row as in the
    /// largest (Skeel 1980). The corrections are so small that one derivative is enough.
    S polish(vector& y) {
        vector r = y, d = y, next = y;
        S rest = roundings_at(y, r);
        for (int k = 0; k < 6 and S(1) < rest and is_regular_; ++k) {
            correct(r, d);
            next = y + d;
            evaluate(next, r);
            S const now = roundings_of(r);
            if (not all_finite(r) or not(now < rest)) break;
            bool const halved = S(2) * now < rest;
            y = next;
            rest = now;
            if (not halved) break;
        }
        put(y);
        return rest;
    }
    /// The largest change of the unknown values for changes of 1 of the values beside them, each relative to the largest of its component,
    /// by these columns of K^-1 alone, at the last derivative. It is 1 for a straight line and less than 2 / |sin T| for an oscillator on
    /// [0, T], in any units and steps, where the norm of K^-1 itself grows with the number of points.
    [[nodiscard]] S response_to_ends() const {
        if (not is_regular_) return S(1) / epsilon<S>();
        vector const unit = component_sizes();
        vector changes = vector::Zero(n_ * d_), column(n_ * d_);
        for (bool const front : {true, false})
            for (int e = 0; e < d_; ++e) {
                column.setZero();
                if (front)
                    column.head(before_.rows()) = before_.col(e);
                else
                    column.tail(behind_.rows()) = behind_.col(e);
                K_.solve(column);
                for (index_type m = 0; m < changes.size(); ++m) changes(m) += magnitude(column(m)) * unit(e) / unit(m % d_);
            }
        return magnitude(changes);
    }

private:
    using block = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    /// The number in x of value m, which is unknown for 0 <= m < n_.
    [[nodiscard]] std::size_t number(int m) const { return static_cast<std::size_t>(parts * begin_ + 1 + m); }
    [[nodiscard]] V& at(int m) const { return x_[number(m)]; }
    [[nodiscard]] bool is_nearly_linearized() const {
        if (not is_regular_ or std::numeric_limits<S>::is_exact) return false;
        vector const near = component_sizes() * S(S(1) / S(1 << 24));
        for (int k = 0; k < n_ * d_; ++k)
            if (not(magnitude(S(s::component(at(k / d_), k % d_) - linearized_at_(k))) <= near(k % d_))) return false;
        return true;
    }
    bool factorize() {
        stop_on_request(stop_, what_);
        work_left_ -= 4;
        K_.set_zero();
        sizes_.setZero(n_ * d_);
        int const end = parts * d_;
        for_each_step(wanted::with_seconds, [&](index_type i, int first, int from, int to) {
            step_.put_slope();
            step_.put_sizes(&at(static_cast<int>(parts * i) - 1));
            for (int k = from; k < to; ++k) sizes_(first + k) += step_.sizes(k);
            K_.add(i, step_.slope);
            if (i == 0) before_ = step_.slope.block(from, 0, to - from, d_);
            if (i + 1 == end_ - begin_) behind_ = step_.slope.block(from, end, to - from, d_);
        });
        linearized_at_ = unknown(x_);
        return is_regular_ = K_.factorize();
    }
    /// Calls use(number, row of its first component, its components from `from` to `to` - 1 that have a row) for each step, evaluated.
    template <class Use>
    void for_each_step(wanted which, Use const& use) {
        for (index_type i = begin_; i < end_; ++i) {
            S const h = on_.step(i);
            if (not(step_.h() == h)) step_.prepare(tableau_of(flow_.embedding(), h), h);
            int const first = static_cast<int>(parts * (i - begin_)) - 1;
            step_.evaluate(problem_, S(on_.element(i)), &at(first), which);
            use(i - begin_, first * d_, i == begin_ ? d_ : 0, (i + 1 == end_ ? parts : parts + 1) * d_);
        }
    }
    [[nodiscard]] S roundings_of(vector const& r) const {
        S worst(0);
        for (int k = 0; k < n_ * d_; ++k) worst = larger(worst, in_roundings<S>(r(k), sizes_(k)));
        return worst;
    }
    /// The largest value of each component; for a component that is zero the largest of all.
    [[nodiscard]] vector component_sizes() const {
        vector sizes = vector::Zero(d_);
        for (V const& value : x_)
            for (int c = 0; c < d_; ++c) sizes(c) = std::max(sizes(c), S(magnitude(s::component(value, c))));
        S const largest = magnitude(sizes);
        for (int c = 0; c < d_; ++c)
            if (sizes(c) == S(0)) sizes(c) = largest == S(0) ? S(1) : largest;
        return sizes;
    }

    Flow const& flow_;
    given<typename Flow::problem_type, V> const problem_;
    Root const& T_;
    Root on_; ///< shorter, on the way
    std::vector<V>& x_;
    char const* what_;
    std::stop_token stop_;
    index_type begin_, end_;
    int work_left_; ///< in evaluations of the residual
    int n_, d_;
    action_of_step<S, V, parts + 1> step_;
    condensed_matrix<S, s::size, parts> K_;
    block before_, behind_; ///< the derivatives of the rows of the first step by the value before them, of the last by that behind them
    vector sizes_, linearized_at_; ///< of the terms of the rows; the values at which K is the derivative
    bool is_regular_ = false;
    S most_{0}; ///< the larger one of the values beside the unknown ones
};

} // namespace hilger::detail
