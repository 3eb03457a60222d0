// SPDX-License-Identifier: BSL-1.0
#include "hilger/text/expression.hpp"

#include <algorithm>
#include <iterator>

#include "hilger/error.hpp"

namespace hilger::text {

node::node(kind k, std::string of_name, std::vector<pointer> of_parts, place where)
    : what(k), name(std::move(of_name)), parts(std::move(of_parts)), at(where) {
    for (std::size_t j = 0; j < parts.size(); ++j)
        depth = std::max(depth, parts[j]->depth + (j == 0 and is_arithmetic(what) and is_arithmetic(parts[j]->what) ? 0 : 1));
}
node::~node() {
    std::vector<pointer> open = std::move(parts);
    while (not open.empty()) {
        pointer const last = std::move(open.back());
        open.pop_back();
        if (last.use_count() == 1) {
            auto& below = const_cast<std::vector<pointer>&>(last->parts); // nobody else has it, and no node is made as a constant
            std::move(below.begin(), below.end(), std::back_inserter(open));
            below.clear();
        }
    }
}

expression::expression(kind what, std::string name, std::vector<expression> const& parts, place at) {
    std::vector<node::pointer> nodes;
    for (expression const& e : parts) nodes.push_back(e.root_);
    auto made = std::make_shared<node>(what, std::move(name), std::move(nodes), at);
    if (made->depth > deepest)
        error::raise<error::invalid_parameter>("a formula has at most ", deepest, " levels of parts in parts, and this one has more");
    root_ = std::move(made);
}

} // namespace hilger::text
