// SPDX-License-Identifier: BSL-1.0
// A printed equation against the one that runs: the text is read (reading.hpp), evaluated for a random function in exact rationals, and
// equals the residual at every point, on exactly the points that the text says; the Hamiltonian form and the LaTeX say the same.
#pragma once

#include <doctest/doctest.h>

#include "hilger/variational/print.hpp"
#include "reading.hpp"
#include "support/values.hpp"

namespace reading {

using hilger::testing::printed;

/// Polynomial, so that rationals stay rational; neither separable nor quadratic.
struct cubic {
    template <class X, class V>
    constexpr auto operator()(X const& x, V const& v) const {
        return v * v / 2 + v * x * x / 3 - x * x * x / 5 + v * v * x / 7;
    }
};
inline constexpr hilger::lagrangian<cubic> L{cubic{}};

inline Q random_value(int i, int seed) { return Q((i * i * 37 + 11 * i + 5 * seed) % 23 - 11, 1 + (i * 7 + seed) % 5); }

/// What stands between the two texts, and after them.
inline std::string cut(std::string& text, std::string const& until) {
    std::size_t const k = text.find(until);
    if (k == std::string::npos) throw std::runtime_error("no \"" + until + "\" in \"" + text + "\"");
    std::string const before = text.substr(0, k);
    text.erase(0, k + until.size());
    return before;
}
/// The two arguments of (a, b)...: up to the bracket that closes.
inline std::pair<std::string, std::string> arguments(std::string const& text) {
    int depth = 0;
    std::size_t comma = 0;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if (text[k] == '(' or text[k] == '[') ++depth;
        if (text[k] == ')' or text[k] == ']') --depth;
        if (depth == 0 and comma == 0 and text.compare(k, 2, ", ") == 0) comma = k;
        if (depth < 0) return {text.substr(0, comma), text.substr(comma + 2, k - comma - 2)};
    }
    throw std::runtime_error("no arguments: " + text);
}

template <class Root>
reader reader_on(Root const& T) {
    reader r;
    for (Q const& t : T) r.t.push_back(t);
    table q{{}, {}};
    for (int i = 0; i <= T.last(); ++i) q.at[i] = random_value(i, 3);
    r.names["q"] = q;
    return r;
}
template <class Root>
auto random_function(Root const& T) {
    std::vector<Q> values;
    for (int i = 0; i <= T.last(); ++i) values.push_back(random_value(i, 3));
    return hilger::function_on(T, values);
}
/// The values of dL/dq and dL/dv at the arguments that are printed, and those of H.
inline void take_arguments(reader& r, std::string const& a, std::string const& b) {
    table const x = r.restricted(r.read(a), r.integral), v = r.restricted(r.read(b), r.integral);
    table p{r.integral, {}}, minus_f = p, velocity = p, force = p;
    for (auto const& [i, q] : x.at)
        if (v.at.count(i) > 0) {
            force.at[i] = hilger::gradient_first(cubic{}, q, v.at.at(i));
            minus_f.at[i] = -force.at[i];
            p.at[i] = hilger::gradient_second(cubic{}, q, v.at.at(i));
            velocity.at[i] = v.at.at(i);
        }
    r.names["∂L/∂q(⋆)"] = force;
    r.names["∂L/∂v(⋆)"] = p;
    r.names["∂H/∂q"] = minus_f;
    r.names["∂H/∂p"] = velocity;
    r.names["P"] = p;
}
/// Equal, and on the same points.
template <class R>
bool same_as_residual(table const& left, std::pair<int, int> const& numbers, R const& residual, int sign) {
    if (numbers.first != residual.first() or numbers.second - numbers.first != residual.last() - residual.first()) return false;
    for (int i = numbers.first; i <= numbers.second; ++i)
        if (left.at.count(i) == 0 or left.at.at(i) != sign * residual[i]) return false;
    return true;
}
template <class Base>
family family_of(Base const& base) {
    if constexpr (requires { base.lambda; })
        return {family::between, base.lambda.template as<Q>()};
    else
        return {};
}

/// The text of the equation of the action S is the equation.
template <class Action>
void read_back(Action const& S) {
    auto const EL = variation(S);
    auto const text = printed(EL);
    CAPTURE(text);
    // No C++ in it.
    CHECK(text.find_first_of("{}") == std::string::npos);
    CHECK(text.find('_') == std::string::npos);

    auto const q = random_function(S.T);
    auto const residual = EL.residual(q);
    reader r = reader_on(S.T);
    r.integral = family_of(S.position.image(hilger::domain<hilger::nodes>{}).base);

    std::string rest = text;
    std::string const left = cut(rest, " = 0   on "), where = cut(rest, ",   ⋆ = (");
    auto const [a, b] = arguments(rest);
    take_arguments(r, a, b);
    auto const numbers = numbers_of(where, r);
    CHECK(same_as_residual(r.read(left), numbers, residual, 1));

    // -B*[p] = A*[-dH/dq], B[q] = dH/dp, of the same state
    rest = printed(hamiltonian_form(EL));
    CAPTURE(rest);
    std::string const first_left = cut(rest, " = "), first_right = cut(rest, "   on "), first_where = cut(rest, "\n");
    std::string const second_left = cut(rest, " = "), second_right = cut(rest, "   on ");
    std::string const of = second_right.substr(std::string("∂H/∂p").size());
    CHECK(of.size() >= a.size() + 3);
    CHECK(of.substr(of.size() - a.size() - 3) == ", " + a + ")");
    std::string const name_of_p = of.substr(1, of.size() - a.size() - 4);
    reader h = r;
    h.names.clear();
    h.names[name_of_p] = r.names["P"];
    h.names["∂H/∂q" + of] = r.names["∂H/∂q"];
    table const momentum = h.read(first_left), force = h.read(first_right);
    table difference{momentum.on, {}};
    for (auto const& [i, x] : momentum.at)
        if (force.at.count(i) > 0) difference.at[i] = x - force.at.at(i);
    CHECK(same_as_residual(difference, numbers_of(first_where, h), residual, -1));
    CHECK(second_left == b);

    // the same words in LaTeX
    std::string const formula = as_terminal(latex(EL));
    CAPTURE(formula);
    CHECK(formula.find(left + " &= 0, && t \\in " + "T") != std::string::npos);
    CHECK(formula.find("⋆ = (" + a + ", " + b + ")") != std::string::npos);
    std::string const system = as_terminal(latex(hamiltonian_form(EL)));
    CAPTURE(system);
    CHECK(system.find(first_left + " &= " + first_right) != std::string::npos);
    CHECK(system.find(second_left + " &= " + second_right) != std::string::npos);
}

} // namespace reading
