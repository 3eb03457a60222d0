// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/summed.hpp"

namespace engine {

template std::unique_ptr<motion<double>> summed(problem const&, std::string const&, points<double> const&);

} // namespace engine
