// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/damped.hpp"

namespace engine {

made damped(problem const& what, std::string const& method, points<double> const& T) {
    if (method != "mid-point") return nullptr;
    made result;
    with_damped(what, with_any_force(what), T.steps, [&](auto const& flow) { result = motion_by(flow, T, method); });
    return result;
}

} // namespace engine
