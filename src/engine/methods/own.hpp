// SPDX-License-Identifier: BSL-1.0
// Motions under an embedding of one's own, stated as what is summed: integral(L((q + sigma[q])/2, Delta_plus[q])).
#pragma once

#include "engine/motions.hpp"
#include "hilger/text/stated_embedding.hpp"

namespace engine {

inline bool is_embedding_in_text(std::string const& method) { return method.find('(') != std::string::npos; }

/// The embedding; parameters of the problem are known in it.
inline hilger::text::embedding_formula own_embedding(problem const& what, std::string const& method) {
    auto words = std::make_shared<hilger::text::vocabulary const>(what.lagrangian.formula().words());
    return hilger::text::embedding_in(method, std::move(words), "the method");
}
/// Calls use(how) with its operators over S. @throws hilger::error::unreadable, hilger::error::invalid_parameter
template <class S, class Use>
auto with_own_embedding(problem const& what, std::string const& method, bool uniform, Use const& use) {
    return hilger::text::with_embedding<S>(own_embedding(what, method), uniform, use);
}
/// The lambda of a method whose steps are those of theta_at(lambda): theta:0.3, and embeddings in text. Nothing for others.
/// @throws hilger::error::unreadable, hilger::error::invalid_parameter
template <class S>
std::optional<S> lambda_of(problem const& what, std::string const& method) {
    if (is_embedding_in_text(method)) return hilger::text::lambda_of_step<S>(own_embedding(what, method));
    if (not method.starts_with("theta:")) return {};
    auto const lambda = hilger::text::number_in<S>(method.substr(6));
    if (not lambda) hilger::error::raise<hilger::error::invalid_parameter>("theta takes a number, as theta:0.3, and not '", method, "'");
    if (not(S(0) < *lambda and *lambda < S(1)))
        hilger::error::raise<hilger::error::invalid_parameter>("theta takes a number between 0 and 1, and here is ", method.substr(6));
    return lambda;
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
