// SPDX-License-Identifier: BSL-1.0
// Newmark's method for linear structures with fractional damping (Galucio, Deue, Dubois (3), (5), (6), (9)):
//   M u'' + C tau^alpha D^alpha u + K u = f(t),   0 < alpha < 2,   D^alpha Caputo's derivative,
// with gamma = 1/2, and beta = 1/4 for the average acceleration. With the momentum p = M u' and the total force r = M u'' it reads
//   M (u_{n+1} - u_n) = h p_n + h^2 ((1/2 - beta) r_n + beta r_{n+1}),   p_{n+1} = p_n + (h/2) (r_n + r_{n+1}),
//   r_n = f(t_n) - K u_n - C tau^alpha (D^alpha u)_n,   (D^alpha u)_n by the weights of any generating function.
// The unknown of a step is the increment u_{n+1} - u_n: second differences of positions, whose rounding grows like n^2, are nowhere formed.
// M is divided by for beta = 0 only, and may otherwise be singular.
//   auto const scheme = newmark<bdf<2>>(fractional_structure{.mass = M, ...}, load);            the G^alpha-Newmark scheme
//   for (auto const& [t, u, p] : scheme.along(uniform(0.0, h, N), initial_velocity{u0, v0})) ...
#pragma once

#include <Eigen/LU>

#include "hilger/integrator/fractional_memory.hpp"
#include "hilger/integrator/trajectory.hpp"
#include "hilger/mechanics/newton_stop.hpp"

namespace hilger {

/// M u'' + C tau^alpha D^alpha u + K u: numbers for one degree of freedom, square Eigen matrices for d. Columns of C that are zero cost
/// nothing: those components keep no history. `order` is fraction<P, Q>{} or a number. tau is a time, C a stiffness.
template <class B, class Time, class Order>
struct fractional_structure {
    B mass, damping, stiffness;
    Time relaxation_time;
    Order order;
};
template <class B, class Time, class Order>
fractional_structure(B, B, B, Time, Order) -> fractional_structure<B, Time, Order>;

/// Newmark's beta. All have order two with a generating function of order two; what differs is the error of an undamped frequency w, of
/// which the first term is (beta - 1/12) w^3 h^2 / 2, and that for beta < 1/4 h has an upper limit of the size of 1/w.
inline constexpr fraction<1, 4> average_acceleration{};
inline constexpr fraction<1, 6> linear_acceleration{};
inline constexpr fraction<1, 12> fox_goodwin{};
inline constexpr fraction<0> central_difference{};

namespace detail {

/// What matrices that may be numbers do.
template <class V>
struct matrices {
    using S = scalar_of<V>;
    using kept = std::conditional_t<shape<V>::is_scalar, V, Eigen::Matrix<S, Eigen::Dynamic, 1>>;
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
    template <class V>
    void solve(V& x) {
        x = lu_.solve(x);
    }

private:
    Eigen::PartialPivLU<B> lu_;
};
template <class B>
    requires(shape<B>::is_scalar and not requires(B const& b) { b.rows(); })
class factorized<B> {
public:
    factorized(B const& a, char const* what) : a_(a) {
        if (a == B(0)) error::raise<error::singular>(what, " is singular");
    }
    void solve(B& x) const { x = x / a_; }

private:
    B a_;
};

/// The number of rows of a square matrix; a number has one.
template <class B>
index rows_of(B const& b) {
    if constexpr (requires { b.rows(); })
        return b.rows() == b.cols() ? b.rows() : -1;
    else
        return 1;
}

} // namespace detail

template <generating_function G, class B, class Time, class Order, class Load, class Beta, class Policy>
class newmark_flow : public stepping<newmark_flow<G, B, Time, Order, Load, Beta, Policy>> {
public:
    newmark_flow(fractional_structure<B, Time, Order> structure, Load load, Policy policy)
        : structure_(std::move(structure)), load_(std::move(load)), policy_(std::move(policy)) {
        auto const& [M, C, K, tau, order] = structure_;
        index const d = detail::rows_of(M);
        if (d < 1 or detail::rows_of(C) != d or detail::rows_of(K) != d)
            error::raise<error::mismatch>("mass, damping and stiffness of a structure are square matrices of one size");
        if (not is_finite(M) or not is_finite(C) or not is_finite(K))
            error::raise<error::not_finite>("mass, damping and stiffness of a structure are finite, and these contain NaN or infinity");
        if (not is_finite(tau) or not(Time(0) < tau))
            error::raise<error::invalid_parameter>("a relaxation time is positive, and this one is ", tau);
    }

