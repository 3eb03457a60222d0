// SPDX-License-Identifier: BSL-1.0
// Instantiations that our programs share instead of compiling them in each file: engines*.cpp and numbers.cpp hold them, optimised. This
// only saves minutes of compile time.
#pragma once

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

// Templates over the number type alone.
#define HILGER_ENGINES(how, S)                                                                                                             \
    how template class large_matrix<S>;                                                                                                    \
    how template class patterned_matrix<S>;                                                                                                \
    how template class mass_solver<Eigen::Matrix<S, -1, -1>, Eigen::Matrix<S, -1, 1>>;                                                     \
    how template class evaluation<S>;                                                                                                      \
    how template traced_formula<S> derivatives_in(formula_graph<S>&, int, traced<S> const&, std::vector<traced<S>> const&, std::uint8_t);

// Arithmetic of many digits; HILGER_DIGITS adds that of rounded numbers.
#define HILGER_ARITHMETIC(how, S)                                                                                                          \
    how template void backends::eval_add(S::backend_type&, S::backend_type const&);                                                        \
    how template void backends::eval_subtract(S::backend_type&, S::backend_type const&);                                                   \
    how template void backends::eval_multiply(S::backend_type&, S::backend_type const&);                                                   \
    how template void backends::eval_divide(S::backend_type&, S::backend_type const&);                                                     \
    how template S operator+(S const&, S const&);                                                                                          \
    how template S operator-(S const&, S const&);                                                                                          \
    how template S operator*(S const&, S const&);                                                                                          \
    how template S operator/(S const&, S const&);                                                                                          \
    how template bool operator==(S const&, S const&);                                                                                      \
    how template bool operator<(S const&, S const&);
#define HILGER_DIGITS(how, S, digits)                                                                                                      \
    HILGER_ARITHMETIC(how, S)                                                                                                              \
    how template void backends::eval_add(S::backend_type&, S::backend_type const&, S::backend_type const&);                                \
    how template void backends::eval_subtract(S::backend_type&, S::backend_type const&, S::backend_type const&);                           \
    how template void backends::eval_multiply(S::backend_type&, S::backend_type const&, S::backend_type const&);                           \
    how template void backends::eval_divide(S::backend_type&, S::backend_type const&, S::backend_type const&);                             \
    how template void backends::eval_sqrt(S::backend_type&, S::backend_type const&);                                                       \
    how template void backends::eval_exp(S::backend_type&, S::backend_type const&);                                                        \
    how template void default_ops::eval_log(S::backend_type&, S::backend_type const&);                                                     \
    how template void default_ops::eval_sin(S::backend_type&, S::backend_type const&);                                                     \
    how template void default_ops::eval_cos(S::backend_type&, S::backend_type const&);                                                     \
    how template void default_ops::eval_pow(S::backend_type&, S::backend_type const&, S::backend_type const&);                             \
    how template backends::cpp_bin_float<digits>& backends::cpp_bin_float<digits>::operator=(char const*);                                 \
    how template std::string backends::cpp_bin_float<digits>::str(std::streamsize, std::ios_base::fmtflags) const;
#define HILGER_NUMBERS(how)                                                                                                                \
    namespace boost::multiprecision {                                                                                                      \
    HILGER_ARITHMETIC(how, hilger::Q)                                                                                                      \
    HILGER_DIGITS(how, hilger::float50, 50)                                                                                                \
    HILGER_DIGITS(how, hilger::float100, 100)                                                                                              \
    }                                                                                                                                      \
    how template class Eigen::PartialPivLU<Eigen::MatrixXd>;                                                                               \
    how template class Eigen::PartialPivLU<Eigen::Matrix<hilger::float50, -1, -1>>;                                                        \
    how template class Eigen::PartialPivLU<Eigen::Matrix<hilger::Q, -1, -1>>;

HILGER_NUMBERS(extern)
namespace hilger::detail {
HILGER_ENGINES(extern, double)
HILGER_ENGINES(extern, float50)
HILGER_ENGINES(extern, Q)
} // namespace hilger::detail
