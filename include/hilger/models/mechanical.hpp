// SPDX-License-Identifier: BSL-1.0
// Large systems of known structure: L(q, v) = v.Mv / 2 - U(q) with a constant mass M and a potential that is a sum of small terms. The sum
// determines the nonzero second derivatives: a step of d = 1000 costs as much as its terms, and no d x d matrix is filled.
//   mechanical{mass, chain{energy}}             neighbours in a row between two walls: a tridiagonal Hessian
//   mechanical{mass, pairs<3>{list, energy}}    bodies in space, two at a time
//   mechanical{mass, any generic U(q)}          a dense Hessian, by jets
// Mass is a number, a vector (one mass a component) or a matrix with a positive definite symmetric part.
#pragma once

#include <utility>

#include "hilger/inlining.hpp"
#include "hilger/models/mass_solver.hpp"
#include "hilger/models/pairs.hpp"

namespace hilger {

/// U(q) = sum_{k=0..d} energy(k, q_k - q_{k-1}) with q_{-1} = q_d = 0: d particles on a line, the walls at rest. energy(k, r) is generic in
/// r.
template <class Energy>
struct chain {
    [[no_unique_address]] Energy energy;

    explicit constexpr chain(Energy e) : energy(std::move(e)) {}

    /// U(q) of a vector q, in any number type.
    template <class X>
    auto operator()(X const& q) const {
        index_type const d = q.size();
        auto sum = energy(index_type{0}, plain_t<decltype(q(0))>(q(0)));
        for (index_type k = 1; k < d; ++k) sum = sum + energy(k, plain_t<decltype(q(0))>(q(k) - q(k - 1)));
        return plain_t<decltype(sum)>(sum + energy(d, plain_t<decltype(q(0))>(-q(d - 1))));
    }
    /// Every dimension is admissible.
    void check(index_type) const {}

    /// g = dU/dq; `tension` is workspace for d + 1 numbers.
    template <class V, class Room>
    void gradient(V const& q, V& g, Room& tension) const {
        if constexpr (std::is_floating_point_v<scalar_of<V>>)
            flat_tensions(q, tension);
        else
            tensions(q, tension);
        for (index_type k = 0; k < q.size(); ++k) g(k) = tension(k) - tension(k + 1);
    }
    /// Calls put(j, k, x) for every entry j >= k of the Hessian; entries of one place add up.
    template <class V, class Put>
    void hessian(V const& q, Put const& put) const {
        using S = scalar_of<V>;
        using J = jet<S, 0, 1, 2>;
        index_type const d = q.size();
        for (index_type k = 0; k <= d; ++k) {
            S const r = k == 0 ? S(q(0)) : k == d ? S(-q(d - 1)) : S(q(k) - q(k - 1));
            S const bend = detail::as_jet<J>(energy(k, J::variable(r, 0, {}))).template by<0, 0>();
            if (k < d) put(k, k, bend);
            if (k > 0) put(k - 1, k - 1, bend);
            if (k > 0 and k < d) put(k, k - 1, S(-bend));
        }
    }

private:
    // Flattened for built-in floating-point types, for the reasons of flat_jets_of.
    template <class V, class Room>
    HILGER_FLATTEN void flat_tensions(V const& q, Room& tension) const {
        tensions(q, tension);
    }
    template <class V, class Room>
    HILGER_ALWAYS_INLINE void tensions(V const& q, Room& tension) const {
        using S = scalar_of<V>;
        index_type const d = q.size();
        tension(0) = slope<S>(0, q(0));
        for (index_type k = 1; k < d; ++k) tension(k) = slope<S>(k, q(k) - q(k - 1));
        tension(d) = slope<S>(d, -q(d - 1));
    }
    template <class S>
    HILGER_ALWAYS_INLINE S slope(index_type k, S const& r) const {
        using J = jet<S, 0, 1, 1>;
        return detail::as_jet<J>(energy(k, J::variable(r, 0, {}))).template by<0>();
    }
};

namespace detail {
/// A generic U(q), with a dense Hessian by jets.
template <class U>
struct dense_potential {
    [[no_unique_address]] U function;
    template <class X>
    auto operator()(X const& q) const {
        return function(q);
    }
    void check(index_type) const {}
    template <class V, class Room>
    void gradient(V const& q, V& g, Room&) const {
        g = gradient_by(q, function);
    }
    template <class V, class Put>
    void hessian(V const& q, Put const& put) const {
        auto const e = hilger::expand([this](auto const& x, auto const&) { return function(x); }, q, q);
        for (index_type j = 0; j < q.size(); ++j)
            for (index_type k = 0; k <= j; ++k) put(j, k, e.qq(j, k));
    }
};
template <class U>
concept structured_potential = requires(U const& u) {
    u.check(index_type{});
};
} // namespace detail

/// L(q, v) = v.Mv / 2 - U(q) of vectors q and v. Only the symmetric part of a matrix M enters.
template <class Mass, class Potential>
class mechanical {
    using wrapped = std::conditional_t<detail::structured_potential<Potential>, Potential, detail::dense_potential<Potential>>;

public:
    /// @throws error::not_finite; error::mismatch if a matrix is not square; error::singular if a number or component is not positive
    mechanical(Mass m, Potential u) : mass_(std::move(m)), potential_{std::move(u)} {
        if (not is_finite(mass_)) error::raise<error::not_finite>("a mass is finite, and one of these is NaN or infinite");
        bool positive = true;
        if constexpr (is_matrix) {
            if (mass_.rows() != mass_.cols())
                error::raise<error::mismatch>("a mass matrix is square, and this one has ", mass_.rows(), " rows and ", mass_.cols(),
                                              " columns");
            if (mass_ != mass_.transpose()) mass_ = Mass(mass_ / 2 + mass_.transpose() / 2);
        } else {
            if constexpr (requires { mass_.minCoeff(); })
                positive = mass_.minCoeff() > typename Mass::Scalar(0);
            else
                positive = mass_ > Mass(0);
        }
        if (not positive) error::raise<error::singular>("a mass is positive, and one of these is not");
    }
    static constexpr bool is_matrix = requires { requires Mass::ColsAtCompileTime != 1; };