    /// The factorized matrix, the force, and the history of the damped components.
    template <class S, class V>
    class memory {
        using m = detail::matrices<V>;
        using s = detail::shape<V>;
        using kept = typename m::kept;

    public:
        /// @throws error::singular when M + beta h^2 (K + C (tau / h)^alpha omega(0)^alpha) is
        memory(newmark_flow const& f, S const& h, V const& like)
            : h_(h), damped_(damped_components(f.structure_.damping)),
              history_(f.structure_.order, f.policy_, initial_history::caputo, h,
                       detail::shape<kept>::zero(static_cast<int>(damped_.size()))),
              C_(damping_columns(f)), A_(matrix_of_a_step(f), "the matrix of a Newmark step"), r_(zero_like(like)), d_(r_), u_(r_),
              x_(detail::shape<kept>::zero(static_cast<int>(damped_.size()))) {}

        /// One step h further. @throws error::mismatch when h is not the length that the history has, error::not_finite
        void advance(newmark_flow const& f, state<S, V>& x, S const& h) {
            begin(f, x, h);
            move(f, x);
        }
        void begin(newmark_flow const& f, state<S, V> const& x, S const& h) {
            if (not(h == h_))
                error::raise<error::mismatch>("fractional damping remembers steps of one length, ", h_, ", and this step has ", h);
            if (begun_) return;
            V v0 = x.p;
            detail::factorized<B>(f.structure_.mass, "the mass, which gives the first velocity,").solve(v0);
            if (not damped_.empty()) {
                take(v0);
                kept const velocity = x_;
                take(x.q);
                history_.begin(x_, velocity);
            }
            force(f, x.t, x.q, true);
            r_ = d_;
            begun_ = true;
        }
        /// @throws the same as a step_failure
        void advance_equally(newmark_flow const& f, state<S, V>& x) {
            saying_where(x, h_, [&] { move(f, x); });
        }
        /// The total force M u'' at the point reached last.
        [[nodiscard]] V const& total_force() const { return r_; }
        /// The number of components that keep a history.
        [[nodiscard]] index damped_components() const { return static_cast<index>(damped_.size()); }

    private:
        void move(newmark_flow const& f, state<S, V>& x) {
            S const beta = Beta::template as<S>();
            S const t = x.t + h_, hh = h_ * h_, half_h = h_ / S(2);
            force(f, t, x.q, false); // what the force would be if u stayed
            u_ = x.p * h_ + r_ * S(hh * (S(1) / S(2) - beta)) + d_ * S(hh * beta);
            A_.solve(u_);
            u_ = u_ + x.q;
            if (not is_finite(u_)) error::raise<error::not_finite>("the Newmark step meets NaN or infinity");
            force(f, t, u_, true);
            x.q = u_;
            x.p = x.p + (r_ + d_) * half_h;
            r_ = d_;
            x.t = t;
        }
        /// d_ = f(t) - K u - C tau^alpha D^alpha u at the next point of the history, which takes u or not.
        void force(newmark_flow const& f, S const& t, V const& u, bool taken) {
            d_ = f.load_(t);
            m::add_product(d_, f.structure_.stiffness, u, S(-1));
            if (damped_.empty()) return;
            take(u);
            m::add_product(d_, C_, taken ? history_.arrive(x_) : history_.at_next(x_), S(-1));
        }
        void take(V const& u) {
            for (std::size_t k = 0; k < damped_.size(); ++k)
                detail::shape<kept>::component(x_, static_cast<int>(k)) = s::component(u, damped_[k]);
        }
        static std::vector<int> damped_components(B const& C) {
            std::vector<int> all;
            for (int j = 0; j < static_cast<int>(detail::rows_of(C)); ++j)
                if constexpr (s::is_scalar) {
                    if (not(C == B(0))) all.push_back(j);
                } else if (not(magnitude(V(C.col(j))) == S(0)))
                    all.push_back(j);
            return all;
        }
        /// C tau^alpha, without the columns that are zero
        typename m::columns damping_columns(newmark_flow const& f) const {
            S const scale = detail::power(S(f.structure_.relaxation_time), S(f.structure_.order.template as<S>()));
            if constexpr (s::is_scalar)
                return f.structure_.damping * scale;
            else {
                typename m::columns c(detail::rows_of(f.structure_.damping), static_cast<index>(damped_.size()));
                for (std::size_t k = 0; k < damped_.size(); ++k)
                    c.col(static_cast<index>(k)) = f.structure_.damping.col(damped_[k]) * scale;
                return c;
            }
        }
        B matrix_of_a_step(newmark_flow const& f) const {
            S const weight = Beta::template as<S>() * h_ * h_;
            B a = f.structure_.mass + f.structure_.stiffness * weight;
            if (damped_.empty()) return a;
            if constexpr (s::is_scalar)
                a = a + C_ * S(weight * history_.present_weight());
            else
                for (std::size_t k = 0; k < damped_.size(); ++k)
                    a.col(damped_[k]) += C_.col(static_cast<index>(k)) * S(weight * history_.present_weight());
            return a;
        }
        S h_;
        std::vector<int> damped_;
        detail::fractional_memory<G, Order, Policy, S, kept> history_;
        typename m::columns C_;
        detail::factorized<B> A_;
        V r_, d_, u_;
        kept x_;
        bool begun_ = false;
    };

