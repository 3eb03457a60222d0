// SPDX-License-Identifier: BSL-1.0
// Solves some rows of an equation for the values at their points: those inside a step, or all between two ends.
#pragma once

#include <algorithm>
#include <sstream>
#include <utility>
#include <vector>

#include "hilger/integrator/march.hpp"
#include "hilger/newton/system.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/variational/relative_residual.hpp"
#include "hilger/variational/variation.hpp"

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
/// The roundings of a row: some tens of its terms and of the operations in L, independent of the number of points.
inline constexpr int most_roundings = 256;

/// The rows with the numbers from `begin` to `end` - 1 as an equation (newton/newton.hpp) for the values with these numbers in x, which
/// holds the values at all points of the equation, in order; a row reads values that are at most `reach` numbers from its own.
template <class Action, class V, class Force>
class rows_of_equation {
    using Root = typename Action::root_type;
    using s = shape<V>;
    using S = scalar_of<V>;

public:
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;

    rows_of_equation(euler_lagrange<Action> const& equation, Root const& T, std::vector<V>& x, index_type begin, index_type end,
                     index_type reach, Force const& force, char const* what, std::stop_token stop)
        : equation_(equation), T_(T), on_(T), x_(x), force_(force), derivatives_(equation.derivatives(force)), what_(what),
          stop_(std::move(stop)), begin_(begin), n_(static_cast<int>(end - begin)), d_(s::dimension(x[0])), near_(static_cast<int>(reach)) {
        std::vector<std::pair<int, int>> entries;
        for (int m = 0; m < n_ * d_; ++m)
            for (int k = first_near(m / d_) * d_; k < end_near(m / d_) * d_; ++k) entries.emplace_back(m, k);
        K_.prepare(n_ * d_, entries);
        most_ = std::max(S(magnitude(at(begin - 1))), S(magnitude(at(end))));
    }
    rows_of_equation(rows_of_equation const&) = delete;
    rows_of_equation& operator=(rows_of_equation const&) = delete;

