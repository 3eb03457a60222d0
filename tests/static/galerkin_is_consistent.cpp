// SPDX-License-Identifier: BSL-1.0
// What Galerkin's embeddings say of themselves: their weights add up to the step, and value and slope of 1 and of t are 1, 0 and 1.
#include "hilger/embedding/galerkin.hpp"

namespace {

using namespace hilger;

template <int Stages, class Quadrature>
constexpr bool is_consistent() {
    constexpr int degree = Quadrature::degree(Stages);
    return detail::examine<step_weight>(polynomial_value<degree, Quadrature, Stages>{}, polynomial_slope<degree, Quadrature, Stages>{},
                                        prime_field(7919), [](auto x, auto y) { return x == y; }) == detail::consistency::holds;
}
template <int... Stages>
constexpr bool are_consistent(std::integer_sequence<int, Stages...>) {
    return (is_consistent<Stages + 1, gauss>() and ...) and (is_consistent<Stages + 2, lobatto>() and ...) and
           (is_consistent<Stages + 1, radau>() and ...);
}
static_assert(are_consistent(std::make_integer_sequence<int, 6>{}));

} // namespace