    /// Only on scales with equal steps: differences of fractional order are defined there. p0 = M u'(0).
    /// @throws error::mismatch when q0 has another dimension than M, error::not_finite; while walking, a step_failure.
    template <time_scale_like Scale, class V>
    auto along(Scale const& T, V q0, V p0) const {
        if constexpr (not(Scale::root_type::is_uniform and detail::has_equal_steps<typename Scale::domain_type::base_type>))
            return does_not_compile<text("fractional damping lives on a uniform T, and this one has steps of different lengths")>{};
        else {
            if (detail::shape<V>::dimension(q0) != detail::rows_of(structure_.mass))
                error::raise<error::mismatch>("a structure of ", detail::rows_of(structure_.mass),
                                              " degrees of freedom starts from as many, and not from ", detail::shape<V>::dimension(q0));
            return stepping<newmark_flow>::along(T, std::move(q0), std::move(p0));
        }
    }
    template <time_scale_like Scale, class V>
    auto along(Scale const& T, initial_velocity<V> const& from) const {
        return along(T, from.q0, V(structure_.mass * from.v0));
    }
    /// One step has no history.
    template <class S, class V>
    auto step(state<S, V> const&, S const&) const {
        return does_not_compile<text("a step with fractional damping depends on all steps before it: walk along(T, q0, p0)")>{};
    }
    [[nodiscard]] auto const& structure() const { return structure_; }

private:
    fractional_structure<B, Time, Order> structure_;
    [[no_unique_address]] Load load_;
    [[no_unique_address]] Policy policy_;
};

/// The Newmark scheme of a structure under the load f(t), a vector of its dimension (a number for one degree of freedom), with the weights
/// of G: bdf<2> is the G^alpha-scheme, grunwald_letnikov of order one. @throws error::mismatch, error::not_finite, error::invalid_parameter
template <generating_function G, class B, class Time, class Order, class Load, class Beta = fraction<1, 4>, class Policy = direct>
auto newmark(fractional_structure<B, Time, Order> const& structure, Load load, Beta = {}, Policy policy = {}) {
    if constexpr (detail::is_fraction<Order>)
        return newmark_flow<G, B, Time, Order, Load, Beta, Policy>(structure, std::move(load), std::move(policy));
    else {
        detail::require_order(structure.order);
        using order = run_time<Order>;
        return newmark_flow<G, B, Time, order, Load, Beta, Policy>(
            {structure.mass, structure.damping, structure.stiffness, structure.relaxation_time, order{structure.order}}, std::move(load),
            std::move(policy));
    }
}

} // namespace hilger
