// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/damped.hpp"

#include "engine/motions.hpp"

namespace engine {

made damped(problem const& what, std::string const& method, points<double> const& T) {
    if (method != "mid-point") return nullptr;
    return with_mechanics(what, [&](auto const& mechanics) {
        made result;
        with_damped(what, mechanics, T.steps, [&](auto const& flow) { result = on_scale(flow, T, method); });
        return result;
    });
}

} // namespace engine
