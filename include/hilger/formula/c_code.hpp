// SPDX-License-Identifier: BSL-1.0
// Stand-alone C99 of an embedded Lagrangian, from the same types that run: the Lagrangian is run on symbols, the embedding's operators are
// run on a symbolic h, and what follows from both is differentiated and written out.
//   std::cout << c_code(embed(L, mid_point), "pendulum");
//   std::cout << c_code<Eigen::Vector2d>(embed(L, mid_point), "kepler");
#pragma once

#include "hilger/formula/c_step.hpp"
#include "hilger/integrator/flow.hpp"
#include "hilger/variational/print.hpp"

namespace hilger {

namespace detail {

class c_writer {
public:
    c_writer(node_evaluation what, tableau<symbol> b, symbol h, std::string name)
        : N(what.dimension), what_(std::move(what)), b_(std::move(b)), h_(std::move(h)), name_(std::move(name)) {}

    [[nodiscard]] std::string all() const {
        return "/* L */\n" + lagrangian() + "\n/* p = dL/dv */\n" + momentum() +
               "\n/* r = d_2 L_h(q0, q1) + d_1 L_h(q1, q2), zero on solutions */\n" + residual() + '\n' +
               (N > 1 ? c_solve(name_, N) + '\n' : "") +
               "/* One step (q_i, p_i) -> (q_{i+1}, p_{i+1}); v is the guess of the velocity at the node and becomes that velocity.\n"
               "   Of several solutions of a long step it is the one that Newton's method comes to from v.\n"
               "   On failure all three are left as they were. */\n" +
               step();
    }

private:
    [[nodiscard]] std::string lagrangian() const {
        c_statements body("    ");
        body.add("return", here().L);
        std::string const text = body.text();
        return function("double", "lagrangian", {"const q", "const v"}, text, body.read());
    }
    [[nodiscard]] std::string momentum() const {
        c_statements body("    ");
        auto const p = here().p;
        for (int k = 0; k < N; ++k) body.add(element("p", k) + " =", p[static_cast<std::size_t>(k)]);
        std::string const text = body.text();
        return function("void", "momentum", {"const q", "const v", "p"}, text, body.read());
    }
    /// d_2 L_h(q0, q1) + d_1 L_h(q1, q2): w (b_1 dL/dv + a_1 dL/dq) at the first node and w (b_0 dL/dv + a_0 dL/dq) at the second.
    [[nodiscard]] std::string residual() const {
        symbol const w = b_.w(0), t = symbol::variable("t"), t1 = symbol::variable("t1"), t2 = symbol::variable("t2");
        std::string const _ = N == 1 ? "" : "_";
        symbol_list const x1 = c_locals("x1" + _, N), v1 = c_locals("v1" + _, N), x2 = c_locals("x2" + _, N), v2 = c_locals("v2" + _, N);
        node_formulas const before = what_.at(t1, x1, v1), after = what_.at(t2, x2, v2);
        c_statements sums("    ");
        for (int k = 0; k < N; ++k) {
            auto const n = static_cast<std::size_t>(k);
            sums.add(element("r", k) + " =", w * b_.b(0, 1) * before.p[n] + w * b_.b(0, 0) * after.p[n] +
                                                 (w * b_.a(0, 1) * before.g[n] + w * b_.a(0, 0) * after.g[n]));
        }
        std::string const last = sums.text();
        c_statements nodes("    ", "at");
        auto const put = [&](symbol const& variable, symbol const& value) {
            if (sums.read().contains(variable.get().name)) nodes.add("const double " + variable.get().name + " =", value);
        };
        put(t1, t + b_.a(0, 1) * h_);
        put(t2, t + (1 + b_.a(0, 1)) * h_);
        auto const between = [&](symbol_list const& x, symbol_list const& v, std::string const& from, std::string const& to) {
            for (int k = 0; k < N; ++k) {
                symbol const q = symbol::variable(element(from, k)), r = symbol::variable(element(to, k));
                put(x[static_cast<std::size_t>(k)], b_.a(0, 0) * q + b_.a(0, 1) * r);
                put(v[static_cast<std::size_t>(k)], b_.b(0, 1) * r + b_.b(0, 0) * q);
            }
        };
        between(x1, v1, "q0", "q1");
        between(x2, v2, "q1", "q2");
        std::string const first = nodes.text();
        auto read = sums.read();
        read.insert(nodes.read().begin(), nodes.read().end());
        return function("void", "residual", {"h", "const q0", "const q1", "const q2", "r"}, first + last, read);
    }
    [[nodiscard]] std::string step() const {
        c_step body(what_, b_, h_, name_);
        std::string const text = body.text();
        return function("int", "step", {"h", "q", "p", "v"}, text, body.read());
    }
    [[nodiscard]] node_formulas here() const { return what_.at(symbol::variable("t"), c_array("q", N), c_array("v", N)); }
    /// Arguments: "h" is a number, "const q" an array that is read, "r" one that is written. Those that are not read are said to be unused.
    [[nodiscard]] std::string function(std::string const& type, std::string const& suffix, std::vector<std::string> const& arguments,
                                       std::string const& body, std::set<std::string> const& read) const {
        std::string list = what_.timed ? "double t" : "", unused = what_.timed and not read.contains("t") ? "    (void)t;\n" : "";
        for (std::string const& argument : arguments) {
            bool const is_const = argument.starts_with("const ");
            std::string const name = is_const ? argument.substr(6) : argument;
            list += list.empty() ? "" : ", ";
            list += (is_const ? "const double " : "double ") + name + (name == "h" ? "" : "[" + std::to_string(N) + "]");
            if ((is_const or name == "h") and not read.contains(name)) unused += "    (void)" + name + ";\n";
        }
        return type + " " + name_ + "_" + suffix + "(" + list + ")\n{\n" + unused + body + "}\n";
    }

