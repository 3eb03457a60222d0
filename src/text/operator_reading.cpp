// SPDX-License-Identifier: BSL-1.0
// The meaning of a formula as an operator: a number, an operator, or an operator applied to the unknown q.
#include <utility>

#include "hilger/error.hpp"
#include "hilger/text/operator.hpp"

namespace hilger::text {

namespace {

class operator_reader {
    /// A number, an operator, or an operator applied to the unknown.
    struct meant {
        enum class kind { number, an_operator, function } is;
        expression number;
        operator_formula op;
    };

public:
    operator_reader(std::shared_ptr<vocabulary const> words, std::string source) : words_(std::move(words)), source_(std::move(source)) {}

    /// @throws error::unreadable
    operator_formula as_operator(node::pointer const& n) { return applied(meaning_of(n)); }
    embedding_formula as_embedding(node::pointer const& n) {
        bool const nabla = n->name == "nabla_integral";
        if (n->what != kind::call or (n->name != "integral" and not nabla))
            refuse(*n, "an embedding is written integral(L(A, B)) or nabla_integral(L(A, B))");
        bool const right = n->parts.size() == 1 and n->parts[0]->what == kind::call and n->parts[0]->name == "L";
        if (not right or n->parts[0]->parts.size() != 2)
            refuse(*n, "what is integrated is L(A, B), a position and a velocity made of q, as in integral(L(q, Delta_plus[q]))");
        auto const& both = n->parts[0]->parts;
        return {as_operator(both[0]), as_operator(both[1]), nabla ? sum_weight::nabla : sum_weight::delta, {}};
    }

private:
    using is = typename meant::kind;
    static std::optional<operator_formula> named(std::string const& name) {
        if (name == "identity") return operator_formula();
        if (name == "sigma") return operator_formula::shift(side::plus);
        if (name == "rho") return operator_formula::shift(side::minus);
        if (name == "Delta_plus") return operator_formula::derivative(side::plus);
        if (name == "Delta_minus") return operator_formula::derivative(side::minus);
        if (name == "mu_over_nu") return operator_formula::reweight(sum_weight::delta, sum_weight::nabla);
        if (name == "nu_over_mu") return operator_formula::reweight(sum_weight::nabla, sum_weight::delta);
        return {};
    }
    meant meaning_of(node::pointer const& n) {
        switch (n->what) {
        case kind::name:
            if (n->name == "q") return {is::function, {}, {}};
            if (auto const op = named(n->name)) {
                if (words_->find(n->name) != nullptr)
                    refuse(*n, "'" + n->name +
                                   "' is an operator, and a parameter of the problem: one of them needs another name, or write " + n->name +
                                   "[q]");
                return {is::an_operator, {}, *op};
            }
            break;
        case kind::call:           // sigma(q) is sigma[q]
            if (n->name.empty()) { // (A + B)[q]
                meant const outer = meaning_of(n->parts[0]);
                meant inner = meaning_of(n->parts[1]);
                if (outer.is == is::function) refuse(*n, "an operator is linear in q, and this one is not");
                if (inner.is == is::number) refuse(*n->parts[1], "(...)[...] acts on q or on an operator, and here is a number");
                inner.op = applied(outer) * inner.op;
                return inner;
            }
            [[fallthrough]];
        case kind::element:
            if (auto const op = named(n->name)) {
                if (n->parts.size() != 1) refuse(*n, n->name + " acts on one function, as in " + n->name + "[q]");
                meant inner = meaning_of(n->parts[0]);
                if (inner.is == is::number) refuse(*n->parts[0], n->name + "[...] acts on q or on an operator, and here is a number");
                inner.op = *op * inner.op;
                return inner;
            }
            break;
        case kind::negative: {
            meant x = meaning_of(n->parts[0]);
            if (x.is != is::number) {
                x.op = -x.op;
                return x;
            }
            break;
        }
        case kind::plus:
        case kind::minus: {
            meant x = meaning_of(n->parts[0]), y = meaning_of(n->parts[1]);
            if (x.is == is::number and y.is == is::number) break;
            if ((x.is == is::function) != (y.is == is::function))
                refuse(*n, "both terms of a sum are made of q, or none is, as in q + sigma[q]");
            operator_formula const a = applied(x), b = applied(y);
            return {x.is == is::number ? y.is : x.is, {}, n->what == kind::plus ? a + b : a - b};
        }
        case kind::times: {
            meant x = meaning_of(n->parts[0]), y = meaning_of(n->parts[1]);
            if (x.is == is::number and y.is == is::number) break;
            if (x.is == is::function and y.is != is::number) refuse(*n, "an operator is linear in q, and this product is not");
            if (y.is == is::number) std::swap(x, y);
            return {y.is, {}, x.is == is::number ? operator_formula::multiple(factor(x.number), y.op) : x.op * y.op};
        }
        case kind::over: {
            meant x = meaning_of(n->parts[0]), y = meaning_of(n->parts[1]);
            if (x.is == is::number and y.is == is::number) break;
            if (y.is != is::number) refuse(*n->parts[1], "an operator is divided by a number");
            if (is_zero(y.number)) refuse(*n->parts[1], "an operator is divided by 0");
            expression const one = expression::number("1");
            return {x.is, {}, operator_formula::multiple(factor(one / y.number), x.op)};
        }
        case kind::power: { // sigma^2 is sigma[sigma]
            meant const x = meaning_of(n->parts[0]);
            if (x.is == is::number) break;
            if (x.is == is::function) refuse(*n, "an operator is linear in q, and this power is not");
            return {x.is, {}, repeated(x.op, *n->parts[1])};
        }
        default:
            break;
        }
        bool const is_word = n->what == kind::name or n->what == kind::element;
        if (is_word and n->name != "pi" and words_->find(n->name) == nullptr)
            refuse(*n, "'" + n->name + "' has no meaning: there are q, identity, sigma, rho, Delta_plus, Delta_minus" +
                           (words_->known().empty() ? " and numbers" : ", numbers and parameters"));
        return {is::number, expression(n), {}};
    }
    operator_formula repeated(operator_formula const& a, node const& times) const {
        constexpr int most = 99;
        bool const is_whole = times.what == kind::number and times.name.size() <= 2 and times.name.find('.') == std::string::npos;
        int const n = is_whole ? std::stoi(times.name) : most + 1;
        if (n > most) refuse(times, "an operator is repeated n = 0, 1, ... " + std::to_string(most) + " times, as in sigma^2");
        operator_formula power;
        for (int k = 0; k < n; ++k) power = power * a;
        return power;
    }
    /// 1 + sigma: a number is a multiple of the identity.
    operator_formula applied(meant const& x) { return x.is == is::number ? operator_formula::multiple(factor(x.number), {}) : x.op; }
    /// @throws error::unreadable, with the known names, when it is not a formula of numbers alone
    stated factor(expression const& e) {
        stated f(e, words_, source_);
        if (f.reads_state())
            refuse(e.root(),
                   "a factor is a number, and this one depends on the state; an operator acts on q, which stands for every coordinate");
        return f;
    }
    [[noreturn]] void refuse(node const& n, std::string const& why) const {
        if (n.at.line == 0) error::raise<error::unreadable>(source_, ": ", why);
        error::raise<error::unreadable>(source_, ", line ", n.at.line, ", column ", n.at.column, ": ", why);
    }
    std::shared_ptr<vocabulary const> words_;
    std::string source_;
};

} // namespace

operator_formula operator_in(std::string_view text, std::shared_ptr<vocabulary const> words, std::string const& source) {
    auto const e = read(text, source, {1, 1}, true);
    return operator_reader(std::move(words), source).as_operator(e.shared());
}
embedding_formula embedding_in(std::string_view text, std::shared_ptr<vocabulary const> words, std::string const& source, place from) {
    auto const e = read(text, source, from, true);
    embedding_formula made = operator_reader(std::move(words), source).as_embedding(e.shared());
    made.text = text;
    return made;
}

} // namespace hilger::text
