// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/newmark.hpp"

namespace engine {

template std::unique_ptr<motion<double>> by_newmark(problem const&, std::string const&, points<double> const&);

} // namespace engine
