// SPDX-License-Identifier: BSL-1.0
// Reads printed equations back: a parser of the printed notation that knows its words and nothing of the library's operators, and computes
// with tables of exact rationals. Grammar, with feet such as ½, ∘ and ∘,⅓:
//   sum = [−] term {(+ | −) term};   term = {factor} primary {mark};   factor = 3/2 | 2.5 | h⁻¹ | (ν/μ) | (1 − 0.3) | ρ
//   primary = name | symbol [ sum ] | [ sum ] foot | ( sum );   symbol = σ ρ Δ₊ Δ₋ Δ₋^(1/2) π π⁻¹ ι with feet;   mark = ∘ |T |T½ (a)
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "hilger/multiprecision.hpp"

namespace reading {

using hilger::Q;

/// Points of T, T_lambda or T_{o,lambda}.
struct family {
    enum kind { T, between, joined } is = T;
    Q lambda{0};
    friend bool operator==(family const&, family const&) = default;
};
/// Values at some points of a family, by their numbers.
struct table {
    family on;
    std::map<int, Q> at;
};

class reader {
public:
    std::vector<Q> t{};                   ///< the points of T
    family integral{};                    ///< where a term on T_o is meant
    std::map<std::string, table> names{}; ///< q, ∂L/∂q(⋆), ...
    std::map<std::string, Q> constants{}; ///< ρ

    table read(std::string const& text) {
        s_ = text;
        at_ = 0;
        table const result = sum();
        if (at_ != s_.size()) fail("something is left");
        return result;
    }
    table restricted(table const& f, family const& to) const {
        if (f.on == to) return f;
        if (f.on.is != family::joined) throw std::runtime_error("two families in one sum");
        table r{to, {}};
        for (auto const& [j, x] : f.at)
            if ((j % 2 == 0) == (to.is == family::T)) r.at[j / 2] = x;
        return r;
    }
    [[nodiscard]] int last(family const& f) const {
        int const n = static_cast<int>(t.size()) - 1;
        return f.is == family::T ? n : f.is == family::between ? n - 1 : 2 * n;
    }

private:
    std::string s_{};
    std::size_t at_ = 0;

    [[noreturn]] void fail(std::string const& what) const {
        throw std::runtime_error(what + " at \"" + s_.substr(at_) + "\" in \"" + s_ + "\"");
    }
    bool next(std::string const& word) {
        if (s_.compare(at_, word.size(), word) != 0) return false;
        at_ += word.size();
        return true;
    }
    void need(std::string const& word) {
        if (not next(word)) fail("no " + word);
    }
    [[nodiscard]] Q point(family const& f, int i) const {
        auto const at = [&](int k) { return t[static_cast<std::size_t>(k)]; };
        if (f.is == family::T) return at(i);
        if (f.is == family::joined and i % 2 == 0) return at(i / 2);
        int const k = f.is == family::joined ? i / 2 : i;
        return Q((1 - f.lambda) * at(k) + f.lambda * at(k + 1));
    }
    [[nodiscard]] Q after(family const& f, int i) const { return i < last(f) ? Q(point(f, i + 1) - point(f, i)) : Q(0); }
    [[nodiscard]] Q before(family const& f, int i) const { return i > 0 ? after(f, i - 1) : Q(0); }
    [[nodiscard]] Q step(int i) const { return Q(t[static_cast<std::size_t>(i) + 1] - t[static_cast<std::size_t>(i)]); }

