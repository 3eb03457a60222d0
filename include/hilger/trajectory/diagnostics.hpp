// SPDX-License-Identifier: BSL-1.0
// Quality measures of geometric integrators, for any method, problem and scalar:
//   drift_along(path, energy(L))                       error of the energy: largest, slope against time, correlation with time
//   drift_along(path, momentum_map(xi))                the same of the momentum p.xi(q) of a symmetry with generator xi (Noether)
//   symplecticity_error(jacobian_of_step(...))         |M^T J M - J|
//   reversibility_error(method, adjoint, x, h)         a step there with the method and back with its adjoint
//   largest_residual(equation, x)                      of the discrete Euler-Lagrange equation at a trajectory
// Backward error analysis predicts bounded energy errors without drift for symplectic methods (Hairer, Lubich, Wanner, Geometric Numerical
// Integration, theorem IX.8.1).
#pragma once

#include <optional>

#include "hilger/trajectory/trajectory.hpp"
#include "hilger/variational/legendre.hpp"
#include "hilger/variational/problem.hpp"
#include "hilger/variational/relative_residual.hpp"
#include "hilger/variational/restricted.hpp"
#include "hilger/variational/variation.hpp"

namespace hilger {

/// The drift of a quantity e(t) that should be constant.
template <class S>
struct drift_statistics {
    S largest{0};                                  ///< max |e(t) - e(start)|
    S time_square{0}, error_square{0}, product{0}; ///< sums of squares and products of the deviations from the means
    /// Least-squares slope of the error against time.
    [[nodiscard]] S slope() const { return time_square == S(0) ? S(0) : S(product / time_square); }
    /// Correlation of the error with time, between -1 and 1; 0 where there is no error.
    [[nodiscard]] S correlation() const {
        using std::sqrt;
        return error_square == S(0) or time_square == S(0) ? S(0) : S(product / sqrt(S(time_square * error_square)));
    }
};

namespace detail {
/// quantity(x), or quantity(x, v) with the last velocity for a quantity that depends on which of several velocities is meant.
template <class Quantity, class Path, class State>
auto along_a_walk(Quantity const& quantity, Path const& path, std::optional<State>& before, State const& x) {
    if constexpr (requires { typename Quantity::depends_on_velocity; }) {
        if (before) {
            auto const near = mean_velocity(*before, x);
            *before = x;
            return quantity(x, near);
        }
        before = x;
        if constexpr (requires { path.starting_velocity(); })
            if (path.starting_velocity()) return quantity(x, *path.starting_velocity());
    }
    return quantity(x);
}
} // namespace detail

/// The drift of quantity(state) along any range of states, in one pass and with nothing stored (Welford's update of means and sums).
template <class Path, class Quantity>
auto drift_along(Path const& path, Quantity const& quantity) {
    using S = std::remove_cvref_t<decltype((*path.begin()).t)>;
    drift_statistics<S> result;
    S start(0), mean_t(0), mean_e(0);
    long long count = 0;
    std::optional<std::remove_cvref_t<decltype(*path.begin())>> before;
    for (auto const& x : path) {
        S const value = detail::along_a_walk(quantity, path, before, x);
        if (count == 0) start = value;
        S const error = value - start;
        result.largest = detail::larger(result.largest, S(magnitude(error)));
        S const n(static_cast<S>(++count)), from_t = x.t - mean_t, from_e = error - mean_e;
        mean_t = mean_t + from_t / n;
        mean_e = mean_e + from_e / n;
        result.time_square = result.time_square + from_t * (x.t - mean_t);
        result.error_square = result.error_square + from_e * (error - mean_e);
        result.product = result.product + from_t * (error - mean_e);
    }
    return result;
}

/// The energy H(p, q) = p.v - L(q, v) of a state, for L(q, v) or L(t, q, v): energy(L)(x). Where several velocities have the momentum of x,
/// as with L = v^4 - v^2, energy(L)(x, v) takes the one near v.
template <class L>
class energy_of_states {
public:
    using depends_on_velocity = void;
    explicit energy_of_states(L lagrangian) : kept_(problem<L>{std::move(lagrangian), {}}) {}
    auto operator()(auto const& x, auto const& near) const {
        return detail::energy_of(detail::at_time{kept_.what().lagrangian, x.t}, x.q, detail::velocity_by(kept_, x.t, x.q, x.p, near), x.p);
    }
    auto operator()(auto const& x) const { return (*this)(x, zero_like(x.q)); }

private:
    detail::kept_derivatives<problem<L>> kept_;
};
/// energy_of_states of a Lagrangian L(q, v) or L(t, q, v). @throws as the inverse Legendre map does
template <class L>
auto energy(L lagrangian) {
    return energy_of_states<L>(std::move(lagrangian));
}
/// The momentum map p.xi(q) of a one-parameter group of symmetries of L with infinitesimal generator xi, a vector field.
template <class Generator>
auto momentum_map(Generator xi) {
    return [xi = std::move(xi)](auto const& x) { return scalar_of<decltype(x.q)>(dot_product(x.p, decltype(x.q)(xi(x.q)))); };
}

namespace detail {
/// A 2d x 2d matrix that acts on (q, p).
template <class V>
using phase_matrix = Eigen::Matrix<scalar_of<V>, shape<V>::size == Eigen::Dynamic ? Eigen::Dynamic : 2 * shape<V>::size,
                                   shape<V>::size == Eigen::Dynamic ? Eigen::Dynamic : 2 * shape<V>::size>;
/// Component k of (q, p).
template <class S, class V>
S& phase_component(state<S, V>& x, int k) {
    using s = shape<V>;
    int const d = s::dimension(x.q);
    return k < d ? s::component(x.q, k) : s::component(x.p, k - d);
}
} // namespace detail

/// The derivative M of one step (q, p) -> (q', p'), 2d x 2d, by central differences of order 4. With increments of epsilon^(1/5) their
/// error and rounding are of the size of epsilon^(4/5); in an exact scalar M is exact where the step is linear. @throws as a step does
template <class Method, class S, class V>
auto jacobian_of_step(Method const& method, state<S, V> const& x, S const& h) {
    int const n = 2 * detail::shape<V>::dimension(x.q);
    detail::phase_matrix<V> M(n, n);
    for (int column = 0; column < n; ++column) {
        S e(1);
        if constexpr (not std::numeric_limits<S>::is_exact) {
            using std::pow;
            state<S, V> here = x;
            e = pow(epsilon<S>(), S(S(1) / S(5))) * std::max(S(1), S(magnitude(detail::phase_component(here, column))));
        }
        auto const moved = [&](int times) {
            state<S, V> y = x;
            S& z = detail::phase_component(y, column);
            z = z + S(times) * e;
            return method.step(y, h);
        };
        auto a = moved(-2), b = moved(-1), c = moved(1), d = moved(2);
        for (int row = 0; row < n; ++row) {
            auto const part = [&](state<S, V>& y) { return S(detail::phase_component(y, row)); };
            M(row, column) = (S(8) * (part(c) - part(b)) - (part(d) - part(a))) / (S(12) * e);
        }
    }
    return M;
}

/// The largest entry of |M^T J M - J|, zero for a symplectic M of size 2d.
template <class Matrix>
auto symplecticity_error(Matrix const& M) {
    using S = typename Matrix::Scalar;
    int const n = static_cast<int>(M.rows()), d = n / 2;
    S worst(0);
    for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) {
            S sum(k == j + d ? -1 : j == k + d ? 1 : 0);
            for (int i = 0; i < d; ++i) sum = sum + (M(i, j) * M(d + i, k) - M(d + i, j) * M(i, k));
            worst = detail::larger(worst, S(magnitude(sum)));
        }
    return worst;
}

