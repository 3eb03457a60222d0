// SPDX-License-Identifier: BSL-1.0
// Lagrangians that are a sum of parts, each with an embedding of its own, as in "mid-point + order-one".
#pragma once

#include "from_file.hpp"

namespace program {

/// The texts between plus signs outside of brackets.
inline std::vector<std::string> summands(std::string const& text) {
    std::vector<std::string> all{""};
    int depth = 0;
    for (char const c : text) {
        depth += (c == '(' or c == '[') - (c == ')' or c == ']');
        if (c == '+' and depth == 0)
            all.emplace_back();
        else
            all.back() += c;
    }
    for (std::string& one : all) {
        one.erase(0, std::min(one.find_first_not_of(' '), one.size()));
        one.erase(one.find_last_not_of(' ') + 1);
    }
    return all;
}
/// Whether a method is one for each of several parts.
inline bool names_parts(stated_problem const& what, std::string const& method) {
    if (what.parts.empty()) return false;
    std::vector<std::string> const methods = summands(method);
    return methods.size() > 1 and not methods.back().empty(); // mid-point+ has another meaning
}

/// A problem of the engine and its method.
struct problem_with_method {
    engine::problem of;
    std::string method;
};
/// @throws hilger::error::invalid_parameter when the numbers of methods and of parts differ
inline problem_with_method read_by(stated_problem const& what, std::string const& method) {
    if (not names_parts(what, method)) return {what.of, method};
    std::vector<std::string> const methods = summands(method);
    if (methods.size() != what.parts.size())
        hilger::error::raise<hilger::error::invalid_parameter>("there is one embedding for all or one for each of the ", what.parts.size(),
                                                               " Lagrangians, and here are ", methods.size());
    engine::problem sum = what.of;
    sum.lagrangian = what.parts[0];
    for (std::size_t k = 1; k < methods.size(); ++k) sum.besides.push_back({what.parts[k], methods[k]});
    return {std::move(sum), methods[0]};
}

} // namespace program
