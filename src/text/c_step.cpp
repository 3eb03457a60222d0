// SPDX-License-Identifier: BSL-1.0
#include "text/c_step.hpp"

#include <algorithm>

#include "hilger/newton/stop.hpp"

namespace hilger::detail {

namespace {

constexpr char const* loop = R"(    int done = 0;
$settled    for (int iteration = 0; !done; ++iteration) {
        if (iteration == $most) return NAME_no_convergence;
$work$stop    }
)";
constexpr char const* stop_of_one =
    R"(        /* after a small correction the error is of the size of the rounding; so it is where r is no more than that */
        const double correction = $d;
        const double rounding = $rounding * ($size);
        done = correction <= $floor * $y$plausible;
        if (iteration > 0 && $r <= rounding) done = 1;
)";
constexpr char const* stop_in_each =
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
constexpr char const* stop_on_branches =
    R"(        /* a small correction may lead to another branch: it has to be rounding itself */
        done = $d <= $rounding * $y;
)";

} // namespace

std::string c_solve(std::string const& name, int n) {
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
    return filled(
        text, {{"NAME", name}, {"$n", std::to_string(n)}, {"$limit", c_number(n * epsilon<double>())}, {"$last", std::to_string(n - 1)}});
}

c_step::c_step(node_formulas const& of, tableau<formula_node> const& b, std::string name)
    : node_equation(of, b, "double"), name_(std::move(name)), branches_(has_branches()) {
    linear_ = linear_ and not branches_;
}

std::string c_step::text() {
    std::string work = correction(linear_ ? "    " : "        ");
    if (not linear_) work = iterated(work);
    if (f_.is(0)) work += force_at_the_end(read_);
    std::string finite;
    for (int k = 0; k < N; ++k) finite += (k > 0 ? " + " : "") + element("g", k) + " + " + element("y", k);
    work += "    if (!isfinite(" + finite + ")) " + failure() + "not_finite;\n" + update() + "    " + failure() + "ok;\n";
    read_.insert({"q", "p", "v"});
    return declarations() + work;
}

std::string c_step::iterated(std::string const& work) const {
    char const* const stop = branches_ ? stop_on_branches : N > 1 ? stop_in_each : stop_of_one;
    return filled(loop, {{"$most", std::to_string(most_iterations<double>)},
                         {"NAME", name_},
                         {"$stop", stop},
                         // near the speed of light the mass diverges, and all corrections are small
                         {"$plausible", are_numbers(node_.pv) ? "" : " && $r <= $size"},
                         {"$settled", branches_ or N == 1 ? "" : "    int settled = 0;\n"},
                         {"$small", in_each([](std::string const& k) { return "fabs(d[" + k + "]) <= $floor * fabs(y[" + k + "])"; })},
                         {"$rounded", in_each([this](std::string const& k) {
                              return "fabs(r[" + k + "]) <= $rounding * (fabs(p[" + k + "])" +
                                     (f_.is(0) ? "" : " + fabs(" + name_of(f_) + ") * fabs(g[" + k + "])") + ")";
                          })},
                         {"$d", largest("d")},
                         {"$rounding", c_number(4 * epsilon<double>())},
                         {"$size", size_of_residual()},
                         {"$floor", c_number(square_root_of_epsilon<double>() / 2)},
                         {"$y", largest("y")},
                         {"$r ", largest("r") + " "},
                         {"$work", work}});
}

/// One iteration of Newton's method for y, with g updated to first order.
std::string c_step::correction(std::string const& in) {
    c_statements body = statements(in);
    if (not f_.is(0))
        for (int k = 0; k < N; ++k) body.add(element("g", k) + " =", node_.g[static_cast<std::size_t>(k)]);
    for (int k = 0; k < N; ++k)
        body.add(element("r", k) + " =", variable(element("p", k)) + f_ * variable(element("g", k)) - node_.p[static_cast<std::size_t>(k)]);
    for (int j = 0; j < N; ++j)
        for (int k = 0; k < N; ++k)
            if (has_slope(j, k)) body.add(element("D", j, k) + " =", D_[at(j, k)]);
    for (int j = 0; j < N; ++j)
        for (int k = 0; k < N; ++k) body.add(element("K", j, k) + " =", slope_of_row(j, k, element("D", j, k)));
    std::string const formulas = body.text();
    std::set<std::string> used = body.read();
    std::string const work = position(in, used) + formulas;
    read_.insert(used.begin(), used.end());
    return work + solution(in);
}
/// Solves the linear equations computed before.
std::string c_step::solution(std::string const& in) const {
    std::string sum = element("r", 0), work;
    for (int k = 1; k < N; ++k) sum += " + " + element("r", k);
    work += in + "if (!isfinite(" + sum + ")) " + failure() + "not_finite;\n";
    if (branches_)
        work += in + "/* L has branches: here, and nowhere near, is where its equation has to hold */\n" + in + "if (" + largest("r") +
                " <= " + c_number(4 * epsilon<double>()) + " * (" + size_of_residual() + ")) break;\n";
    if (N == 1) {
        work += in + "if (K[0][0] == 0.0 || !isfinite(K[0][0])) " + failure() + "singular;\n" + in + "d[0] = r[0] / K[0][0];\n";
    } else {
        for (int k = 0; k < N; ++k) work += in + element("d", k) + " = " + element("r", k) + ";\n";
        work += in + "if (!" + name_ + "_solve(K, d)) " + failure() + "singular;\n";
    }
    for (int k = 0; k < N; ++k) work += in + element("y", k) + " += " + element("d", k) + ";\n";
    for (int j = 0; j < N; ++j)
        for (int k = 0; k < N; ++k)
            if (has_slope(j, k)) work += in + element("g", j) + " += " + element("D", j, k) + " * " + element("d", k) + ";\n";
    return work;
}
std::string c_step::update() {
    c_statements lines = statements("    ", "by");
    for (int k = 0; k < N; ++k) {
        lines.add(element("q", k) + " +=", w_ * y(k));
        lines.add(element("p", k) + " +=", w_ * variable(element("g", k)));
        lines.add(element("v", k) + " =", y(k));
    }
    std::string text = lines.text();
    read_.insert(lines.read().begin(), lines.read().end());
    return text;
}
std::string c_step::declarations() {
    c_statements lines = statements("    ", "of");
    for (auto const& [name, value] : constants_)
        if (read_.contains(name)) lines.add_local(name, value);
    std::string const n = "[" + std::to_string(N) + "]";
    std::string text = lines.text(), start = linear_ ? "0.0" : element("v", 0);
    read_.insert(lines.read().begin(), lines.read().end());
    for (int k = 1; k < N; ++k) start += linear_ ? ", 0.0" : ", " + element("v", k);
    text += "    double y" + n + " = {" + start + "};\n";
    for (std::string const array : {"g", "r", "d"}) text += "    double " + array + n + ";\n";
    if (not std::all_of(D_.begin(), D_.end(), [](formula_node const& x) { return x.is(0); })) text += "    double D" + n + n + ";\n";
    return text + "    double K" + n + n + ";\n";
}

} // namespace hilger::detail
