// SPDX-License-Identifier: BSL-1.0
// The unknown q in C(T) of a variational problem: a function with a domain and no values. What is written with it is a description,
// an operator applied to q, that is later applied to functions that have values.
#pragma once

#include "hilger/function/concept.hpp"
#include "hilger/text.hpp"

namespace hilger {

template <text Name = text("q")>
struct unknown : discrete_function_tag {
    using domain_type = hilger::domain<nodes>;
    static constexpr auto name() { return Name; }
};

} // namespace hilger
