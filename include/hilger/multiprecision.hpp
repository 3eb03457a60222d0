// SPDX-License-Identifier: BSL-1.0
// Exact rationals and wide floats from Boost.Multiprecision, all with expression templates off: with them on, auto variables and
// lambdas keep references to temporaries. Not included by hilger.hpp; the calculus needs no particular scalar.
#pragma once

#include <type_traits>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>

// Boost asks every type that is converted to a number whether it is a container of bytes, by its const_iterator. Eigen's matrices of more
// than one column name a const_iterator, and it is void: without this a matrix of rationals does not compile.
template <class Matrix>
    requires std::is_void_v<typename Matrix::const_iterator>
struct boost::multiprecision::detail::is_byte_container<Matrix> : std::false_type {
};

namespace hilger {

namespace mp = boost::multiprecision;

/// Exact rationals: identities are tested with ==.
using Q = mp::number<mp::cpp_rational_backend, mp::et_off>;
using float50 = mp::number<mp::cpp_bin_float<50>, mp::et_off>;
using float100 = mp::number<mp::cpp_bin_float<100>, mp::et_off>;

} // namespace hilger
