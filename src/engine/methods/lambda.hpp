// SPDX-License-Identifier: BSL-1.0
// Methods with a number in them: theta:0.3, and embeddings in text whose steps are those of a theta.
#pragma once

#include "engine/engine.hpp"
#include "hilger/text/operator.hpp"

namespace engine {

inline bool is_embedding_in_text(std::string const& method) { return method.find('(') != std::string::npos; }

/// The embedding; parameters of the problem are known in it.
inline hilger::text::embedding_formula own_embedding(problem const& what, std::string const& method) {
    auto words = std::make_shared<hilger::text::vocabulary const>(what.lagrangian.formula().words());
    return hilger::text::embedding_in(method, std::move(words), "the method");
}
/// Whether it is an embedding whose lambda is another one for each length of step.
bool has_lambda_of_step(problem const& what, std::string const& method);
/// The lambda of a method whose steps of length h are those of theta_at(lambda): theta:0.3, and embeddings in text; without h that of all
/// lengths. Nothing for others. In double, float, float50, float100 and Q, compiled once: an embedding is examined exactly.
/// @throws hilger::error::unreadable, hilger::error::invalid_parameter
template <class S>
std::optional<S> lambda_of(problem const& what, std::string const& method, std::optional<S> const& h = {});
extern template std::optional<double> lambda_of(problem const&, std::string const&, std::optional<double> const&);
extern template std::optional<float> lambda_of(problem const&, std::string const&, std::optional<float> const&);
extern template std::optional<hilger::float50> lambda_of(problem const&, std::string const&, std::optional<hilger::float50> const&);
extern template std::optional<hilger::float100> lambda_of(problem const&, std::string const&, std::optional<hilger::float100> const&);
extern template std::optional<hilger::Q> lambda_of(problem const&, std::string const&, std::optional<hilger::Q> const&);

} // namespace engine
