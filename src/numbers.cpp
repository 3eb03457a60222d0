// SPDX-License-Identifier: BSL-1.0
// What tests and scenes spend their time in when they are compiled to be looked into: arithmetic of rationals and of many digits, and
// factorizations. Compiled once, optimised, and linked first: of what is in several files the linker takes the first. Nothing depends on it
// but the time: where a compiler puts these functions elsewhere, all is as slow as it was.
#include "compiled_once.hpp"

#define INSTANTIATE_ARITHMETIC(S)                                                                                                          \
    template void backends::eval_add(S::backend_type&, S::backend_type const&);                                                            \
    template void backends::eval_subtract(S::backend_type&, S::backend_type const&);                                                       \
    template void backends::eval_multiply(S::backend_type&, S::backend_type const&);                                                       \
    template void backends::eval_divide(S::backend_type&, S::backend_type const&);                                                         \
    template S operator+(S const&, S const&);                                                                                              \
    template S operator-(S const&, S const&);                                                                                              \
    template S operator*(S const&, S const&);                                                                                              \
    template S operator/(S const&, S const&);                                                                                              \
    template bool operator==(S const&, S const&);                                                                                          \
    template bool operator<(S const&, S const&);

#define INSTANTIATE_DIGITS(S)                                                                                                              \
    INSTANTIATE_ARITHMETIC(S)                                                                                                              \
    template void backends::eval_add(S::backend_type&, S::backend_type const&, S::backend_type const&);                                    \
    template void backends::eval_subtract(S::backend_type&, S::backend_type const&, S::backend_type const&);                               \
    template void backends::eval_multiply(S::backend_type&, S::backend_type const&, S::backend_type const&);                               \
    template void backends::eval_divide(S::backend_type&, S::backend_type const&, S::backend_type const&);                                 \
    template void backends::eval_sqrt(S::backend_type&, S::backend_type const&);                                                           \
    template void backends::eval_exp(S::backend_type&, S::backend_type const&);                                                            \
    template void default_ops::eval_log(S::backend_type&, S::backend_type const&);                                                         \
    template void default_ops::eval_sin(S::backend_type&, S::backend_type const&);                                                         \
    template void default_ops::eval_cos(S::backend_type&, S::backend_type const&);                                                         \
    template void default_ops::eval_pow(S::backend_type&, S::backend_type const&, S::backend_type const&);

namespace boost::multiprecision {
INSTANTIATE_ARITHMETIC(hilger::Q)
INSTANTIATE_DIGITS(hilger::float50)
INSTANTIATE_DIGITS(hilger::float100)
} // namespace boost::multiprecision

template class Eigen::PartialPivLU<Eigen::MatrixXd>;
template class Eigen::PartialPivLU<Eigen::Matrix<hilger::float50, -1, -1>>;
template class Eigen::PartialPivLU<Eigen::Matrix<hilger::Q, -1, -1>>;
