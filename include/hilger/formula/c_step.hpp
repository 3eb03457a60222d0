// SPDX-License-Identifier: BSL-1.0
// The C function of one step in position-momentum form, as step/small/one_node.hpp makes it: the equation of node_equation.hpp solved by
// Newton's method.
#pragma once

#include <algorithm>

#include "hilger/formula/c_statements.hpp"
#include "hilger/formula/node_equation.hpp"
#include "hilger/newton/stop.hpp"

namespace hilger::detail {

/// max |array[k]|
inline std::string c_largest(std::string const& array, int n) {
    std::string text = "fabs(" + element(array, 0) + ")";
    for (int k = 1; k < n; ++k) text = "fmax(" + text + ", fabs(" + element(array, k) + "))";
    return text;
}

/// `text` with the value of each key in place of it.
inline std::string filled(std::string text, std::initializer_list<std::pair<char const*, std::string>> const& values) {
    for (auto const& [key, value] : values)
        for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos; at += value.size())
            text.replace(at, std::string(key).size(), value);
    return text;
}

inline std::string c_solve(std::string const& name, int n) {
    char const* const text = R"(/* x becomes K^-1 x, by elimination with row pivots; 0 where K is singular to rounding */
static int NAME_solve(double K[$n][$n], double x[$n])
{
    double largest = 0.0;
    double smallest = HUGE_VAL;
    for (int k = 0; k < $n; ++k) {
        int pivot = k;
        for (int j = k + 1; j < $n; ++j)
            if (fabs(K[j][k]) > fabs(K[pivot][k])) pivot = j;
        for (int j = 0; j < $n; ++j) {
            const double above = K[k][j];
            K[k][j] = K[pivot][j];
            K[pivot][j] = above;
        }
        const double above = x[k];
        x[k] = x[pivot];
        x[pivot] = above;
        if (!(fabs(K[k][k]) > 0.0)) return 0;
        largest = fmax(largest, fabs(K[k][k]));
        smallest = fmin(smallest, fabs(K[k][k]));
        for (int j = k + 1; j < $n; ++j) {
            const double factor = K[j][k] / K[k][k];
            for (int m = k + 1; m < $n; ++m) K[j][m] -= factor * K[k][m];
            x[j] -= factor * x[k];
        }
    }
    if (!($limit * largest < smallest)) return 0;
    for (int k = $last; k >= 0; --k) {
        for (int j = k + 1; j < $n; ++j) x[k] -= K[k][j] * x[j];
        x[k] /= K[k][k];
    }
    return 1;
}
)";
    return filled(text, {{"NAME", name},
                         {"$n", std::to_string(n)},
                         {"$limit", c_spelling::number(n * epsilon<double>())},
                         {"$last", std::to_string(n - 1)}});
}

/// The body of NAME_step, and what it reads of the arguments.
class c_step : node_equation {
public:
    c_step(node_evaluation const& what, tableau<symbol> const& b, symbol const& h, std::string name)
        : node_equation(what, b, h), name_(std::move(name)) {
        branches_ = branches(node_.g, y_) or branches(node_.p, y_) or (not c_.is(0) and (branches(node_.g, x_) or branches(node_.p, x_)));
        linear_ = linear_ and not branches_;
    }

