// SPDX-License-Identifier: BSL-1.0
// Runs of two numbers in double beside the same in 50 digits.
#pragma once

#include "runtime/trajectory/resuming.hpp"

namespace hilger::testing {

template <class S>
using plane = Eigen::Matrix<S, 2, 1>;
template <class S>
auto path_of(auto const& flow, S const& end, hilger::index_type steps, double q, double p) {
    return flow.along(uniform(interval<S>{0, end}, steps), plane<S>(S(q), S(0)), plane<S>(S(0), S(p)));
}
template <class Path>
auto last_of(Path const& path) {
    auto last = *path.begin();
    for (auto const& x : path) last = x;
    return last;
}
/// How far a run in double ends from the same run in 50 digits.
double rounding_in(auto const& flow, auto const& exact_flow, double end, hilger::index_type steps, double q, double p) {
    auto const a = last_of(path_of<double>(flow, end, steps, q, p));
    auto const b = last_of(path_of<float50>(exact_flow, end, steps, q, p));
    return static_cast<double>((a.q.template cast<float50>() - b.q).norm() + (a.p.template cast<float50>() - b.p).norm());
}

} // namespace hilger::testing
