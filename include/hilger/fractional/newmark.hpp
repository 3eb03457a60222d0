// SPDX-License-Identifier: BSL-1.0
// Newmark's method for structures with memory (Galucio, Deue, Dubois (5), (9)), with gamma = 1/2, and beta = 1/4 for the average
// acceleration. With the momentum p = M u' and the total force r = M u'' it reads
//   M (u_{n+1} - u_n) = h p_n + h^2 ((1/2 - beta) r_n + beta r_{n+1}),   p_{n+1} = p_n + (h/2) (r_n + r_{n+1}),
// r_n being the load f(t_n) less the internal force, in which fractional derivatives have the weights of any generating function. The
// unknown of a step is the increment u_{n+1} - u_n, which is also the argument of histories, and the sums of positions and momenta are
// compensated: differences of positions, whose rounding grows like n^2, are nowhere formed. A load with jumps at its switching_times(a, b)
// keeps the order two (fractional/switched_load.hpp). u_0 and u'_0 need not be zero, and no start-up step is needed: with weights of order
// two the order is two for all alpha in ]0, 2[.
//   auto const scheme = newmark<bdf<2>>(fractional_structure{M, C, K, tau, alpha}, load);            the G^alpha-Newmark scheme
//   for (auto const& [t, u, p] : scheme.along(uniform(0.0, h, N), initial_velocity{u0, v0})) ...
#pragma once

#include "hilger/fractional/structure.hpp"
#include "hilger/fractional/switched_load.hpp"
#include "hilger/step/summation.hpp"
#include "hilger/trajectory/stepping.hpp"

namespace hilger {

/// Newmark's beta. All have order two with a generating function of order two; they differ in the error of an undamped frequency w, w -
/// computed = (beta - 1/12) w^3 h^2 / 2 + ..., and for beta < 1/4 steps have an upper limit: the motion grows where an eigenvalue of (1 - 4
/// beta) h^2 M^-1 (C tau^alpha h^-alpha omega(-1)^alpha + K) is above 4.
inline constexpr fraction<1, 4> average_acceleration{};
inline constexpr fraction<1, 6> linear_acceleration{};
inline constexpr fraction<1, 12> fox_goodwin{};
inline constexpr fraction<0> central_difference{};

/// Newmark's method for a structure under a load; see newmark(). Exists on uniform T only.
template <generating_function G, class Structure, class Load, class Beta, class Policy>
class newmark_flow : public stepping<newmark_flow<G, Structure, Load, Beta, Policy>> {
    using B = decltype(Structure::mass);

public:
    newmark_flow(Structure structure, Load load, Policy policy)
        : structure_((structure.require_valid(), std::move(structure))), load_(std::move(load)), policy_(std::move(policy)),
          mass_(structure_.mass, "the mass of a structure") {}

    /// Each step depends on all steps before it.
    static constexpr bool has_history = true;

    /// The factorized matrix, the force, and the history of the damped components.
    template <class S, class V>
    class memory {
        using s = detail::shape<V>;

    public:
        /// @throws error::singular when M + beta h^2 (K + the part of the history) is
        memory(newmark_flow const& f, S const& h, V const& like)
            : h_(h), load_(h), response_(f.structure_, f.policy_, h, like), A_(matrix_of_a_step(f), "the matrix of a Newmark step"),
              r_(zero_like(like)), d_(r_), u_(r_), by_(r_), zero_(r_), sum_q_(s::dimension(like)), sum_p_(s::dimension(like)) {}

        /// Advances x by one step h. @throws error::mismatch when h is not the step of the history or the load has another dimension,
        /// error::not_finite; x is unchanged then.
        void advance(newmark_flow const& f, state<S, V>& x, S const& h) {
            begin(f, x, h);
            move(f, x);
        }
        void begin(newmark_flow const& f, state<S, V> const& x, S const& h) {
            if (not(h == h_))
                error::raise<error::mismatch>("fractional damping remembers steps of one length, ", h_, ", and this step has ", h);
            if (begun_) return;
            response_.begin(x.q, f.velocity(x.p));
            force(f, x.t, x.q, zero_, true);
            r_ = d_;
            begun_ = true;
        }
        /// @throws the same as a step_failure
        void advance_equally(newmark_flow const& f, state<S, V>& x) {
            saying_where(x, h_, [&] { move(f, x); });
        }
        /// Everything that later steps depend on, for checkpoints.
        template <class Visit>
        void visit(newmark_flow const&, Visit& each) {
            each("begun", begun_);
            response_.visit(each);
            detail::memory::visit_components("force", r_, each);
            sum_q_.visit(each);
            sum_p_.visit(each);
        }

