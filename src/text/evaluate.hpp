// SPDX-License-Identifier: BSL-1.0
// Evaluates a formula in any number type, traced numbers included (differentiation/traced/traced.hpp). Each type is compiled once
// (in_numbers.hpp).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <unordered_map>

#include "hilger/text/stated.hpp"
#include "text/formula_reader.hpp"
#include "text/functions.hpp"

namespace hilger::text {

namespace detail {

/// A limit above every sensible sum.
inline constexpr long long most_terms = 2'000'000;

template <class T>
class evaluator : formula_reader {
    using S = decltype(number_of(std::declval<T>()));

public:
    /// `everywhere`: evaluates both branches of choices that depend on the state, to check that they have a meaning.
    evaluator(vocabulary const& words, std::string const& source, T const& t, components_view<T> q, components_view<T> v, bool everywhere)
        : formula_reader(words, source), t_(t), q_(q), v_(v), everywhere_(everywhere) {}

    T value(node const& n) {
        // down the left side of a + b + c + ..., and up again
        std::vector<node const*> above;
        node const* at = &n;
        for (; is_arithmetic(at->what); at = at->parts[0].get()) {
            if (at != &n and indices_.empty() and values_.contains(at)) break;
            above.push_back(at);
        }
        T x = value_of_other(*at);
        for (; not above.empty(); above.pop_back()) {
            node const& here = *above.back();
            T const y = value(*here.parts[1]);
            x = here.what == kind::plus ? T(x + y) : here.what == kind::minus ? T(x - y) : here.what == kind::times ? T(x * y) : T(x / y);
            keep(here, x);
            ++operations_;
        }
        return x;
    }
    /// The number of operations so far.
    [[nodiscard]] long long operations() const { return operations_; }

private:
    /// The values of both parts, the first one first.
    std::pair<T, T> both_values(node const& n) { return {value(*n.parts[0]), value(*n.parts[1])}; }
    /// Values computed outside of all sums are valid everywhere: shared parts are computed once.
    void keep(node const& n, T const& x) {
        if (indices_.empty()) values_.emplace(&n, x);
    }
    T value_of_other(node const& n) {
        if (indices_.empty())
            if (auto const at = values_.find(&n); at != values_.end()) return at->second;
        T const x = computed(n);
        keep(n, x);
        return x;
    }
    T computed(node const& n) {
        ++operations_;
        switch (n.what) {
        case kind::number:
            return constant(n, n.name);
        case kind::name:
            return named(n);
        case kind::element:
            return component(n, meaning_of(n), whole(*n.parts[0]));
        case kind::negative:
            return T(-value(*n.parts[0]));
        case kind::power:
            return power(n);
        case kind::choice:
            return choice(n);
        case kind::sum:
            return sum(n);
        case kind::call:
            return call(n);
        default:
            refuse(n, "a number was expected, and here is a condition, which belongs into if(condition, a, b)");
        }
    }
    T named(node const& n) {
        if (auto const at = indices_.find(n.name); at != indices_.end()) return T(S(at->second));
        if (meaning const* m = words_.find(n.name)) {
            if (m->size > 0)
                refuse(n, "'" + n.name + "' has " + std::to_string(m->size) + " components: " + n.name + "[0], dot(" + n.name + ", " +
                              n.name + "), norm(" + n.name + ")");
            return component(n, *m, 0);
        }
        if (n.name == "pi") {
            if constexpr (std::numeric_limits<S>::is_exact)
                refuse(n, "pi is no rational number");
            else {
                using std::acos;
                return T(S(acos(S(-1))));
            }
        }
        refuse_name(n);
    }
    T component(node const& n, meaning const& m, long long k) {
        require_component(n, m, k);
        int const at = m.first + static_cast<int>(k);
        switch (m.is) {
        case meaning::role::time:
            return t_;
        case meaning::role::position:
            return q_(at);
        case meaning::role::velocity:
            return v_(at);
        default:
            return constant(n, words_.digits(at));
        }
    }
    T constant(node const& n, std::string const& digits) {
        auto const x = number_in<S>(digits);
        if (not x) refuse(n, "'" + digits + "' is no number of this scalar");
        return T(*x);
    }
    T sum(node const& n) {
        long long const first = whole(*n.parts[0]), last = whole(*n.parts[1]);
        if (words_.find(n.name) != nullptr or indices_.contains(n.name))
            refuse(n, "the index of a sum has a name of its own, and '" + n.name + "' is another thing already");
        T total(0);
        for (long long i = first; i <= last; ++i) {
            if (++terms_ > most_terms) refuse(n, "sums have at most " + std::to_string(most_terms) + " terms together");
            indices_[n.name] = i;
            T const x = value(*n.parts[2]);
            total = i == first ? x : T(total + x);
        }
        indices_.erase(n.name);
        return total;
    }
    T choice(node const& n) {
        bool const first = holds(*n.parts[0]);
        if (everywhere_ and not is_of_indices(*n.parts[0])) value(*n.parts[first ? 2 : 1]);
        return value(*n.parts[first ? 1 : 2]);
    }
    bool holds(node const& n) {
        switch (n.what) {
        case kind::less:
        case kind::less_or_equal:
        case kind::equal: {
            auto const [x, y] = both_values(n);
            return compared<T>(n.what == kind::less ? x < y : n.what == kind::equal ? x == y : x <= y);
        }
        case kind::both: {
            bool const first = holds(*n.parts[0]);
            return (first or everywhere_) and holds(*n.parts[1]) and first;
        }
        case kind::either: {
            bool const first = holds(*n.parts[0]);
            return (first and not everywhere_) or holds(*n.parts[1]) or first;
        }
        case kind::not_so:
            return not holds(*n.parts[0]);
        default:
            refuse(n, "a condition was expected, as q < 0, and here is a number");
        }
    }
    T call(node const& n) {
        if (n.name == "dot" or n.name == "norm") {
            require_arguments(n, n.name == "dot" ? 2 : 1);
            node const &x = *n.parts.front(), &y = *n.parts.back();
            for (node const* of : {&x, &y})
                if (of->what != kind::name) refuse(*of, n.name + " takes names of vectors, as in dot(q, v)");
            meaning const &a = meaning_of(x), &b = meaning_of(y);
            if (a.size != b.size)
                refuse(n, "dot takes vectors of one length, and these have " + std::to_string(a.size) + " and " + std::to_string(b.size) +
                              " components");
            T total = component(x, a, 0) * component(y, b, 0);
            for (int k = 1; k < a.size; ++k) total = total + component(x, a, k) * component(y, b, k);
            return n.name == "dot" ? total : elementary(n, "sqrt", total);
        }
        if (n.name == "pow") {
            require_arguments(n, 2);
            return power(n);
        }
        if (n.name == "min" or n.name == "max" or n.name == "atan2" or n.name == "hypot") {
            require_arguments(n, 2);
            auto const [x, y] = both_values(n);
            return n.name == "min" ? least_of(x, y) : n.name == "max" ? most_of(x, y) : elementary(n, n.name, x, y);
        }
        if (std::find(functions_of_one.begin(), functions_of_one.end(), n.name) == functions_of_one.end()) refuse_function(n);
        require_arguments(n, 1);
        T const x = value(*n.parts[0]);
        return n.name == "abs" ? absolute(x) : elementary(n, n.name, x);
    }
    T power(node const& n) {
        constexpr bool exact = std::numeric_limits<S>::is_exact;
        if (auto const exponent = whole_constant(*n.parts[1], words_, indices_)) {
            constexpr long long most = 1000; // bounds the memory of one number's digits
            if (exact and (*exponent < -most or most < *exponent))
                refuse(n, "in rationals exponents are at most " + std::to_string(most) + ", and here is " + std::to_string(*exponent));
            return whole_power(value(*n.parts[0]), *exponent);
        }
        if constexpr (exact)
            refuse(n, "in rationals exponents are whole numbers");
        else {
            using std::pow;
            auto const [x, y] = both_values(n);
            return T(pow(x, y));
        }
    }
    template <class... X>
    T elementary(node const& n, std::string const& name, X const&... x) {
        if constexpr (std::numeric_limits<S>::is_exact)
            refuse(n, name + " has no exact value in rationals");
        else
            return text::elementary(name, x...);
    }

    T const& t_;
    components_view<T> q_, v_;
    std::unordered_map<node const*, T> values_;
    bool everywhere_;
    long long terms_ = 0, operations_ = 0;
};

extern template class evaluator<double>;

} // namespace detail

template <class T>
T stated::evaluate(T const& t, components_view<T> q, components_view<T> v, bool everywhere) const {
    return detail::evaluator<T>(*words_, source_, t, q, v, everywhere).value(what_.root());
}
template <class S>
S stated::number() const {
    auto const none = [](int) { return S(0); };
    try {
        return value(S(0), none, none);
    } catch (std::overflow_error const&) { // thrown by rationals
        error::raise<error::unreadable>(source_, ": a division by zero");
    }
}

} // namespace hilger::text
