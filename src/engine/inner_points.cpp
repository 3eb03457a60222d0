// SPDX-License-Identifier: BSL-1.0
#include "engine/motions.hpp"

namespace engine {

made embedded_with_inner_points(problem const& what, std::string const& method, points<double> const& T) {
    return with_mechanics(what, [&](auto const& mechanics) -> made {
        if (method == "gauss-2") return on_scale(hilger::embed(mechanics, hilger::galerkin<2, hilger::gauss>), T, method);
        if (method == "gauss-4") return on_scale(hilger::embed(mechanics, hilger::galerkin<4, hilger::gauss>), T, method);
        if (method == "gauss-8") return on_scale(hilger::embed(mechanics, hilger::galerkin<8, hilger::gauss>), T, method);
        if (method == "lobatto-3") return on_scale(hilger::embed(mechanics, hilger::galerkin<3, hilger::lobatto>), T, method);
        return nullptr;
    });
}

} // namespace engine
