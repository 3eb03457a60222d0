// SPDX-License-Identifier: BSL-1.0
#include "hilger/text/formula.hpp"

#include <algorithm>

#include "text/printed.hpp"

namespace hilger {

namespace detail {

named_graph::named_graph(int d, bool is_scalar) : graph(d), dimension(d) {
    graph.has_values = false;
    for (char const* const name : {"q", "v"})
        for (int k = 0; k < d; ++k) names.push_back({name, is_scalar ? -1 : k});
    names.push_back({"t"});
}
formula_node named_graph::variable(std::string const& name) {
    auto const first = names.begin() + formula_graph<double>::arguments(dimension);
    auto const at = std::find_if(first, names.end(), [&](argument_name const& x) { return x.name == name; });
    if (at != names.end()) return argument(variables_[static_cast<std::size_t>(at - first)]);
    names.push_back({name});
    variables_.push_back(graph.new_argument());
    return argument(variables_.back());
}

node_formulas differentiated(std::shared_ptr<named_graph> in, formula_node const& L, std::vector<formula_node> const& force) {
    auto const d = static_cast<std::size_t>(in->dimension);
    tracing<double> const here(in->graph);
    differentiator<double> derive(in->graph);
    node_formulas made{std::move(in), L, {}, {}, {}, {}, {}, {}};
    for (auto* list : {&made.g, &made.p}) list->assign(d, formula_node(0));
    auto const put = [d](std::vector<formula_node>& by_q, std::vector<formula_node>& by_v, std::size_t row) {
        return [&by_q, &by_v, d, row](int k, formula_node const& x) {
            auto const column = static_cast<std::size_t>(k);
            (column < d ? by_q[row * d + column] : by_v[row * d + column - d]) = x;
        };
    };
    derive.derivatives(L, on_position | on_velocity, put(made.g, made.p, 0));
    for (std::size_t k = 0; k < force.size(); ++k) made.g[k] = made.g[k] + force[k];
    for (auto* list : {&made.gq, &made.gv, &made.pq, &made.pv}) list->assign(d * d, formula_node(0));
    for (std::size_t j = 0; j < d; ++j) {
        derive.derivatives(made.g[j], on_position | on_velocity, put(made.gq, made.gv, j));
        derive.derivatives(made.p[j], on_position | on_velocity, put(made.pq, made.pv, j));
    }
    return made;
}

} // namespace detail

formula formula::by(int argument) const {
    auto& g = in_->graph;
    detail::tracing<double> const here(g);
    detail::formula_node found(0);
    detail::differentiator<double>(g).derivatives(what_, detail::on_position | detail::on_velocity | detail::on_time,
                                                  [&](int k, detail::formula_node const& x) {
                                                      if (k == argument) found = x;
                                                  });
    return {in_, found};
}
double formula::value(std::vector<double> const& arguments) const {
    if (what_.is_constant()) return what_.value;
    auto const& g = in_->graph;
    std::vector<double> x(static_cast<std::size_t>(what_.node) + 1);
    for (int k = 0; k <= what_.node; ++k)
        if (auto const& n = g[k]; n.what != nullptr)
            n.what->run(x.data(), k, 1, &n.a, &n.b);
        else
            x[static_cast<std::size_t>(k)] = g.is_number(k) ? g.number(k) : arguments.at(static_cast<std::size_t>(n.b));
    return x.back();
}
int formula::size(int most) const {
    if (what_.is_constant()) return 1;
    auto const& g = in_->graph;
    std::vector<int> sizes;
    for (int k = 0; k <= what_.node; ++k) {
        auto const size_of = [&](int operand) { return sizes[static_cast<std::size_t>(operand)]; };
        auto const& n = g[k];
        sizes.push_back(n.what == nullptr ? 1 : std::min(most, 1 + size_of(n.a) + (detail::takes_two(n.what->name) ? size_of(n.b) : 0)));
    }
    return std::min(most, sizes.back());
}
std::ostream& operator<<(std::ostream& out, formula const& f) { return out << detail::printed(*f.in_, f.what_, print_style::terminal); }
std::string latex(formula const& f) { return detail::printed(*f.in_, f.what_, print_style::latex); }

formula formula_of(text::stated const& lagrangian, std::vector<text::coordinate> const& coordinates, std::string const& time) {
    int const d = lagrangian.words().dimension();
    auto in = std::make_shared<detail::named_graph>(d);
    std::size_t at = 0;
    for (auto const& x : coordinates)
        for (int k = 0; k < std::max(x.size, 1); ++k, ++at) {
            int const component = x.size == 0 ? -1 : k;
            in->names[at] = {x.position, component};
            in->names[at + static_cast<std::size_t>(d)] = {x.velocity, component};
        }
    in->names[2 * static_cast<std::size_t>(d)].name = time;
    detail::tracing<double> const here(in->graph);
    auto const L = lagrangian.value(
        detail::named_graph::argument(2 * d), [](int k) { return detail::named_graph::argument(k); },
        [d](int k) { return detail::named_graph::argument(d + k); });
    return {std::move(in), L};
}

} // namespace hilger
