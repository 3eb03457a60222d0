// SPDX-License-Identifier: BSL-1.0
#include "engine/many_digits.hpp"

namespace engine {

template <>
std::unique_ptr<motion<hilger::float50>> make_motion(problem const& what, std::string const& method, points<hilger::float50> const& T) {
    return made_in(what, method, T, "50 digits", "verlet, gauss-8, kahan-li-8, ");
}

} // namespace engine
