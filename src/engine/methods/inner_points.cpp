// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/small.hpp"

namespace engine {

made embedded_with_inner_points(problem const& what, std::string const& method, points<double> const& T) {
    auto const by = [&](auto const& how) {
        return motion_by_making(what, method, T, [how](auto const& L) { return hilger::embed(L, how); });
    };
    if (method == "gauss-2") return by(hilger::galerkin<2, hilger::gauss>);
    if (method == "gauss-4") return by(hilger::galerkin<4, hilger::gauss>);
    if (method == "gauss-6") return by(hilger::galerkin<6, hilger::gauss>);
    if (method == "gauss-8") return by(hilger::galerkin<8, hilger::gauss>);
    if (method == "lobatto-3") return by(hilger::galerkin<3, hilger::lobatto>);
    return nullptr;
}

} // namespace engine
