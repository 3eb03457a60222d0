// SPDX-License-Identifier: BSL-1.0
// An interval divided at the times at which a callable switches, its switching_times(a, b), with equal steps in each piece: the scale of an
// accurate solution (accuracy/doubling.hpp). With a memory the solution begins anew at such a time like a broken power, and the first
// eighth of each piece is a graded one of its own.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"

namespace hilger::detail {

template <class Callable, class S>
concept says_when_it_switches = requires(Callable const& f, S const& t) {
    f.switching_times(t, t);
};
/// The ends of the pieces of [a, b]. Of times that differ by rounding, as those of two callables may, the first is taken.
template <class S, class... Callables>
std::vector<S> ends_of_pieces(interval<S> const& I, Callables const&... callables) {
    std::vector<S> times, ends{I.a};
    auto const add = [&](auto const& f) {
        if constexpr (says_when_it_switches<std::remove_cvref_t<decltype(f)>, S>)
            if (I.a < I.b) // other intervals are refused later
                for (S const& t : f.switching_times(I.a, I.b)) times.push_back(t);
    };
    (add(callables), ...);
    std::sort(times.begin(), times.end());
    S const unit = S(64) * epsilon<S>() * std::max(magnitude(I.a), magnitude(I.b));
    for (S const& t : times)
        if (ends.back() + unit < t and t + unit < I.b) ends.push_back(t);
    ends.push_back(I.b);
    return ends;
}
/// Each piece divided into its first eighth and the rest. Where a callable switches, a piece ends some roundings before: a step has a node
/// at its end, which sees nothing of what follows.
template <class S>
std::vector<S> with_starts(std::vector<S> ends) {
    std::vector<S> all{ends.front()};
    for (std::size_t k = 1; k < ends.size(); ++k) {
        if (k + 1 < ends.size()) ends[k] = ends[k] - S(8) * epsilon<S>() * magnitude(ends[k]);
        all.push_back(S(ends[k - 1] + (ends[k] - ends[k - 1]) / S(8)));
        all.push_back(ends[k]);
    }
    return all;
}

/// The numbers of steps of the pieces with these ends.
using steps_of_pieces = std::vector<index_type>;
inline index_type sum(steps_of_pieces const& each) { return std::accumulate(each.begin(), each.end(), index_type{0}); }
template <class Change>
steps_of_pieces changed(steps_of_pieces each, Change const& change) {
    for (index_type& n : each) n = change(n);
    return each;
}
/// @throws error::invalid_parameter where longest < 0 or needs more than `most` steps, 2^n with n > 2
inline void require_longest_step(double whole, double longest, index_type most) {
    if (not(longest >= 0)) error::raise<error::invalid_parameter>("the longest step is positive, or 0 for any, and not ", longest);
    if (longest > 0 and whole > longest * static_cast<double>(most))
        error::raise<error::invalid_parameter>("steps of at most ", longest, " are more than ", most, " on this interval");
}
/// The numbers of steps of the first run. @throws error::invalid_parameter where longest < 0 or needs more than `most` steps
template <class S>
steps_of_pieces first_steps(std::vector<S> const& ends, double longest, index_type most) {
    double const whole = static_cast<double>(S(ends.back() - ends.front()));
    index_type steps = 8;
    require_longest_step(whole, longest, most);
    if (longest > 0)
        while (whole > longest * static_cast<double>(steps)) steps *= 2;
    steps_of_pieces each;
    for (std::size_t k = 1; k < ends.size(); ++k) {
        double const share = static_cast<double>(S(ends[k] - ends[k - 1])) / whole;
        each.push_back(std::max<index_type>(1, static_cast<index_type>(std::ceil(share * static_cast<double>(steps)))));
    }
    return each;
}
/// The scale of piece k.
template <class S>
auto piece(std::vector<S> const& ends, steps_of_pieces const& each, std::size_t k) {
    return uniform(interval<S>{ends[k], ends[k + 1]}, each[k]);
}
/// The scale of all pieces. With a gamma above 1 the first, the third, ... are graded.
template <class S>
time_scale<S> joined_pieces(std::vector<S> const& ends, steps_of_pieces const& each, S const& gamma) {
    std::vector<S> points{ends.front()};
    auto const add = [&](auto const& T) {
        for (S const& t : T)
            if (points.back() < t) points.push_back(t);
    };
    for (std::size_t k = 0; k < each.size(); ++k)
        if (S(1) < gamma and k % 2 == 0)
            add(graded(ends[k], ends[k + 1], each[k], gamma));
        else
            add(piece(ends, each, k));
    return time_scale<S>(std::move(points));
}

} // namespace hilger::detail
