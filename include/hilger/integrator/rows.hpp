// SPDX-License-Identifier: BSL-1.0
// Some values of a function such that the rows of an equation beside them hold: those inside a step, or all between two ends.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "hilger/integrator/march.hpp"
#include "hilger/newton/near.hpp"
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
    V const first = at(begin - 1), way = at(end) - first;
    for (index_type j = begin; j < end; ++j) at(j) = first + way * (S(j - begin + 1) / S(end - begin + 1));
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
/// By how much at most the unknown values of a system change, for changes of 1 of the values beside them that `from_ends` has the
/// derivatives by, each value in units of its component's largest one: K^-1 is asked for these columns alone. That is 1 for a straight line
/// and less than 2 / |sin T| for an oscillator on [0, T], in any units and steps, where the norm of K^-1 itself grows with the number of
/// points.
template <class S, class Vector>
S response_to_ends(patterned_matrix<S>& K, std::vector<Vector> from_ends, Vector const& component_sizes) {
    if (not K.is_factorized() and not K.factorize()) return S(1) / epsilon<S>();
    auto const d = component_sizes.size();
    Vector changes = Vector::Zero(K.size());
    for (std::size_t c = 0; c < from_ends.size(); ++c) {
        Vector& change = from_ends[c];
        K.solve(change);
        for (index_type m = 0; m < changes.size(); ++m)
            changes(m) += magnitude(change(m)) * component_sizes(static_cast<index_type>(c) % d) / component_sizes(m % d);
    }
    return magnitude(changes);
}
/// The values of `x` with the numbers from `begin` to `end` - 1, such that the rows of the equation with these numbers hold: next to
/// those that there are or, where `straight_line` has values on one, near them. `x` has the values at all points that the equation reads,
/// in their order, and there are some before and behind the unknown ones; a row reads values that are at most `reach` numbers from its own.
/// `what` names the rows in messages. Returns how strongly the values respond to those at both sides, where `straight_line` has values.
/// @throws newton_failure, an error::no_convergence; error::singular, error::not_finite
template <class Action, class V, class Force>
auto solve_rows(euler_lagrange<Action> const& equation, typename Action::root_type const& T, std::vector<V>& x, index_type begin,
                index_type end, index_type reach, Force const& force, char const* what, std::vector<V> const* straight_line = nullptr,
                solvability const& by = by_the_velocity, std::stop_token const& stop = {}) {
    using s = shape<V>;
    using S = scalar_of<V>;
    using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
    auto const at = [&](index_type j) -> V& { return x[static_cast<std::size_t>(j)]; };
    auto on = T; // shorter, on the way
    S length(1);
    values_so_far<V, typename Action::root_type, typename Action::position_type::from> const now{{}, &on, &x};
    int const n = static_cast<int>(end - begin), d = s::dimension(x[0]), near = static_cast<int>(reach);
    auto const first_near = [&](int m) { return std::max(0, m - near); };
    auto const end_near = [&](int m) { return std::min(n, m + near + 1); };
    std::vector<std::pair<int, int>> entries;
    for (int m = 0; m < n * d; ++m)
        for (int k = first_near(m / d) * d; k < end_near(m / d) * d; ++k) entries.emplace_back(m, k);
    patterned_matrix<S> empty;
    empty.prepare(n * d, entries);

    auto const put = [&](vector const& y) {
        for (int m = 0; m < n; ++m)
            for (int c = 0; c < d; ++c) s::component(at(begin + m), c) = y(m * d + c);
    };
    auto const derivatives = equation.derivatives(force);
    auto const system = [&](vector const& y, S const& part) {
        put(y);
        if (not(part == length)) on = part == S(1) ? T : shortened(T, part);
        length = part;
        newton_system<vector, patterned_matrix<S>> made{vector(n * d), empty};
        made.jacobian.set_zero();
        for (int k = 0; k < n; ++k) {
            stop_on_request(stop, what);
            auto const slope = equation.residual_slope(now, begin + k, derivatives);
            for (int m = first_near(k); m < end_near(k); ++m) {
                auto const block = slope.get(begin + m);
                for (int c = 0; c < d; ++c)
                    for (int e = 0; e < d; ++e) made.jacobian[made.jacobian.place(m * d + c, k * d + e)] = s::entry(block, c, e);
            }
        }
        auto const residual = equation.residual(now, force); // of the T that there is now
        for (int m = 0; m < n; ++m) {
            V const row = residual.get(begin + m);
            for (int c = 0; c < d; ++c) made.residual(m * d + c) = s::component(row, c);
        }
        return made;
    };
    auto const relative = [&](vector const& residual) { // at the last iterate
        auto const sizes_of_terms = sizes_of_rows(equation, now, begin, end - 1, derivatives);
        S worst(0);
        for (int m = 0; m < n * d; ++m)
            worst = larger(worst, in_roundings<S>(residual(m), s::component(sizes_of_terms[static_cast<std::size_t>(m / d)], m % d)));
        return worst;
    };
    auto const unknown = [&](std::vector<V> const& of) {
        vector y(n * d);
        for (int m = 0; m < n; ++m)
            for (int c = 0; c < d; ++c) y(m * d + c) = s::component(of[static_cast<std::size_t>(begin + m)], c);
        return y;
    };
    vector const guess = unknown(x), line = straight_line ? unknown(*straight_line) : guess;
    vector rounding(n * d);
    S const most = std::max(S(magnitude(at(begin - 1))), S(magnitude(at(end))));
    // A row is a difference of terms of this size.
    rounding.setConstant(S(system(guess, S(1)).jacobian.largest()) * most);
    vector const root =
        newton_near<vector, patterned_matrix<S>>(system, relative, guess, straight_line ? &line : nullptr, rounding, what, by, stop);
    put(root);
    if (straight_line == nullptr or std::numeric_limits<S>::is_exact) return S(0);
    auto at_root = system(root, S(1));
    std::vector<vector> from_ends(static_cast<std::size_t>(2 * d), vector::Zero(n * d));
    for (int const k : {-1, n}) {
        auto const slope = equation.residual_slope(now, begin + k, derivatives);
        for (int m = first_near(k); m < end_near(k); ++m) {
            auto const block = slope.get(begin + m);
            for (int c = 0; c < d; ++c)
                for (int e = 0; e < d; ++e) from_ends[static_cast<std::size_t>(k < 0 ? e : d + e)](m * d + c) = s::entry(block, c, e);
        }
    }
    vector component_sizes = vector::Zero(d);
    for (V const& value : x)
        for (int c = 0; c < d; ++c) component_sizes(c) = std::max(component_sizes(c), S(magnitude(s::component(value, c))));
    S const largest = magnitude(component_sizes);
    for (int c = 0; c < d; ++c)
        if (component_sizes(c) == S(0)) component_sizes(c) = largest == S(0) ? S(1) : largest;
    return response_to_ends<S, vector>(at_root.jacobian, from_ends, component_sizes);
}

} // namespace hilger::detail
