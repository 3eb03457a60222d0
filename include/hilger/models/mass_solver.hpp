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
            factors_.compute(matrix);
            bool regular = factors_.info() == Eigen::Success;
            if constexpr (exact)
                regular = regular and (factors_.vectorD().array() > S(0)).all();
            else
                for (index_type k = 0; regular and k < d; ++k) {
                    S const pivot = S(factors_.matrixLLT()(k, k)) * S(factors_.matrixLLT()(k, k));
                    regular = is_pivot(pivot, S(matrix(k, k)), d);
                }
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
    static constexpr bool exact = std::numeric_limits<S>::is_exact; ///< rationals have no square roots
    static constexpr bool is_matrix = requires { requires Mass::ColsAtCompileTime != 1; };
    struct nothing {};
    [[noreturn]] static void wrong(index_type m, index_type d) {
        error::raise<error::mismatch>("the mass has dimension ", m, ", and the state has ", d);
    }
    V inverse_;
    using factors = std::conditional_t<exact, Eigen::LDLT<block_of<V>>, Eigen::LLT<block_of<V>>>; // exchanged pivots may lose digits
    std::conditional_t<is_matrix, factors, nothing> factors_;
};

} // namespace hilger::detail
