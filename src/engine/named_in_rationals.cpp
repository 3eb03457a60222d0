// SPDX-License-Identifier: BSL-1.0
#include "engine/many_digits.hpp"

namespace engine {

template <>
std::unique_ptr<motion<hilger::Q>> made_by_name(problem const& what, std::string const& method, points<hilger::Q> const& T) {
    if (method != "verlet") return nullptr;
    return made_by([](auto const& L) { return hilger::stoermer_verlet(L); }, what, method, T);
}

} // namespace engine