    [[nodiscard]] std::string text() {
        std::string const in = linear_ ? "    " : "        ", failure = "return " + name_ + "_";
        std::string work = correction(in);
        if (not linear_) {
            char const* const loop = R"(    int done = 0;
$settled    for (int iteration = 0; !done; ++iteration) {
        if (iteration == $most) return NAME_no_convergence;
$work$stop    }
)";
            char const* const stop =
                R"(        /* after a small correction the error is of the size of the rounding; so it is where r is no more than that */
        const double correction = $d;
        const double rounding = $rounding * ($size);
        done = correction <= $floor * $y$plausible;
        if (iteration > 0 && $r <= rounding) done = 1;
)";
            char const* const stop_in_each =
                R"(        /* after a small correction the error is of the size of the rounding; so it is where r is no more than that: in
           each component, or two rounds after it is so in all of them together */
        int each = ($small)$plausible;
        int together = $d <= $floor * $y$plausible;
        if (iteration > 0) {
            each = each || ($rounded);
            together = together || $r <= $rounding * ($size);
        }
        settled += each || together;
        done = each || settled > 2;
)";
            char const* const stop_on_branches =
                R"(        /* a small correction may lead to another branch: it has to be rounding itself */
        done = $d <= $rounding * $y;
)";
            work =
                filled(loop, {{"$most", std::to_string(most_iterations<double>)},
                              {"NAME", name_},
                              {"$stop", branches_ ? stop_on_branches
                                        : N > 1   ? stop_in_each
                                                  : stop},
                              // near the speed of light masses grow without bound, and all corrections are small
                              {"$plausible", has_constant_mass() ? "" : " && $r <= $size"},
                              {"$settled", branches_ or N == 1 ? "" : "    int settled = 0;\n"},
                              {"$small", in_each([](std::string const& k) { return "fabs(d[" + k + "]) <= $floor * fabs(y[" + k + "])"; })},
                              {"$rounded", in_each([this](std::string const& k) {
                                   return "fabs(r[" + k + "]) <= $rounding * (fabs(p[" + k + "])" +
                                          (f_.is(0) ? "" : " + fabs(" + f_.get().name + ") * fabs(g[" + k + "])") + ")";
                               })},
                              {"$d", c_largest("d", N)},
                              {"$rounding", c_spelling::number(4 * epsilon<double>())},
                              {"$size", size_of_residual()},
                              {"$floor", c_spelling::number(square_root_of_epsilon<double>() / 2)},
                              {"$y", c_largest("y", N)},
                              {"$r ", c_largest("r", N) + " "},
                              {"$work", work}});
        }
        if (f_.is(0)) work += force_at_the_end();
        std::string finite;
        for (int k = 0; k < N; ++k) finite += (k > 0 ? " + " : "") + element("g", k) + " + " + element("y", k);
        work += "    if (!isfinite(" + finite + ")) " + failure + "not_finite;\n";
        c_statements update("    ", "by");
        for (int k = 0; k < N; ++k) {
            update.add(element("q", k) + " +=", w_ * y_[static_cast<std::size_t>(k)]);
            update.add(element("p", k) + " +=", w_ * symbol::variable(element("g", k)));
            update.add(element("v", k) + " =", y_[static_cast<std::size_t>(k)]);
        }
        work += update.text() + "    return " + name_ + "_ok;\n";
        read_.insert(update.read().begin(), update.read().end());
        read_.insert({"q", "p", "v"});
        return declarations() + work;
    }
    [[nodiscard]] std::set<std::string> const& read() const { return read_; }

