// SPDX-License-Identifier: BSL-1.0
// All that is compiled for a kind of numbers: what reads and evaluates formulas, and operators with factors in them.
#pragma once

#include "hilger/text/embedding.hpp"
#include "text/evaluate.hpp"
#include "text/number_in.hpp"
#include "text/operator_in_numbers.hpp"
#include "text/operator_row.hpp"
#include "text/switching.hpp"

namespace hilger::text {

template <class S>
S lambda_of_step(embedding_formula const& e, std::optional<S> const& h) {
    require_one_step(e, detail::rounding_of_factors<S>);
    if (not h and depends_on_step(e))
        error::raise<error::invalid_parameter>("the position of ", e.text,
                                               " is another mean of the ends for each length of the step, which is possible here on equal "
                                               "steps alone");
    return detail::row_on<S>(detail::equal_steps<S>{h.value_or(S(1))}, e.position, e.lost())[1];
}

} // namespace hilger::text

#define HILGER_FORMULAS_AS(T)                                                                                                              \
    template class detail::evaluator<T>;                                                                                                   \
    template T stated::evaluate(T const&, components_view<T>, components_view<T>, bool) const;
#define HILGER_FORMULAS_IN(S)                                                                                                              \
    template std::optional<S> number_in(std::string_view);                                                                                 \
    HILGER_FORMULAS_AS(S)                                                                                                                  \
    HILGER_FORMULAS_AS(traced<S>)                                                                                                          \
    template S stated::number<S>() const;
#define HILGER_SWITCHING_IN(S) template std::vector<S> switching_times(std::vector<stated const*> const&, S const&, S const&);
#define HILGER_OPERATORS_IN(S)                                                                                                             \
    template class operator_in_numbers<S>;                                                                                                 \
    template S lambda_of_step(embedding_formula const&, std::optional<S> const&);
