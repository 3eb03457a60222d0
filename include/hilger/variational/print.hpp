// SPDX-License-Identifier: BSL-1.0
// The generated equations, written out: the discrete Euler-Lagrange equation (Cresson-Safi (14), (56)) and the discrete Hamiltonian
// system ((18), (94)) of an action, for a terminal or in LaTeX, from the same types that run (printing/notation.hpp).
//   std::cout << EL;            terminal
//   std::cout << latex(EL);     LaTeX, an aligned display
// In an equation on T_half a function on T_o is taken at those points.
#pragma once

#include <sstream>

#include "hilger/embedding/written.hpp"
#include "hilger/printing/notation.hpp"
#include "hilger/variational/restricted.hpp"
#include "hilger/variational/sum_of_actions.hpp"

namespace hilger {

/// The discrete Hamiltonian system of an Euler-Lagrange equation: with p = dL/dv(A q, B q) on the scale of the integral,
///   -B*[p] = A*[-dH/dq(p, A q)],   B[q] = dH/dp(p, A q).
template <class Action>
struct hamiltonian_system {
    euler_lagrange<Action> equation;
};
/// The Hamiltonian form of an equation, for printing.
template <class Action>
constexpr auto hamiltonian_form(euler_lagrange<Action> const& equation) {
    return hamiltonian_system<Action>{equation};
}

template <class First, class Second>
constexpr auto hamiltonian_form(euler_lagrange<action_sum<First, Second>> const&) {
    return does_not_compile<"a Hamiltonian form is of one position and one velocity, and a sum of actions has several of them: flow_of(EL) "
                            "is its discrete Hamiltonian flow",
                            First>{};
}

namespace detail {

/// dL/dq, dH/dp, ... of arguments in brackets; `number` is that of L in a sum.
inline notation derivative_of(char function, char by, notation const& arguments, bool negative = false, notation const& number = {"", ""}) {
    return {(negative ? "−∂" : "∂") + std::string(1, function) + number.terminal + "/∂" + by + arguments.terminal,
            (negative ? "-\\frac{\\partial " : "\\frac{\\partial ") + std::string(1, function) + number.latex + "}{\\partial " + by + "}" +
                arguments.latex};
}

template <class Action, class P = typename Action::position_type::from_weight>
class equation_writer {
    using A = typename Action::position_type;
    using B = typename Action::velocity_type;
    using from = typename A::from;
    using base_type = typename A::to;
    /// The equation is written on T_lambda if the integral is over it; else on T, or on T with its points inside the steps.
    static constexpr bool on_lambda = requires(base_type const& base) { base.lambda; };
    // For A = identity and a derivative B, the integrand lives on the domain of B[q].
    using integrand = decltype(euler_lagrange<Action, P>::counted(
        intersect(std::declval<A const&>().image(domain<from>{}), std::declval<B const&>().image(domain<from>{}))));

public:
    equation_writer(euler_lagrange<Action, P> const& equation, print_style style) : EL_(equation), s_(style) {}
    /// The part with this number of a sum, which is written on T.
    equation_writer(euler_lagrange<Action, P> const& equation, print_style style, int number)
        : EL_(equation), s_(style), number_{subscript(number), "_{" + std::to_string(number) + "}"} {}

