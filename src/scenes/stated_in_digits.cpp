// SPDX-License-Identifier: BSL-1.0
// In 50 and 100 digits, where the time goes into loops over digits: compiled without much optimisation.
#include "stated_walk.hpp"

namespace program {

template std::unique_ptr<walk> begin_in_numbers<hilger::float50>(stated_problem const&, configuration const&);
template std::unique_ptr<walk> begin_in_numbers<hilger::float100>(stated_problem const&, configuration const&);

} // namespace program
