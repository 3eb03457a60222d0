// SPDX-License-Identifier: BSL-1.0
// What scalars of many digits have: the embeddings in one step.
#pragma once

#include "engine/methods/own.hpp"

namespace engine {

template <class S>
std::unique_ptr<motion<S>> made_in(problem const& what, std::string const& method, points<S> const& T, char const* scalar) {
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is for numbers of the processor, and not for ", scalar);
    if (auto made = embedded_by_operators(what, method, T)) return made;
    auto made = with_mechanics(what, [&](auto const& mechanics) -> std::unique_ptr<motion<S>> {
        if (method == "order-one") return on_scale(hilger::embed(mechanics, hilger::order_one), T, method);
        if (method == "order-one-left") return on_scale(hilger::embed(mechanics, hilger::order_one_left), T, method);
        if (method == "mid-point") return on_scale(hilger::embed(mechanics, hilger::mid_point), T, method);
        return nullptr;
    });
    if (not made)
        hilger::error::raise<hilger::error::invalid_parameter>(
            "in ", scalar,
            " the methods are order-one, order-one-left, mid-point and embeddings, as integral(L(q, Delta_plus[q])), and not '", method,
            "'");
    return made;
}

} // namespace engine
