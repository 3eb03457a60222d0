// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/small.hpp"

namespace engine {

made embedded_in_one_step(problem const& what, std::string const& method, points<double> const& T) {
    return with_mechanics(what, [&](auto const& mechanics) -> made {
        auto const by = [&](auto const& how) { return embedded_small_by(mechanics, how, T, method); };
        if (method == "order-one") return by(hilger::order_one);
        if (method == "order-one-left") return by(hilger::order_one_left);
        if (method == "mid-point") return by(hilger::mid_point);
        return nullptr;
    });
}

} // namespace engine
