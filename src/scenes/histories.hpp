// SPDX-License-Identifier: BSL-1.0
// The histories that scenes with memory can be run with, by name; what follows a colon is a parameter. And Newmark's scheme with them.
#pragma once

#include <charconv>
#include <string>

#include "hilger/error.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/history/history.hpp"
#include "scene.hpp"

namespace program {

/// The number after the colon. @throws hilger::error::invalid_parameter
template <class N>
N parameter_of(std::string const& name, N otherwise) {
    auto const colon = name.find(':');
    if (colon == std::string::npos) return otherwise;
    N value{};
    char const *const begin = name.data() + colon + 1, *const end = name.data() + name.size();
    auto const [stopped, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} or stopped != end)
        hilger::error::raise<hilger::error::invalid_parameter>("a number is expected after the colon in '", name, "'");
    return value;
}

/// Calls use(policy) for one of history_names().
template <class Use>
void with_history(std::string const& name, hilger::index_type steps, Use const& use) {
    std::string const kind = name.substr(0, name.find(':'));
    if (kind == "direct") use(hilger::direct{});
    if (kind == "blocks") use(hilger::blocks{});
    if (kind == "exponentials") use(hilger::exponentials{parameter_of(name, 0.0), steps + 1});
    if (kind == "window") use(hilger::window{parameter_of(name, hilger::index_type{1000})});
}
/// Calls use(scheme) with the weights that c.embedding names, one of newmark_names(), and the history that c.history does.
template <class Structure, class Load, class Use>
void with_newmark(configuration const& c, Structure const& on, Load const& load, Use const& use) {
    with_history(c.history, c.steps, [&](auto const& policy) {
        if (c.embedding == "gl-newmark")
            use(hilger::newmark<hilger::grunwald_letnikov>(on, load, hilger::average_acceleration, policy));
        else
            use(hilger::newmark<hilger::bdf<2>>(on, load, hilger::average_acceleration, policy));
    });
}
inline std::vector<std::string> newmark_names() { return {"g-alpha-newmark", "gl-newmark"}; }
inline std::vector<std::string> history_names() { return {"exponentials", "exponentials:1e-8", "blocks", "direct", "window:1000"}; }

} // namespace program
