// SPDX-License-Identifier: BSL-1.0
// Methods with a number: theta:0.3, and embeddings in text whose steps are those of a theta.
#pragma once

#include "engine/engine.hpp"
#include "hilger/text/embedding.hpp"

namespace engine {

inline bool is_embedding_in_text(std::string const& method) { return method.find('(') != std::string::npos; }

/// The embedding in text; it may use parameters of the problem.
inline hilger::text::embedding_formula own_embedding(problem const& what, std::string const& method) {
    auto words = std::make_shared<hilger::text::vocabulary const>(what.lagrangian.formula().words());
    return hilger::text::embedding_in(method, std::move(words), "the method");
}
/// Whether its lambda depends on the length of the step.
inline bool has_lambda_of_step(problem const& what, std::string const& method) {
    return is_embedding_in_text(method) and hilger::text::depends_on_step(own_embedding(what, method));
}
/// The lambda of a method whose steps of length h are those of theta_at(lambda): theta:0.3, and embeddings in text; without h, one for all
/// lengths. Nothing for others.
/// @throws hilger::error::unreadable, hilger::error::invalid_parameter
template <class S>
std::optional<S> lambda_of(problem const& what, std::string const& method, std::optional<S> const& h = {}) {
    if (is_embedding_in_text(method)) return hilger::text::lambda_of_step<S>(own_embedding(what, method), h);
    if (not method.starts_with("theta:")) return {};
    auto const lambda = hilger::text::number_in<S>(method.substr(6));
    if (not lambda) hilger::error::raise<hilger::error::invalid_parameter>("theta takes a number, as theta:0.3, and not '", method, "'");
    if (not(S(0) < *lambda and *lambda < S(1)))
        hilger::error::raise<hilger::error::invalid_parameter>("theta takes a number between 0 and 1, and here is ", method.substr(6));
    return lambda;
}
/// The same, also for embeddings in one step that have a name.
template <class S>
std::optional<S> lambda_in_one_step(problem const& what, std::string const& method, std::optional<S> const& h = {}) {
    if (method == "order-one") return S(0);
    if (method == "order-one-left") return S(1);
    if (method == "mid-point") return S(S(1) / S(2));
    return lambda_of<S>(what, method, h);
}
/// The problem of one Lagrangian of a sum.
inline problem alone(problem::summand const& part) { return {part.lagrangian, {}, {}}; }

} // namespace engine
