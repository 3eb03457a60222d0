// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <string_view>

#include "hilger/scalar.hpp"

namespace hilger::testing {

/// How many numbers the histories have that a memory shows for checkpoints: past values, and modes of a sum of exponentials.
template <class Memory, class Method>
index_type numbers_of_histories(Memory memory, Method const& method) {
    index_type numbers = 0;
    auto count = [&numbers](std::string_view label, auto const&) { numbers += label == "value" or label == "mode"; };
    memory.visit(method, count);
    return numbers;
}

} // namespace hilger::testing
