// SPDX-License-Identifier: BSL-1.0
// Systems in text whose Lagrangian is a sum of parts, each read by an embedding of its own, as "mid-point + order-one" says.
#include "engine/methods/summed.hpp"
#include "stated_walk.hpp"

namespace program {

namespace {

/// What stands between plus signs outside of brackets.
std::vector<std::string> summands(std::string const& text) {
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
engine::problem read_by(stated_problem const& what, std::vector<std::string> const& methods) {
    if (methods.size() != what.parts.size())
        hilger::error::raise<hilger::error::invalid_parameter>("there is one embedding for all or one for each of the ", what.parts.size(),
                                                               " Lagrangians, and here are ", methods.size());
    engine::problem sum = what.of;
    sum.lagrangian = what.parts[0];
    for (std::size_t k = 1; k < methods.size(); ++k) sum.besides.push_back({what.parts[k], methods[k]});
    return sum;
}

} // namespace

bool names_parts(stated_problem const& what, std::string const& method) {
    if (what.parts.empty()) return false;
    std::vector<std::string> const methods = summands(method);
    return methods.size() > 1 and not methods.back().empty(); // mid-point+ has another meaning
}

bool is_for_parts(stated_problem const& what, std::string const& method) {
    if (not names_parts(what, method)) return false;
    std::vector<std::string> const methods = summands(method);
    (void)engine::embeddings_of_sum<double>(read_by(what, methods), methods[0], 1.0);
    return true;
}

std::unique_ptr<walk> begin_summed(stated_problem const& what, configuration const& c) {
    if (c.scalar != "double") return nullptr;
    std::vector<std::string> const methods = summands(c.embedding);
    engine::problem const sum = read_by(what, methods);
    auto const& begin = beginning_of<double>(what);
    auto const how = engine::embeddings_of_sum<double>(sum, methods[0], begin.step(c.steps));
    auto const along = [&](auto const& force) {
        engine::summed_flow<double, std::remove_cvref_t<decltype(force)>> const flow(engine::summed_lagrangian(sum), force, how);
        return walk_along(flow.along(begin.scale(c.steps), begin.from()), begin.seen);
    };
    if (sum.force) return along(*sum.force);
    return along(hilger::no_force{});
}

} // namespace program
