// SPDX-License-Identifier: BSL-1.0
// How far a history of stages is from the direct powers.
#pragma once

#include "hilger/history/stages.hpp"
#include "histories.hpp"
#include "stage_judge.hpp"

namespace hilger::testing {

struct distances {
    double past = 0, leading = 0; ///< in units of sum_j |D^alpha_nj| |F_j| over the past, and of the largest entry of the leading block
};
/// Of the history from D^alpha, at every stage of every step.
template <class S>
distances distances_of(stage_history<S> history, stage_judge::matrix const& power, std::vector<double> const& steps, index_type s) {
    noise source;
    std::vector<S> F;
    for (index_type k = 0; k < power.rows(); ++k) F.push_back(source.next<S>());
    distances worst;
    index_type first = 0; // of the step's stages
    for (double const nu : steps) {
        history.begin(S(nu));
        auto const block = power.block(first, first, s, s);
        stage_judge::matrix const difference = history.leading().template cast<float50>() - block;
        worst.leading = std::max(worst.leading, static_cast<double>(difference.cwiseAbs().maxCoeff() / block.cwiseAbs().maxCoeff()));
        for (index_type i = 0; i < s and first > 0; ++i) {
            float50 exact(0), all(0);
            for (index_type j = 0; j < first; ++j) {
                float50 const term = power(first + i, j) * float50(F[static_cast<std::size_t>(j)]);
                exact += term;
                all += abs(term);
            }
            worst.past = std::max(worst.past, static_cast<double>(abs(float50(history.past(i)) - exact) / all));
        }
        history.push(std::span<S const>(F.data() + first, static_cast<std::size_t>(s)));
        first += s;
    }
    return worst;
}

} // namespace hilger::testing
