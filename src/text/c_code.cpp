// SPDX-License-Identifier: BSL-1.0
#include "hilger/text/c_code.hpp"

#include <sstream>

#include "text/c_step.hpp"

namespace hilger::detail {

namespace {

class c_writer {
public:
    explicit c_writer(c_step_of const& what) : what_(what), in_(*what.node.in), here_(in_.graph), N(in_.dimension) {}

    [[nodiscard]] std::string all() const {
        return "/* L */\n" + lagrangian() + "\n/* p = dL/dv */\n" + momentum() +
               "\n/* r = d_2 L_h(q0, q1) + d_1 L_h(q1, q2), zero on solutions */\n" + residual() + '\n' +
               (N > 1 ? c_solve(what_.name, N) + '\n' : "") +
               "/* One step (q_i, p_i) -> (q_{i+1}, p_{i+1}); v is the guess of the velocity at the node and becomes that velocity.\n"
               "   Of several solutions of a long step it is the one that Newton's method comes to from v.\n"
               "   On failure all three are left as they were. */\n" +
               step();
    }
    /// The position and the velocity at the node, between the points of the step.
    [[nodiscard]] formula_node position(formula_node const& from, formula_node const& to) const {
        return what_.embedding.a(0, 0) * from + what_.embedding.a(0, 1) * to;
    }
    [[nodiscard]] formula_node velocity(formula_node const& from, formula_node const& to) const {
        return (to - from) / what_.embedding.w(0);
    }

private:
    [[nodiscard]] std::string lagrangian() const {
        name_arguments();
        c_statements body(in_, "    ");
        body.add("return", what_.node.L);
        std::string const text = body.text();
        return function("double", "lagrangian", {"const q", "const v"}, text, body.read());
    }
    [[nodiscard]] std::string momentum() const {
        name_arguments();
        c_statements body(in_, "    ");
        for (int k = 0; k < N; ++k) body.add(element("p", k) + " =", what_.node.p[static_cast<std::size_t>(k)]);
        std::string const text = body.text();
        return function("void", "momentum", {"const q", "const v", "p"}, text, body.read());
    }
    /// d_2 L_h(q0, q1) + d_1 L_h(q1, q2) is dL/dv + c dL/dq at the first node and -dL/dv + f dL/dq at the second one.
    [[nodiscard]] std::string residual() const {
        auto const& b = what_.embedding;
        auto const h = in_.variable("h"), t = in_.variable("t");
        std::set<std::string> read;
        std::string text = node("q0", "q1", t + b.a(0, 1) * h, b.w(0) * b.a(0, 1), "", read);
        text += node("q1", "q2", t + (1 + b.a(0, 1)) * h, b.w(0) * b.a(0, 0), "-", read);
        return function("void", "residual", {"h", "const q0", "const q1", "const q2", "r"}, text, read);
    }
    /// The contribution of one node to r; the first node begins it.
    [[nodiscard]] std::string node(std::string const& from, std::string const& to, formula_node const& time, formula_node const& weight,
                                   std::string const& minus, std::set<std::string>& read) const {
        for (int k = 0; k < N; ++k)
            for (auto const& [at, name] : {std::pair(k, "x"), std::pair(N + k, "v")})
                in_.names[static_cast<std::size_t>(at)] = {N == 1 ? name : name + std::to_string(k)};
        in_.names[static_cast<std::size_t>(2 * N)] = {"t_node"};
        c_statements sums(in_, "        ");
        for (int k = 0; k < N; ++k) {
            auto const n = static_cast<std::size_t>(k);
            auto const p = minus.empty() ? what_.node.p[n] : -what_.node.p[n];
            sums.add(element("r", k) + (minus.empty() ? " =" : " +="), p + weight * what_.node.g[n]);
        }
        std::string const last = sums.text();
        c_statements places(in_, "        ", "of");
        auto const put = [&](int argument, formula_node const& value) {
            auto const& name = in_.names[static_cast<std::size_t>(argument)].name;
            if (sums.read().contains(name)) places.add_local(name, value);
        };
        put(2 * N, time);
        for (int k = 0; k < N; ++k) {
            auto const a = in_.variable(element(from, k)), b = in_.variable(element(to, k));
            put(k, position(a, b));
            put(N + k, velocity(a, b));
        }
        std::string const first = places.text();
        for (auto const* used : {&sums.read(), &places.read()}) read.insert(used->begin(), used->end());
        return "    {\n" + first + last + "    }\n";
    }
    [[nodiscard]] std::string step() const {
        c_step body(what_.node, what_.embedding, what_.name);
        std::string const text = body.text();
        return function("int", "step", {"h", "q", "p", "v"}, text, body.read());
    }
    void name_arguments() const {
        for (int k = 0; k < N; ++k) {
            in_.names[static_cast<std::size_t>(k)] = {element("q", k)};
            in_.names[static_cast<std::size_t>(N + k)] = {element("v", k)};
        }
        in_.names[static_cast<std::size_t>(2 * N)] = {"t"};
    }
    /// Arguments: "h" is a number, "const q" an input array, "r" an output array. Unused ones are marked as unused.
    [[nodiscard]] std::string function(std::string const& type, std::string const& suffix, std::vector<std::string> const& arguments,
                                       std::string const& body, std::set<std::string> const& read) const {
        std::string list = what_.is_timed ? "double t" : "", unused = what_.is_timed and not read.contains("t") ? "    (void)t;\n" : "";
        for (std::string const& argument : arguments) {
            bool const is_const = argument.starts_with("const ");
            std::string const name = is_const ? argument.substr(6) : argument;
            list += list.empty() ? "" : ", ";
            list += (is_const ? "const double " : "double ") + name + (name == "h" ? "" : "[" + std::to_string(N) + "]");
            if ((is_const or name == "h") and not read.contains(name)) unused += "    (void)" + name + ";\n";
        }
        return type + " " + what_.name + "_" + suffix + "(" + list + ")\n{\n" + unused + body + "}\n";
    }

