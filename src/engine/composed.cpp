// SPDX-License-Identifier: BSL-1.0
#include "engine/motions.hpp"

namespace engine {

made composed(problem const& what, std::string const& method, points<double> const& T) {
    return with_mechanics(what, [&](auto const& mechanics) -> made {
        if (method == "verlet") return on_scale(hilger::symmetrized(hilger::embed(mechanics, hilger::order_one)), T, method);
        if (method == "kahan-li-8")
            return on_scale(hilger::compose(hilger::kahan_li<8>, hilger::embed(mechanics, hilger::mid_point)), T, method);
        return nullptr;
    });
}

} // namespace engine
