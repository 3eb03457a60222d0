// SPDX-License-Identifier: BSL-1.0
// How orders are fitted: in 50 digits, from errors of two runs whose steps are in the ratio 2.
#pragma once

#include "hilger/integrator/flow.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::testing {

/// The slope of log error against log h, from the errors with steps h and h/2; not a number where their signs differ.
template <class S>
double order_of(S const& coarse, S const& fine) {
    using std::log;
    return static_cast<double>(log(S(coarse / fine)) / log(S(2)));
}

/// Where a flow in one degree of freedom is at t = 1, from q = 1, p = 1/2 at t = 0.
template <class Flow>
state<float50, float50> at_one(Flow const& flow, int steps) {
    state<float50, float50> last;
    for (auto const& x : flow.along(uniform(interval<float50>{0, 1}, steps), float50(1), float50(1) / 2)) last = x;
    return last;
}
/// The position at t = 1 to order four, of a flow of order two: Richardson's.
template <class Flow>
float50 extrapolated_at_one(Flow const& flow, int steps) {
    float50 const coarse = at_one(flow, steps).q, fine = at_one(flow, 2 * steps).q;
    return fine + (fine - coarse) / 3;
}
/// The order of the position at t = 1, between steps of 1/steps and of half that.
template <class Flow>
double fitted_order(Flow const& flow, int steps, float50 const& reference) {
    return order_of(float50(at_one(flow, steps).q - reference), float50(at_one(flow, 2 * steps).q - reference));
}

} // namespace hilger::testing
