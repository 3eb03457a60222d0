// SPDX-License-Identifier: BSL-1.0
#include "engine/many_digits.hpp"

namespace engine {

template <>
std::unique_ptr<motion<hilger::float50>> made_with_inner_points(problem const& what, std::string const& method,
                                                                points<hilger::float50> const& T) {
    if (method != "gauss-8") return nullptr;
    return made_by(hilger::galerkin<8, hilger::gauss>, what, method, T);
}

} // namespace engine
