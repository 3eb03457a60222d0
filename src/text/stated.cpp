// SPDX-License-Identifier: BSL-1.0
// The names in formulas, and whole numbers in them: indices of components, limits of sums, exponents.
#include <unordered_set>

#include "text/evaluate.hpp"

namespace hilger::text {

using detail::indices, detail::whole_constant;

namespace {

std::optional<long long> in_range(long long x) {
    constexpr long long most = 1'000'000'000; // products of two stay in range
    return x < -most or most < x ? std::nullopt : std::optional(x);
}
std::optional<long long> whole_in(std::string const& digits) {
    auto const x = number_in<double>(digits);
    return x and *x == std::floor(*x) and std::abs(*x) < 1e9 ? in_range(static_cast<long long>(*x)) : std::nullopt;
}

/// The whole number of a node that is no arithmetic operation.
std::optional<long long> whole_leaf(node const& n, vocabulary const& words, indices const& known) {
    if (n.what == kind::number) return whole_in(n.name);
    if (n.what == kind::negative) {
        auto const x = whole_constant(*n.parts[0], words, known);
        return x ? std::optional(-*x) : x;
    }
    if (n.what == kind::power) {
        auto const x = whole_constant(*n.parts[0], words, known), y = whole_constant(*n.parts[1], words, known);
        if (not x or not y or *y < 0 or *y > 30) return {};
        std::optional<long long> z = 1;
        for (long long k = 0; k < *y and z; ++k) z = in_range(*z * *x);
        return z;
    }
    if (n.what != kind::name and n.what != kind::element) return {};
    if (auto const at = known.find(n.name); n.what == kind::name and at != known.end()) return at->second;
    meaning const* const m = words.find(n.name);
    if (m == nullptr or m->is != meaning::role::parameter or (m->size == 0) != (n.what == kind::name)) return {};
    auto const k = n.what == kind::name ? 0 : whole_constant(*n.parts[0], words, known);
    if (not k or *k < 0 or (m->size > 0 and *k >= m->size)) return {};
    return whole_in(words.digits(m->first + static_cast<int>(*k)));
}

} // namespace

std::optional<long long> detail::whole_constant(node const& n, vocabulary const& words, indices const& known) {
    std::vector<node const*> above; // a stack instead of recursion: chains may be long
    node const* at = &n;
    for (; is_arithmetic(at->what); at = at->parts[0].get()) above.push_back(at);
    auto x = whole_leaf(*at, words, known);
    for (; x and not above.empty(); above.pop_back()) {
        auto const y = whole_constant(*above.back()->parts[1], words, known);
        if (not y) return {};
        switch (above.back()->what) {
        case kind::plus:
            x = in_range(*x + *y);
            break;
        case kind::minus:
            x = in_range(*x - *y);
            break;
        case kind::times:
            x = in_range(*x * *y);
            break;
        default:
            x = *y == 0 or *x % *y != 0 ? std::nullopt : std::optional(*x / *y);
        }
    }
    return x;
}

namespace detail {

meaning const& formula_reader::meaning_of(node const& n) const {
    meaning const* const m = words_.find(n.name);
    if (m == nullptr) refuse_name(n);
    if (m->size == 0) refuse(n, "'" + n.name + "' is a number, and has no components");
    return *m;
}
void formula_reader::require_component(node const& n, meaning const& m, long long k) const {
    if (k < 0 or (k >= m.size and m.size > 0))
        refuse(n, "'" + n.name + "' has the components 0 to " + std::to_string(m.size - 1) + ", and here is asked for number " +
                      std::to_string(k));
}
long long formula_reader::whole(node const& n) const {
    auto const x = whole_constant(n, words_, indices_);
    if (not x) refuse(n, "indices are whole numbers below 10^9, made of numbers, parameters and indices of sums, and here is none");
    return *x;
}
bool formula_reader::is_of_indices(node const& n) const {
    return std::all_of(n.parts.begin(), n.parts.end(), [&](auto const& part) {
        return is_condition(part->what) ? is_of_indices(*part) : bool(whole_constant(*part, words_, indices_));
    });
}
void formula_reader::require_arguments(node const& n, std::size_t count) const {
    if (n.parts.size() != count)
        refuse(n, n.name + " takes " + std::to_string(count) + (count == 1 ? " argument" : " arguments") + ", and here are " +
                      std::to_string(n.parts.size()));
}
void formula_reader::refuse_function(node const& n) const {
    refuse(n, words_.find(n.name) != nullptr or indices_.contains(n.name)
                  ? "'" + n.name + "' is no function: a product is written with *, as 2*q, and a component with q[0]"
                  : "there is no function '" + n.name + "': there are " + names_of_functions());
}
void formula_reader::refuse_name(node const& n) const {
    refuse(n, "'" + n.name + "' has no meaning: there are " + (words_.known().empty() ? "numbers alone" : words_.known()));
}
void formula_reader::refuse(node const& n, std::string const& why) const {
    if (n.at.line == 0) error::raise<error::unreadable>(source_, ": ", why);
    error::raise<error::unreadable>(source_, ", line ", n.at.line, ", column ", n.at.column, ": ", why);
}

} // namespace detail

stated::stated(expression what, std::shared_ptr<vocabulary const> words, std::string source)
    : what_(std::move(what)), words_(std::move(words)), source_(std::move(source)) {
    double const time = 1;
    auto const one = [](int) { return 1.0; };
    detail::evaluator<double> everywhere(*words_, source_, time, one, one, true);
    everywhere.value(what_.root());
    operations_ = everywhere.operations();
}
bool stated::reads(meaning::role role) const {
    std::vector<node const*> open{&what_.root()};
    std::unordered_set<node const*> seen;
    while (not open.empty()) {
        node const& n = *open.back();
        open.pop_back();
        if (not seen.insert(&n).second) continue;
        if (n.what == kind::name or n.what == kind::element)
            if (meaning const* m = words_->find(n.name); m != nullptr and m->is == role) return true;
        for (auto const& part : n.parts) open.push_back(part.get());
    }
    return false;
}

} // namespace hilger::text
