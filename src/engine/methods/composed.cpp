// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/small.hpp"

namespace engine {

made composed(problem const& what, std::string const& method, points<double> const& T) {
    return with_mechanics(what, [&](auto const& mechanics) -> made {
        auto const by = [&](auto const& make) { return embedded_small(mechanics, make, T, method); };
        if (method == "verlet") return by([](auto const& L) { return hilger::stoermer_verlet(L); });
        if (method == "kahan-li-8")
            return by([](auto const& L) { return hilger::compose(hilger::kahan_li<8>, hilger::stoermer_verlet(L)); });
        return nullptr;
    });
}

} // namespace engine
