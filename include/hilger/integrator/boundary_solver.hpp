// SPDX-License-Identifier: BSL-1.0
// Two-sided problems of the fractional embedding: x in C(T) with x(t_0) and x(t_N) given that solves (EL_h^alpha) of Bourdin, Cresson,
// Greff, Inizan (2013),  F_k + (A^T p)_k = 0 for k = 1..N-1,  F = dL/dx, p = dL/dv, v = A Q, A = Delta_-^alpha.
// A is a triangle whose inverse is known, the Toeplitz matrix of h^alpha (1 - z)^-alpha. Multiplied by its transpose, with a multiplier
// for the row N that is no equation, the problem is
//   p(Q, v) + A^-T F(Q, v) = lambda g,  Q = A^-1 v,  Q_N = x(t_N);  g = A^-T e_N,  g_k = h^alpha beta_{N-k},
// an integral equation of the second kind for v. For L = v.M v / 2 its solution is v = c g, one convolution. Otherwise Newton's method
// starts from there, with GMRES for its linear equations: divided by dL/dv dv they are a compact perturbation of the identity, and take a
// number of iterations that does not depend on N, each of two convolutions.
// For L = v^2 / 2 and alpha <= 1/2 the continuous problem has no solution: the functional does not see values at points. Each of the
// discrete problems has one, and their solutions tend to the free one, away from t_N, as h^(1 - 2 alpha).
#pragma once

#include <sstream>

#include <Eigen/LU>

#include "hilger/integrator/krylov.hpp"
#include "hilger/mechanics/fractional_problem.hpp"
#include "hilger/mechanics/newton_stop.hpp"

namespace hilger {

struct boundary_options {
    int most_iterations = 50;    ///< of Newton's method
    int krylov_columns = 60;     ///< vectors that GMRES keeps before it starts again, each of the size of the solution
    int most_applications = 600; ///< of a derivative, in one linear equation
};

/// What solve_boundary found. The number of iterations is that of Newton's corrections, 0 for L = v.M v / 2; `applications` is how often a
/// derivative was applied in them.
template <class Root, class V>
struct boundary_solution {
    decltype(function(std::declval<Root const&>(), std::declval<std::vector<V>>())) q;
    scalar_of<V> residual; ///< largest component of the left-hand side of (EL_h^alpha) at q
    int iterations;
    int applications;
};

namespace detail {

/// What a boundary value is: an Eigen vector as it is, any number in the scalar of the scale.
template <class Value, class S>
struct boundary_value {
    using type = S;
};
template <class Value, class S>
    requires requires { typename plain_t<Value>::Scalar; }
struct boundary_value<Value, S> {
    using type = plain_t<Value>;
};

template <class F, class Order, class Root, class V>
class boundary_solver {
    using S = scalar_of<V>;
    using s = shape<V>;
    using values = std::vector<V>; ///< one for each of t_1 ... t_N
    static constexpr bool exact = std::numeric_limits<S>::is_exact;

public:
    boundary_solver(fractional_problem<F, Order> const& problem, Root const& T, V const& first, V const& last,
                    boundary_options const& options)
        : problem_(problem), T_(T), first_(first), last_(last), options_(options), count_(static_cast<std::size_t>(T.steps())),
          scale_(power_of_step(T.h(), problem.template order<S>())),
          beta_(first_weights<grunwald_letnikov>(S(-problem.template order<S>()), T.steps() + 1)),
          inverse_(std::vector<S>(beta_.begin(), beta_.end() - 1)) {}

    boundary_solution<Root, V> solve() {
        point at = start();
        evaluate(at);
        if (not all_finite(at.rest))
            error::raise<error::not_finite>("L or its derivatives are NaN or infinite at the first guess, the solution for L = v.v / 2");
        S size(0);
        int iteration = 0;
        while (not at_rest(at)) {
            if (iteration == most()) fail(at, size, iteration);
            ++iteration;
            auto const [correction, accuracy] = solve_linear(at);
            size = relative_size(correction, at.v);
            // The error left is accuracy times size, for the linear equation, and size^2, for what is not linear.
            bool const last = not exact and size * std::max(size, accuracy) <= small() * small();
            if (not advance(at, correction, last)) fail(at, size, iteration);
            if (last) break;
        }
        values all{first_};
        all.insert(all.end(), at.q.begin(), at.q.end());
        all.back() = last_;
        if (not all_finite(all)) error::raise<error::not_finite>("the solution of a boundary value problem is NaN or infinite");
        auto q = function(T_, std::move(all));
        S largest(0);
        for (auto const& rest : problem_.residual(q)) largest = std::max(largest, S(magnitude(rest)));
        return {std::move(q), largest, iteration, applications_};
    }

private:
    /// An iterate, the derivatives there, and -P(p + A^-T F), the correction if nothing depended on the position.
    struct point {
        values v, q;
        std::vector<expansion<V>> at{};
        bool coupled = false; ///< some second derivative by the position is not zero
        block_of<V> stiffness{};
        values forces{}; ///< -(p + A^-T F)
        values rest{};
        S merit{0};
    };

