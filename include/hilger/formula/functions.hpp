// SPDX-License-Identifier: BSL-1.0
// The elementary functions of symbols, and what Eigen must know to make vectors of them.
#pragma once

#include <Eigen/Core>

#include "hilger/formula/symbol.hpp"

namespace hilger {

inline symbol sin(symbol const& x) { return symbol::call(operation::sin, x); }
inline symbol cos(symbol const& x) { return symbol::call(operation::cos, x); }
inline symbol tan(symbol const& x) { return symbol::call(operation::tan, x); }
inline symbol exp(symbol const& x) { return symbol::call(operation::exp, x); }
inline symbol log(symbol const& x) { return symbol::call(operation::log, x); }
inline symbol sqrt(symbol const& x) { return symbol::call(operation::sqrt, x); }
inline symbol sinh(symbol const& x) { return symbol::call(operation::sinh, x); }
inline symbol cosh(symbol const& x) { return symbol::call(operation::cosh, x); }
inline symbol tanh(symbol const& x) { return symbol::call(operation::tanh, x); }
inline symbol asin(symbol const& x) { return symbol::call(operation::asin, x); }
inline symbol acos(symbol const& x) { return symbol::call(operation::acos, x); }
inline symbol atan(symbol const& x) { return symbol::call(operation::atan, x); }
inline symbol asinh(symbol const& x) { return symbol::call(operation::asinh, x); }
inline symbol acosh(symbol const& x) { return symbol::call(operation::acosh, x); }
inline symbol atanh(symbol const& x) { return symbol::call(operation::atanh, x); }
inline symbol abs(symbol const& x) { return symbol::call(operation::abs, x); }
inline symbol fabs(symbol const& x) { return abs(x); }
inline symbol cbrt(symbol const& x) { return symbol::call(operation::cbrt, x); }
inline symbol expm1(symbol const& x) { return symbol::call(operation::expm1, x); }
inline symbol log1p(symbol const& x) { return symbol::call(operation::log1p, x); }
inline symbol erf(symbol const& x) { return symbol::call(operation::erf, x); }
inline symbol atan2(symbol const& y, symbol const& x) { return symbol::call(operation::atan2, y, x); }
inline symbol hypot(symbol const& x, symbol const& y) { return sqrt(x * x + y * y); }

} // namespace hilger

namespace Eigen {

template <>
struct NumTraits<hilger::symbol> : NumTraits<double> {
    using Real = hilger::symbol;
    using NonInteger = Real;
    using Nested = Real;
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 1, AddCost = 10, MulCost = 10 };
};
template <class K, class Operation>
    requires(std::constructible_from<double, K const&> and not std::same_as<K, hilger::symbol>)
struct ScalarBinaryOpTraits<hilger::symbol, K, Operation> {
    using ReturnType = hilger::symbol;
};
template <class K, class Operation>
    requires(std::constructible_from<double, K const&> and not std::same_as<K, hilger::symbol>)
struct ScalarBinaryOpTraits<K, hilger::symbol, Operation> {
    using ReturnType = hilger::symbol;
};

} // namespace Eigen
