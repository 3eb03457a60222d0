// SPDX-License-Identifier: BSL-1.0
// Newton's method for the integral equation of a two-sided problem (boundary/equation.hpp), from the solution for L = v.M v / 2 on, with
// GMRES for its linear equations: it takes a number of iterations that does not depend on N, each of two convolutions.
#pragma once

#include <sstream>

#include <Eigen/LU>

#include "hilger/boundary/equation.hpp"
#include "hilger/variational/given_state.hpp"

namespace hilger {

/// Options of two-sided problems.
struct boundary_options {
    int most_iterations = 50;    ///< of Newton's method, for one equation
    int most_applications = 600; ///< of a derivative, in one linear equation; each keeps a vector of the size of the solution
    std::stop_token stop = {};   ///< throws error::no_convergence when a stop is requested
};

/// The result of solve(EL, T, ends, options). The number of iterations is that of Newton's corrections, 0 for L = v.M v / 2; `applications`
/// counts the applications of derivatives in them.
template <class Root, class V>
struct boundary_solution {
    decltype(function_on(std::declval<Root const&>(), std::declval<std::vector<V>>())) q;
    scalar_of<V> residual; ///< largest component of the left-hand side of (EL_h^alpha) at q
    int iterations;
    int applications;
};

namespace detail {

template <class Action, class V>
class boundary_solver {
    using Root = typename Action::root_type;
    using S = scalar_of<V>;
    using s = shape<V>;
    using equation = boundary_equation<Action, V>;
    using values = typename equation::values;
    using point = typename equation::point;
    static constexpr bool exact = std::numeric_limits<S>::is_exact;

public:
    boundary_solver(Action const& action, V const& first, V const& last, boundary_options const& options)
        : action_(action), equation_(action, first, last), options_(options) {}

    boundary_solution<Root, V> solve() {
        point start = equation_.start();
        equation_.evaluate(start);
        if (not equation::all_finite(start.rest))
            error::raise<error::not_finite>("L or its derivatives are NaN or infinite at the first guess, the solution for L = v.v / 2");
        attempt found = newton(start, most());
        if constexpr (not exact)
            if (not found.arrived) found = by_growing_shares(std::move(start), std::move(found));
        if (not found.arrived) fail(found);
        values all = equation_.whole(found.at);
        if (not equation::all_finite(all)) error::raise<error::not_finite>("the solution of a boundary value problem is NaN or infinite");
        S const largest = largest_of(convolved_residual(action_, all));
        return {function_on(action_.T, std::move(all)), largest, iterations_, applications_};
    }

private:
    /// The last iterate of Newton's method, and its correction relative to the velocity.
    struct attempt {
        point at;
        S size{0};
        bool arrived = false;
    };
    /// Newton's method from an evaluated point.
    attempt newton(point at, int most_corrections) {
        attempt so{std::move(at)};
        for (int count = 0; not at_rest(so.at); ++count) {
            if (count == most_corrections) return so;
            ++iterations_;
            auto const [correction, accuracy] = solve_linear(so.at);
            so.size = relative_size(correction, so.at.v);
            // The remaining error is accuracy times size, of the linear equation, and size^2, of the nonlinear part.
            bool const last = not exact and so.size * std::max(so.size, accuracy) <= small() * small();
            branch_path const path = so.at.path;
            if (not advance(so.at, correction, last)) return so;
            if (last and so.at.path == path) break; // a correction is valid on the branches of its derivative
        }
        so.arrived = true;
        return so;
    }
    /// Newton's path ends where its derivative is singular. The solutions of (1 - s) v.M v / 2 + s L, each found from one of a smaller s,
    /// are another path, which may avoid that on the way to s = 1.
    attempt by_growing_shares(point at, attempt failed) {
        equation_.set_mass(at);
        for (S share(0), step = S(1) / S(2); share < S(1);) {
            S const next = std::min(S(1), S(share + step));
            equation_.set_share(next);
            attempt one{at};
            try {
                equation_.evaluate(one.at);
                one = newton(std::move(one.at), std::min(8, most()));
            } catch (error::singular const&) {
                one.arrived = false;
            }
            if (one.arrived) {
                at = std::move(one.at);
                share = next;
                step = S(2) * step;
            } else {
                step = step / S(2);
                if (step < S(1) / S(1000)) return failed;
            }
        }
        return {std::move(at), S(0), true};
    }
    [[nodiscard]] int most() const { return exact ? most_iterations<S> : options_.most_iterations; }
    static S small() { return square_root_of_epsilon<S>() / S(16); }
    static S largest_of(values const& x) {
        S largest(0);
        for (auto const& value : x) largest = std::max(largest, S(magnitude(value)));
        return largest;
    }
    static S relative_size(values const& y, values const& v) {
        S const of = euclidean_norm(v);
        return S(0) < of ? S(euclidean_norm(y) / of) : S(1);
    }
    /// Whether only rounding is left.
    static bool at_rest(point const& at) { return at.merit <= S(32) * epsilon<S>() * euclidean_norm(at.v); }

    [[nodiscard]] krylov_solution<V> solve_linear(point const& at) {
        if (not at.coupled) return {at.rest, S(0)};
        auto const A = [&](values const& y) {
            ++applications_;
            detail::stop_on_request(options_.stop, "a boundary value problem");
            return equation_.derivative(at, y);
        };
        if constexpr (exact)
            return {eliminated(A, at.rest), S(0)};
        else
            return gmres<V>(A, at.rest, small(), options_.most_applications);
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
        if (not is_regular(lu)) refuse_singular("a boundary value problem", by_the_ends);
        rhs = lu.solve(rhs);
        values x = b;
        for (int row = 0; row < n; ++row) component(x, row) = rhs(row);
        return x;
    }
    /// One step of Newton's method, shortened until the residual shrinks. Returns false when it does not.
    [[nodiscard]] bool advance(point& at, values const& correction, bool last) const {
        S const before = at.merit;
        S part(1);
        for (int halvings = 0; halvings < 12; ++halvings, part = part / S(2)) {
            point next{at.v, {}};
            add_multiple(next.v, part, correction);
            equation_.place(at, next);
            if (not last or not(at.path == branch_path{})) equation_.evaluate(next);
            bool const better = (last and next.path == at.path) or exact or
                                (equation::all_finite(next.rest) and equation_.natural(at, next) <= (S(1) - part / S(4)) * before);
            if (better) {
                at = std::move(next);
                return true;
            }
        }
        return false;
    }
    [[noreturn]] void fail(attempt const& last) const {
        values all = equation_.whole(last.at);
        values rest = convolved_residual(action_, all);
        std::ostringstream message;
        message << "a boundary value problem did not converge: after " << iterations_ << " Newton iterations the last correction was "
                << last.size
                << (exact ? ". An exact scalar needs an equation that is linear in the unknown"
                          : " of the velocity. It may have no solution, or one far from that of L = v.v / 2");
        throw newton_failure<values>(message.str(), std::move(all), std::move(rest));
    }

    Action const& action_;
    equation equation_;
    boundary_options options_;
    int iterations_ = 0, applications_ = 0;
};

} // namespace detail

} // namespace hilger
