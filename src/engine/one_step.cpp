// SPDX-License-Identifier: BSL-1.0
#include "engine/small.hpp"

namespace engine {

made embedded_in_one_step(problem const& what, std::string const& method, points<double> const& T) {
    return with_mechanics(what, [&](auto const& mechanics) -> made {
        if (method == "order-one") return on_scale(hilger::embed(mechanics, hilger::order_one), T, method);
        if (method == "order-one-left") return on_scale(hilger::embed(mechanics, hilger::order_one_left), T, method);
        if (method == "mid-point") return embedded_small(mechanics, hilger::mid_point, T, method);
        return nullptr;
    });
}

} // namespace engine
