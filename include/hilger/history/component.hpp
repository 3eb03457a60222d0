// SPDX-License-Identifier: BSL-1.0
// A history keeps the components of its values, scalars or Eigen vectors (shape.hpp), in arrays of scalars. This file checks its values,
// and visits them for checkpoints.
#pragma once

#include <vector>

#include "hilger/error.hpp"
#include "hilger/fixed_text.hpp"
#include "hilger/scalar.hpp"
#include "hilger/shape.hpp"
#include "hilger/simd.hpp"

namespace hilger::detail::memory {

/// @throws error::mismatch, error::not_finite with the number of the value, from 0 on.
template <class V>
void check_value(V const& x, int size, index_type number) {
    if (shape<V>::dimension(x) != size)
        error::raise<error::mismatch>("value ", number, " of a history has ", shape<V>::dimension(x),
                                      " components, the history was made for ", size);
    if (not is_finite(x)) error::raise<error::not_finite>("value ", number, " of a history is not finite");
}

/// For checkpoints: each(label, number) for every component, which may change them.
template <class V, class Visit>
void visit_components(char const* label, V& x, Visit& each) {
    for (int c = 0; c < shape<V>::dimension(x); ++c) each(label, shape<V>::component(x, c));
}
/// The same for an engine that its values determine: their number and each of them, value_of(n, c). Where other values come back, they are
/// pushed one by one, so that the engine is restored bit for bit.
template <class Engine, class V, class ValueOf, class Visit>
void visit_values(Engine& engine, V const& like, ValueOf const& value_of, Visit& each) {
    using s = shape<V>;
    index_type const kept = engine.count();
    index_type count = kept;
    each("values", count);
    std::vector<V> values;
    bool same = count == kept;
    for (index_type n = 0; n < count; ++n) {
        V x = s::zero(s::dimension(like));
        for (int c = 0; c < s::dimension(like); ++c) {
            auto& value = s::component(x, c);
            if (n < kept) value = value_of(n, c);
            auto const before = value;
            each("value", value);
            same = same and before == value;
        }
        values.push_back(std::move(x));
    }
    if (same) return;
    engine.reset();
    for (V const& x : values) engine.push(x);
}

/// Whether an order and the values of a history have one scalar; make_history refuses others.
template <class S, class V>
inline constexpr bool same_scalar = std::is_same_v<S, scalar_of<plain_t<V>>>;
template <class S, class V>
auto scalars_differ() {
    return does_not_compile<"the order of a fractional difference and the values of its history have the same scalar", S, V>{};
}

} // namespace hilger::detail::memory
