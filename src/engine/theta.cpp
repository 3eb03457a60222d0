// SPDX-License-Identifier: BSL-1.0
#include "engine/motions.hpp"

namespace engine {

made embedded_at_lambda(problem const& what, std::string const& method, points<double> const& T) {
    if (not method.starts_with("theta:")) return nullptr;
    auto const lambda = hilger::text::number_in<double>(method.substr(6));
    if (not lambda) hilger::error::raise<hilger::error::invalid_parameter>("theta takes a number, as theta:0.3, and not '", method, "'");
    return with_mechanics(what,
                          [&](auto const& mechanics) { return on_scale(hilger::embed(mechanics, hilger::theta_at(*lambda)), T, method); });
}

} // namespace engine