    /// 3, 3/2, 2.5, ½
    std::optional<Q> number() {
        static std::pair<char const*, Q> const signs[] = {{"½", Q(1, 2)}, {"⅓", Q(1, 3)}, {"⅔", Q(2, 3)}, {"¼", Q(1, 4)},
                                                          {"¾", Q(3, 4)}, {"⅕", Q(1, 5)}, {"⅖", Q(2, 5)}};
        for (auto const& [sign, value] : signs)
            if (next(sign)) return value;
        if (at_ == s_.size() or not std::isdigit(static_cast<unsigned char>(s_[at_]))) return std::nullopt;
        auto const digits = [&] {
            Q n(0);
            for (; at_ < s_.size() and std::isdigit(static_cast<unsigned char>(s_[at_])); ++at_) n = 10 * n + (s_[at_] - '0');
            return n;
        };
        Q n = digits();
        if (at_ + 1 < s_.size() and s_[at_] == '.') {
            ++at_;
            std::size_t const from = at_;
            Q const rest = digits();
            Q scale(1);
            for (std::size_t k = from; k < at_; ++k) scale *= 10;
            n += rest / scale;
        } else if (at_ + 1 < s_.size() and s_[at_] == '/' and std::isdigit(static_cast<unsigned char>(s_[at_ + 1]))) {
            ++at_;
            n /= digits();
        }
        return n;
    }
    /// Nothing is T, ½ is T½, ∘ is T∘, and ∘,⅓ likewise.
    family foot() {
        if (next("∘")) {
            std::size_t const back = at_;
            if (next(","))
                if (auto const l = number()) return {family::joined, *l};
            at_ = back;
            return {family::joined, Q(1, 2)};
        }
        if (auto const l = number()) return {family::between, *l};
        return {};
    }
    table on(table const& f, family const& wanted) const {
        if (f.on == wanted) return f;
        throw std::runtime_error("an operator on another family in \"" + s_ + "\"");
    }
    [[nodiscard]] table shifted(table const& f, int by) const {
        table r{f.on, {}};
        for (auto const& [i, x] : f.at)
            if (i - by >= 0 and i - by <= last(f.on)) r.at[i - by] = x;
        return r;
    }
    /// by(i) where all the values f(i + k) are known.
    template <class By>
    static table where(table const& f, std::vector<int> const& offsets, By const& by) {
        table r{f.on, {}};
        for (auto const& [i, x] : f.at) {
            bool all = true;
            for (int k : offsets) all = all and f.at.count(i + k) > 0;
            if (all) r.at[i] = by(i);
        }
        return r;
    }
    table differences(table const& f, bool forward) const {
        int const k = forward ? 1 : -1;
        return where(f, {k}, [&](int i) { return Q((f.at.at(i + k) - f.at.at(i)) / (k * (forward ? after(f.on, i) : before(f.on, i)))); });
    }
    /// The coefficients of (1 - z)^alpha, in steps of length 1 where alpha is no whole number.
    table fractional(table const& f, Q const& alpha, bool forward) const {
        table r{f.on, {}};
        for (auto const& [i, x] : f.at) {
            Q w(1), total(0);
            for (int n = 0; f.at.count(forward ? i + n : i - n) > 0; ++n) {
                total += w * f.at.at(forward ? i + n : i - n);
                w *= (n - alpha) / (n + 1);
            }
            for (Q n = alpha; n >= 1; n -= 1) total /= step(0); // what is left is a power of 1
            r.at[i] = total;
        }
        return r;
    }
    table in_brackets() {
        need("[");
        table const f = sum();
        need("]");
        return f;
    }
    table extended(table const& f, Q const& lambda) const {
        table const g = on(f, {});
        table r{{family::joined, lambda}, {}};
        for (auto const& [i, x] : g.at) {
            r.at[2 * i] = x;
            if (g.at.count(i + 1) > 0) r.at[2 * i + 1] = Q((1 - lambda) * x + lambda * g.at.at(i + 1));
        }
        return r;
    }
    table primary() {
        for (auto const& [name, value] : names)
            if (next(name)) return value;
        if (next("Δ")) {
            family const f = foot();
            if (not(f == family{})) need(",");
            bool const forward = next("₊");
            if (not forward) need("₋");
            std::optional<Q> order;
            if (next("^")) {
                bool const brackets = next("(");
                order = number();
                if (brackets) need(")");
            }
            table const g = on(in_brackets(), f);
            return order ? fractional(g, *order, forward) : differences(g, forward);
        }
        if (bool const up = next("BDF2₊^1"); up or next("BDF2₋^1")) { // (3 - 4 z + z^2) / 2h
            table const g = on(in_brackets(), {});
            int const k = up ? 1 : -1;
            auto const at = [&](int i) { return g.at.count(i) > 0 ? g.at.at(i) : Q(0); };
            table r{{}, {}};
            for (auto const& [i, x] : g.at) r.at[i] = Q((3 * x - 4 * at(i + k) + at(i + 2 * k)) / (2 * step(0)));
            return r;
        }
        if (next("σ")) {
            family const f = foot();
            return shifted(on(in_brackets(), f), 1);
        }
        if (next("ρ")) {
            family const f = foot();
            return shifted(on(in_brackets(), f), -1);
        }
        if (next("π")) {
            auto const l = number();
            if (next("⁻¹")) {
                table g = on(in_brackets(), {});
                g.at.erase(last({}));
                return {{family::between, l.value_or(Q(1, 2))}, g.at};
            }
            return {{}, on(in_brackets(), {family::between, l.value_or(Q(1, 2))}).at};
        }
        if (next("ι")) {
            auto const l = number();
            table const g = in_brackets();
            table r{{family::joined, l ? *l : integral.lambda}, {}};
            for (auto const& [i, x] : g.at) {
                r.at[2 * i + (l ? 1 : 0)] = x;
                for (int beside : {2 * i + (l ? 0 : -1), 2 * i + (l ? 2 : 1)})
                    if (beside >= 0 and beside <= last(r.on)) r.at.emplace(beside, 0);
            }
            return r;
        }
        if (next("[")) {
            table const f = sum();
            need("]");
            if (next("∘")) {
                table r{{}, {}};
                for (auto const& [j, x] : f.at)
                    if (j % 2 == 0 and f.at.count(j - 1) > 0 and f.at.count(j + 1) > 0)
                        r.at[j / 2] = Q((f.at.at(j - 1) + f.at.at(j + 1)) / 2);
                return r;
            }
            if (next("μ"))
                return where(f, {-1}, [&](int i) {
                    Q const a = (1 - f.on.lambda) * step(i), b = f.on.lambda * step(i - 1);
                    return Q((a * f.at.at(i) + b * f.at.at(i - 1)) / (a + b));
                });
            Q const l = foot().lambda;
            need(",");
            int const k = next("₊") ? 1 : -1;
            if (k < 0) need("₋");
            return where(f, {k}, [&](int i) { return Q((1 - l) * f.at.at(i) + l * f.at.at(i + k)); });
        }
        if (next("(")) {
            table const f = sum();
            need(")");
            return f;
        }
        fail("no term");
    }
    table marked() {
        table f = primary();
        for (;;) {
            if (next("∘")) {
                at_ -= std::string("∘").size();
                f = extended(f, foot().lambda);
            } else if (next("|T")) {
                auto const l = number();
                f = restricted(f, l ? family{family::between, *l} : family{});
            } else if (next("(a)")) {
                Q const first = f.at.at(0);
                for (auto& [i, x] : f.at) x = first;
            } else
                return f;
        }
    }
    /// A factor, as a function of the points of a family; nothing when a term begins here.
    std::optional<std::function<Q(family const&, int)>> factor() {
        std::size_t const from = at_;
        if (auto const n = number()) {
            if (next(" ")) return [x = *n](family const&, int) { return x; };
            at_ = from;
            return std::nullopt;
        }
        for (auto const& [name, value] : constants)
            if (next(name + " ")) return [x = value](family const&, int) { return x; };
        static std::pair<char const*, int> const powers[] = {{"h⁻⁴ ", -4}, {"h⁻³ ", -3}, {"h⁻² ", -2}, {"h⁻¹ ", -1},
                                                             {"h ", 1},    {"h² ", 2},   {"h³ ", 3}};
        for (auto const& [text, power] : powers)
            if (next(text)) {
                Q x(1);
                for (int k = 0; k < power; ++k) x *= step(0);
                for (int k = 0; k < -power; ++k) x /= step(0);
                return [x](family const&, int) { return x; };
            }
        if (at_ < s_.size() and s_[at_] == '(') {
            int depth = 0;
            std::size_t end = at_;
            for (; end < s_.size(); ++end) {
                depth += s_[end] == '(' ? 1 : s_[end] == ')' ? -1 : 0;
                if (depth == 0) break;
            }
            std::string const inside = s_.substr(at_, end + 1 - at_);
            if (inside.find('[') != std::string::npos or inside.find('q') != std::string::npos or inside.find("∂") != std::string::npos or
                s_.compare(end + 1, 1, " ") != 0)
                return std::nullopt;
            at_ = end + 2;
            return [this, inside](family const& f, int i) {
                reader sub = *this;
                sub.s_ = inside;
                sub.at_ = 0;
                Q const x = sub.weight(f, i);
                if (sub.at_ != inside.size()) sub.fail("something is left in a weight");
                return x;
            };
        }
        return std::nullopt;
    }
    Q weight(family const& f, int i) {
        Q x = weight_product(f, i);
        for (;;) {
            if (next(" + "))
                x += weight_product(f, i);
            else if (next(" − "))
                x -= weight_product(f, i);
            else
                return x;
        }
    }
    Q weight_product(family const& f, int i) {
        Q x = weight_atom(f, i);
        for (;;) {
            if (next("/"))
                x /= weight_atom(f, i);
            else if (at_ < s_.size() and s_[at_] != ')' and s_[at_] != ' ')
                x *= weight_atom(f, i);
            else
                return x;
        }
    }
    Q weight_atom(family const& f, int i) {
        if (next("(")) {
            Q const x = weight(f, i);
            need(")");
            return x;
        }
        if (next("μ")) return (void)foot(), after(f, i);
        if (next("ν")) return (void)foot(), before(f, i);
        if (next("h")) return step(i);
        if (auto const n = number()) return *n;
        fail("no weight");
    }
    table term(int sign) {
        std::vector<std::function<Q(family const&, int)>> factors;
        while (auto const c = factor()) factors.push_back(*c);
        table f = marked();
        table r{f.on, {}};
        for (auto const& [i, x] : f.at) try {
                Q product = sign * x;
                for (auto const& c : factors) product *= c(f.on, i);
                r.at[i] = product;
            } catch (std::overflow_error const&) { // 1/0: there is no such weight at this end
            }
        return r;
    }
    table sum() {
        table total = term(next("−") ? -1 : 1);
        for (;;) {
            int const sign = next(" + ") ? 1 : next(" − ") ? -1 : 0;
            if (sign == 0) return total;
            table f = term(sign);
            if (not(f.on == total.on)) {
                family const to = total.on.is == family::joined ? f.on : total.on;
                f = restricted(f, to);
                total = restricted(total, to);
            }
            table both{total.on, {}};
            for (auto const& [i, x] : total.at)
                if (f.at.count(i) > 0) both.at[i] = x + f.at[i];
            total = both;
        }
    }
};

/// A printed domain, T½⁻ or T±: its first and its last number.
inline std::pair<int, int> numbers_of(std::string text, reader const& with) {
    family f{};
    auto const take = [&](std::string const& word) {
        bool const there = text.rfind(word, 0) == 0;
        if (there) text.erase(0, word.size());
        return there;
    };
    if (not take("T")) throw std::runtime_error("no domain: " + text);
    if (with.integral.is == family::between) f = with.integral;
    while (not text.empty() and text.find("⁺") != 0 and text.find("⁻") != 0 and text.find("±") != 0) text.erase(0, 1); // its foot
    int front = 0, back = 0;
    while (not text.empty()) {
        if (take("±"))
            ++front, ++back;
        else if (take("⁺"))
            ++back;
        else if (take("⁻"))
            ++front;
        else
            throw std::runtime_error("no domain: " + text);
    }
    return {front, with.last(f) - back};
}

/// LaTeX in the words of a terminal.
inline std::string as_terminal(std::string text) {
    auto const replace = [&](std::string const& old, std::string const& by) {
        for (std::size_t k = text.find(old); k != std::string::npos; k = text.find(old, k + by.size())) text.replace(k, old.size(), by);
    };
    static std::pair<char const*, char const*> const words[] = {{"\\frac{\\partial L}{\\partial q}", "∂L/∂q"},
                                                                {"\\frac{\\partial L}{\\partial v}", "∂L/∂v"},
                                                                {"\\frac{\\partial H}{\\partial q}", "∂H/∂q"},
                                                                {"\\frac{\\partial H}{\\partial p}", "∂H/∂p"},
                                                                {"\\frac{1}{2}", "½"},
                                                                {"\\frac{1}{3}", "⅓"},
                                                                {"\\frac{2}{3}", "⅔"},
                                                                {"\\frac{2}{5}", "⅖"},
                                                                {"\\frac{3}{7}", "3/7"},
                                                                {"\\star", "⋆"},
                                                                {"\\circ", "∘"},
                                                                {"\\Delta", "Δ"},
                                                                {"\\sigma", "σ"},
                                                                {"\\rho", "ρ"},
                                                                {"\\pi", "π"},
                                                                {"\\mu", "μ"},
                                                                {"\\nu", "ν"},
                                                                {"\\iota", "ι"},
                                                                {"\\left", ""},
                                                                {"\\right", ""},
                                                                {"\\mathbb{T}", "T"},
                                                                {"\\mathrm{BDF2}", "BDF2"},
                                                                {"^{-1}", "⁻¹"},
                                                                {"^{-2}", "⁻²"},
                                                                {"^{-3}", "⁻³"},
                                                                {"_{+}", "₊"},
                                                                {"_{-}", "₋"},
                                                                {",+}", ",₊}"},
                                                                {",-}", ",₋}"},
                                                                {"-", "−"}};
    for (auto const& [old, by] : words) replace(old, by);
    // fractions of numbers are factors, and those of weights stand in brackets
    for (std::size_t k = text.find("\\tfrac{"); k != std::string::npos; k = text.find("\\tfrac{")) {
        std::size_t const middle = text.find("}{", k + 7);
        std::size_t end = text.find("}\\,", middle);
        std::string const above = text.substr(k + 7, middle - k - 7), below = text.substr(middle + 2, end - middle - 2);
        bool const number = (above + below).find_first_not_of("0123456789") == std::string::npos;
        auto const enclosed = [](std::string const& x) {
            bool const is_sum = x.find(" + ") != std::string::npos and x.find('(') == std::string::npos;
            return is_sum ? "(" + x + ")" : x;
        };
        auto const part = [](std::string x) {
            std::erase(x, '{');
            std::erase(x, '}');
            std::erase(x, '_');
            for (std::string const greek : {"μ", "ν"}) // 2 mu is 2mu
                for (char digit = '2'; digit <= '9'; ++digit)
                    for (std::string const old = std::string(1, digit) + " " + greek; x.find(old) != std::string::npos;)
                        x.replace(x.find(old), old.size(), digit + greek);
            return x;
        };
        std::string a = part(above), b = part(below);
        text.replace(k, end + 3 - k,
                     number
                         ? a + "/" + b + " "
                         : "(" + enclosed(a) + "/" + (std::isdigit(static_cast<unsigned char>(b[0])) ? "(" + b + ")" : enclosed(b)) + ") ");
    }
    replace("\\,", " ");
    for (std::size_t k = text.find("^{"); k != std::string::npos; k = text.find("^{")) { // orders
        std::size_t const end = text.find('}', k);
        std::string const order = text.substr(k + 2, end - k - 2);
        text.replace(k, end + 1 - k, order.size() > 1 ? "^(" + order + ")" : "^" + order);
    }
    std::erase(text, '_');
    std::erase(text, '{');
    std::erase(text, '}');
    return text;
}

} // namespace reading
