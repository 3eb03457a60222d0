// SPDX-License-Identifier: BSL-1.0
// Nodes of a graph as statements of C99: one assignment a line, shared nodes computed once under a name. An argument has the same spelling
// in C as in the graph: "h", "q[0]".
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "text/printed.hpp"

namespace hilger::detail {

std::string c_number(double x);
/// An operation of a graph by its name. Some call functions that math.h does not have: see functions_called.
written c_operation(std::string_view name, written const& a, written const& b);

class c_statements {
public:
    /// `letter` begins the names of shared nodes, u1, u2, ..., and differs between statements of one scope. `type` is the C type of values.
    c_statements(named_graph const& in, std::string indent, std::string letter = "u", std::string type = "double")
        : in_(in), indent_(std::move(indent)), letter_(std::move(letter)), type_(std::move(type)) {}

    /// `before` is the text before the value: "r[0] =", "const double x =", "q[0] +=", "return".
    void add(std::string before, formula_node const& value) { results_.emplace_back(std::move(before), value); }
    /// Adds a local constant of this name.
    void add_local(std::string const& name, formula_node const& value) { add("const " + type_ + " " + name + " =", value); }

    /// The statements. Call it once, after the last add.
    std::string text();
    /// The arguments that the statements read, without indices: "q" for "q[1]".
    [[nodiscard]] std::set<std::string> const& read() const { return read_; }

private:
    void count();
    void write(int node, bool is_result);
    [[nodiscard]] written const& at(int node) const { return written_.at(node).text; }
    struct spelt {
        written text;
        int size = 0; ///< number of operations
    };
    named_graph const& in_;
    std::string indent_, letter_, type_, lines_;
    std::vector<std::pair<std::string, formula_node>> results_;
    std::map<int, int> uses_;
    std::map<int, spelt> written_;
    std::map<std::string, int> numbers_;
    std::set<std::string> read_;
};

inline std::string element(std::string const& array, int k) { return array + "[" + std::to_string(k) + "]"; }
inline std::string element(std::string const& array, int j, int k) { return element(element(array, j), k); }
/// max |array[k]|, by the functions `larger` and `size_of`.
std::string largest_in(std::string const& array, int n, std::string const& larger, std::string const& size_of);

/// Replaces each key in `text` by its value.
std::string filled(std::string text, std::initializer_list<std::pair<char const*, std::string>> const& values);

} // namespace hilger::detail