    /// L(q, v) in any number type. @throws error::mismatch if M has another dimension
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        static_assert(
            requires { v.dot(v); }, "mechanical(mass, U) is for states that are Eigen vectors: for numbers write "
                                    "[](auto const& q, auto const& v) { return mass * v * v / 2 - U(q); }");
        if constexpr (requires { v.size(); }) require_size(v.size());
        if constexpr (not requires { v.dot(v); })
            return v;
        else if constexpr (is_matrix)
            return v.dot(mass_ * v) / 2 - potential_(q);
        else if constexpr (requires { mass_.size(); })
            return v.dot(mass_.cwiseProduct(v)) / 2 - potential_(q);
        else
            return v.dot(v) * mass_ / 2 - potential_(q);
    }
    /// The Legendre map p = M v. @throws error::mismatch if M has another dimension
    template <class V>
    [[nodiscard]] V momentum(V const& q, V const& v) const {
        require_size(q.size());
        V p = v;
        put_momentum(v, p);
        return p;
    }
    /// p = M v, into p, which has the size of v.
    template <class V, class P>
    void put_momentum(V const& v, P&& p) const {
        using S = scalar_of<V>;
        if constexpr (is_matrix)
            p.noalias() = mass_.template cast<S>() * v;
        else if constexpr (requires { mass_.size(); })
            p = mass_.template cast<S>().cwiseProduct(v);
        else
            p = v * S(mass_);
    }
    /// The inverse of the Legendre map. @throws error::mismatch; error::singular if a mass matrix is not positive definite
    template <class V>
    [[nodiscard]] V velocity(V const& q, V const& p) const {
        V v = p;
        detail::mass_solver<Mass, V>(mass_, q.size()).solve(p, v);
        return v;
    }
    /// M, symmetric if it is a matrix.
    [[nodiscard]] Mass const& mass() const { return mass_; }
    /// Calls put(j, k, x) for the entries j >= k of the mass matrix of d components.
    template <class S, class Put>
    void put_mass(index_type d, Put const& put) const {
        for (index_type j = 0; j < d; ++j)
            if constexpr (is_matrix)
                for (index_type k = 0; k <= j; ++k) put(j, k, S(mass_(j, k)));
            else if constexpr (requires { mass_.size(); })
                put(j, j, S(mass_(j)));
            else
                put(j, j, S(mass_));
    }
    /// U, with its derivatives by jets if it is generic.
    [[nodiscard]] wrapped const& potential() const { return potential_; }

private:
    void require_size(index_type d) const {
        if constexpr (requires { mass_.size(); }) {
            index_type const m = mass_.rows();
            if (m != d) error::raise<error::mismatch>("the mass has dimension ", m, ", and the state has ", d);
        }
    }
    Mass mass_;
    wrapped potential_;
};

/// Whether F is a mechanical system.
template <class F>
inline constexpr bool is_mechanical = false;
template <class M, class U>
inline constexpr bool is_mechanical<mechanical<M, U>> = true;

} // namespace hilger
