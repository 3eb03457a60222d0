// SPDX-License-Identifier: BSL-1.0
// Each node becomes a term: a coefficient and powers of atoms (factors that are not products). So x * x / x is written x, and the
// derivatives of a norm are quotients by it.
#include "text/printed.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "hilger/error.hpp"

namespace hilger::detail {

namespace {

/// A name, with the component's number as index unless negative: Greek letters, dots and indices in LaTeX, other words upright.
std::string latex_name(std::string const& name, int component) {
    constexpr std::string_view greek =
        " alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi pi rho sigma tau upsilon phi "
        "chi psi omega Gamma Delta Theta Lambda Xi Pi Sigma Upsilon Phi Psi Omega ";
    auto const is_word = [](char c) { return (c >= 'a' and c <= 'z') or (c >= 'A' and c <= 'Z') or (c >= '0' and c <= '9') or c == '_'; };
    std::string const number = component < 0 ? "" : std::to_string(component);
    if (name.size() < 2 or not std::all_of(name.begin(), name.end(), is_word)) // or the user's own LaTeX
        return number.empty() ? name : name + "_{" + number + "}";
    auto const upright = [&](std::string const& word) {
        if (word.size() == 1 or word.find_first_not_of("0123456789") == std::string::npos) return word;
        if (greek.find(" " + word + " ") != std::string_view::npos) return "\\" + word;
        std::string text = "\\mathrm{";
        for (char const c : word) text += c == '_' ? std::string("\\_") : std::string(1, c);
        return text + "}";
    };
    auto const bar = name.find('_');
    bool const has_index = bar != std::string::npos and bar > 0 and bar + 1 < name.size();
    std::string const index = has_index ? upright(name.substr(bar + 1)) + (number.empty() ? "" : ",") + number : number;
    return upright(has_index ? name.substr(0, bar) : name) + (index.empty() ? "" : "_{" + index + "}");
}

/// The notation of a formula's parts on a terminal and in LaTeX.
struct spelling {
    bool latex;

    [[nodiscard]] std::string minus() const { return latex ? "-" : "−"; }
    [[nodiscard]] std::string number(double x) const {
        std::string const digits = round_trip(finite_constant(x));
        auto const e = digits.find('e');
        if (not latex or e == std::string::npos) return digits;
        return "{" + digits.substr(0, e) + " \\cdot 10^{" + std::to_string(std::stoi(digits.substr(e + 1))) + "}}";
    }
    [[nodiscard]] std::string name(argument_name const& x) const {
        if (latex) return latex_name(x.name, x.component);
        return x.component < 0 ? x.name : x.name + subscript(x.component);
    }
    [[nodiscard]] written product(written const& a, written const& b) const {
        return {a.in(written::product) + (latex ? " \\, " + b.in(written::product) : "·" + b.in(written::factor)), written::product};
    }
    [[nodiscard]] written quotient(written const& a, written const& b) const {
        if (latex) return {"\\frac{" + a.text + "}{" + b.text + "}", written::product};
        return {a.in(written::product) + "/" + b.in(written::factor), written::product};
    }
    [[nodiscard]] written power(written const& a, std::string const& n) const {
        if (n == "1") return a;
        if (latex) return {"{" + a.in(written::atom) + "}^{" + n + "}", written::factor};
        return {a.in(written::atom) + (n == "2" ? "²" : n == "3" ? "³" : n == "4" ? "⁴" : "^" + n), written::factor};
    }
    /// The indicator function, in Iverson's brackets.
    [[nodiscard]] written condition(bool is_negative, std::string const& x) const {
        return {"[" + x + (is_negative ? " < 0]" : latex ? " \\ge 0]" : " ≥ 0]")};
    }
    [[nodiscard]] written call(std::string_view name, std::string const& arguments) const {
        if (name == "abs") return {latex ? "\\left|" + arguments + "\\right|" : "|" + arguments + "|"};
        if (name == "sqrt") return {latex ? "\\sqrt{" + arguments + "}" : "√(" + arguments + ")"};
        if (name == "cbrt" and latex) return {"\\sqrt[3]{" + arguments + "}"};
        return {(latex ? latex_function(name) : std::string(name)) + "(" + arguments + ")"};
    }

private:
    static std::string latex_function(std::string_view name) {
        if (name == "asin" or name == "acos" or name == "atan") return "\\arc" + std::string(name.substr(1));
        for (std::string_view const known : {"sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh", "max", "min"})
            if (name == known) return "\\" + std::string(name);
        return "\\operatorname{" + std::string(name) + "}";
    }
};

/// The quotient times / by, multiplied by powers of atoms.
struct term {
    double times = 1, by = 1;
    std::map<std::size_t, int> powers;
};

class printer {
public:
    printer(named_graph const& in, spelling how) : in_(in), spell_(how) {}

