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
} // namespace engine