private:
    /// What `of` says of a component, for all of them.
    template <class Of>
    [[nodiscard]] std::string in_each(Of const& of) const {
        std::string text = of("0");
        for (int k = 1; k < N; ++k) text += " && " + of(std::to_string(k));
        return text;
    }
    [[nodiscard]] bool has_constant_mass() const {
        return std::all_of(node_.pv.begin(), node_.pv.end(), [](symbol const& f) { return f.op() == operation::number; });
    }
    /// r is the difference of numbers of this size.
    [[nodiscard]] std::string size_of_residual() const {
        return c_largest("p", N) + (f_.is(0) ? "" : " + fabs(" + f_.get().name + ") * " + c_largest("g", N));
    }
    /// One iteration of Newton for y, with g carried along to first order.
    std::string correction(std::string const& in) {
        c_statements body(in);
        auto const at = [this](int j, int k) { return static_cast<std::size_t>(j * N + k); };
        auto const entry = [&](int j, int k) { return D_[at(j, k)].is(0) ? symbol(0) : symbol::variable(element("D", j, k)); };
        if (not f_.is(0))
            for (int k = 0; k < N; ++k) body.add(element("g", k) + " =", node_.g[static_cast<std::size_t>(k)]);
        for (int k = 0; k < N; ++k)
            body.add(element("r", k) + " =",
                     symbol::variable(element("p", k)) + f_ * symbol::variable(element("g", k)) - node_.p[static_cast<std::size_t>(k)]);
        for (int j = 0; j < N; ++j)
            for (int k = 0; k < N; ++k)
                if (not D_[at(j, k)].is(0)) body.add(element("D", j, k) + " =", D_[at(j, k)]);
        for (int j = 0; j < N; ++j)
            for (int k = 0; k < N; ++k)
                body.add(element("K", j, k) + " =", node_.pv[at(j, k)] + c_ * node_.pq[at(j, k)] - f_ * entry(j, k));
        std::string const formulas_ = body.text();
        std::string work = position(in, body.read()) + formulas_;
        std::string sum = element("r", 0);
        for (int k = 1; k < N; ++k) sum += " + " + element("r", k);
        work += in + "if (!isfinite(" + sum + ")) return " + name_ + "_not_finite;\n";
        if (branches_) {
            work += in + "/* L has branches: here, and nowhere near, is where its equation has to hold */\n" + in + "if (" +
                    c_largest("r", N) + " <= " + c_spelling::number(4 * epsilon<double>()) + " * (" + size_of_residual() + ")) break;\n";
        }
        if (N == 1) {
            work += in + "if (K[0][0] == 0.0 || !isfinite(K[0][0])) return " + name_ + "_singular;\n" + in + "d[0] = r[0] / K[0][0];\n";
        } else {
            for (int k = 0; k < N; ++k) work += in + element("d", k) + " = " + element("r", k) + ";\n";
            work += in + "if (!" + name_ + "_solve(K, d)) return " + name_ + "_singular;\n";
        }
        for (int k = 0; k < N; ++k) work += in + element("y", k) + " += " + element("d", k) + ";\n";
        for (int j = 0; j < N; ++j)
            for (int k = 0; k < N; ++k)
                if (not D_[at(j, k)].is(0)) work += in + element("g", j) + " += " + element("D", j, k) + " * " + element("d", k) + ";\n";
        return work;
    }
    /// Where the position is that at the end, g was not needed until now.
    std::string force_at_the_end() {
        c_statements body("        ");
        for (int k = 0; k < N; ++k) body.add(element("g", k) + " =", node_.g[static_cast<std::size_t>(k)]);
        std::string const formulas_ = body.text();
        return "    {\n" + position("        ", body.read()) + formulas_ + "    }\n";
    }
    /// The time and the position at the node, as far as they are used.
    std::string position(std::string const& in, std::set<std::string> const& used) {
        c_statements lines(in, "at");
        if (used.contains("t_node")) lines.add("const double t_node =", time_);
        for (int k = 0; k < N; ++k)
            if (std::string const& name = x_[static_cast<std::size_t>(k)].get().name; used.contains(name))
                lines.add("const double " + name + " =", symbol::variable(element("q", k)) + c_ * y_[static_cast<std::size_t>(k)]);
        std::string const text = lines.text();
        read_.insert(used.begin(), used.end());
        read_.insert(lines.read().begin(), lines.read().end());
        return text;
    }
    std::string declarations() {
        c_statements lines("    ", "of");
        for (auto const& [constant, value] : constants_)
            if (read_.contains(constant)) lines.add("const double " + constant + " =", value);
        std::string const n = "[" + std::to_string(N) + "]";
        std::string text = lines.text(), start = linear_ ? "0.0" : element("v", 0);
        read_.insert(lines.read().begin(), lines.read().end());
        for (int k = 1; k < N; ++k) start += linear_ ? ", 0.0" : ", " + element("v", k);
        text += "    double y" + n + " = {" + start + "};\n";
        for (std::string const array : {"g", "r", "d"}) text += "    double " + array + n + ";\n";
        bool const any = std::any_of(D_.begin(), D_.end(), [](symbol const& x) { return not x.is(0); });
        if (any) text += "    double D" + n + n + ";\n";
        return text + "    double K" + n + n + ";\n";
    }

    std::string name_;
    bool branches_ = false;
    std::set<std::string> read_;
};

} // namespace hilger::detail