/// The distance from x, in the largest component of q and p, after a step h with the method and a step -h with its adjoint, which is the
/// method itself for a self-adjoint one. @throws as a step does
template <class Method, class Adjoint, class S, class V>
S reversibility_error(Method const& method, Adjoint const& adjoint, state<S, V> const& x, S const& h) {
    state<S, V> const back = adjoint.step(method.step(x, h), S(-h));
    return std::max(S(magnitude(V(back.q - x.q))), S(magnitude(V(back.p - x.p))));
}

/// The largest component of the residual of a discrete Euler-Lagrange equation at x in C(T), with a force f(q, v) or f(t, q, v) beside
/// dL/dq where one is given; 0 where T has no inner point. Terms of the size |p| / h cancel in it, so it is a few epsilons of that where x
/// is a solution. For a restricted principle the equation is that of the first curve, with its damping.
template <class Equation, discrete_function X, class... Force>
    requires requires(Equation const& equation, X const& x, Force const&... force) { equation.residual(x, force...); }
auto largest_residual(Equation const& equation, X const& x, Force const&... force) {
    using S = typename X::root_type::scalar_type;
    S worst(0);
    for (auto const& r : equation.residual(x, force...)) {
        using s = detail::shape<std::remove_cvref_t<decltype(r)>>;
        for (int k = 0; k < s::dimension(r); ++k) worst = detail::larger(worst, S(magnitude(s::component(r, k))));
    }
    return worst;
}

} // namespace hilger
