// SPDX-License-Identifier: BSL-1.0
// The histories of fractional terms by name; a parameter follows a colon.
#pragma once

#include <string>

#include "hilger/error.hpp"
#include "hilger/history/history.hpp"
#include "hilger/text/vocabulary.hpp"

namespace engine {

/// Calls use(policy) with the named history for so many steps. @throws hilger::error::invalid_parameter
template <class Use>
void with_history(std::string const& name, hilger::index_type steps, Use const& use) {
    auto const colon = name.find(':');
    std::string const kind = name.substr(0, colon);
    bool const has_number = colon != std::string::npos;
    auto const number = hilger::text::number_in<double>(has_number ? name.substr(colon + 1) : "0");
    if (kind == "direct" and not has_number) return use(hilger::direct{});
    if (kind == "blocks" and not has_number) return use(hilger::blocks{});
    if (kind == "exponentials" and number) return use(hilger::exponentials{*number, steps + 1});
    hilger::error::raise<hilger::error::invalid_parameter>("histories are direct, blocks, exponentials and exponentials:1e-8, and not '",
                                                           name, "'");
}

/// @throws hilger::error::invalid_parameter for an unknown name or parameter
inline void require_history(std::string const& name) {
    with_history(name, 1, []<class Policy>(Policy const& policy) {
        if constexpr (std::same_as<Policy, hilger::exponentials>)
            (void)hilger::detail::memory::exponential_weights<hilger::bdf<1>, double>(0.5, policy);
    });
}

} // namespace engine
