// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/newmark.hpp"

namespace engine {

template std::unique_ptr<motion<hilger::float50>> by_newmark(problem const&, std::string const&, points<hilger::float50> const&);

} // namespace engine
