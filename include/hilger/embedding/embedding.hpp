// SPDX-License-Identifier: BSL-1.0
// An embedding takes a Lagrangian to a discrete scale by a position operator A, a velocity operator B, and the integral of L(A q, B q). The
// library's own and a user's are the same aggregate of three operators.
//   order_one        q, Delta_plus[q], the Delta integral          (Cresson-Safi (10))
//   order_one_left   q, Delta_minus[q], the nabla integral
//   theta<P, Q>      q_{o,lambda}, Delta_plus[q], the lambda-integral, lambda = P/Q
//   mid_point         q_o, Delta_o_plus[q_o], the 1/2-integral      (Cresson-Safi (43)), which is theta<1, 2>
#pragma once

#include "hilger/embedding/one_step.hpp"

namespace hilger {

/// Permits an embedding whose steps converge to another system: make_embedding<W>(A, B, name, inconsistent).
struct inconsistent_t {};
inline constexpr inconsistent_t inconsistent{};

/// Position and Velocity map C(T) to one common scale; Weight is the integral's weight there: delta_weight, nabla_weight or step_weight. An
/// embedding that is not consistent (embedding/one_step.hpp) is refused, at compile time or, where its numbers are known at run time only,
/// when it is stepped, unless Checked = false.
template <linear_map Position, linear_map Velocity, class Weight, bool Checked = true>
struct embedding {
    static_assert(std::is_same_v<typename Position::to, typename Velocity::to>, "position and velocity of an embedding meet on one scale");
    static constexpr auto found = Checked ? detail::consistency_by_type<Position, Velocity, Weight>() : detail::consistency::holds;
    static_assert(
        found != detail::consistency::weights,
        "the weights of an embedding add up to the step h, and these do not, so that it integrates another system; if that is meant, "
        "say make_embedding<Weight>(position, velocity, name, inconsistent)");
    static_assert(found != detail::consistency::position_of_one,
                  "the position operator of an embedding makes 1 of the constant 1, and this one does not, so that it integrates another "
                  "system; if that is meant, say make_embedding<Weight>(position, velocity, name, inconsistent)");
    static_assert(found != detail::consistency::velocity_of_one,
                  "the velocity operator of an embedding makes 0 of the constant 1, and this one does not, so that it integrates another "
                  "system; if that is meant, say make_embedding<Weight>(position, velocity, name, inconsistent)");
    static_assert(found != detail::consistency::velocity_of_time,
                  "the velocity operator of an embedding makes 1 of the function t, and this one does not, so that it integrates another "
                  "system; if that is meant, say make_embedding<Weight>(position, velocity, name, inconsistent)");
    static_assert(found != detail::consistency::values_inside,
                  "the velocities at the nodes of an embedding determine the values inside the step, and here they are too few, so that it "
                  "integrates another system; if that is meant, say make_embedding<Weight>(position, velocity, name, inconsistent)");
    using weight = Weight;
    [[no_unique_address]] Position position;
    [[no_unique_address]] Velocity velocity;
    char const* name;
};

/// The embedding with position operator A, velocity operator B and the integral of weight W: delta_weight over T^+, nabla_weight over T^-,
/// step_weight over T_lambda. `name` is its name in reports.
template <class Weight, linear_map Position, linear_map Velocity>
constexpr auto make_embedding(Position position, Velocity velocity, char const* name) {
    return embedding<Position, Velocity, Weight>{position, velocity, name};
}
/// The same for operators that are not consistent, on purpose.
template <class Weight, linear_map Position, linear_map Velocity>
constexpr auto make_embedding(Position position, Velocity velocity, char const* name, inconsistent_t) {
    return embedding<Position, Velocity, Weight, false>{position, velocity, name};
}

inline constexpr auto order_one = make_embedding<delta_weight>(identity_T, Delta_plus, "order one");
inline constexpr auto order_one_left = make_embedding<nabla_weight>(identity_on<nodes, nabla_weight>{}, Delta_minus, "order one, left");

namespace detail {
template <int P, int Q>
constexpr auto theta_of() {
    static_assert(lambda_inside<fraction<P, Q>>, "the lambda of theta<P, Q> lies in ]0, 1[; at its ends are order_one and order_one_left");
    if constexpr (lambda_inside<fraction<P, Q>>)
        return make_embedding<step_weight>(on_lambda<P, Q> * extend_lambda<P, Q>, pi_lambda_inverse<P, Q> * Delta_plus, "theta");
    else
        return order_one;
}
} // namespace detail
/// The lambda-embedding, lambda = P/Q in ]0, 1[. The velocity is Delta_o_plus[q_o] on T_lambda, one difference by lemma 1 of Cresson-Safi.
template <int P, int Q>
inline constexpr auto theta = detail::theta_of<P, Q>();
/// The same for a lambda known at run time only. @throws error::invalid_parameter when lambda is outside ]0, 1[.
template <class S>
constexpr auto theta_at(S const& lambda) {
    using number = std::conditional_t<std::is_integral_v<S>, double, S>;
    using at = run_time<number>;
    return make_embedding<step_weight>(restriction_to<at, false>{{}, at{number(lambda)}} * extend_at(number(lambda)),
                                       projection<at, true>{{}, at{number(lambda)}} * Delta_plus, "theta");
}
inline constexpr auto mid_point = make_embedding<step_weight>(on_half * extend, pi_inverse* Delta_plus, "mid-point");

} // namespace hilger