    int N;
    node_evaluation what_;
    tableau<symbol> b_;
    symbol h_;
    std::string name_;
};

/// The number of nodes of f counted as often as they are written, or `most` when there are more.
inline int size_of(symbol const& f, int most) {
    int size = 1;
    for (auto const& part : {f.get().a, f.get().b})
        if (part and size < most) size += size_of(part == f.get().a ? f.first() : f.second(), most - size);
    return std::min(size, most);
}
/// The discrete equations as variational/print.hpp writes them, on a T of equal steps.
template <class F, linear_map A, linear_map B, class W, bool Checked>
std::string written_equations(F const& L, embedding<A, B, W, Checked> const& e, std::string const& indent) {
    auto const T = uniform(0.0, 1.0, 2);
    auto const EL = variation(action<F, A, B, W, std::remove_cvref_t<decltype(T)>>{L, e.position, e.velocity, T});
    return text_lines(EL, indent) + indent + text_lines(hamiltonian_form(EL), indent);
}

/// L as a formula, or nothing when it would fill a page.
template <class V, class F>
std::string written_lagrangian(F const& lagrangian, int d) {
    constexpr int page = 200; // operations and leaves, without sharing
    symbol const t = symbol::variable("t");
    auto const q = variables<V>("q", d), v = variables<V>("v", d);
    symbol const L(at_time{lagrangian, t}(q, v));
    if (size_of(L, page) >= page) return "a Lagrangian L";
    std::ostringstream out;
    out << (reads_time<F, std::remove_const_t<decltype(q)>>(lagrangian) ? "L(t, q, v) = " : "L(q, v) = ") << L;
    return out.str();
}

/// The text, and before it those functions that it calls and math.h does not have: fmax and fmin pass over what is no number.
inline std::string with_functions(std::string text, std::string const& name) {
    struct {
        char const *call, *what, *value;
    } const all[] = {{"over_norm(", "a / b, and 0 where b is: the slope of a norm at 0", "b == 0.0 ? a * b : a / b"},
                     {"larger(", "the larger one, or what is no number", "a > b || a != a ? a : b"},
                     {"smaller(", "the smaller one, or what is no number", "a < b || a != a ? a : b"},
                     {"sign_of(", "b with the sign of a, which a zero has not", "a < 0.0 ? -b : a >= 0.0 ? b : a"},
                     {"if_not_negative(", "b where a is not negative, else 0", "a >= 0.0 ? b : a < 0.0 ? 0.0 : a"},
                     {"if_negative(", "b where a is negative, else 0", "a < 0.0 ? b : a >= 0.0 ? 0.0 : a"}};
    std::string before;
    for (auto const& f : all) {
        if (text.find(f.call) == std::string::npos) continue;
        std::string const call = name + '_' + f.call;
        before += std::string("/* ") + f.what + " */\nstatic double " + call + "double a, double b)\n{\n    return " + f.value + ";\n}\n\n";
        text = filled(text, {{f.call, call}});
    }
    return before + text;
}

inline void require_c_name(std::string const& name) {
    auto const letter = [](char c) { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or c == '_'; };
    bool good = not name.empty() and letter(name[0]);
    for (char const c : name) good = good and (letter(c) or (c >= '0' and c <= '9'));
    if (not good) error::raise<error::invalid_parameter>("C names are letters, digits and _, and this one is \"", name, "\"");
}

} // namespace detail

/// C99 that needs math.h alone, for states of the kind V: double, or an Eigen vector of d components. With d = 1 for a number, and
/// `double t` as the first argument of all where L or the force depends on the time (t at q, at q0 for the residual):
///   double NAME_lagrangian(const double q[d], const double v[d])
///   void NAME_momentum(const double q[d], const double v[d], double p[d])                    p = dL/dv
///   void NAME_residual(double h, const double q0[d], const double q1[d], const double q2[d], double r[d])
///       r = d_2 L_h(q0, q1) + d_1 L_h(q1, q2) and the forces, a momentum
///   int NAME_step(double h, double q[d], double p[d], double v[d])
///       one step; v is the guess of the velocity at the node, and becomes that velocity. Of several solutions of a long step it is the
///       one that Newton's method comes to from there. Returns NAME_ok (0), or NAME_singular,
///       NAME_no_convergence, NAME_not_finite with q, p and v as they were.
/// @throws error::no_formula when L compares its arguments, error::invalid_parameter when `name` is no name in C, or V is of dynamic size
///         and d is not said
template <class V = double, class F, class Force, class E>
std::string c_code(flow<F, Force, E, sums::plain> const& method, std::string const& name, int d = detail::shape<V>::size) {
    static_assert(facts_of<E>.one_node,
                  "C code is written for embeddings whose integral has one node in a step, as mid-point and order one");
    detail::require_c_name(name);
    if (d < 1 or (detail::shape<V>::size != Eigen::Dynamic and d != detail::shape<V>::size))
        error::raise<error::invalid_parameter>(
            "C code is for a number of components that is known: c_code<Eigen::VectorXd>(flow, name, d)");
    symbol const h = symbol::variable("h"), from = symbol::variable("q_i"), to = symbol::variable("q_{i+1}");
    tableau<symbol> const b = tableau_of(method.embedding(), h);
    detail::c_writer const write(detail::evaluation_of<V>(method.mechanics(), d), b, h, name);
    std::ostringstream out;
    out << "/* " << name << ": " << detail::written_lagrangian<V>(method.mechanics().lagrangian, d)
        << (std::same_as<Force, no_force> ? "" : ", with forces beside ∂L/∂q") << "\n * under the embedding \"" << method.embedding().name
        << "\". The discrete Euler-Lagrange equation and Hamiltonian system:\n *   "
        << detail::written_equations(method.mechanics().lagrangian, method.embedding(), " *   ") << " * One node in a step h: weight "
        << b.w(0) << ", position " << b.a(0, 0) * from + b.a(0, 1) * to << ", velocity " << b.b(0, 1) * to + b.b(0, 0) * from << ". */\n"
        << "#include <math.h>\n\nenum {\n    " << name << "_ok,\n    " << name << "_singular,\n    " << name << "_no_convergence,\n    "
        << name << "_not_finite\n};\n\n"
        << detail::with_functions(write.all(), name);
    return out.str();
}

/// Others are refused.
template <class V = double, class Method>
std::string c_code(Method const&, std::string const&, int = 0) {
    static_assert(sizeof(Method) == 0, "C code is that of a flow of one embedding with plain sums and without a history, c_code(embed(L, "
                                       "mid_point), name): flows of a composition are written one by one");
    return {};
}

} // namespace hilger
