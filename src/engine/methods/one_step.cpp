// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/one_step.hpp"
#include "engine/methods/small.hpp"

namespace engine {

made embedded_in_one_step(problem const& what, std::string const& method, points<double> const& T) {
    bool const is_compensated = method == "mid-point+";
    auto const small = [&](auto const&... how) {
        return begin_small(what, T, [how...](auto const& L) { return hilger::embed(L, how...); });
    };
    auto const by = [&](auto const& begin) {
        if (is_compensated) return in_one_step<double, hilger::sums::compensated>(what, "mid-point", T, begin);
        return in_one_step<double>(what, method, T, begin);
    };
    if (is_compensated) return by(small(hilger::mid_point, hilger::compensated));
    if (method == "order-one") return by(small(hilger::order_one));
    if (method == "order-one-left") return by(small(hilger::order_one_left));
    if (not T.is_uniform() or not what.besides.empty()) return by(beginning_by<double>());
    auto const lambda = lambda_in_one_step<double>(what, method, T.equal_step());
    // Steps of vectors of dynamic size detect that the position is an end of the step, and are explicit.
    if (not lambda or *lambda == 0 or *lambda == 1) return by(beginning_by<double>());
    return by(small(hilger::text::embedding_at(*lambda)));
}

} // namespace engine
