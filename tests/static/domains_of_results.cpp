// SPDX-License-Identifier: BSL-1.0
// Where the result of an operation lives is in its type: T^{+-} has lost both end points, and nothing is made up for them.
#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

constexpr auto T = uniform(0.0, 0.1, 10);
constexpr auto formula = [](double t) { return t; };
constexpr auto f = function_on(T, formula);
constexpr auto f_h = function_on(half(T), formula);
constexpr auto f_o = function_on(circ(T), formula);
constexpr auto f_plus = function_on(without_last(T), formula);
constexpr auto f_minus = function_on(without_first(T), formula);

/// True when f lives on the family Base without its first Front and last Back points.
template <class Base, int Front, int Back, class F>
constexpr bool lives_on(F const&) {
    return std::same_as<typename F::domain_type, domain<Base, Front, Back>>;
}
using T_half = between<fraction<1, 2>>;
using T_o = joined<fraction<1, 2>>;

static_assert(lives_on<nodes, 0, 0>(f) and lives_on<T_half, 0, 0>(f_h) and lives_on<T_o, 0, 0>(f_o));
static_assert(lives_on<nodes, 0, 1>(f_plus) and lives_on<nodes, 1, 0>(f_minus));

// sigma: C(T^-) -> C(T^+), and from all of T the value at the first point is not needed; rho is its mirror image.
static_assert(lives_on<nodes, 0, 1>(sigma[f]) and lives_on<nodes, 0, 1>(sigma[f_minus]) and lives_on<nodes, 0, 2>(sigma[f_plus]));
static_assert(lives_on<nodes, 1, 0>(rho[f]) and lives_on<nodes, 1, 0>(rho[f_plus]) and lives_on<nodes, 2, 0>(rho[f_minus]));
static_assert(lives_on<nodes, 0, 2>(sigma[sigma[f]]) and lives_on<nodes, 1, 0>(rho[sigma[f]]) and lives_on<nodes, 0, 1>(sigma[rho[f]]));

// Derivatives lose a point each, on their side: T^kappa.
static_assert(lives_on<nodes, 0, 1>(Delta_plus[f]) and lives_on<nodes, 1, 0>(Delta_minus[f]));
static_assert(lives_on<nodes, 0, 2>(Delta_plus[Delta_plus[f]]) and lives_on<nodes, 0, 3>(Delta_plus[Delta_plus[Delta_plus[f]]]));
static_assert(lives_on<nodes, 1, 1>(Delta_minus[Delta_plus[f]]) and lives_on<nodes, 1, 1>(Delta_plus[Delta_minus[f]]));
static_assert(lives_on<nodes, 1, 1>((Delta_minus * Delta_plus)[f]) and lives_on<nodes, 2, 0>(Delta_minus[Delta_minus[f]]));
static_assert(lives_on<T_half, 0, 1>(Delta_h_plus[f_h]) and lives_on<T_half, 1, 0>(Delta_h_minus[f_h]));
static_assert(lives_on<T_o, 0, 1>(Delta_o_plus[f_o]) and lives_on<T_o, 1, 1>(Delta_o_minus[Delta_o_plus[f_o]]));
static_assert(lives_on<nodes, 1, 1>(Delta_plus[f_minus]) and lives_on<nodes, 0, 2>(Delta_plus[f_plus]));

