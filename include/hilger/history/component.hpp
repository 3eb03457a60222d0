// SPDX-License-Identifier: BSL-1.0
// A history keeps the components of its values in arrays of scalars. Here is how a value, a scalar or an Eigen vector, is taken apart and
// put together, and what is refused.
#pragma once

#include <vector>

#include "hilger/error.hpp"
#include "hilger/fixed_text.hpp"
#include "hilger/scalar.hpp"
#include "hilger/simd.hpp"

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

/// For checkpoints: each(label, number) for every component, which may change them.
template <class V, class Visit>
void visit_components(char const* label, V& x, Visit& each) {
    for (index_type c = 0; c < components(x); ++c) each(label, component(x, c));
}
/// The same of an engine that its values make: their number and each of them, value_of(n, c) for those there are. Where other values come
/// back, the engine takes them one by one as it has taken its own, so that every bit of it is the same.
template <class Engine, class V, class ValueOf, class Visit>
void visit_values(Engine& engine, V const& like, ValueOf const& value_of, Visit& each) {
    index_type const kept = engine.count(), size = components(like);
    index_type count = kept;
    each("values", count);
    std::vector<V> values;
    bool same = count == kept;
    for (index_type n = 0; n < count; ++n) {
        V x = zero_of_size(like);
        for (index_type c = 0; c < size; ++c) {
            if (n < kept) component(x, c) = value_of(n, c);
            auto const before = component(x, c);
            each("value", component(x, c));
            same = same and before == component(x, c);
        }
        values.push_back(std::move(x));
    }
    if (same) return;
    engine.reset();
    for (V const& x : values) engine.push(x);
}

/// What make_history returns for an order and values that differ in their scalar.
template <class S, class V>
inline constexpr bool same_scalar = std::is_same_v<S, component_t<plain_t<V>>>;
template <class S, class V>
auto scalars_differ() {
    return does_not_compile<"the order of a fractional difference and the values of its history have the same scalar", S, V>{};
}

} // namespace hilger::detail::memory
