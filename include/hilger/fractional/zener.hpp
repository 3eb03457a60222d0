// SPDX-License-Identifier: BSL-1.0
// Structures of a viscoelastic material, the fractional Zener model in one dimension (Galucio, Deue, Dubois (7)):
//   sigma + tau^alpha D^alpha sigma = E_o eps + E_inf tau^alpha D^alpha eps.
// With the anelastic strain eps_a = eps - sigma / E_inf (8) it has one fractional derivative,
//   eps_a + tau^alpha D^alpha eps_a = (E_inf - E_o) / E_inf eps,   sigma = E_inf (eps - eps_a),
// and so has the structure, K being its stiffness for E_o: M q'' + (E_inf / E_o) K (q - q_a) = f(t). The differences at t_{n+1} give q_a
// there from q and the values before, so that the step's matrix is that of (9), (10), with
//   c_a = omega(0)^alpha tau^alpha / (h^alpha + omega(0)^alpha tau^alpha);
// (10) omits omega(0)^alpha, (3/2)^alpha for G^alpha: as printed, its relaxation time is 2 tau / 3. The material is unstrained before t_0:
// q_a(t_0) = 0, whatever q(t_0) is. Its q then jumps at t_0, and q_a begins like (t - t_0)^alpha. The order is two all the same. With z =
// e^{-sh} the weights of order two and Newmark's sums (1 + z) / (2 (1 - z)) equal s^alpha and 1/(sh) up to a factor 1 + O((sh)^2); so are
// the transforms of the sequences t_n and, halved at t_0, 1 of a motion and a load. The error at a fixed t is an integral of e^{st} times
// that over a contour with s of the size of 1/t, however rough the beginning is. But q_a = 0 at t_0 leaves of the jump the sequence 0, 1,
// 1, ..., and z / (1 - z) = 1/(sh) - 1/2 + O(sh) is of order one. Hence half of the jump more at t_1 (Lubich's correction of the first
// weights): z / (1 - z) + z / 2 = 1/(sh) + O(sh).
#pragma once

#include "hilger/fractional/structure.hpp"

namespace hilger {

/// `stiffness` is K for the relaxed modulus E_o; E_inf >= E_o > 0, in one unit; tau > 0 is a time; alpha in ]0, 1], fraction<P, Q>{} or a
/// number. Matrices as in fractional_structure; all components keep a history.
template <class B, class Number, class Order>
struct zener_structure {
    B mass, stiffness;
    Number relaxed_modulus, unrelaxed_modulus;
    Number relaxation_time;
    Order order;

    /// @throws error::mismatch, error::not_finite, error::invalid_parameter
    void require_valid() const {
        detail::require_matrices(mass, stiffness);
        detail::require_positive(relaxation_time, "a relaxation time");
        detail::require_positive(relaxed_modulus, "the relaxed modulus of a material");
        if (not is_finite(unrelaxed_modulus) or unrelaxed_modulus < relaxed_modulus)
            error::raise<error::invalid_parameter>("the unrelaxed modulus of a material is not below the relaxed one, and here they are ",
                                                   unrelaxed_modulus, " and ", relaxed_modulus);
        auto const alpha = detail::checked_order(order).template as<Number>();
        if (Number(1) < alpha)
            error::raise<error::invalid_parameter>("the order of a fractional Zener material lies in ]0, 1], and this one is ", alpha);
    }

    template <generating_function G, class Policy, class S, class V>
    class response {
        using m = detail::matrices<V>;
        using order_type = decltype(detail::checked_order(std::declval<Order const&>()));

    public:
        response(zener_structure const& on, Policy const& policy, S const& h, V const& like)
            : history_(detail::checked_order(on.order), policy, initial_history::caputo, h, like), anelastic_(zero_like(like)),
              next_(anelastic_), zero_(anelastic_), difference_(anelastic_), ratio_(S(on.unrelaxed_modulus) / S(on.relaxed_modulus)),
              tau_(detail::power(S(on.relaxation_time), detail::checked_order(on.order).template as<S>())),
              present_(S(1) + tau_ * history_.present_weight()) {}
        void begin(V const& u0, V const&) {
            jump_ = u0 * S(S(1) / S(2));
            history_.begin(zero_, zero_);
            history_.arrive(zero_);
        }
        [[nodiscard]] B stiffness(zener_structure const& on) const { return on.stiffness * S(ratio_ - (ratio_ - S(1)) / present_); }
        void resist(zener_structure const& on, V& d, V const& u, V const&, bool taken) {
            if (first_) { // t_0, where q_a = 0 is known
                m::add_product(d, on.stiffness, u, S(-ratio_));
                first_ = not taken;
                return;
            }
            // The increment of eps_a, times 1 + tau^alpha h^-alpha omega(0)^alpha, is
            //   (E_inf - E_o) / E_inf eps - eps_a - tau^alpha (the derivative if eps_a stayed).
            next_ = (u + jump_) * S((ratio_ - S(1)) / ratio_) - anelastic_ - history_.at_next(anelastic_) * tau_;
            next_ = anelastic_ + next_ * S(S(1) / present_);
            difference_ = u - next_;
            m::add_product(d, on.stiffness, difference_, S(-ratio_));
            if (taken) {
                anelastic_ = next_;
                history_.arrive(anelastic_);
                jump_ = zero_;
            }
        }
        /// Everything that later forces depend on, for checkpoints.
        template <class Visit>
        void visit(Visit& each) {
            each("first", first_);
            history_.visit(each);
            detail::memory::visit_components("jump", jump_, each);
            detail::memory::visit_components("anelastic", anelastic_, each);
        }

    private:
        detail::fractional_memory<G, order_type, Policy, S, V> history_;
        V anelastic_, next_, zero_, difference_;
        V jump_{zero_}; ///< half of q(t_0), until t_1 is reached
        S ratio_, tau_, present_;
        bool first_ = true;
    };
};
template <class B, class Number, class Order>
zener_structure(B, B, Number, Number, Number, Order) -> zener_structure<B, Number, Order>;

} // namespace hilger