// Between the families. The last mid-point is before the last point, so Delta_o_plus[f_o] keeps all mid-points.
static_assert(lives_on<T_o, 0, 0>(extend[f]) and lives_on<T_o, 0, 2>(extend[f_plus]) and lives_on<T_o, 2, 0>(extend[f_minus]));
static_assert(lives_on<T_half, 0, 0>(on_half[f_o]) and lives_on<T_half, 0, 0>(on_half[Delta_o_plus[f_o]]));
static_assert(lives_on<T_half, 0, 0>(on_half[Delta_o_minus[Delta_o_plus[f_o]]]));
static_assert(lives_on<nodes, 0, 0>(on_T[f_o]) and lives_on<nodes, 0, 1>(on_T[Delta_o_plus[f_o]]) and lives_on<nodes, 1, 1>(mean_o[f_o]));
static_assert(lives_on<T_half, 0, 1>(on_half[extend[f_plus]]) and lives_on<nodes, 0, 1>(on_T[extend[f_plus]]));
static_assert(lives_on<nodes, 0, 1>(pi_half[f_h]) and lives_on<T_half, 0, 0>(pi_inverse[f]) and lives_on<T_half, 0, 0>(pi_inverse[f_plus]));
static_assert(lives_on<T_half, 1, 0>(pi_inverse[f_minus]) and lives_on<T_half, 0, 1>(pi_inverse[Delta_plus[f_plus]]));
static_assert(lives_on<T_half, 1, 0>(mean_h_minus[f_h]) and lives_on<T_half, 0, 1>(mean_h_plus[f_h]));
static_assert(lives_on<nodes, 1, 1>(step_mean[f_h]) and lives_on<nodes, 2, 1>(step_mean[mean_h_minus[f_h]]));
static_assert(lives_on<nodes, 0, 0>(antiderivative_h[f_h]) and lives_on<nodes, 0, 0>(antiderivative[f_plus]));
static_assert(lives_on<nodes, 0, 0>(antiderivative_nabla[f_minus]) and lives_on<nodes, 0, 1>(antiderivative_h[Delta_h_plus[f_h]]));
static_assert(lives_on<T_half, 0, 0>(adjoint(antiderivative_h)[f]) and lives_on<nodes, 1, 1>(adjoint(extend)[f_o]));

// Sums of operators and of functions live on the common points.
static_assert(lives_on<nodes, 1, 1>((sigma + rho)[f]) and lives_on<nodes, 1, 1>(Delta_plus[f] + Delta_minus[f]));
static_assert(lives_on<nodes, 0, 1>(Delta_plus[f] * f) and lives_on<nodes, 0, 2>(Delta_plus[Delta_plus[f]] - Delta_plus[f]));
static_assert(lives_on<T_o, 0, 1>(Delta_o_plus[f_o] * f_o) and lives_on<nodes, 1, 1>(f_plus / f_minus) and
              lives_on<nodes, 0, 1>(2 * f_plus));
static_assert(lives_on<nodes, 1, 1>(dot(f_plus, f_minus)) and
              lives_on<nodes, 1, 2>(apply_pointwise([](auto x, auto, auto) { return x; }, f_minus, sigma[f], Delta_plus[Delta_plus[f]])));
static_assert(lives_on<nodes, 1, 1>(restrict_to(f, interior(T))) and
              std::same_as<decltype(tabulate(Delta_plus[f]))::domain_type, domain<nodes, 0, 1>>);

// Any lambda has families of its own; one that is known at run time is a value.
static_assert(lives_on<joined<fraction<1, 3>>, 0, 0>(extend_lambda<1, 3>[f]) and
              lives_on<joined<run_time<double>>, 0, 0>(extend_at(0.3)[f]));
static_assert(lives_on<between<fraction<1, 3>>, 0, 0>(on_lambda<1, 3>[extend_lambda<1, 3>[f]]));
static_assert(extend_at(0.3)[f].domain().base.lambda.value == 0.3);

// What lives where is said in words, too.
static_assert(domain<nodes>::name().text().view() == "T" and domain<T_half>::name().text().view() == "T_half" and
              domain<T_o>::name().text().view() == "T_o");
static_assert(domain<nodes, 1, 2>::name().text().view() == "T^{++-}" and domain<T_o, 0, 1>::name().text().view() == "T_o^{+}");
static_assert(domain<between<fraction<12, 35>>>::name().text().view() == "T_12/35" and
              domain<joined<fraction<1, 3>>>::name().text().view() == "T_{o,1/3}");
static_assert((Delta_minus * Delta_plus).name().text().view() == "Delta_minus[Delta_plus]" and
              Delta_h_plus.name().text().view() == "Delta_h_plus");
static_assert(rho_o.name().text().view() == "rho_o" and
              shift<between<fraction<1, 3>>, side::plus>{}.name().text().view() == "sigma_on<T_1/3>");

} // namespace