    c_step_of const& what_;
    named_graph& in_;
    tracing<double> const here_;
    int N;
};

/// L as a formula, or a placeholder when it would fill a page.
std::string written_lagrangian(c_step_of const& what) {
    constexpr int page = 200; // operations and leaves, without sharing
    formula const L(what.node.in, what.node.L);
    if (L.size(page) >= page) return "a Lagrangian L";
    std::ostringstream out;
    out << (what.is_timed ? "L(t, q, v) = " : "L(q, v) = ") << L;
    return out.str();
}

/// Puts the functions that math.h lacks before the text: fmax and fmin ignore NaN.
std::string with_functions(std::string text, std::string const& name) {
    struct {
        char const *call, *what, *value;
    } const all[] = {{"over_norm(", "a / b, and 0 where b is: the slope of a norm at 0", "b == 0.0 ? a * b : a / b"},
                     {"larger(", "the larger one, or what is no number", "a > b || a != a ? a : b"},
                     {"smaller(", "the smaller one, or what is no number", "a < b || a != a ? a : b"},
                     {"sign_of(", "b with the sign of a, which a zero has not", "a < 0.0 ? -b : a >= 0.0 ? b : a"},
                     {"if_not_negative(", "b where a is not negative, else 0", "a >= 0.0 ? b : a < 0.0 ? 0.0 : a"},
                     {"if_negative(", "b where a is negative, else 0", "a < 0.0 ? b : a >= 0.0 ? 0.0 : a"},
                     {"slope_of_log(", "1 / a, and no number where log(a) is none", "a < 0.0 ? log(a) : 1.0 / a"}};
    std::string before;
    for (auto const& f : all) {
        if (text.find(f.call) == std::string::npos) continue;
        std::string const call = name + '_' + f.call,
                          operands = std::string_view(f.call) == "slope_of_log(" ? "double a" : "double a, double b";
        before += std::string("/* ") + f.what + " */\nstatic double " + call + operands + ")\n{\n    return " + f.value + ";\n}\n\n";
        text = filled(text, {{f.call, call}});
    }
    return before + text;
}

} // namespace

void require_c_code(std::string const& name, int d, int known) {
    auto const letter = [](char c) { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or c == '_'; };
    bool good = not name.empty() and letter(name[0]);
    for (char const c : name) good = good and (letter(c) or (c >= '0' and c <= '9'));
    if (not good) error::raise<error::invalid_parameter>("C names are letters, digits and _, and this one is \"", name, "\"");
    if (d < 1 or (known != Eigen::Dynamic and d != known))
        error::raise<error::invalid_parameter>(
            "C code is for a number of components that is known: c_code<Eigen::VectorXd>(flow, name, d)");
}

std::string c_code(c_step_of const& what) {
    auto& in = *what.node.in;
    std::ostringstream out;
    out << "/* " << what.name << ": " << written_lagrangian(what) << (what.is_forced ? ", with forces beside ∂L/∂q" : "")
        << "\n * under the embedding \"" << what.embedding_name << "\". The discrete Euler-Lagrange equation and Hamiltonian system:\n *   "
        << what.equations;
    c_writer const write(what);
    auto const from = in.variable("q_i"), to = in.variable("q_{i+1}");
    auto const text = [&](formula_node const& x) { return printed(in, x, print_style::terminal); };
    out << " * One node in a step h: weight " << text(what.embedding.w(0)) << ", position " << text(write.position(from, to))
        << ", velocity " << text(write.velocity(from, to)) << ". */\n"
        << "#include <math.h>\n\nenum {\n    " << what.name << "_ok,\n    " << what.name << "_singular,\n    " << what.name
        << "_no_convergence,\n    " << what.name << "_not_finite\n};\n\n"
        << with_functions(write.all(), what.name);
    return out.str();
}

} // namespace hilger::detail
