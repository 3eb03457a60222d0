// SPDX-License-Identifier: BSL-1.0
#include "text/c_statements.hpp"

#include <cctype>

namespace hilger::detail {

namespace {

/// A longer expression is cut in two, to keep lines short.
constexpr int longest = 12;

} // namespace

std::string c_number(double x) {
    std::string const digits = round_trip(finite_constant(x));
    return digits.find_first_of(".e") == std::string::npos ? digits + ".0" : digits;
}

written c_operation(std::string_view name, written const& a, written const& b) {
    if (name == "+") return {a.in(written::sum) + " + " + b.in(written::product), written::sum};
    if (name == "-") return {a.in(written::sum) + " - " + b.in(written::product), written::sum};
    if (name == "*") return {a.in(written::product) + " * " + b.in(written::factor), written::product};
    if (name == "/") return {a.in(written::product) + " / " + b.in(written::factor), written::product};
    if (name == "-x") return {"-" + a.in(written::product), written::sum};
    if (name == "sign") return {"sign_of(" + a.text + ", 1.0)"};
    std::string const called = name == "abs"         ? "fabs"
                               : name == "max"       ? "larger"
                               : name == "min"       ? "smaller"
                               : name == "where"     ? "if_not_negative"
                               : name == "elsewhere" ? "if_negative"
                                                     : std::string(name);
    return {called + "(" + a.text + (takes_two(name) ? ", " + b.text : "") + ")"};
}

std::string c_statements::text() {
    count();
    for (auto const& [before, value] : results_) {
        for (int const k : nodes_below(in_.graph, {value}))
            if (not written_.contains(k)) write(k, k == value.node);
        std::string const of_type = value.is_constant() and type_ != "double" ? "(" + type_ + "){0} + " : "";
        lines_ += indent_ + before + " " + of_type + (value.is_constant() ? c_number(value.value) : at(value.node).text) + ";\n";
    }
    return lines_;
}
void c_statements::count() {
    std::vector<formula_node> all;
    for (auto const& [before, value] : results_) {
        all.push_back(value);
        if (not value.is_constant()) ++uses_[value.node];
    }
    for (int const k : nodes_below(in_.graph, all))
        if (auto const& n = in_.graph[k]; n.what != nullptr) {
            ++uses_[n.a];
            if (takes_two(n.what->name)) ++uses_[n.b];
        }
}
void c_statements::write(int node, bool is_result) {
    auto const& g = in_.graph;
    auto const& n = g[node];
    auto& made = written_[node];
    if (g.is_number(node)) {
        made.text = {c_number(g.number(node)), g.number(node) < 0 ? written::product : written::atom};
        return;
    }
    if (n.what == nullptr) {
        made.text = {in_.names[static_cast<std::size_t>(n.b)].name};
        read_.insert(made.text.text.substr(0, made.text.text.find('[')));
        return;
    }
    std::string_view const name = n.what->name;
    made.text = c_operation(name, at(n.a), at(n.b));
    if (name == "+")
        for (auto const& [first, second] : {std::pair(n.a, n.b), std::pair(n.b, n.a)})
            if (auto const& m = g[second]; m.what != nullptr and std::string_view(m.what->name) == "-x") {
                made.text = c_operation("-", at(first), at(m.a)); // the same bits as a + (-b)
                break;
            }
    made.size = 1 + written_[n.a].size + (takes_two(name) ? written_[n.b].size : 0);
    bool const is_trivial = name == "-x" and g[n.a].what == nullptr;
    if (is_trivial or (uses_[node] < 2 and (is_result or made.size < longest))) return;
    bool const is_called = std::isalpha(static_cast<unsigned char>(name[0])) != 0;
    std::string const kind = is_called ? (letter_ == "u" ? "" : letter_ + "_") + std::string(name) + "_" : letter_;
    std::string const local = kind + std::to_string(++numbers_[kind]);
    lines_ += indent_ + "const " + type_ + " " + local + " = " + made.text.text + ";\n";
    made = {{local}, 0};
}

std::string largest_in(std::string const& array, int n, std::string const& larger, std::string const& size_of) {
    std::string text = size_of + "(" + element(array, 0) + ")";
    for (int k = 1; k < n; ++k) text = larger + "(" + text + ", " + size_of + "(" + element(array, k) + "))";
    return text;
}

std::string filled(std::string text, std::initializer_list<std::pair<char const*, std::string>> const& values) {
    for (auto const& [key, value] : values)
        for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos; at += value.size())
            text.replace(at, std::string(key).size(), value);
    return text;
}

} // namespace hilger::detail
