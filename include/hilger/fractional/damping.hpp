// SPDX-License-Identifier: BSL-1.0
// A Lagrangian with fractional damping: -rho D^beta q beside dL/dq, 0 < beta < 2, with D^beta q from the weights of a generating function
// and a history policy; and the history of those components of a trajectory that have a rho. A reading says how a step uses it:
//   fractional/mean.hpp       a mean over the step, with the unknown position in it: order two, no limit of stability
//   fractional/impulses.hpp   impulses at the points, as the restricted variational principle has them: explicit
// A reading r has a history r.template along<S, V>(h, like), which defines the changes before and after each undamped step.
#pragma once

#include <algorithm>
#include <ranges>
#include <tuple>
#include <type_traits>
#include <vector>

#include "hilger/fractional/memory.hpp"
#include "hilger/step/state.hpp"

namespace hilger {

/// -rho D^beta q, D by the weights of G, with a history policy.
template <generating_function G, class Rho, class Order, class Policy>
struct fractional_damping {
    using generating = G;
    Rho coefficient;
    [[no_unique_address]] Order order;
    [[no_unique_address]] Policy policy;
    initial_history history = initial_history::caputo;
};

/// A Lagrangian, with or without forces, and a reading of its damping.
template <class L, class Reading>
struct damped_problem {
    [[no_unique_address]] L mechanics;
    Reading damping;
};

namespace detail {

template <class L>
inline constexpr bool is_damped = false;
template <class L, class Reading>
inline constexpr bool is_damped<damped_problem<L, Reading>> = true;

/// Whether the order may be above 1, where the rounding of positions matters in small steps.
template <class Damping>
inline constexpr bool may_exceed_one = true;
template <generating_function G, class Rho, int P, int Q, class Policy>
inline constexpr bool may_exceed_one<fractional_damping<G, Rho, fraction<P, Q>, Policy>> = P > Q;

template <class Policy>
concept options_of_a_damping = requires(Policy const& p) {
    p.history;
};
/// A coefficient as it is stored: a number, or a column with one for each component.
template <class Rho>
auto kept_coefficient(Rho const& rho) {
    if constexpr (requires { rho.allFinite(); }) {
        static_assert(Rho::ColsAtCompileTime == 1,
                      "a fractional damping has one number for all components or one for each, as a column vector or diagonal(); couplings "
                      "of components, as a matrix has them, are not among them");
        Eigen::Matrix<typename Rho::Scalar, Rho::RowsAtCompileTime, 1> column;
        if constexpr (Rho::ColsAtCompileTime == 1) column = rho;
        return column;
    } else {
        static_assert(
            not std::ranges::range<Rho> and not requires { rho.diagonal(); },
            "the coefficients of a fractional damping, one for each component, are a column vector of Eigen's");
        return rho;
    }
}

/// A damping, checked. @throws error::invalid_parameter
template <generating_function G, class Given, class Order, class Policy>
auto checked_damping(Given const& given, Order const& beta, Policy policy, initial_history history) {
    static_assert(std::is_class_v<Policy> and not options_of_a_damping<Policy>,
                  "a damping is given by its coefficient, its order, a history as direct{}, blocks{} or exponentials{} and, for "
                  "impulses, its options, in this order");
    auto rho = kept_coefficient(given);
    using Rho = decltype(rho);
    if (not all_finite(rho)) error::raise<error::invalid_parameter>("the coefficient of a fractional damping is a finite number");
    auto order = checked_order(beta);
    return fractional_damping<G, Rho, decltype(order), Policy>{std::move(rho), std::move(order), std::move(policy), history};
}

/// The components of states V that a damping acts on.
template <class Damping, class S, class V>
class damped_places {
    using s = shape<V>;
    static constexpr bool same_for_all = shape<decltype(Damping::coefficient)>::is_scalar;

public:
    using kept = std::conditional_t<s::is_scalar, V, Eigen::Matrix<S, Eigen::Dynamic, 1>>;

    damped_places(Damping const& d, V const& like) : damped_(components(d, like)), taken_(shape<kept>::zero(count())) {}
    [[nodiscard]] int count() const { return static_cast<int>(damped_.size()); }
    /// These components of q.
    kept const& of(V const& q) {
        for (int k = 0; k < count(); ++k) shape<kept>::component(taken_, k) = s::component(q, at(k));
        return taken_;
    }
    /// x_j += factor y_k for the k-th of them, j
    void add(V& x, S const& factor, kept const& y) const {
        for (int k = 0; k < count(); ++k) {
            S& to = s::component(x, at(k));
            to = to + factor * shape<kept>::component(y, k);
        }
    }
    /// Their coefficients.
    [[nodiscard]] kept coefficients(Damping const& d) const {
        kept rho = shape<kept>::zero(count());
        for (int k = 0; k < count(); ++k) shape<kept>::component(rho, k) = coefficient(d, at(k));
        return rho;
    }
    [[nodiscard]] int at(int k) const { return damped_[static_cast<std::size_t>(k)]; }
    static S coefficient(Damping const& d, int j) {
        if constexpr (same_for_all)
            return S(d.coefficient);
        else
            return S(d.coefficient(j));
    }
    /// @throws error::mismatch
    static void require_dimension(Damping const& d, V const& like) {
        if constexpr (not same_for_all)
            if (s::dimension(like) != d.coefficient.size())
                error::raise<error::mismatch>("a fractional damping has one coefficient for each component, and here are ",
                                              d.coefficient.size(), " for ", s::dimension(like));
    }

private:
    static std::vector<int> components(Damping const& d, V const& like) {
        std::vector<int> all;
        for (int j = 0; j < s::dimension(like); ++j)
            if (not(coefficient(d, j) == S(0))) all.push_back(j);
        return all;
    }
    std::vector<int> damped_;
    kept taken_;
};
/// The same, and their history along one trajectory with steps h.
template <class Damping, class S, class V>
class damped_components : public damped_places<Damping, S, V> {
    using places = damped_places<Damping, S, V>;

public:
    using typename places::kept;
    using memory = fractional_memory<typename Damping::generating, decltype(Damping::order), decltype(Damping::policy), S, kept>;

    damped_components(Damping const& d, S const& h, V const& like)
        : places(d, like), history_(d.order, d.policy, d.history, h, shape<kept>::zero(places::count())) {}
    [[nodiscard]] memory& history() { return history_; }
    [[nodiscard]] memory const& history() const { return history_; }
    [[nodiscard]] bool needs_velocity() const { return places::count() > 0 and history_.needs_velocity(); }
    /// Everything that later derivatives depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        if (places::count() > 0) history_.visit(each);
    }

private:
    memory history_;
};

/// The dampings of a sum along one trajectory, each with a history of its own.
template <class Term>
class sum_of_dampings {
public:
    [[nodiscard]] bool needs_velocity() const {
        return std::any_of(terms_.begin(), terms_.end(), [](Term const& d) { return d.needs_velocity(); });
    }
    /// Everything that later steps depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        for (Term& d : terms_) d.visit(each);
    }
    /// The force at the point reached last, or with `back` at the one before.
    template <class V>
    void add_force(V& force, bool back) const {
        for (Term const& d : terms_) d.add_force(force, back);
    }

protected:
    std::vector<Term> terms_;
};

} // namespace detail
} // namespace hilger
