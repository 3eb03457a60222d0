// SPDX-License-Identifier: BSL-1.0
// A formula in text with what its names stand for.
#pragma once

#include <unordered_set>

#include "hilger/text/evaluate.hpp"

namespace hilger::text {

/// A formula and what its names stand for. Copies share both.
class stated {
public:
    /// @throws error::unreadable with the place of a name that nothing is known of, of a vector without an index, an index outside of its
    ///         vector, a function with a wrong number of arguments
    stated(expression what, std::shared_ptr<vocabulary const> words, std::string source);

    /// The value at (t, q, v), states given by component: q(k) is component k. With `everywhere` both parts of choices are evaluated.
    template <class T, class Q, class V>
    T value(T const& t, Q const& q, V const& v, bool everywhere = false) const;
    [[nodiscard]] vocabulary const& words() const { return *words_; }
    [[nodiscard]] expression const& formula() const { return what_; }
    /// Whether one of the names in it stands for the time, or for velocities.
    [[nodiscard]] bool reads(meaning::role role) const;
    /// Whether it has other values at other states.
    [[nodiscard]] bool reads_state() const {
        return reads(meaning::role::time) or reads(meaning::role::position) or reads(meaning::role::velocity);
    }
    /// The value of one that does not. @throws error::unreadable where S has no such number, as a root in rationals or 1/0
    template <class S>
    [[nodiscard]] S number() const {
        auto const none = [](int) { return S(0); };
        try {
            return value(S(0), none, none);
        } catch (std::overflow_error const&) { // of rationals
            error::raise<error::unreadable>(source_, ": a division by zero");
        }
    }
    [[nodiscard]] std::string const& source() const { return source_; }
    /// How many operations a value takes, and numbers and names it reads: to know what is too long to be shown.
    [[nodiscard]] long long operations() const { return operations_; }

private:
    expression what_;
    std::shared_ptr<vocabulary const> words_;
    std::string source_;
    long long operations_ = 0;
};

template <class T, class Q, class V>
T stated::value(T const& t, Q const& q, V const& v, bool everywhere) const {
    return detail::evaluator<T, Q, V>(*words_, source_, t, q, v, everywhere).value(what_.root());
}

inline stated::stated(expression what, std::shared_ptr<vocabulary const> words, std::string source)
    : what_(std::move(what)), words_(std::move(words)), source_(std::move(source)) {
    double const time = 1;
    auto const one = [](int) { return 1.0; };
    detail::evaluator everywhere(*words_, source_, time, one, one, true);
    everywhere.value(what_.root());
    operations_ = everywhere.operations();
}
inline bool stated::reads(meaning::role role) const {
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
