// SPDX-License-Identifier: BSL-1.0
// Derivatives of formulas, as formulas: forward through the graph, each node once, so that a derivative is at most a fixed number of times
// as large as what it is a derivative of. And a Lagrangian with its first and second derivatives, as `expansion` has them in numbers.
#pragma once

#include <unordered_map>

#include "hilger/differentiation/jet/functions.hpp"
#include "hilger/formula/functions.hpp"
#include "hilger/shape.hpp"

namespace hilger {

namespace detail {

class derivative_by {
public:
    explicit derivative_by(symbol const& variable) : variable_(variable) {}

    symbol of(symbol const& f) {
        if (f.op() == operation::number) return 0;
        if (f.op() == operation::variable) return f.same_as(variable_) ? 1 : 0;
        if (auto const found = known_.find(&f.get()); found != known_.end()) return found->second;
        symbol const result = rule(f);
        known_.emplace(&f.get(), result);
        return result;
    }

private:
    symbol rule(symbol const& f) {
        symbol const a = f.first(), da = of(a);
        switch (f.op()) {
        case operation::plus:
            return da + of(f.second());
        case operation::minus:
            return da - of(f.second());
        case operation::times:
            return da * f.second() + a * of(f.second());
        case operation::over: {
            auto const [z, n] = whole_power(f.second());
            return da / f.second() - n * a * of(z) / pow(z, n + 1);
        }
        case operation::over_norm:
            return symbol::over_norm(da - f * of(f.second()), f.second());
        case operation::sqrt:
            return is_never_negative(a) ? symbol::over_norm(da / 2, f) : da / (2 * f);
        case operation::power:
            if (f.value() < 1 and is_never_negative(a)) return symbol::over_norm(f.value() * f * da, a);
            return slope(f, a) * da;
        case operation::atan2: {
            symbol const x = f.second();
            return (x * da - a * of(x)) / (x * x + a * a);
        }
        case operation::maximum:
            return of_the_first_where(a - f.second(), da, of(f.second()));
        case operation::minimum:
            return of_the_first_where(f.second() - a, da, of(f.second()));
        case operation::where:
        case operation::elsewhere:
            return part(f.op(), a, of(f.second()));
        default:
            return da.is(0) ? da : slope(f, a) * da;
        }
    }
    /// What is never negative by its form has no slope where it is 0.
    static bool is_never_negative(symbol const& f) {
        switch (f.op()) {
        case operation::number:
            return f.value() >= 0;
        case operation::power:
            return f.value() == 2 * std::floor(f.value() / 2) or is_never_negative(f.first());
        case operation::sqrt:
            return true;
        case operation::plus:
        case operation::times:
        case operation::over:
            return is_never_negative(f.first()) and is_never_negative(f.second());
        default:
            return false;
        }
    }
    /// da where x >= 0, else db.
    static symbol of_the_first_where(symbol const& x, symbol const& da, symbol const& db) {
        if (da.same_as(db)) return da;
        return part(operation::where, x, da) + part(operation::elsewhere, x, db);
    }
    static symbol part(operation op, symbol const& x, symbol const& d) {
        if (d.is(0)) return d;
        if (x.is_number()) return (x.value() >= 0) == (op == operation::where) ? d : 0;
        return symbol::call(op, x, d);
    }
    /// g'(a) of f = g(a)
    static symbol slope(symbol const& f, symbol const& a) {
        switch (f.op()) {
        case operation::negative:
            return -1;
        case operation::power:
            return f.value() * pow(a, f.value() - 1);
        case operation::sin:
            return cos(a);
        case operation::cos:
            return -sin(a);
        case operation::tan:
            return 1 + f * f;
        case operation::exp:
            return f;
        case operation::log:
            return 1 / a;
        case operation::sinh:
            return cosh(a);
        case operation::cosh:
            return sinh(a);
        case operation::tanh:
            return 1 - f * f;
        case operation::asin:
            return 1 / sqrt(1 - a * a);
        case operation::acos:
            return -1 / sqrt(1 - a * a);
        case operation::atan:
            return 1 / (1 + a * a);
        case operation::asinh:
            return 1 / sqrt(a * a + 1);
        case operation::acosh:
            return 1 / (sqrt(a - 1) * sqrt(a + 1));
        case operation::atanh:
            return 1 / ((1 - a) * (1 + a));
        case operation::cbrt:
            return 1 / (3 * f * f);
        case operation::expm1:
            return exp(a);
        case operation::log1p:
            return 1 / (1 + a);
        case operation::erf:
            return two_over_root_of_pi<double>() * exp(-(a * a));
        case operation::abs:
            return symbol::call(operation::sign, a);
        default:
            return 0; // sign
        }
    }
    symbol variable_;
    std::unordered_map<formula const*, symbol> known_; // what is differentiated outlives this
};

} // namespace detail

/// df/dx, x a variable.
inline symbol partial(symbol const& f, symbol const& x) { return detail::derivative_by(x).of(f); }
/// The gradient of f by the components of x, in the shape of x: a symbol or a vector of symbols.
template <class X>
    requires(std::same_as<scalar_of<X>, symbol> and not std::same_as<X, symbol>)
X partial(symbol const& f, X const& x) {
    X g = x;
    for (int k = 0; k < detail::shape<X>::dimension(x); ++k) g(k) = partial(f, x(k));
    return g;
}

/// The variables that stand for a state of type V: `name` for a number, `name` 0, ..., d - 1 for a vector.
template <class V>
auto variables(std::string const& name, int d = detail::shape<V>::size) {
    using s = detail::shape<V>;
    typename s::template with<symbol> x;
    if constexpr (s::size == Eigen::Dynamic) x.resize(d);
    for (int k = 0; k < d; ++k) s::component(x, k) = symbol::variable(name, s::is_scalar ? -1 : k);
    return x;
}

} // namespace hilger
