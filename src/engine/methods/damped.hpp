// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <algorithm>

#include "engine/engine.hpp"
#include "engine/methods/histories.hpp"
#include "engine/motions.hpp"
#include "hilger/fractional/flow.hpp"

namespace engine {

/// Damped problems may have a force too.
inline forced_problem with_any_force(problem const& of) {
    if (of.force) return {of.lagrangian, *of.force};
    auto const words = std::make_shared<hilger::text::vocabulary>(of.lagrangian.formula().words());
    std::vector<hilger::text::stated> const none(static_cast<std::size_t>(words->dimension()),
                                                 hilger::text::stated(hilger::text::expression(), words, "the force"));
    return {of.lagrangian, hilger::text::stated_force(none)};
}
inline std::vector<hilger::fractional_term<double>> fractional_terms_of(problem const& what) {
    std::vector<hilger::fractional_term<double>> terms;
    for (auto const& [rho, alpha] : what.damping) terms.push_back({static_cast<double>(rho), static_cast<double>(alpha)});
    return terms;
}
/// Calls use(flow) with the flow of the mid-point embedding; sums are compensated when an order is above 1.
template <class Damped, class Use>
auto use_at_mid_point(Damped const& damped, std::vector<hilger::fractional_term<double>> const& terms, Use const& use) {
    if (std::any_of(terms.begin(), terms.end(), [](auto const& term) { return term.order > 1; }))
        return use(hilger::embed(damped, hilger::mid_point, hilger::compensated));
    return use(hilger::embed(damped, hilger::mid_point, std::integral_constant<hilger::sums, hilger::sums::plain>{}));
}
/// Adds the fractional terms of the problem and calls use(flow) as above. @throws hilger::error::invalid_parameter
template <class Mechanics, class Use>
void with_damped(problem const& what, Mechanics const& mechanics, hilger::index_type steps, Use const& use) {
    auto const terms = fractional_terms_of(what);
    with_history(what.history, steps,
                 [&](auto const& policy) { use_at_mid_point(hilger::with_fractional_damping(mechanics, terms, policy), terms, use); });
}

} // namespace engine
