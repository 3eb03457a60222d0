// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/small.hpp"

namespace engine {

made composed(problem const& what, std::string const& method, points<double> const& T) {
    using namespace hilger;
    auto const by = [&](auto const& make) { return motion_by_making(what, method, T, make); };
    if (method == "verlet") return by([](auto const& L) { return stoermer_verlet(L); });
    if (method == "kahan-li-8") return by([](auto const& L) { return compose(kahan_li<8>, stoermer_verlet(L)); });
    if (method == "kahan-li-8+") return by([](auto const& L) { return compose(kahan_li<8>, stoermer_verlet(L, compensated)); });
    if (method == "blanes-moan-4") return by([](auto const& L) { return compose_with_adjoint(blanes_moan<4>, embed(L, order_one)); });
    return nullptr;
}

} // namespace engine
