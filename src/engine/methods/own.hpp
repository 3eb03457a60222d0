// SPDX-License-Identifier: BSL-1.0
// Motions under an embedding of one's own, stated as what is summed: integral(L((q + sigma[q])/2, Delta_plus[q])).
#pragma once

#include "engine/methods/lambda.hpp"
#include "engine/motions.hpp"
#include "hilger/text/stated_embedding.hpp"

namespace engine {

/// Calls use(how) with its operators over S. @throws hilger::error::unreadable, hilger::error::invalid_parameter
template <class S, class Use>
auto with_own_embedding(problem const& what, std::string const& method, bool uniform, Use const& use) {
    return hilger::text::with_embedding<S>(own_embedding(what, method), uniform, use);
}
/// Nothing for methods that have a name.
template <class S>
std::unique_ptr<motion<S>> embedded_by_operators(problem const& what, std::string const& method, points<S> const& T) {
    if (not is_embedding_in_text(method)) return nullptr;
    return with_own_embedding<S>(what, method, T.is_uniform(), [&](auto const& how) {
        return with_mechanics(what, [&](auto const& mechanics) { return on_scale(hilger::embed(mechanics, how), T, method); });
    });
}

} // namespace engine
