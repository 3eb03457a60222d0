// SPDX-License-Identifier: BSL-1.0
// Operators are empty types, views of a scale weigh what the scale weighs, and an operator applied to a function adds nothing to it.
#include <type_traits>

#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

template <class A>
constexpr bool weighs_nothing(A const&) {
    return std::is_empty_v<A> and sizeof(A) == 1 and std::is_trivially_copyable_v<A>;
}
static_assert(weighs_nothing(sigma) and weighs_nothing(rho) and weighs_nothing(sigma_h) and weighs_nothing(rho_h));
static_assert(weighs_nothing(sigma_o) and weighs_nothing(rho_o));
static_assert(weighs_nothing(Delta_plus) and weighs_nothing(Delta_minus) and weighs_nothing(Delta_h_plus));
static_assert(weighs_nothing(Delta_h_minus) and weighs_nothing(Delta_o_plus) and weighs_nothing(Delta_o_minus));
static_assert(weighs_nothing(extend) and weighs_nothing(on_T) and weighs_nothing(on_half) and weighs_nothing(step_mean));
static_assert(weighs_nothing(pi_half) and weighs_nothing(pi_inverse) and weighs_nothing(identity_T) and weighs_nothing(identity_h));
static_assert(weighs_nothing(antiderivative_h) and weighs_nothing(adjoint(antiderivative_h)) and weighs_nothing(extend_lambda<1, 3>));

// Compositions, multiples and sums of different operators, and adjoints of them.
static_assert(weighs_nothing(-Delta_plus) and weighs_nothing(Delta_minus * Delta_plus) and weighs_nothing(sigma + rho));
static_assert(weighs_nothing(mean_h_minus) and weighs_nothing(mean_h_plus) and weighs_nothing(Delta_o_plus * extend));
static_assert(weighs_nothing(fraction<1, 2>{} * (sigma_o + rho_o)) and weighs_nothing(adjoint(Delta_plus)));

// Two subobjects of one type may not share an address, so these are as small as C++ allows: empty, one byte for each repetition.
static_assert(std::is_empty_v<decltype(Delta_plus * Delta_plus)> and sizeof(Delta_plus * Delta_plus) == 2);
static_assert(std::is_empty_v<decltype(mean_o)> and std::is_empty_v<decltype(antiderivative)> and
              std::is_empty_v<decltype(adjoint(extend))>);

// An order known at run time is carried, and nothing else is.
static_assert(sizeof(extend_at(0.3)) == sizeof(double) and sizeof(extend_at(0.3f)) == sizeof(float));

// T = {a + ih}: three numbers and a count. Its views add nothing, a lambda known at run time adds itself.
using T = uniform_scale<double>;
constexpr auto uniform_T = uniform(0.0, 0.1, 10);
static_assert(sizeof(T) == 3 * sizeof(double) + sizeof(index_type) and std::is_trivially_copyable_v<T>);
static_assert(sizeof(without_last(uniform_T)) == sizeof(T) and sizeof(without_first(uniform_T)) == sizeof(T) and
              sizeof(interior(uniform_T)) == sizeof(T));
static_assert(sizeof(half(uniform_T)) == sizeof(T) and sizeof(circ(uniform_T)) == sizeof(T) and
              sizeof(at_lambda<1, 3>(uniform_T)) == sizeof(T));
static_assert(sizeof(circ<1, 3>(uniform_T)) == sizeof(T) and sizeof(interior(circ(uniform_T))) == sizeof(T));
static_assert(sizeof(at_lambda(uniform_T, 0.3)) == sizeof(T) + sizeof(double) and
              sizeof(circ(uniform_T, 0.3)) == sizeof(T) + sizeof(double));
static_assert(std::is_trivially_copyable_v<decltype(half(uniform_T))>);

// A scale of given points is a handle to them.
static_assert(sizeof(time_scale<double>) == 2 * sizeof(void*) and
              sizeof(derived_scale<time_scale<double>, domain<nodes>>) == 2 * sizeof(void*));

// A formula without state adds nothing to its scale, and an operator adds nothing to its function.
constexpr auto f = function_on(uniform_T, [](double t) { return t * t; });
static_assert(sizeof(f) == sizeof(T));
static_assert(sizeof(extend[f]) == sizeof(f) and sizeof(Delta_o_plus[extend[f]]) == sizeof(f));
static_assert(sizeof(Delta_minus[Delta_plus[f]]) == sizeof(f) and sizeof(mean_h_minus[pi_inverse[f]]) <= sizeof(f) + sizeof(double));
static_assert(sizeof(on_half[Delta_o_plus[extend[f]]]) <= sizeof(f) + sizeof(double)); // its two lambdas = 1/2 need two addresses

// And a table is a handle to its values.
using table = function_on<T, domain<nodes>, by_table<double>>;
static_assert(sizeof(table) == sizeof(T) + 2 * sizeof(void*));
static_assert(sizeof(applied<std::remove_const_t<decltype(Delta_plus)>, table>) == sizeof(table));

} // namespace