    /// The values with the numbers of the rows.
    [[nodiscard]] vector unknown(std::vector<V> const& of) const {
        vector y(n_ * d_);
        for (int m = 0; m < n_; ++m)
            for (int c = 0; c < d_; ++c) y(m * d_ + c) = s::component(of[static_cast<std::size_t>(begin_ + m)], c);
        return y;
    }
    void put(vector const& y) {
        for (int m = 0; m < n_; ++m)
            for (int c = 0; c < d_; ++c) s::component(at(begin_ + m), c) = y(m * d_ + c);
    }
    /// The part of the time interval: the smaller it is, the nearer a straight line is to the root. 1 is the equation itself.
    void set_share(S const& part) { on_ = part == S(1) ? T_ : shortened(T_, part); }
    S evaluate(vector const& y, vector& r) {
        put(y);
        auto const residual = equation_.residual(now_, force_); // on the current T
        for (int m = 0; m < n_; ++m) {
            V const row = residual.get(begin_ + m);
            for (int c = 0; c < d_; ++c) r(m * d_ + c) = s::component(row, c);
        }
        return S(largest_ * std::max(most_, S(magnitude(y))));
    }
    bool linearize() {
        K_.set_zero();
        for (int k = 0; k < n_; ++k) {
            stop_on_request(stop_, what_);
            for_each_slope(k, [&](int row, int column, S const& y) { K_[K_.place(row, k * d_ + column)] = y; });
        }
        largest_ = K_.largest();
        return K_.factorize();
    }
    void correct(vector const& r, vector& d) const {
        d = r;
        K_.solve(d);
        d = -d;
    }
    /// The relative residual at the last values (variational/relative_residual.hpp).
    [[nodiscard]] S roundings_of(vector const& r) const {
        auto const sizes_of_terms = sizes_of_rows(equation_, now_, begin_, begin_ + n_ - 1, derivatives_);
        S worst(0);
        for (int m = 0; m < n_ * d_; ++m)
            worst = larger(worst, in_roundings<S>(r(m), s::component(sizes_of_terms[static_cast<std::size_t>(m / d_)], m % d_)));
        return worst;
    }
    /// Corrects y as long as this halves its residual in roundings, which is returned: where the derivative is nearly singular, a small
    /// correction does not prove that the equation is solved; and one more correction makes elimination as exact in each row as in the
    /// largest (Skeel 1980).
    S polish(vector& y) {
        vector r = y, d = y, next = y;
        evaluate(y, r);
        S rest = roundings_of(r);
        for (int k = 0; k < 6 and S(1) < rest and linearize(); ++k) {
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
    /// by these columns of K^-1 alone. It is 1 for a straight line and less than 2 / |sin T| for an oscillator on [0, T], in any units and
    /// steps, where the norm of K^-1 itself grows with the number of points.
    S response_to_ends() {
        if (not linearize()) return S(1) / epsilon<S>();
        std::vector<vector> from_ends(static_cast<std::size_t>(2 * d_), vector::Zero(n_ * d_));
        for (int const k : {-1, n_})
            for_each_slope(
                k, [&](int row, int column, S const& y) { from_ends[static_cast<std::size_t>(k < 0 ? column : d_ + column)](row) = y; });
        vector const unit = component_sizes();
        vector changes = vector::Zero(n_ * d_);
        for (std::size_t c = 0; c < from_ends.size(); ++c) {
            K_.solve(from_ends[c]);
            for (index_type m = 0; m < changes.size(); ++m)
                changes(m) += magnitude(from_ends[c](m)) * unit(static_cast<index_type>(c) % d_) / unit(m % d_);
        }
        return magnitude(changes);
    }

private:
    [[nodiscard]] V& at(index_type j) const { return x_[static_cast<std::size_t>(j)]; }
    [[nodiscard]] int first_near(int m) const { return std::max(0, m - near_); }
    [[nodiscard]] int end_near(int m) const { return std::min(n_, m + near_ + 1); }
    /// use(row, component, derivative of the row by this component of value k)
    template <class Use>
    void for_each_slope(int k, Use const& use) const {
        auto const slope = equation_.residual_slope(now_, begin_ + k, derivatives_);
        for (int m = first_near(k); m < end_near(k); ++m) {
            auto const block = slope.get(begin_ + m);
            for (int c = 0; c < d_; ++c)
                for (int e = 0; e < d_; ++e) use(m * d_ + c, e, s::entry(block, c, e));
        }
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

    euler_lagrange<Action> const& equation_;
    Root const& T_;
    Root on_; ///< shorter, on the way
    std::vector<V>& x_;
    Force const& force_;
    decltype(equation_.derivatives(force_)) derivatives_;
    values_so_far<V, Root, typename Action::position_type::from> const now_{{}, &on_, &x_};
    char const* what_;
    std::stop_token stop_;
    index_type begin_;
    int n_, d_, near_;
    patterned_matrix<S> K_;
    S most_{0}, largest_{0}; ///< of the values beside the unknown ones; of the entries of K
};

/// The values of `x` with the numbers from `begin` to `end` - 1, such that the rows of the equation with these numbers hold: a root next to
/// the present values or, where `straight_line` is given, near them, by decreasing corrections; where these find no root, the one to which
/// motions in less time lead, if it is not far away. The other arguments are those of rows_of_equation, and `what` names the rows in
/// messages. A root solves its rows to the rounding of their terms. Returns the response of the values to those at both sides, where
/// `straight_line` is given.
/// @throws newton_failure, an error::no_convergence; error::singular, error::not_finite
template <class Action, class V, class Force>
auto solve_rows(euler_lagrange<Action> const& equation, typename Action::root_type const& T, std::vector<V>& x, index_type begin,
                index_type end, index_type reach, Force const& force, char const* what, std::vector<V> const* straight_line = nullptr,
                solvability const& by = by_the_velocity, std::stop_token const& stop = {}) {
    using S = scalar_of<V>;
    using rows_type = rows_of_equation<Action, V, Force>;
    using vector = typename rows_type::vector;
    rows_type rows(equation, T, x, begin, end, reach, force, what, stop);
    auto const evaluate = [&](vector const& y, vector& r) { return rows.evaluate(y, r); };
    auto const linearize = [&] { return rows.linearize(); };
    auto const correct = [&](vector const& r, vector& d) { rows.correct(r, d); };
    newton_equation<vector> const f{evaluate, linearize, correct, true};
    unwatched const inside;
    vector const guess = rows.unknown(x);
    vector y = guess, r = guess;
    newton_outcome const how = newton<vector>(f, y, r, corrections::smaller);
    if (straight_line == nullptr or std::numeric_limits<S>::is_exact) {
        if (how != newton_outcome::found) throw_newton_failure(what, how, y, r, by);
        rows.put(y);
        return S(0);
    }
    vector const first = y, first_rest = r;
    S rest = how == newton_outcome::found ? rows.polish(y) : S(2 * most_roundings);
    bool found = how == newton_outcome::found;
    if (not(rest <= S(most_roundings))) {
        S const quarter = S(1) / S(4);
        bool const arrives = continued<vector>(f, y, rows.unknown(*straight_line), r, {S(0), quarter, quarter / S(8)}, corrections::smaller,
                                               [&](S const& part) { rows.set_share(part); }) and
                             magnitude(vector(y - guess)) <= S(4) * magnitude(guess);
        found = found or arrives;
        if (arrives) rest = rows.polish(y);
    }
    if (not found) throw_newton_failure(what, how, first, first_rest, by);
    if (not(rest <= S(most_roundings))) {
        std::ostringstream message;
        message << what << " did not converge: what is nearest to a solution leaves " << rest
                << " times the rounding of the terms of a row, and a solution less than " << most_roundings << ". " << by.advice;
        throw newton_failure<vector>(message.str(), y, r);
    }
    return rows.response_to_ends();
}

} // namespace hilger::detail
