// SPDX-License-Identifier: BSL-1.0
// The inverse of a structured system's mass, given as a number, a vector or a matrix.
#pragma once

#include <Eigen/Cholesky>

#include "hilger/linear/regular.hpp"
#include "hilger/shape.hpp"

namespace hilger::detail {

/// M^-1 times a vector, for the three kinds of mass.
template <class Mass, class V>
class mass_solver {
    using S = scalar_of<V>;

public:
    /// @throws error::mismatch if M has another dimension than d; error::singular if a matrix is not positive definite
    mass_solver(Mass const& m, index_type d) {
        if constexpr (is_matrix) {
            if (m.rows() != d) wrong(m.rows(), d);
            block_of<V> const matrix = m.template cast<S>();
            factors_.compute(matrix); // no square roots: for rationals too
            auto const pivots = factors_.vectorD();
            V const entries = factors_.transpositionsP() * matrix.diagonal();
            bool regular = factors_.info() == Eigen::Success;
            for (index_type k = 0; regular and k < d; ++k) regular = pivots(k) > S(0) and is_pivot(S(pivots(k)), S(entries(k)), d);
            if (not regular) error::raise<error::singular>("the mass matrix is not positive definite, or not to the digits of its scalar");
        } else if constexpr (requires { m.size(); }) {
            if (m.size() != d) wrong(m.size(), d);
            inverse_ = m.template cast<S>().cwiseInverse();
        } else
            inverse_ = V::Constant(d, S(1) / S(m));
    }
    template <class R>
    void solve(R const& r, V& v) const {
        if constexpr (is_matrix)
            v = factors_.solve(r);
        else
            v = inverse_.cwiseProduct(r);
    }

private:
    static constexpr bool is_matrix = requires { requires Mass::ColsAtCompileTime != 1; };
    struct nothing {};
    [[noreturn]] static void wrong(index_type m, index_type d) {
        error::raise<error::mismatch>("the mass has dimension ", m, ", and the state has ", d);
    }
    V inverse_;
    std::conditional_t<is_matrix, Eigen::LDLT<block_of<V>>, nothing> factors_;
};

} // namespace hilger::detail
