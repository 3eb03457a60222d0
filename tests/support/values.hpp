// SPDX-License-Identifier: BSL-1.0
// How the run-time tests show a function: the points it lives on and its values, as one text that doctest prints when it differs.
#pragma once

#include <sstream>
#include <string>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::testing {

/// "T^{+}: 1, 2/3, -2". Points are part of the text, so that a value at the wrong end is seen.
template <discrete_function F>
std::string values(F const& f) {
    std::ostringstream out;
    out << F::domain_type::name().text().view() << ':';
    char const* separator = " ";
    for (index_type i = f.first(); i <= f.last(); ++i) {
        out << separator << f[i];
        separator = ", ";
    }
    return out.str();
}

/// The same for the points of a scale.
template <time_scale_like Scale>
std::string points(Scale const& scale) {
    return values(function_on(scale, [](auto const& t) { return t; }));
}

/// The scale of the tables computed by hand: its steps 1, 2, 4 are all different, and so are the sums of any of them.
inline time_scale<Q> steps_1_2_4() { return time_scale<Q>{Q(0), Q(1), Q(3), Q(7)}; }

template <class T>
std::string printed(T const& x) {
    std::ostringstream out;
    out << x;
    return out.str();
}

} // namespace hilger::testing