    [[nodiscard]] std::string equals() const { return s_ == print_style::latex ? " &= " : " = "; }
    [[nodiscard]] expression left_hand_side() const {
        return written_on(EL_.force(), expression::name(derivative_of('L', 'q', star))) +
               written_on(EL_.momentum(), expression::name(derivative_of('L', 'v', star)));
    }
    /// The same on T, for a part of a sum.
    [[nodiscard]] expression term() const {
        notation const at{"(⋆" + number_.terminal + ")", "(\\star" + number_.latex + ")"};
        return written_on(EL_.force_on_T(), expression::name(derivative_of('L', 'q', at, false, number_))) +
               written_on(EL_.momentum_on_T(), expression::name(derivative_of('L', 'v', at, false, number_)));
    }
    [[nodiscard]] std::string arguments() const {
        return (s_ == print_style::latex ? "\\star" + number_.latex : "⋆" + number_.terminal) + " = (" + position().in(s_) + ", " +
               velocity().in(s_) + ")";
    }
    [[nodiscard]] std::string momentum_equation() const {
        auto const force = expression::name(derivative_of('H', 'q', state(), true), true);
        return written_on(EL_.momentum(), expression::name(p())).times(-1, 1).in(s_) + equals() + written_on(EL_.force(), force).in(s_);
    }
    [[nodiscard]] std::string position_equation() const { return velocity().in(s_) + equals() + derivative_of('H', 'p', state()).in(s_); }
    [[nodiscard]] std::string definition_of_p() const { return p().in(s_) + " = " + derivative_of('L', 'v', star).in(s_); }
    /// The domain of the equation: inner points, with numbers one lower on T_half.
    [[nodiscard]] std::string inner() const {
        auto const here = domain_of_equation();
        using D = std::remove_const_t<decltype(here)>;
        return written_domain(domain<typename D::base_type, std::max(D::front, 1), std::max(D::back, on_lambda ? 0 : 1)>{here.base}, s_);
    }
    /// The domain of the equation of a sum, which is written on T, or on T with its points inside the steps.
    [[nodiscard]] std::string inner_on_T() const {
        if constexpr (on_lambda)
            return written_domain(domain<nodes, 1, 1>{}, s_);
        else
            return inner();
    }
    [[nodiscard]] std::string whole() const { return written_domain(integrand{base()}, s_); }
    /// Explanations of symbols in the equation and on its right-hand side, each after `before`.
    [[nodiscard]] std::string notes(std::string const& before, expression const& right_hand_side = {}) const {
        std::vector<std::string> all;
        left_hand_side().collect_notes(s_, all);
        position().collect_notes(s_, all);
        velocity().collect_notes(s_, all);
        right_hand_side.collect_notes(s_, all);
        std::string text;
        for (auto const& note : all) text += before + note;
        return text;
    }
    /// An operator on T in an equation written on T_half: its value at t_i is placed at t_{i+1/2}.
    [[nodiscard]] expression on_scale_of_equation(expression const& e) const {
        if constexpr (not on_lambda)
            return e;
        else
            return written_alone(projection<std::remove_cvref_t<decltype(base_type{}.lambda)>, true>{{}, base().lambda}, e);
    }

    [[nodiscard]] expression position() const { return of_q(EL_.action().position); }
    [[nodiscard]] expression velocity() const { return of_q(EL_.action().velocity); }

private:
    inline static notation const star{"(⋆)", "(\\star)"};

    [[nodiscard]] base_type base() const { return EL_.action().position.image(domain<from>{}).base; }
    [[nodiscard]] auto domain_of_equation() const {
        auto const image = [](auto const& op) { return on_uniform_of<std::remove_cvref_t<decltype(op)>>::get(op).image(integrand{}); };
        return intersect(image(EL_.force()), image(EL_.momentum()));
    }
    template <class Op>
    [[nodiscard]] expression of_q(Op const& op) const {
        auto const e = written_on(op, expression::name({"q", "q"}));
        if constexpr (not on_lambda)
            return e;
        else
            return e.without("|" + written_domain(domain<base_type>{base()}, print_style::terminal));
    }
    [[nodiscard]] notation p() const {
        if constexpr (not on_lambda)
            return {"p", "p"};
        else {
            auto const circle = foot(joined<std::remove_cvref_t<decltype(base_type{}.lambda)>>{base().lambda});
            return {"p" + circle.terminal, "p_{" + circle.latex + "}"};
        }
    }
    [[nodiscard]] notation state() const {
        return {"(" + p().terminal + ", " + position().in(print_style::terminal) + ")",
                "(" + p().latex + ", " + position().in(print_style::latex) + ")"};
    }
    euler_lagrange<Action, P> const& EL_;
    print_style s_;
    notation number_{"", ""};
};

/// The sum of the parts of an equation on T, each with its own Lagrangian, and the explanations of symbols.
struct sum_writer {
    print_style style;
    expression sum{};
    std::string where{}, arguments{};
    std::vector<std::string> notes{};
    int parts = 0;

