// SPDX-License-Identifier: BSL-1.0
#include "text/node_equation.hpp"

#include <algorithm>

namespace hilger::detail {

node_equation::node_equation(node_formulas const& of, tableau<formula_node> const& b, std::string type)
    : in_(*of.in), here_(in_.graph), N(in_.dimension), type_(std::move(type)), w_(b.w(0)), c_(constant("c", w_ * b.a(0, 1))),
      f_(constant("f", w_ * b.a(0, 0))), time_(variable("t") + b.a(0, 1) * variable("h")), node_(of) {
    for (int k = 0; k < N; ++k) {
        in_.names[static_cast<std::size_t>(k)] = {N == 1 ? "x" : "x" + std::to_string(k)};
        in_.names[static_cast<std::size_t>(N + k)] = {element("y", k)};
    }
    in_.names[static_cast<std::size_t>(2 * N)] = {"t_node"};
    auto const depends = [this](formula_node const& x) {
        return not x.is_constant() and (in_.graph[x.node].on & (on_velocity | (c_.is(0) ? 0 : on_position))) != 0;
    };
    for (std::size_t k = 0; k < node_.gq.size(); ++k) D_.push_back(f_.is(0) ? formula_node(0) : c_ * node_.gq[k] + node_.gv[k]);
    linear_ = std::none_of(D_.begin(), D_.end(), depends);
    for (std::size_t k = 0; k < D_.size(); ++k) linear_ = linear_ and not depends(node_.pv[k] + c_ * node_.pq[k]);
}

bool node_equation::has_branches() const {
    node_list all = node_.g;
    all.insert(all.end(), node_.p.begin(), node_.p.end());
    auto const nodes = nodes_below(in_.graph, all);
    return std::any_of(nodes.begin(), nodes.end(), [this](int k) {
        auto const& n = in_.graph[k];
        if (n.what == nullptr or (n.on & (on_velocity | (c_.is(0) ? 0 : on_position))) == 0) return false;
        std::string_view const name = n.what->name;
        return name == "max" or name == "min" or name == "abs" or name == "sign" or name == "where" or name == "elsewhere";
    });
}
bool node_equation::are_numbers(node_list const& all) {
    return std::all_of(all.begin(), all.end(), [](formula_node const& x) { return x.is_constant(); });
}
formula_node node_equation::slope_of_row(int j, int k, std::string const& D) const {
    auto const mass = node_.pv[at(j, k)] + c_ * node_.pq[at(j, k)];
    return has_slope(j, k) ? mass - f_ * variable(D) : mass;
}
formula_node node_equation::constant(std::string const& name, formula_node const& value) {
    if (value.is_constant() or in_.graph[value.node].what == nullptr) return value;
    for (auto const& [known, same] : constants_)
        if (same.node == value.node) return variable(known);
    constants_.emplace_back(name, value);
    return variable(name);
}
std::string node_equation::position(std::string const& in, std::set<std::string>& used) const {
    c_statements lines = statements(in, "at");
    if (used.contains("t_node")) lines.add_local("t_node", time_);
    for (int k = 0; k < N; ++k)
        if (used.contains(name_of_x(k))) lines.add_local(name_of_x(k), variable(element("q", k)) + c_ * y(k));
    std::string text = lines.text();
    used.insert(lines.read().begin(), lines.read().end());
    return text;
}
std::string node_equation::force_at_the_end(std::set<std::string>& used) const {
    c_statements body = statements("        ");
    for (int k = 0; k < N; ++k) body.add(element("g", k) + " =", node_.g[static_cast<std::size_t>(k)]);
    std::string const formulas = body.text();
    std::set<std::string> here = body.read();
    std::string const place = position("        ", here);
    used.insert(here.begin(), here.end());
    return "    {\n" + place + formulas + "    }\n";
}

} // namespace hilger::detail
