// SPDX-License-Identifier: BSL-1.0
// Solves some rows of an equation by Newton's method, and by continuation from a straight line.
#pragma once

#include <sstream>
#include <vector>

#include "hilger/integrator/rows.hpp"
#include "hilger/newton/newton.hpp"

namespace hilger::detail {

/// The roundings of a row: some tens of its terms and of the operations in L, independent of the number of points.
inline constexpr int most_roundings = 256;
/// The effort to solve rows: Newton's method from the present values, with some rounds or as many as it takes; and, if it fails, from a
/// straight line by continuation.
enum class search { nearby, alone, everywhere };
/// The work of a search in evaluations of the residual, of which a derivative costs four: Newton's method takes some 20 next to a root.
inline constexpr int little_work = 48, much_work = 10000;

/// The values of `x` inside the steps from `begin` to `end` - 1 and between them, such that the rows of the equation there hold: a root
/// near the present values, by decreasing corrections; where these find no root and the search goes everywhere, the one to which motions in
/// less time lead from the straight `line`, if it is not far away. The other arguments are those of rows_of_equation, and `what` names the
/// rows in messages. Unless Newton's method is alone, a root solves its rows to the rounding of their terms. Returns the response of the
/// values to those at both sides then.
/// @throws newton_failure, an error::no_convergence; error::singular, error::not_finite
template <class Flow, class Root, class V>
auto solve_rows(Flow const& flow, Root const& T, std::vector<V>& x, index_type begin, index_type end, char const* what, search how_far,
                int most_work, std::vector<V> const& line, solvability const& by = by_the_velocity, std::stop_token const& stop = {}) {
    using S = scalar_of<V>;
    using rows_type = rows_of_equation<Flow, Root, V>;
    using vector = typename rows_type::vector;
    rows_type rows(flow, T, x, begin, end, most_work, what, stop);
    auto const evaluate = [&](vector const& y, vector& r) { return rows.evaluate(y, r); };
    auto const linearize = [&] { return rows.linearize(); };
    auto const correct = [&](vector const& r, vector& d) { rows.correct(r, d); };
    newton_equation<vector> const f{evaluate, linearize, correct, true};
    unwatched const inside;
    vector const guess = rows.unknown(x);
    vector y = guess, r = guess;
    newton_outcome const how = newton<vector>(f, y, r, corrections::smaller);
    if (how_far == search::alone or std::numeric_limits<S>::is_exact) {
        if (how != newton_outcome::found) throw_newton_failure(what, how, y, r, by);
        rows.put(y);
        return S(0);
    }
    vector const first = y, first_rest = r;
    bool found = how == newton_outcome::found;
    S rest = found ? rows.polish(y) : S(2 * most_roundings);
    if (found and magnitude(vector(y - guess)) <= S(2) * epsilon<S>() * magnitude(y)) { // rounding has moved a root
        vector other = r;
        rows.evaluate(y, r);
        rows.evaluate(guess, other);
        rows.put(magnitude(r) <= magnitude(other) ? y : y = guess);
    }
    if (how_far == search::everywhere and not(rest <= S(most_roundings))) {
        S const quarter = S(1) / S(4);
        bool const arrives = continued<vector>(f, y, rows.unknown(line), r, {S(0), quarter, quarter / S(8)}, corrections::smaller,
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
