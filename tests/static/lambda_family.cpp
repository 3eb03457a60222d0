// SPDX-License-Identifier: BSL-1.0
// The family of T_lambda and T_{o,lambda} (Cresson-Safi, definition 7): what holds for T_half holds for every lambda, with the weights of
// that lambda.
#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

template <int P, int Q>
constexpr bool the_lambda_family_is_sound() {
    using l = fraction<P, Q>;
    using rest = fraction<Q - P, Q>;
    constexpr auto Delta_l_plus = derivative<joined<l>, side::plus>{};
    constexpr auto Delta_l_minus = derivative<joined<l>, side::minus>{};
    constexpr auto rho_l = shift<between<l>, side::minus>{};
    constexpr auto identity_l = identity_on<between<l>, step_weight>{};
    constexpr auto on_T_l = restriction_to<l, true>{};
    constexpr auto extend_l = extend_lambda<P, Q>;
    constexpr auto on_l = on_lambda<P, Q>;
    constexpr auto pi_l = projection<reduced<P, Q>, false>{};
    constexpr auto pi_l_inverse = pi_lambda_inverse<P, Q>;
    constexpr auto integral_l = antiderivative_at<reduced<P, Q>>{};

    // the extension, at both kinds of points
    static_assert(on_T_l * extend_l == identity_T and on_l * extend_l == pi_l_inverse * (rest{} * identity_T + l{} * sigma));
    static_assert(on_l * extend_l != pi_l_inverse * (l{} * identity_T + rest{} * sigma) or P * 2 == Q);
    // lemma 1, from either side
    static_assert(on_l * Delta_l_plus * extend_l == pi_l_inverse * Delta_plus and on_T_l * Delta_l_plus * extend_l == Delta_plus);
    static_assert(on_l * Delta_l_minus * extend_l == pi_l_inverse * Delta_plus and on_T_l * Delta_l_minus * extend_l == Delta_minus);
    // the adjoint of the average, on every scale and on uniform ones (J (11) has gamma = 1 - lambda)
    static_assert(adjoint(on_l * extend_l) == step_mean_at<l>{} and adjoint(step_mean_at<l>{}) == on_l * extend_l);
    using W = mean_weight<l>;
    static_assert(step_mean_at<l>{} ==
                  rest{} * (reweight<nodes, delta_weight, W>{} * pi_l) + l{} * (reweight<nodes, nabla_weight, W>{} * rho * pi_l));
    static_assert(uniformly(step_mean_at<l>{}) == pi_l * (rest{} * identity_l + l{} * rho_l));
    static_assert(step_mean_at<l>{} != pi_l * (rest{} * identity_l + l{} * rho_l));
    static_assert(adjoint(extend_l) == fraction<1, 2>{} * (on_T_l + step_mean_at<l>{} * on_l) and adjoint(adjoint(extend_l)) == extend_l);
    // the other adjoints do not depend on lambda
    static_assert(adjoint(Delta_l_plus) == -Delta_l_minus and adjoint(pi_l) == pi_l_inverse and
                  adjoint(rho_l) == shift<between<l>, side::plus>{});
    static_assert(adjoint(pi_l_inverse * Delta_plus) == -(Delta_minus * pi_l));
    static_assert(adjoint(on_T_l) == fraction<2>{} * insertion<l, true>{} and adjoint(on_l) == fraction<2>{} * insertion<l, false>{});
    // the fundamental theorem of the lambda-antiderivative (Cresson-Safi (32) to (34))
    static_assert(pi_l_inverse * Delta_plus * integral_l == identity_l and adjoint(integral_l) == tail_integral_at<l>{});
    return true;
}
static_assert(the_lambda_family_is_sound<1, 2>() and the_lambda_family_is_sound<1, 3>() and the_lambda_family_is_sound<2, 3>());
static_assert(the_lambda_family_is_sound<1, 10>() and the_lambda_family_is_sound<99, 100>() and the_lambda_family_is_sound<12, 35>());

// lambda = 0: T_0 is T^+ in all but name, and its integral is the Delta integral.
static_assert(pi_lambda_inverse<0, 1> * Delta_plus * antiderivative_at<fraction<0>>{} == identity_on<between<fraction<0>>, step_weight>{});
static_assert(antiderivative_at<fraction<0>>{} * pi_lambda_inverse<0, 1> == antiderivative);
// Lambda says where the values are taken, not their weights.
static_assert(antiderivative_at<fraction<1, 3>>{} * pi_lambda_inverse<1, 3> == antiderivative);

// The step of T_lambda is a mean of two steps of T, (1 - lambda) mu_i + lambda mu_{i+1}: on a uniform scale that is h for every lambda.
template <int P, int Q>
inline constexpr auto difference =
    projection<reduced<P, Q>, false>{}[derivative<between<fraction<P, Q>>, side::plus>{}[pi_lambda_inverse<P, Q>]];
static_assert(difference<1, 3> != difference<1, 2> and uniformly(difference<1, 3>) == difference<1, 2> and
              difference<0, 1> != difference<1, 2>);
static_assert(difference<0, 1> == Delta_plus * sigma * rho); // on T_0 the steps are those of T^+

// lambda outside its interval names nothing.
template <int P, int Q>
concept names_an_extension = requires {
    extend_lambda<P, Q>;
};
static_assert(names_an_extension<1, 3> and not names_an_extension<0, 1> and not names_an_extension<1, 1> and not names_an_extension<3, 2>);
static_assert(not names_an_extension<-1, 2>);

} // namespace