    [[nodiscard]] int most() const { return exact ? most_iterations<S> : options_.most_iterations; }
    static S small() { return square_root_of_epsilon<S>() / S(16); }
    [[nodiscard]] S g(std::size_t i) const { return scale_ * beta_[count_ - 1 - i]; }
    [[nodiscard]] values integrated(values const& v) const { return apply_triangle(inverse_, v, scale_, direction::forward); }
    [[nodiscard]] values integrated_back(values const& p) const { return apply_triangle(inverse_, p, scale_, direction::backward); }
    static bool all_finite(values const& x) {
        for (auto const& value : x)
            if (not detail::all_finite(value)) return false;
        return true;
    }
    static S largest_of(values const& x) {
        S largest(0);
        for (auto const& value : x) largest = std::max(largest, S(magnitude(value)));
        return largest;
    }
    static S relative_size(values const& y, values const& v) {
        if constexpr (exact)
            return largest_of(y);
        else {
            S const of = euclidean_norm(v);
            return S(0) < of ? S(euclidean_norm(y) / of) : S(1);
        }
    }
    /// Rounding alone is left.
    static bool at_rest(point const& at) {
        if constexpr (exact)
            return largest_of(at.rest) == S(0);
        else
            return at.merit <= S(32) * epsilon<S>() * euclidean_norm(at.v);
    }

