// SPDX-License-Identifier: BSL-1.0
#pragma once

#include "engine/engine.hpp"
#include "engine/methods/histories.hpp"
#include "hilger/fractional/flow.hpp"

namespace engine {

/// Calls use(mechanics) with the fractional terms of the problem beside what moves. @throws hilger::error::invalid_parameter
template <class Mechanics, class Use>
void with_damped(problem const& what, Mechanics const& mechanics, hilger::index_type steps, Use const& use) {
    std::vector<hilger::fractional_term<double>> terms;
    for (auto const& [rho, alpha] : what.damping) terms.push_back({static_cast<double>(rho), static_cast<double>(alpha)});
    with_history(what.history, steps, [&]<class Policy>(Policy const& policy) {
        if constexpr (std::same_as<Policy, hilger::window>)
            hilger::error::raise<hilger::error::invalid_parameter>("a window is for Newmark's scheme, and not for embeddings");
        else
            use(hilger::with_fractional_damping(mechanics, terms, policy));
    });
}

} // namespace engine