    template <class Action, class P>
    void add(euler_lagrange<Action, P> const& equation) {
        if constexpr (is_action_sum<Action>) {
            add(equation.first());
            add(equation.second());
        } else {
            equation_writer<Action, P> const w(equation, style, ++parts);
            if (parts == 1) where = w.inner_on_T();
            expression const term = w.term();
            term.collect_notes(style, notes);
            w.position().collect_notes(style, notes);
            w.velocity().collect_notes(style, notes);
            sum = sum + term;
            arguments += between() + w.arguments();
        }
    }
    [[nodiscard]] std::string between() const { return style == print_style::latex ? ", \\quad " : ",   "; }
    [[nodiscard]] std::string written() const {
        std::string conclusion = arguments;
        for (auto const& note : notes) conclusion += between() + note;
        if (style == print_style::latex)
            return "\\begin{aligned}\n  " + sum.in(style) + " &= 0, && t \\in " + where + conclusion + "\n\\end{aligned}\n";
        return sum.in(style) + " = 0   on " + where + conclusion + '\n';
    }
};

} // namespace detail

/// Prints the equation, its domain and the arguments of L in one line.
template <class Action>
std::ostream& operator<<(std::ostream& out, euler_lagrange<Action> const& equation) {
    detail::equation_writer<Action> const w(equation, print_style::terminal);
    return out << w.left_hand_side().in(print_style::terminal) << " = 0   on " << w.inner() << ",   " << w.arguments() << w.notes(",   ")
               << '\n';
}
/// Prints the equation of a sum of actions: L₁, L₂, ... are their Lagrangians with their factors.
template <class First, class Second>
std::ostream& operator<<(std::ostream& out, euler_lagrange<action_sum<First, Second>> const& equation) {
    detail::sum_writer w{print_style::terminal};
    w.add(equation);
    return out << w.written();
}
/// The same as a LaTeX display (amsmath).
template <class First, class Second>
std::string latex(euler_lagrange<action_sum<First, Second>> const& equation) {
    detail::sum_writer w{print_style::latex};
    w.add(equation);
    return w.written();
}
/// Prints both equations, a line each.
template <class Action>
std::ostream& operator<<(std::ostream& out, hamiltonian_system<Action> const& system) {
    detail::equation_writer<Action> const w(system.equation, print_style::terminal);
    return out << w.momentum_equation() << "   on " << w.inner() << '\n'
               << w.position_equation() << "   on " << w.whole() << ",   " << w.definition_of_p() << w.notes(",   ") << '\n';
}
/// The equation as a LaTeX display (amsmath).
template <class Action>
std::string latex(euler_lagrange<Action> const& equation) {
    detail::equation_writer<Action> const w(equation, print_style::latex);
    return "\\begin{aligned}\n  " + w.left_hand_side().in(print_style::latex) + w.equals() + "0, && t \\in " + w.inner() + ", \\quad " +
           w.arguments() + w.notes(", \\quad ") + "\n\\end{aligned}\n";
}
/// Both equations as a LaTeX display (amsmath).
template <class Action>
std::string latex(hamiltonian_system<Action> const& system) {
    detail::equation_writer<Action> const w(system.equation, print_style::latex);
    return "\\begin{aligned}\n  " + w.momentum_equation() + ", && t \\in " + w.inner() + ", \\\\\n  " + w.position_equation() +
           ", && t \\in " + w.whole() + ", \\quad " + w.definition_of_p() + w.notes(", \\quad ") + "\n\\end{aligned}\n";
}

/// Prints the equations of x and, in reversed time, of y: the undamped part on the left, rho times the damping on the right.
template <class Action, linear_map A, linear_map B, class Root>
std::ostream& operator<<(std::ostream& out, restricted_euler_lagrange<Action, A, B, Root> const& equation) {
    auto const conservative = equation.conservative();
    detail::equation_writer<Action> const w(conservative, print_style::terminal);
    auto const damping = [&](auto const& D, char const* of) {
        return w.on_scale_of_equation(detail::written_on(D, detail::expression::name({of, of}))).times_constant({"ρ", "\\rho"});
    };
    auto const of_q = damping(equation.damping(), "q");
    return out << w.left_hand_side().in(print_style::terminal) << " = " << of_q.in(print_style::terminal) << "   on " << w.inner() << ",   "
               << w.arguments() << w.notes(",   ", of_q) << '\n'
               << "the same of y = " << damping(equation.reversed_damping(), "y").in(print_style::terminal)
               << ",   ρ = " << detail::written_number(equation.factor()) << '\n';
}
/// The same as a LaTeX display (amsmath).
template <class Action, linear_map A, linear_map B, class Root>
std::string latex(restricted_euler_lagrange<Action, A, B, Root> const& equation) {
    auto const conservative = equation.conservative();
    detail::equation_writer<Action> const w(conservative, print_style::latex);
    auto const damping = [&](auto const& D, char const* of) {
        return w.on_scale_of_equation(detail::written_on(D, detail::expression::name({of, of}))).times_constant({"ρ", "\\rho"});
    };
    auto const of_q = damping(equation.damping(), "q");
    return "\\begin{aligned}\n  " + w.left_hand_side().in(print_style::latex) + w.equals() + of_q.in(print_style::latex) + ", && t \\in " +
           w.inner() + ", \\quad " + w.arguments() + w.notes(", \\quad ", of_q) + ", \\\\\n  \\text{the same of } y" + w.equals() +
           damping(equation.reversed_damping(), "y").in(print_style::latex) + ", && \\rho = " + detail::written_number(equation.factor()) +
           "\n\\end{aligned}\n";
}

/// The output of operator<<, with every further line indented by `indent`.
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

} // namespace hilger
