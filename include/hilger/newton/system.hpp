// SPDX-License-Identifier: BSL-1.0
// Newton's method for the small systems of a Legendre map, and for rows of an equation: one callable returns the residual and its matrix.
#pragma once

#include <initializer_list>
#include <utility>

#include "hilger/linear/patterned_matrix.hpp"
#include "hilger/newton/newton.hpp"

namespace hilger {

/// The residual of a system and its derivative at one iterate: a full matrix, or one of a known pattern.
template <class V, class Jacobian = block_of<V>>
struct newton_system {
    V residual;
    Jacobian jacobian;
};

namespace detail {
/// The factors of a derivative: a number, a full or a patterned matrix.
template <class V, class Jacobian>
class factors_of {
    using S = scalar_of<V>;
    static constexpr bool is_patterned = requires(Jacobian & J) { J.is_factorized(); };
    using kept = std::conditional_t<shape<V>::is_scalar or is_patterned, Jacobian, elimination<S, shape<V>::size>>;

public:
    /// @returns false if J is singular to rounding.
    bool factorize(Jacobian&& J) {
        if constexpr (shape<V>::is_scalar) {
            kept_ = J;
            return is_divisor(J);
        } else if constexpr (is_patterned) {
            kept_ = std::move(J);
            return kept_.factorize();
        } else {
            kept_ = elimination_of<S>(J);
            return kept_.factorize();
        }
    }
    /// x = J^-1 r
    void solve(V const& r, V& x) const {
        if constexpr (shape<V>::is_scalar)
            x = r / kept_;
        else {
            x = r;
            kept_.solve(x);
        }
    }

private:
    kept kept_{};
};
template <class Jacobian>
auto largest_entry(Jacobian& J) {
    if constexpr (requires { J.largest(); })
        return J.largest();
    else
        return magnitude(J);
}
template <class V>
V ones_like(V x) {
    if constexpr (requires { x.setOnes(); })
        return x.setOnes();
    else
        return V(1);
}
/// Iterate -> newton_system, type-erased: one iteration is compiled for all systems of the same vectors and matrices.
template <class V, class Jacobian>
using newton_function = function_view<newton_system<V, Jacobian>(V const&)>;

/// A system as a newton_equation; the residual is a quantity less `given`, and rounds like it.
template <class V, class Jacobian>
class equation_of_system {
    using S = scalar_of<V>;

public:
    equation_of_system(newton_function<V, Jacobian> const& system, V const& given) : system_(system), given_(given) {}
    /// Returns use(equation), which may refer to this object.
    template <class Use>
    auto with(Use const& use) {
        auto const evaluate = [this](V const& y, V& r) {
            auto made = system_(y);
            r = std::move(made.residual);
            J_ = std::move(made.jacobian);
            return S(magnitude(given_) + S(shape<V>::dimension(y)) * largest_entry(J_) * magnitude(y));
        };
        auto const linearize = [this] { return factors_.factorize(std::move(J_)); };
        auto const correct = [this](V const& r, V& d) {
            factors_.solve(r, d);
            d = -d;
        };
        return use(newton_equation<V>{evaluate, linearize, correct});
    }

private:
    newton_function<V, Jacobian> const& system_;
    V const& given_;
    Jacobian J_{};
    factors_of<V, Jacobian> factors_{};
};
/// The first root found from one of the guesses. @throws the error of the first guess if there is none
template <class V, class Jacobian>
V newton_from(std::initializer_list<V> guesses, newton_function<V, Jacobian> const& system, V const& given, char const* what,
              solvability const& by) {
    unwatched const inside;
    equation_of_system<V, Jacobian> equation(system, given);
    return equation.with([&](newton_equation<V> const& f) {
        V x = *guesses.begin(), residual = zero_like(x), first = x, first_residual = residual;
        newton_outcome first_how = newton_outcome::found;
        for (V const& guess : guesses) {
            if (&guess != guesses.begin() and guess == *guesses.begin()) continue;
            x = guess;
            newton_outcome const how = newton<V>(f, x, residual, corrections::on_the_path);
            if (how == newton_outcome::found) return x;
            if (&guess != guesses.begin()) continue;
            first_how = how;
            first = x;
            first_residual = residual;
        }
        throw_newton_failure(what, first_how, first, first_residual, by);
    });
}
} // namespace detail

/// The root of `system` (iterate -> newton_system) near `guess`. The residual is a quantity less `given`, and rounds like it; `what` names
/// the equation in messages, and `by` says when its derivative is regular. An exact scalar must reach the root exactly, which linear
/// equations do in one iteration. The branches of the system are not recorded for an enclosing search.
/// @throws newton_failure, with error::no_branch if a system with branches has no solution; error::singular, error::not_finite
template <class V, class System>
V newton(System const& system, V const& guess, V const& given, char const* what, detail::solvability const& by = detail::by_the_velocity) {
    using jacobian = decltype(system(guess).jacobian);
    return detail::newton_from<V, jacobian>({guess}, system, given, what, by);
}
/// The same and, if there is no root from `near`, from 0, from `given` and from ones: the derivative at 0 may be singular or undefined, as
/// for L = v^4 and L = v log v.
template <class V, class System>
V newton_near(System const& system, V const& near, V const& given, char const* what) {
    using jacobian = decltype(system(near).jacobian);
    return detail::newton_from<V, jacobian>({near, zero_like(given), given, detail::ones_like(given)}, system, given, what,
                                            detail::by_the_velocity);
}

} // namespace hilger
