// SPDX-License-Identifier: BSL-1.0
// What our own programs do not compile again in each of their files: engines*.cpp and numbers.cpp do, optimised.
// A matter of minutes alone: without this header all is the same.
#pragma once

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

// What depends on the kind of numbers alone; the second is of numbers that have roots.
#define HILGER_ENGINES(how, S)                                                                                                             \
    how template class patterned_matrix<S>;                                                                                                \
    how template bool solve_positive_definite(Eigen::Matrix<S, -1, -1> const&, Eigen::Matrix<S, -1, 1>&);                                  \
    how template class evaluation<S>;                                                                                                      \
    how template traced_formula<S> derivatives_in(formula_graph<S>&, int, traced<S> const&, std::vector<traced<S>> const&, std::uint8_t);
#define HILGER_ENGINES_WITH_ROOTS(how, S)                                                                                                  \
    HILGER_ENGINES(how, S)                                                                                                                 \
    how template class symmetric_matrix<S>;

extern template class Eigen::PartialPivLU<Eigen::MatrixXd>;
extern template class Eigen::PartialPivLU<Eigen::Matrix<hilger::float50, -1, -1>>;
extern template class Eigen::PartialPivLU<Eigen::Matrix<hilger::Q, -1, -1>>;
namespace hilger::detail {
HILGER_ENGINES_WITH_ROOTS(extern, double)
HILGER_ENGINES_WITH_ROOTS(extern, float50)
HILGER_ENGINES(extern, Q)
} // namespace hilger::detail
