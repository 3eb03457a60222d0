// SPDX-License-Identifier: BSL-1.0
// The unknown q in C(T), or in C(T/d), of a variational problem: a function with a domain and no values. An expression in it describes an
// operator on q, to be applied later to functions that have values.
#pragma once

#include "hilger/fixed_text.hpp"
#include "hilger/function/concept.hpp"

namespace hilger {

/// The unknown with this name, on T or another family Base.
template <text_argument Name = "q", class Base = nodes>
struct unknown : discrete_function_tag {
    using domain_type = hilger::domain<Base>;
    static constexpr auto name() { return Name; }
};

} // namespace hilger
