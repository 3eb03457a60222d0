// SPDX-License-Identifier: BSL-1.0
// One case at the limits of the accepted input: its promise, the measured value, and its outcome, which is either full accuracy or a typed
// error, never a silent wrong number. The tests check the rows that `hilger extremes` prints. A bound follows from theory if that is
// sharp; if rounding is random or cancels, it is 4 epsilon or up to thirty times the measured value, because compilers and processors
// contract products and sums differently.
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/scalar.hpp"

namespace extremes {

struct row {
    std::string what, promised, measured;
    bool ok;
    std::string how;
};
using rows = std::vector<row>;

inline constexpr auto oscillator = [](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; };
inline constexpr auto pendulum = [](auto const& q, auto const& v) {
    using std::cos;
    return v * v / 2 + cos(q);
};

/// The time for the cases: two seconds in a test, a minute in a report.
enum class scope { test, report };

/// The groups of cases, one in each source file.
rows orders(scope);
rows histories(scope);
rows stages(scope);
rows counts(scope);
rows steps(scope);
rows differences(scope);
rows sizes(scope);
rows masses(scope);
rows encounters(scope);
rows ends(scope);
rows smallest(scope);
rows scalars(scope);
rows not_finite(scope);

/// A number with three digits.
std::string few_digits(double x);

/// `error` is at most `bound`, both in `unit`s; NaN is not.
row kept(std::string what, double error, double bound, std::string const& unit = "eps");
/// A statement that is true or not.
row holds(std::string what, std::string promised, bool true_, std::string measured = "");

/// Computes all states of a path, for their errors.
template <class Path>
void walk(Path const& path) {
    for (auto const& x : path) (void)x;
}
template <class Path>
auto last_of(Path const& path) {
    auto last = *path.begin();
    for (auto const& x : path) last = x;
    return last;
}

/// |x - exact| in epsilons of x's scalar, relative to `size` (or to |exact|).
template <class S, class Wide>
double in_epsilons(S const& x, Wide const& exact, Wide const& size) {
    Wide const error = Wide(x) - exact;
    if (error == Wide(0)) return 0;
    return static_cast<double>(Wide((error < Wide(0) ? Wide(-error) : error) / size / Wide(hilger::epsilon<S>())));
}
template <class S, class Wide>
double in_epsilons(S const& x, Wide const& exact) {
    return in_epsilons(x, exact, exact < Wide(0) ? Wide(-exact) : exact);
}

template <class Error>
inline constexpr char const* name_of = "exception";
template <>
inline constexpr char const* name_of<hilger::error::invalid_scale> = "invalid_scale";
template <>
inline constexpr char const* name_of<hilger::error::outside_domain> = "outside_domain";
template <>
inline constexpr char const* name_of<hilger::error::mismatch> = "mismatch";
template <>
inline constexpr char const* name_of<hilger::error::invalid_parameter> = "invalid_parameter";
template <>
inline constexpr char const* name_of<hilger::error::not_finite> = "not_finite";
template <>
inline constexpr char const* name_of<hilger::error::unreadable> = "unreadable";
template <>
inline constexpr char const* name_of<hilger::error::singular> = "singular";
template <>
inline constexpr char const* name_of<hilger::error::no_convergence> = "no_convergence";

/// `action` throws Error, with a message that contains `fragment`.
template <class Error, class Action>
row refused(std::string what, Action const& action, std::string const& fragment = "") {
    std::string const promised = std::string("error::") + name_of<Error>;
    try {
        action();
    } catch (Error const& e) {
        bool const said = std::string(e.what()).find(fragment) != std::string::npos;
        return {std::move(what), promised, said ? promised : "does not say '" + fragment + "'", said, "typed error"};
    } catch (std::exception const& e) {
        return {std::move(what), promised, e.what(), false, "another error"};
    }
    return {std::move(what), promised, "no error", false, "silence"};
}

} // namespace extremes
