// SPDX-License-Identifier: BSL-1.0
// The C function of one step in position-momentum form, as in step/small/one_node.hpp: solves the equation of node_equation.hpp by Newton's
// method.
#pragma once

#include "hilger/text/c_code.hpp"
#include "text/node_equation.hpp"

namespace hilger::detail {

/// The body of NAME_step, and the arguments that it reads.
class c_step : node_equation {
public:
    c_step(node_formulas const& of, tableau<formula_node> const& b, std::string name);
    [[nodiscard]] std::string text();
    [[nodiscard]] std::set<std::string> const& read() const { return read_; }

private:
    /// Joins the texts that `of` gives for each component.
    template <class Of>
    [[nodiscard]] std::string in_each(Of const& of) const {
        std::string text = of("0");
        for (int k = 1; k < N; ++k) text += " && " + of(std::to_string(k));
        return text;
    }
    [[nodiscard]] std::string largest(std::string const& array) const { return largest_in(array, N, "fmax", "fabs"); }
    /// The scale of the terms whose difference is r.
    [[nodiscard]] std::string size_of_residual() const {
        return largest("p") + (f_.is(0) ? "" : " + fabs(" + name_of(f_) + ") * " + largest("g"));
    }
    [[nodiscard]] std::string failure() const { return "return " + name_ + "_"; }
    /// Corrections in a loop until one is small.
    [[nodiscard]] std::string iterated(std::string const& work) const;
    std::string correction(std::string const& in);
    [[nodiscard]] std::string solution(std::string const& in) const;
    std::string update();
    std::string declarations();

    std::string name_;
    bool branches_ = false;
    std::set<std::string> read_;
};

} // namespace hilger::detail