    private:
        void move(newmark_flow const& f, state<S, V>& x) {
            S const beta = Beta::template as<S>();
            S const t = x.t + h_, hh = h_ * h_, half_h = h_ / S(2);
            force(f, t, x.q, zero_, false); // the force if u stayed
            d_ = x.p * h_ + r_ * S(hh * (S(1) / S(2) - beta)) + d_ * S(hh * beta);
            A_.solve(d_, by_);
            u_ = x.q;
            add(sum_q_, u_, by_);
            if (not is_finite(u_)) error::raise<error::not_finite>("the Newmark step meets NaN or infinity");
            force(f, t, u_, by_, true);
            by_ = (r_ + d_) * half_h;
            r_ = x.p;
            add(sum_p_, r_, by_);
            if (not is_finite(r_)) error::raise<error::not_finite>("the Newmark step meets NaN or infinity in its momentum");
            x.q = u_;
            x.p = r_;
            r_ = d_;
            x.t = t;
        }
        /// d_ = f(t) - internal force at the next point; `taken`: the history takes u.
        void force(newmark_flow const& f, S const& t, V const& u, V const& increment, bool taken) {
            load_.read(f.load_, t, not begun_, d_);
            if (s::dimension(d_) != s::dimension(u))
                error::raise<error::mismatch>("a load has one component for each degree of freedom, and this one has ", s::dimension(d_),
                                              " for ", s::dimension(u));
            response_.resist(f.structure_, d_, u, increment, taken);
        }
        template <class Sum>
        static void add(Sum& sum, V& to, V const& increment) {
            for (int k = 0; k < s::dimension(to); ++k) sum.add(s::component(to, k), s::component(increment, k), k);
        }
        B matrix_of_a_step(newmark_flow const& f) const {
            return f.structure_.mass + response_.stiffness(f.structure_) * S(Beta::template as<S>() * h_ * h_);
        }
        S h_;
        detail::switched_load<S> load_;
        typename Structure::template response<G, Policy, S, V> response_;
        detail::factorized<B> A_;
        V r_, d_, u_, by_, zero_;
        detail::summation<not std::numeric_limits<S>::is_exact, S, s::size> sum_q_, sum_p_;
        bool begun_ = false;
    };

    /// Only on scales with equal steps: differences of fractional order are defined there. p0 = M u'(0).
    /// @throws error::mismatch when q0 has another dimension than M, error::not_finite; during iteration, a step_failure.
    template <time_scale_like Scale, class V>
    auto start(Scale const& T, V q0, V p0) const {
        detail::require_equal_steps<Scale>();
        index_type const d = detail::rows_of(structure_.mass);
        if (detail::shape<V>::dimension(q0) != d)
            error::raise<error::mismatch>("a structure of ", d, " degrees of freedom starts from as many, and not from ",
                                          detail::shape<V>::dimension(q0));
        return stepping<newmark_flow>::start(T, std::move(q0), std::move(p0));
    }
    /// p = M u'
    template <class S, class V>
    [[nodiscard]] V momentum(S const&, V const&, V const& v) const {
        return V(structure_.mass * v);
    }
    /// Refused: one step has no history.
    template <class S, class V>
    auto step(state<S, V> const&, S const&) const {
        return detail::no_single_step<S>();
    }
    /// u' = M^-1 p
    template <class V>
    [[nodiscard]] V velocity(V const& p) const {
        V v = p;
        mass_.solve(p, v);
        return v;
    }
    [[nodiscard]] Structure const& structure() const { return structure_; }

private:
    Structure structure_;
    [[no_unique_address]] Load load_;
    [[no_unique_address]] Policy policy_;
    detail::factorized<B> mass_;
};

/// The Newmark scheme of a structure under the load f(t), a vector of its dimension (a number for one degree of freedom), with the weights
/// of G: bdf<2> is the G^alpha-scheme, grunwald_letnikov of order one.
/// @throws error::mismatch, error::not_finite, error::invalid_parameter, error::singular as the structure's members require
template <generating_function G, class Structure, class Load, class Beta = fraction<1, 4>, class Policy = direct>
auto newmark(Structure const& structure, Load load, Beta = {}, Policy policy = {}) {
    return newmark_flow<G, Structure, Load, Beta, Policy>(structure, std::move(load), std::move(policy));
}

} // namespace hilger
