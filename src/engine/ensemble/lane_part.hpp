// SPDX-License-Identifier: BSL-1.0
// One part of a step, with one node, in lanes. Solves the equation of text/node_equation.hpp as text/c_step.hpp does, with masks instead of
// branches: a converged lane keeps its values while others iterate.
#pragma once

#include <algorithm>

#include "engine/ensemble/lane_text.hpp"
#include "hilger/newton/stop.hpp"
#include "text/node_equation.hpp"

namespace engine {

/// A slower lane had a misleading guess: it goes on alone, by a search (hilger/newton/newton.hpp).
constexpr int most_rounds_in_lanes = 4;

class lane_part : hilger::detail::node_equation {
public:
    /// `one`: for one member, with branches instead of masks.
    lane_part(hilger::detail::node_formulas const& what, hilger::tableau<hilger::detail::formula_node> const& b, std::string name, bool one)
        : node_equation(what, b, "lanes"), name_(std::move(name)), one_(one) {
        w_ = constant("w", w_);
    }
    /// Whether the equation is linear in y: it then needs no guess.
    [[nodiscard]] bool is_linear() const { return linear_; }
    /// Whether the node is inside the step: a polynomial then guesses its velocity.
    [[nodiscard]] bool is_inside() const { return not c_.is(0) and not f_.is(0); }
    /// A part that is called once or twice is inlined into the walk.
    [[nodiscard]] std::string text(bool is_inlined) {
        std::string const array = "[" + std::to_string(N) + "]";
        std::string all = std::string("static ") + (is_inlined ? "inline __attribute__((always_inline))" : "__attribute__((noinline))") +
                          " void " + name_ + "(lanes t, lanes h, const lanes *m, lanes *q, lanes *p, lanes *v, mask *lost" +
                          (linear_ ? "" : ", lanes (*before)[" + std::to_string(N) + "], long known") +
                          ")\n{\n    (void)t;\n    (void)m;\n    (void)v;\n";
        auto constants = statements("    ", "of");
        for (auto const& [name, value] : constants_) constants.add_local(name, value);
        all += constants.text() + "    lanes y" + array + ", g" + array + " = {{0}}, d" + array +
               ";\n    mask done = *lost, settled = {0}, late = {0};\n    (void)done;\n    (void)settled;\n    (void)late;\n";
        for (int k = 0; k < N; ++k) all += "    " + element("y", k) + " = " + (linear_ ? std::string("all(0.0)") : element("v", k)) + ";\n";
        all += linear_ ? "    {\n" : "    for (int iteration = 0; !are_all(done); ++iteration) {\n";
        all += iteration("        ") + "    }\n";
        if (std::set<std::string> used; f_.is(0)) all += force_at_the_end(used);
        if (not linear_) all += nearness();
        auto update = statements("    ", "by");
        for (int k = 0; k < N; ++k) {
            update.add(element("q", k) + " +=", w_ * y(k));
            update.add(element("p", k) + " +=", w_ * variable(element("g", k)));
        }
        all += update.text();
        std::string sum; // x * 0 is NaN for a value that is not finite: one sum checks all of q and p
        for (int k = 0; k < N; ++k) {
            all += "    " + element("v", k) + " = " + element("y", k) + ";\n";
            sum += (k > 0 ? " + " : "") + element("q", k) + " * 0.0 + " + element("p", k) + " * 0.0";
        }
        return all + "    *lost |= none(" + sum + " == 0.0);\n}\n";
    }

private:
    /// One iteration of Newton's method for y, with g carried along to first order.
    [[nodiscard]] std::string iteration(std::string const& in) {
        std::string const array = "[" + std::to_string(N) + "]";
        auto body = statements(in);
        std::string declared = in + "lanes K" + array + array + ";\n";
        for (int k = 0; k < N; ++k) {
            auto const n = static_cast<std::size_t>(k);
            std::string const number = std::to_string(k);
            if (not f_.is(0)) body.add_local("g" + number, node_.g[n]);
            body.add_local("r" + number, variable(element("p", k)) + f_ * variable("g" + number) - node_.p[n]);
        }
        for (int j = 0; j < N; ++j)
            for (int k = 0; k < N; ++k)
                if (has_slope(j, k)) body.add_local(slope(j, k), D_[at(j, k)]);
        std::vector<bool> K(static_cast<std::size_t>(N * N));
        for (int j = 0; j < N; ++j)
            for (int k = 0; k < N; ++k) {
                auto const element_of_K = slope_of_row(j, k, slope(j, k));
                K[at(j, k)] = j == k or not element_of_K.is(0);
                if (K[at(j, k)]) body.add(element("K", j, k) + " =", element_of_K);
            }
        std::string const formulas = body.text();
        auto used = body.read();
        std::string text = declared + position(in, used) + formulas;
        std::string sum = "r0", rest = "size_of(r0)";
        for (int k = 1; k < N; ++k) {
            sum += " + r" + std::to_string(k);
            rest = "larger(" + rest + ", size_of(r" + std::to_string(k) + "))";
        }
        for (int k = 0; k < N; ++k) text += in + element("d", k) + " = r" + std::to_string(k) + ";\n";
        text += elimination(N, in, one_, K);
        text += in + "const lanes rest = " + sum + ";\n" + in + "*lost |= none(done) & none(regular & (rest - rest == 0.0));\n";
        for (int k = 0; k < N; ++k) {
            std::string const dk = element("d", k), gk = element("g", k), yk = element("y", k);
            if (not f_.is(0)) {
                std::string const change = "change" + std::to_string(k);
                std::string terms;
                for (int m = 0; m < N; ++m)
                    if (has_slope(k, m)) terms += (terms.empty() ? "" : " + ") + slope(k, m) + " * " + element("d", m);
                text += in + "const lanes " + change + " = " + (terms.empty() ? "all(0.0)" : terms) + ";\n";
                text += in + gk + " = " + kept(gk, "g" + std::to_string(k) + (terms.empty() ? "" : " + " + change)) + ";\n";
            }
            text += in + yk + " = " + (linear_ ? dk : kept(yk, yk + " + " + dk)) + ";\n";
        }
        return linear_ ? text : text + stop(in, rest, used);
    }
    /// A lane has converged when the correction is so small that the remaining error is of the size of the rounding, or when r is no larger
    /// than rounding: in each component, or two rounds after that holds for all of them together.
    [[nodiscard]] std::string stop(std::string const& in, std::string const& rest, std::set<std::string> const& used) const {
        std::string const f = f_.is(0) ? "" : " + size_of(" + name_of(f_) + ") * ", both = one_ ? " && " : " & ";
        std::string small, rounded;
        for (int k = 0; k < N; ++k) {
            std::string const n = std::to_string(k), g = f_.is(0) ? "" : f + "size_of(" + element("g", k) + ")", more = k > 0 ? both : "";
            small += more + "(size_of(d[" + n + "]) <= $floor * size_of(y[" + n + "]))";
            rounded += more + "(size_of(r" + n + ") <= $rounding * (size_of(p[" + n + "])" + g + "))";
        }
        // For one member most steps end with the first line.
        std::string const first = one_ ? "$inif ($small$not_far) break;\n$inmask each = 0;\n" : "$inmask each = $small;\n";
        std::string const others = R"($inmask together = $d <= $floor * $y;
$plausible$negligible$inif (iteration > 0) {
$in    each |= $rounded;
$in    together |= $r <= $rounding * ($all);
$in}
$insettled $counts together | each;
$indone |= each | (settled > 2) | *lost;
$inif (iteration == 1) late = none(done);
$inif (iteration == $most) *lost |= none(done), done |= *lost;
)";
        return filled(
            first + others,
            {{"$small", small},
             {"$rounded", rounded},
             {"$not_far", has_constant_mass() ? "" : " && $r <= $all"},
             {"$counts", one_ ? "+=" : "-="},
             {"$plausible", has_constant_mass() ? "" : in + (one_ ? "" : "each &= $r <= $all;\n" + in) + "together &= $r <= $all;\n"},
             {"$negligible", has_constant_mass() and not f_.is(0) ? negligible(in, used) : ""},
             {"$in", in},
             {"$d", largest_of("d", N)},
             {"$floor", c_number(hilger::detail::square_root_of_epsilon<double>() / 2)},
             {"$y", largest_of("y", N)},
             {"$rounding", c_number(4 * hilger::epsilon<double>())},
             {"$r", rest},
             {"$all", largest_of("p", N) + (f_.is(0) ? "" : f + largest_of("g", N))},
             {"$most", std::to_string(most_rounds_in_lanes)}});
    }
    /// When the velocity enters quadratically the error is in dL/dq alone, of second order in the correction c d of the position
    /// (is_negligible of hilger/newton/small_solve.hpp).
    [[nodiscard]] std::string negligible(std::string const& in, std::set<std::string> const& used) const {
        std::string const c = name_of(c_), w = name_of(w_);
        std::string text = in + "lanes relative = all(0.0);\n", each;
        for (int k = 0; k < N; ++k)
            if (std::string const x = name_of_x(k); used.contains(x)) {
                std::string const n = "[" + std::to_string(k) + "]";
                text += in + "relative = larger(size_of(" + c + " * d" + n + ") / (size_of(" + x + ") + size_of(" + c + " * y" + n +
                        ")), relative);\n";
            }
        for (int k = 0; k < N; ++k) {
            std::string const n = std::to_string(k);
            each += (k > 0 ? " & " : "") +
                    ("(size_of(" + w + ") * relative * (size_of(g[" + n + "]) * relative + size_of(change" + n + ")) <= ") +
                    c_number(hilger::epsilon<double>() / 2) + " * (size_of(p[" + n + "]) + size_of(" + w + ") * size_of(g[" + n + "])))";
        }
        return text + in + "each |= " + each + ";\n";
    }
    /// After more than two rounds the root must be near the last velocity, or the lane is lost: is_near of hilger/newton/stop.hpp. The
    /// first velocity belongs to the start, half a step before the second; and from vanishing forces changes grow from nothing.
    [[nodiscard]] std::string nearness() const {
        return filled(R"(    if (known >= 2 && !are_all(~late)) {
        lanes change = {0}, last = {0}, earlier = {0}, speed = {0};
        for (int k = 0; k < $n; ++k) {
            change = larger(size_of(y[k] - before[0][k]), change);
            last = larger(size_of(before[0][k] - before[-1][k]), last);
            earlier = larger(size_of(before[-1][k] - before[-2][k]), earlier);
            speed = larger(size_of(before[0][k]), speed);
        }
        last = known > 2 ? larger(last, earlier) : 2.0 * last;
        *lost |= late & ~(change <= larger(2.0 * last, 0.125 * speed));
    }
)",
                      {{"$n", std::to_string(N)}});
    }
    [[nodiscard]] bool has_constant_mass() const { return are_numbers(node_.pv) and are_numbers(node_.gv) and are_numbers(node_.pq); }
    [[nodiscard]] static std::string slope(int j, int k) { return "D" + std::to_string(j) + "_" + std::to_string(k); }
    /// Keeps the old value in a converged lane.
    [[nodiscard]] std::string kept(std::string const& old, std::string const& made) const {
        return linear_ or one_ ? made : "either(done, " + old + ", " + made + ")";
    }

    std::string name_;
    bool one_;
};

} // namespace engine
