// SPDX-License-Identifier: BSL-1.0
// The generated equations, written out: the discrete Euler-Lagrange equation (Cresson-Safi (14), (56)) and the discrete Hamiltonian
// system ((18), (94)) of an action, for a terminal or in LaTeX, from the same types that run.
//   std::cout << EL;            terminal
//   std::cout << latex(EL);     LaTeX, an aligned display
#pragma once

#include <sstream>

#include "hilger/mechanics/notation.hpp"
#include "hilger/mechanics/restricted.hpp"

namespace hilger {

/// The discrete Hamiltonian system of an Euler-Lagrange equation: with p = dL/dv(A q, B q) on the scale of the integral,
///   -B*[p] = A*[-dH/dq(p, A q)],   B[q] = dH/dp(p, A q).
template <class Action>
struct hamiltonian_system {
    euler_lagrange<Action> equation;
};
template <class Action>
constexpr auto hamiltonian_form(euler_lagrange<Action> const& equation) {
    return hamiltonian_system<Action>{equation};
}

namespace detail {

struct symbols {
    std::string dLdq, dLdv, dHdq, dHdp, q, p, minus, equals;
};
inline symbols symbols_of(print_style s, bool extended) {
    if (s == print_style::latex) {
        std::string const o = extended ? "_\\circ" : "";
        return {"\\frac{\\partial L}{\\partial q}",
                "\\frac{\\partial L}{\\partial v}",
                "\\frac{\\partial H}{\\partial q}",
                "\\frac{\\partial H}{\\partial p}",
                "q" + o,
                "p" + o,
                " - ",
                " &= "};
    }
    std::string const o = extended ? "∘" : "";
    return {"∂L/∂q", "∂L/∂v", "∂H/∂q", "∂H/∂p", "q" + o, "p" + o, " − ", " = "};
}

/// Where an equation with operator op on functions on Base holds.
template <class Op, class From>
std::string where(Op const& op, print_style s, From from) {
    auto const& a = [&]() -> auto const& {
        if constexpr (requires { op.op; })
            return op.op;
        else
            return op;
    }
    ();
    using D = decltype(a.image(from));
    // On T the end points have no equation, though a fractional difference has values there.
    if constexpr (std::same_as<typename D::base_type, nodes>)
        return written_domain<domain<nodes, std::max(D::front, 1), std::max(D::back, 1)>>(s);
    else
        return written_domain<D>(s);
}

template <class Action>
struct writer {
    using A = typename Action::position_type;
    using scale = typename A::to;
    static constexpr bool extended = not std::same_as<scale, nodes>;
    // For A = identity and B a derivative, the integrand lives where B[q] does.
    using integrand = decltype(intersect(std::declval<A const&>().image(domain<nodes>{}),
                                         std::declval<typename Action::velocity_type const&>().image(domain<nodes>{})));

    euler_lagrange<Action> const& EL;
    print_style s;
    symbols w = symbols_of(s, extended);

