// SPDX-License-Identifier: BSL-1.0
// Linear structures whose damping is a fractional derivative (Galucio, Deue, Dubois (3), (5), (6)):
//   M u'' + C tau^alpha D^alpha u + K u = f(t),   0 < alpha < 2,   D^alpha Caputo's derivative.
// A time integrator needs of a structure its mass and its internal force at the next point, an affine function of the displacement there:
// structure::response. Other materials are other structures (hilger/fractional/zener.hpp).
#pragma once

#include <Eigen/LU>

#include "hilger/fractional/memory.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger {

namespace detail {

/// Matrices that may be numbers.
template <class V>
struct matrices {
    using S = scalar_of<V>;
    using list = std::conditional_t<shape<V>::is_scalar, V, Eigen::Matrix<S, Eigen::Dynamic, 1>>;
    using columns = std::conditional_t<shape<V>::is_scalar, V, Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>>;

    /// to + factor A x
    template <class A, class X>
    static void add_product(V& to, A const& a, X const& x, S const& factor) {
        if constexpr (shape<V>::is_scalar)
            to = to + factor * a * x;
        else
            to.noalias() += factor * (a * x);
    }
};

/// A^-1 for one matrix and many right-hand sides. @throws error::singular
template <class B>
class factorized {
public:
    factorized(B const& a, char const* what) : lu_(a) {
        if (not is_regular(lu_)) error::raise<error::singular>(what, " is singular");
    }
    /// x = A^-1 b; the two are different objects.
    template <class V>
    void solve(V const& b, V& x) const {
        x = lu_.solve(b);
    }

private:
    Eigen::PartialPivLU<B> lu_;
};
template <class B>
    requires(not requires(B const& b) { b.rows(); })
class factorized<B> {
public:
    factorized(B const& a, char const* what) : a_(a) {
        if (a == B(0)) error::raise<error::singular>(what, " is singular");
    }
    void solve(B const& b, B& x) const { x = b / a_; }

private:
    B a_;
};

/// The number of rows of a square matrix, -1 for others; a number has one.
template <class B>
index_type rows_of(B const& b) {
    if constexpr (requires { b.rows(); })
        return b.rows() == b.cols() ? b.rows() : -1;
    else
        return 1;
}
/// @throws error::mismatch, error::not_finite
template <class B, class... More>
void require_matrices(B const& mass, More const&... others) {
    index_type const d = rows_of(mass);
    if (d < 1 or ((rows_of(others) != d) or ...)) error::raise<error::mismatch>("the matrices of a structure are square and of one size");
    if (not is_finite(mass) or (not is_finite(others) or ...))
        error::raise<error::not_finite>("the matrices of a structure are finite, and these contain NaN or infinity");
}
/// @throws error::invalid_parameter
template <class S>
void require_positive(S const& x, char const* what) {
    if (not is_finite(x) or not(S(0) < x)) error::raise<error::invalid_parameter>(what, " is positive, and this one is ", x);
}
} // namespace detail

/// M u'' + C tau^alpha D^alpha u + K u: numbers for one degree of freedom, square Eigen matrices for d. Columns of C that are zero cost
/// nothing: those components keep no history. `order` is fraction<P, Q>{} or a number. tau is a time, C a stiffness.
template <class B, class Time, class Order>
struct fractional_structure {
    B mass, damping, stiffness;
    Time relaxation_time;
    Order order;

    /// @throws error::mismatch, error::not_finite, error::invalid_parameter
    void require_valid() const {
        detail::require_matrices(mass, damping, stiffness);
        detail::require_positive(relaxation_time, "a relaxation time");
        (void)detail::checked_order(order);
    }
    /// Along one trajectory of displacements V with steps h.
    template <generating_function G, class Policy, class S, class V>
    class response {
        using m = detail::matrices<V>;
        using s = detail::shape<V>;
        using kept = typename m::list;
        using order_type = decltype(detail::checked_order(std::declval<Order const&>()));

    public:
        response(fractional_structure const& on, Policy const& policy, S const& h, V const&)
            : damped_(damped_components_of(on.damping)), x_(detail::shape<kept>::zero(static_cast<int>(damped_.size()))),
              history_(detail::checked_order(on.order), policy, initial_history::caputo, h, x_), C_(damping_columns(on)) {}
        void begin(V const& u0, V const& v0) {
            if (damped_.empty()) return;
            take(v0);
            kept const velocity = x_;
            take(u0);
            history_.begin(x_, velocity);
        }
        /// The derivative of the internal force at the next point by the displacement there.
        [[nodiscard]] B stiffness(fractional_structure const& on) const {
            B k = on.stiffness;
            if constexpr (s::is_scalar)
                k = k + C_ * history_.present_weight();
            else
                for (std::size_t j = 0; j < damped_.size(); ++j)
                    k.col(damped_[j]) += C_.col(static_cast<index_type>(j)) * history_.present_weight();
            return k;
        }
        /// Subtracts from d the internal force at the next point for the displacement u, `increment` further; `taken`: the history takes u.
        void resist(fractional_structure const& on, V& d, V const& u, V const& increment, bool taken) {
            m::add_product(d, on.stiffness, u, S(-1));
            if (damped_.empty()) return;
            take(increment);
            by_ = x_;
            take(u);
            m::add_product(d, C_, taken ? history_.arrive(x_, by_) : history_.at_next(x_, by_), S(-1));
        }
        /// Everything that later forces depend on, for checkpoints.
        template <class Visit>
        void visit(Visit& each) {
            if (not damped_.empty()) history_.visit(each);
        }

    private:
        void take(V const& u) {
            for (std::size_t k = 0; k < damped_.size(); ++k)
                detail::shape<kept>::component(x_, static_cast<int>(k)) = s::component(u, damped_[k]);
        }
        static std::vector<int> damped_components_of(B const& C) {
            std::vector<int> all;
            for (int j = 0; j < static_cast<int>(detail::rows_of(C)); ++j)
                if constexpr (s::is_scalar) {
                    if (not(C == B(0))) all.push_back(j);
                } else if (not(magnitude(V(C.col(j))) == S(0)))
                    all.push_back(j);
            return all;
        }
        /// C tau^alpha, without the columns that are zero
        typename m::columns damping_columns(fractional_structure const& on) const {
            S const scale = detail::power(S(on.relaxation_time), detail::checked_order(on.order).template as<S>());
            if constexpr (s::is_scalar)
                return on.damping * scale;
            else {
                typename m::columns c(detail::rows_of(on.damping), static_cast<index_type>(damped_.size()));
                for (std::size_t k = 0; k < damped_.size(); ++k) c.col(static_cast<index_type>(k)) = on.damping.col(damped_[k]) * scale;
                return c;
            }
        }
        std::vector<int> damped_;
        kept x_, by_ = x_;
        detail::fractional_memory<G, order_type, Policy, S, kept> history_;
        typename m::columns C_;
    };
};
template <class B, class Time, class Order>
fractional_structure(B, B, B, Time, Order) -> fractional_structure<B, Time, Order>;

} // namespace hilger
