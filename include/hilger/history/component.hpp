// SPDX-License-Identifier: BSL-1.0
// A history keeps the components of its values in arrays of scalars. Here is how a value, a scalar or an Eigen vector, is taken apart and
// put together, and what is refused.
#pragma once

#include "hilger/error.hpp"
#include "hilger/fixed_text.hpp"
#include "hilger/history/simd.hpp"
#include "hilger/scalar.hpp"

namespace hilger::detail::memory {

template <class V>
struct component_of {
    using type = V;
};
template <class V>
    requires requires { typename V::Scalar; }
struct component_of<V> {
    using type = typename V::Scalar;
};
template <class V>
using component_t = typename component_of<V>::type;

template <class V>
inline constexpr bool is_vector = not std::is_same_v<V, component_t<V>>;

template <class V>
index_type components(V const& x) {
    if constexpr (is_vector<V>)
        return static_cast<index_type>(x.size());
    else
        return 1;
}
template <class V>
component_t<V> const& component(V const& x, index_type i) {
    if constexpr (is_vector<V>)
        return x.data()[i];
    else
        return x;
}
template <class V>
component_t<V>& component(V& x, index_type i) {
    if constexpr (is_vector<V>)
        return x.data()[i];
    else
        return x;
}
/// Zero, with the size of x; what x contains does not matter.
template <class V>
V zero_of_size(V const& x) {
    using S = component_t<V>;
    if constexpr (is_vector<V>)
        return V(V::Constant(x.rows(), x.cols(), S(0)));
    else
        return S(0);
}

/// @throws error::mismatch, error::not_finite with the number of the value, from 0 on.
template <class V>
void check_value(V const& x, index_type size, index_type number) {
    if (components(x) != size)
        error::raise<error::mismatch>("value ", number, " of a history has ", components(x), " components, the history was made for ",
                                      size);
    if (not is_finite(x)) error::raise<error::not_finite>("value ", number, " of a history is not finite");
}

/// What make_history returns for an order and values that differ in their scalar.
template <class S, class V>
inline constexpr bool same_scalar = std::is_same_v<S, component_t<plain_t<V>>>;
template <class S, fixed_text Sentence>
auto refused() { // depends on S: instantiated where it is reached only
    return does_not_compile<Sentence>{};
}
inline constexpr fixed_text scalars_differ{"the order of a fractional difference and the values of its history have the same scalar"};

} // namespace hilger::detail::memory