    [[nodiscard]] std::string velocity() const {
        if constexpr (extended)
            return s == print_style::latex ? "\\Delta_{\\circ,+}[q_\\circ]" : "Δ∘,₊[q∘]";
        else
            return notation_of(EL.action().velocity, s).around(w.q);
    }
    [[nodiscard]] std::string euler_lagrange_equation() const { return left_hand_side() + w.equals + "0"; }
    [[nodiscard]] std::string left_hand_side() const {
        std::string const star = s == print_style::latex ? "(\\star)" : "(⋆)";
        notation const f = notation_of(EL.force(), s), m = notation_of(EL.momentum(), s);
        return f.around(w.dLdq + star) + (m.negative ? w.minus : " + ") + m.around(w.dLdv + star);
    }
    [[nodiscard]] std::string arguments() const {
        return (s == print_style::latex ? "\\star = (" : "⋆ = (") + w.q + ", " + velocity() + ")";
    }
    [[nodiscard]] std::string momentum_equation() const {
        notation const f = notation_of(EL.force(), s), m = notation_of(EL.momentum(), s);
        std::string const left = (m.negative ? "" : "−") + m.around(w.p);
        std::string const force = (s == print_style::latex ? "-" : "−") + w.dHdq + "(" + w.p + ", " + w.q + ")";
        return left + w.equals + f.around(force);
    }
    [[nodiscard]] std::string position_equation() const { return velocity() + w.equals + w.dHdp + "(" + w.p + ", " + w.q + ")"; }
    [[nodiscard]] std::string definition_of_p() const {
        return w.p + (s == print_style::latex ? " = " : " = ") + w.dLdv + (s == print_style::latex ? "(\\star)" : "(⋆)");
    }
    [[nodiscard]] std::string inner() const { return where(EL.momentum(), s, integrand{}); }
    [[nodiscard]] std::string whole() const { return written_domain<integrand>(s); }
};

} // namespace detail

template <class Action>
std::ostream& operator<<(std::ostream& out, euler_lagrange<Action> const& equation) {
    detail::writer<Action> const w{equation, print_style::terminal};
    return out << w.euler_lagrange_equation() << "   on " << w.inner() << ",   " << w.arguments() << '\n';
}
template <class Action>
std::ostream& operator<<(std::ostream& out, hamiltonian_system<Action> const& system) {
    detail::writer<Action> const w{system.equation, print_style::terminal};
    return out << w.momentum_equation() << "   on " << w.inner() << '\n'
               << w.position_equation() << "   on " << w.whole() << ",   " << w.definition_of_p() << '\n';
}

/// The equation of x and that of y, in reversed time: what is not damped on the left, rho times the damping on the right.
template <class Action, linear_map A, linear_map B, class Root>
std::ostream& operator<<(std::ostream& out, restricted_euler_lagrange<Action, A, B, Root> const& equation) {
    auto const conservative = equation.conservative();
    detail::writer<Action> const w{conservative, print_style::terminal};
    return out << w.left_hand_side() << " = ρ " << notation_of(equation.damping(), print_style::terminal).around("q") << "   on "
               << w.inner() << ",   " << w.arguments() << '\n'
               << "the same of y = ρ " << notation_of(equation.reversed_damping(), print_style::terminal).around("y")
               << ",   ρ = " << equation.factor() << '\n';
}
template <class Action, linear_map A, linear_map B, class Root>
std::string latex(restricted_euler_lagrange<Action, A, B, Root> const& equation) {
    auto const conservative = equation.conservative();
    detail::writer<Action> const w{conservative, print_style::latex};
    return "\\begin{aligned}\n  " + w.left_hand_side() + " &= \\rho\\," + notation_of(equation.damping(), print_style::latex).around("q") +
           ", && t \\in " + w.inner() + ", \\quad " + w.arguments() + "\n\\end{aligned}\n";
}

/// What operator<< prints, with every further line set off by `indent`.
template <class Printable>
std::string text_lines(Printable const& printable, std::string const& indent) {
    std::ostringstream out;
    out << printable;
    std::string lines;
    for (char const c : out.str()) {
        lines += c;
        if (c == '\n') lines += indent;
    }
    lines.erase(lines.size() - indent.size());
    return lines;
}

/// The equation as a LaTeX display (amsmath).
template <class Action>
std::string latex(euler_lagrange<Action> const& equation) {
    detail::writer<Action> const w{equation, print_style::latex};
    return "\\begin{aligned}\n  " + w.euler_lagrange_equation() + ", && t \\in " + w.inner() + ", \\quad " + w.arguments() +
           "\n\\end{aligned}\n";
}
template <class Action>
std::string latex(hamiltonian_system<Action> const& system) {
    detail::writer<Action> const w{system.equation, print_style::latex};
    return "\\begin{aligned}\n  " + w.momentum_equation() + ", && t \\in " + w.inner() + ", \\\\\n  " + w.position_equation() +
           ", && t \\in " + w.whole() + ", \\quad " + w.definition_of_p() + "\n\\end{aligned}\n";
}

} // namespace hilger
