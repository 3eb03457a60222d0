// SPDX-License-Identifier: BSL-1.0
#include "engine/many_digits.hpp"

namespace engine {

template <>
std::unique_ptr<motion<hilger::float50>> make_motion(problem const& what, std::string const& method, points<hilger::float50> const& T) {
    return motion_in_digits(what, method, T);
}

} // namespace engine