    std::string text(formula_node const& f) {
        if (f.is_constant()) return text_of({f.value, 1, {}}).text;
        for (int const k : nodes_below(in_.graph, {f})) terms_[k] = term_of(k);
        return text_of(terms_[f.node]).text;
    }

private:
    /// A factor that is not a product; `root_of` is the atom that it is the square root of.
    struct atom {
        written text;
        std::optional<std::size_t> root_of;
    };
    term new_atom(written text) {
        atoms_.push_back({std::move(text), {}});
        return {1, 1, {{atoms_.size() - 1, 1}}};
    }
    term term_of(int k) {
        auto const& g = in_.graph;
        if (g.is_number(k)) return {g.number(k), 1, {}};
        auto const& n = g[k];
        if (n.what == nullptr) return new_atom({spell_.name(in_.names[static_cast<std::size_t>(n.b)])});
        std::string_view const name = n.what->name;
        term const &a = terms_[n.a], &b = terms_[n.b];
        if (name == "+") return sum(a, b);
        if (name == "-") return sum(a, negative(b));
        if (name == "-x") return negative(a);
        if (name == "*") return product(a, b, 1);
        if (name == "/" or name == "over_norm") return product(a, b, -1);
        if (name == "where" or name == "elsewhere") return product(new_atom(spell_.condition(name == "elsewhere", text_of(a).text)), b, 1);
        if (name == "slope_of_log") return product(term{}, a, -1);
        if (name == "pow") return new_atom(spell_.power(text_of(a), spell_.latex ? text_of(b).text : text_of(b).in(written::atom)));
        std::string arguments = text_of(a).text;
        if (takes_two(name)) arguments += ", " + text_of(b).text;
        term made = new_atom(spell_.call(name, arguments));
        if (name == "sqrt" and a.times == 1 and a.by == 1 and a.powers.size() == 1 and a.powers.begin()->second == 1)
            atoms_.back().root_of = a.powers.begin()->first;
        return made;
    }
    static term negative(term x) {
        x.times = -x.times;
        return x;
    }
    /// a b^n, n = 1 or -1.
    term product(term a, term const& b, int n) const {
        a.times *= n > 0 ? b.times : b.by;
        a.by *= n > 0 ? b.by : b.times;
        for (auto const& [x, m] : b.powers) a.powers[x] += n * m;
        for (auto const& [root, x] : roots_in(a)) {
            int const both = a.powers[root] + 2 * a.powers[x]; // the power of the root
            a.powers[x] = both % 2 == 0 ? both / 2 : 0;
            a.powers[root] = both % 2 == 0 ? 0 : both;
        }
        std::erase_if(a.powers, [](auto const& power) { return power.second == 0; });
        if (a.by < 0) a.times = -a.times, a.by = -a.by;
        double const size = std::abs(a.times);
        if (std::fmod(size, a.by) == 0) a.times /= a.by, a.by = 1;
        if (a.by != 1 and std::fmod(a.by, size) == 0) a.times /= size, a.by /= size;
        return a;
    }
    /// The roots whose powers combine with powers of their radicands.
    [[nodiscard]] std::vector<std::pair<std::size_t, std::size_t>> roots_in(term const& a) const {
        std::vector<std::pair<std::size_t, std::size_t>> found;
        for (auto const& [x, n] : a.powers)
            if (auto const& of = atoms_[x].root_of; of and n != 0 and (n % 2 == 0 or a.powers.contains(*of))) found.emplace_back(x, *of);
        return found;
    }
    term sum(term const& a, term const& b) {
        if (a.times == 0) return b;
        if (b.times == 0) return a;
        if (a.powers == b.powers) {
            term made = a;
            made.times = a.by == b.by ? a.times + b.times : a.times / a.by + b.times / b.by;
            made.by = a.by == b.by ? a.by : 1;
            if (made.times == 0) return {0, 1, {}};
            return product(made, {}, 1);
        }
        if (a.times < 0 and b.times > 0) return sum(b, a);
        term const right = b.times < 0 ? negative(b) : b;
        return new_atom(
            {text_of(a).in(written::sum) + (b.times < 0 ? " " + spell_.minus() + " " : " + ") + text_of(right).in(written::product),
             written::sum});
    }
    [[nodiscard]] written text_of(term const& x) const {
        std::optional<written> above, below;
        auto const put = [&](std::optional<written>& to, written const& next) { to = to ? spell_.product(*to, next) : next; };
        double const size = std::abs(x.times);
        if (size != 1) put(above, {spell_.number(size)});
        if (x.by != 1) put(below, {spell_.number(x.by), x.by < 0 ? written::sum : written::atom});
        for (auto const& [at, n] : x.powers) put(n > 0 ? above : below, spell_.power(atoms_[at].text, std::to_string(std::abs(n))));
        written made = above.value_or(written{spell_.number(1)});
        if (below) made = spell_.quotient(made, *below);
        if (std::signbit(x.times) and x.times != 0) made = {spell_.minus() + made.in(written::product), written::sum};
        return made;
    }

    named_graph const& in_;
    spelling spell_;
    std::vector<atom> atoms_;
    std::map<int, term> terms_;
};

} // namespace

double finite_constant(double x) {
    if (not std::isfinite(x)) error::raise<error::no_formula>("the constants of a formula are finite doubles, and this one is ", x);
    return x;
}
std::vector<int> nodes_below(formula_graph<double> const& g, std::vector<formula_node> const& results) {
    std::vector<bool> is_needed(static_cast<std::size_t>(g.size()), false);
    for (auto const& f : results)
        if (not f.is_constant()) is_needed[static_cast<std::size_t>(f.node)] = true;
    std::vector<int> nodes;
    for (int k = g.size(); k-- > 0;) {
        if (not is_needed[static_cast<std::size_t>(k)]) continue;
        nodes.push_back(k);
        if (auto const& n = g[k]; n.what != nullptr)
            for (int const operand : {n.a, n.b}) is_needed[static_cast<std::size_t>(operand)] = true;
    }
    std::reverse(nodes.begin(), nodes.end());
    return nodes;
}
std::string printed(named_graph const& in, formula_node const& f, print_style style) {
    return printer(in, {style == print_style::latex}).text(f);
}

} // namespace hilger::detail