    /// The solution for L = v.M v / 2, whatever M: v = c g.
    [[nodiscard]] point start() const {
        std::vector<S> reversed(beta_.rbegin() + 1, beta_.rend());
        auto const u = inverse_(reversed);
        V const c = (last_ - beta_.back() * first_) / u.back();
        point at{values(count_, c), values(count_, c)};
        for (std::size_t i = 0; i < count_; ++i) {
            at.v[i] = c * S(reversed[i] / scale_);
            at.q[i] = beta_[i + 1] * first_ + u[i] * c;
        }
        return at;
    }
    [[nodiscard]] values position(values const& v) const {
        values q = integrated(v);
        for (std::size_t i = 0; i < count_; ++i) q[i] = q[i] + beta_[i + 1] * first_;
        return q;
    }
    /// Everything at (v, q); at.at[i].vv becomes its own inverse.
    void evaluate(point& at) const {
        at.at.clear();
        at.at.reserve(count_);
        values force;
        bool forced = false, finite = true;
        at.coupled = false;
        for (std::size_t i = 0; i < count_; ++i) {
            S const t = T_.element(static_cast<index>(i) + 1);
            at.at.push_back(expand(at_time{problem_.lagrangian(), t}, at.q[i], at.v[i]));
            auto& e = at.at.back();
            force.push_back(e.by_q); // that of row N, which is no equation, is a multiple of g: lambda takes it up
            forced = forced or magnitude(force.back()) != S(0);
            at.coupled = at.coupled or largest_entry(e.qq) != S(0) or largest_entry(e.qv) != S(0);
            finite =
                finite and detail::all_finite(e.by_q) and detail::all_finite(e.by_v) and largest_entry(e.vv) - largest_entry(e.vv) == S(0);
        }
        at.rest.assign(count_, zero_like(first_));
        if (not finite) {
            at.rest[0] = at.at[0].by_v / S(0);
            return;
        }
        if (forced) at.rest = integrated_back(force);
        for (std::size_t i = 0; i < count_; ++i) {
            at.rest[i] = -(at.rest[i] + at.at[i].by_v);
            at.at[i].vv = inverted(at.at[i].vv);
        }
        at.stiffness = inverted(pairwise_sum(0, count_, [&](std::size_t i) { return block_of<V>(S(g(i) * g(i)) * at.at[i].vv); }));
        at.forces = at.rest;
        at.rest = projected(at, std::move(at.rest));
        if constexpr (not exact) at.merit = euclidean_norm(at.rest);
    }
    template <class Block>
    static S largest_entry(Block const& b) {
        if constexpr (s::is_scalar)
            return S(magnitude(b));
        else
            return S(b.cwiseAbs().maxCoeff());
    }
    static block_of<V> inverted(block_of<V> const& H) {
        char const* const what = "a boundary value problem";
        if constexpr (s::is_scalar) {
            if (H == S(0)) refuse_singular(what);
            return S(1) / H;
        } else {
            Eigen::PartialPivLU<block_of<V>> const lu(H);
            if (not is_regular(lu)) refuse_singular(what);
            return lu.inverse();
        }
    }
    /// P r = H^-1 (r + g lambda) with lambda such that the position at t_N does not move.
    [[nodiscard]] values projected(point const& at, values r) const {
        for (std::size_t i = 0; i < count_; ++i) r[i] = at.at[i].vv * r[i];
        V const lambda = -(at.stiffness * pairwise_sum(0, count_, [&](std::size_t i) { return V(g(i) * r[i]); }));
        for (std::size_t i = 0; i < count_; ++i) r[i] = r[i] + at.at[i].vv * V(g(i) * lambda);
        return r;
    }
    /// The derivative of P(p + A^-T F) = y + P C y by v in the direction y.
    [[nodiscard]] values derivative(point const& at, values const& y) const {
        values const q = integrated(y);
        values force = y, c = y;
        for (std::size_t i = 0; i < count_; ++i) {
            auto const& e = at.at[i];
            if constexpr (s::is_scalar) {
                c[i] = e.qv * q[i];
                force[i] = e.qq * q[i] + e.qv * y[i];
            } else {
                c[i] = e.qv.transpose() * q[i];
                force[i] = e.qq * q[i] + e.qv * y[i];
            }
        }
        force = integrated_back(force);
        for (std::size_t i = 0; i < count_; ++i) c[i] = c[i] + force[i];
        c = projected(at, std::move(c));
        for (std::size_t i = 0; i < count_; ++i) c[i] = c[i] + y[i];
        return c;
    }
    struct linear_solution {
        values correction;
        S accuracy;
    };
    [[nodiscard]] linear_solution solve_linear(point const& at) {
        if (not at.coupled) return {at.rest, S(0)};
        auto const A = [&](values const& y) {
            ++applications_;
            return derivative(at, y);
        };
        if constexpr (exact)
            return {eliminated(A, at.rest), S(0)};
        else {
            auto solution = gmres<V>(A, at.rest, small(), {options_.krylov_columns, options_.most_applications});
            return {std::move(solution.x), std::move(solution.residual)};
        }
    }
    /// Gauss's elimination with the matrix written down: exact scalars have no square roots.
    template <class Apply>
    static values eliminated(Apply const& A, values const& b) {
        int const d = s::dimension(b[0]), n = static_cast<int>(b.size()) * d;
        Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> M(n, n);
        Eigen::Matrix<S, Eigen::Dynamic, 1> rhs(n);
        auto const component = [d](auto& x, int row) -> decltype(auto) {
            return s::component(x[static_cast<std::size_t>(row / d)], row % d);
        };
        for (int column = 0; column < n; ++column) {
            values y(b.size(), zero_like(b[0]));
            component(y, column) = S(1);
            y = A(y);
            for (int row = 0; row < n; ++row) M(row, column) = component(y, row);
            rhs(column) = component(b, column);
        }
        Eigen::PartialPivLU<decltype(M)> const lu(M);
        if (not is_regular(lu)) refuse_singular("a boundary value problem");
        rhs = lu.solve(rhs);
        values x = b;
        for (int row = 0; row < n; ++row) component(x, row) = rhs(row);
        return x;
    }
    /// The size of the rest at a later point, measured as at the earlier one: a norm that changed with the point would not be monotone.
    [[nodiscard]] S natural(point const& earlier, point const& later) const {
        if constexpr (exact)
            return S(0);
        else
            return euclidean_norm(projected(earlier, later.forces));
    }
    /// One step of Newton's method, shortened until the residual shrinks. False when it does not.
    [[nodiscard]] bool advance(point& at, values const& correction, bool last) const {
        S const before = at.merit;
        S part(1);
        for (int halvings = 0; halvings < 12; ++halvings, part = part / S(2)) {
            point next{at.v, {}};
            add_multiple(next.v, part, correction);
            next.q = position(next.v);
            // What rounding has taken from the condition at t_N is given back along g.
            V const missing = at.stiffness * (last_ - next.q.back());
            for (std::size_t i = 0; i < count_; ++i) next.v[i] = next.v[i] + at.at[i].vv * V(g(i) * missing);
            if (not last) evaluate(next);
            bool const better = last or exact or (all_finite(next.rest) and natural(at, next) <= (S(1) - part / S(4)) * before);
            if (better) {
                at = std::move(next);
                return true;
            }
        }
        return false;
    }
    [[noreturn]] void fail(point const& at, S const& size, int iterations) const {
        values all{first_};
        all.insert(all.end(), at.q.begin(), at.q.end());
        all.back() = last_;
        values rest;
        for (auto const& r : problem_.residual(function(T_, all))) rest.push_back(r);
        std::ostringstream message;
        message << "a boundary value problem did not converge: after " << iterations << " Newton iterations the last correction was "
                << size
                << (exact ? ". An exact scalar needs an equation that is linear in the unknown"
                          : " of the velocity. It may have no solution, or one far from that of L = v.v / 2");
        throw newton_failure<values>(message.str(), std::move(all), std::move(rest));
    }

    fractional_problem<F, Order> const& problem_;
    Root const& T_;
    V first_, last_;
    boundary_options options_;
    std::size_t count_;
    S scale_; ///< h^alpha
    std::vector<S> beta_;
    toeplitz_triangle<S> inverse_;
    int applications_ = 0;
};

} // namespace detail

} // namespace hilger
