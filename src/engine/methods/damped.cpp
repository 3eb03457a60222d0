// SPDX-License-Identifier: BSL-1.0
#include "engine/motions.hpp"

namespace engine {

namespace {

/// Calls use(policy) with the history of that name. @throws hilger::error::invalid_parameter
template <class Use>
made with_history(std::string const& name, hilger::index_type steps, Use const& use) {
    auto const colon = name.find(':');
    std::string const kind = name.substr(0, colon);
    auto const number = hilger::text::number_in<double>(colon == std::string::npos ? "0" : name.substr(colon + 1));
    if (number and kind == "direct") return use(hilger::direct{});
    if (number and kind == "blocks") return use(hilger::blocks{});
    if (number and kind == "exponentials") return use(hilger::exponentials{*number, steps + 1});
    hilger::error::raise<hilger::error::invalid_parameter>("histories are direct, blocks, exponentials and exponentials:1e-8, and not '",
                                                           name, "'");
}

} // namespace

made damped(problem const& what, std::string const& method, points<double> const& T) {
    std::vector<hilger::fractional_term<double>> terms;
    for (auto const& [rho, alpha] : what.damping) terms.push_back({rho, alpha});
    return with_mechanics(what, [&](auto const& mechanics) -> made {
        return with_history(what.history, T.steps, [&](auto const& policy) -> made {
            auto const with_damping = hilger::with_fractional_damping(mechanics, terms, policy);
            if (method == "mid-point") return on_scale(hilger::embed(with_damping, hilger::mid_point), T, method);
            return nullptr;
        });
    });
}

} // namespace engine
