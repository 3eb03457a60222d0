// SPDX-License-Identifier: BSL-1.0
#include "extremes/row.hpp"

#include <sstream>

namespace extremes {

std::string few_digits(double x) {
    std::ostringstream out;
    out.precision(3);
    out << x;
    return out.str();
}

row kept(std::string what, double error, double bound, std::string const& unit) {
    bool const ok = error <= bound;
    return {std::move(what), "<= " + few_digits(bound) + ' ' + unit, few_digits(error) + ' ' + unit, ok,
            ok ? "digits kept" : "digits lost"};
}

row holds(std::string what, std::string promised, bool true_, std::string measured) {
    if (measured.empty()) measured = true_ ? "so it is" : "is not so";
    return {std::move(what), std::move(promised), std::move(measured), true_, true_ ? "as promised" : "broken"};
}

} // namespace extremes
