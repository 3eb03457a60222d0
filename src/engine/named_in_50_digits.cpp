// SPDX-License-Identifier: BSL-1.0
#include "engine/many_digits.hpp"

namespace engine {

template <>
std::unique_ptr<motion<hilger::float50>> made_by_name(problem const& what, std::string const& method, points<hilger::float50> const& T) {
    auto const by = [&](auto const& make) { return made_by(make, what, method, T); };
    if (method == "gauss-8") return by([](auto const& L) { return hilger::embed(L, hilger::galerkin<8, hilger::gauss>); });
    if (method == "verlet") return by([](auto const& L) { return hilger::stoermer_verlet(L); });
    if (method == "kahan-li-8") return by([](auto const& L) { return hilger::compose(hilger::kahan_li<8>, hilger::stoermer_verlet(L)); });
    return nullptr;
}

} // namespace engine
