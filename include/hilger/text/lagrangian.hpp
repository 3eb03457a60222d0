// SPDX-License-Identifier: BSL-1.0
// Lagrangians and forces in text, as callables of states: they are derived, stepped and printed like all others.
//   auto words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 1}});
//   auto const L = lagrangian{text::lagrangian_in("v[0]^2/2 - (1 - cos(q[0]))", words)};
//   embed(L, mid_point).along(T, q0, p0)            states are vectors of dynamic size
#pragma once

#include <algorithm>
#include <optional>

#include "hilger/differentiation/traced/trace.hpp"
#include "hilger/error.hpp"
#include "hilger/text/time_transformation.hpp"

namespace hilger::text {

namespace detail {

/// f in the numbers of a state: traced ones, or jets without variables, as jets of dynamic states have none
/// (differentiation/derivatives.hpp).
template <class Formula, class T, class Q, class V>
auto value_at_state(Formula const& f, T const& t, Q const& q, V const& v) {
    using X = plain_t<decltype(q(0) * v(0))>;
    if constexpr (is_jet<X>) {
        static_assert(X::count == 1 and Q::SizeAtCompileTime == Eigen::Dynamic, "states of formulas in text are vectors of dynamic size");
        return X(f.value(
            X(t).value, [&](int k) { return X(q(k)).value; }, [&](int k) { return X(v(k)).value; }));
    } else
        return f.value(X(t), q, v);
}

} // namespace detail

/// L(t, q, v) given by a formula. @throws error::mismatch if a state has another dimension
class stated_lagrangian {
public:
    static constexpr bool is_generic_in_time = true;
    explicit stated_lagrangian(stated of) : of_(std::move(of)) {}
    template <class T, class Q, class V>
        requires requires(Q const& q) { q(0); }
    auto operator()(T const& t, Q const& q, V const& v) const {
        if (int const d = of_.words().dimension(); d != q.size())
            error::raise<error::mismatch>(of_.source(), " has ", d, " coordinates, and the state has ", q.size());
        if (in_time_) return detail::value_at_state(*in_time_, t, q, v);
        return detail::value_at_state(of_, t, q, v);
    }
    /// g(q) (L(q, q'/g(q)) + E), in the time tau with dt = g(q) dtau (variational/time_transformation.hpp). `formula` remains that of L.
    [[nodiscard]] stated_lagrangian in_time(stated_rate rate, stated energy) const {
        stated_lagrangian made(of_);
        made.in_time_.emplace(formula_in_time{of_, std::move(rate), std::move(energy)});
        return made;
    }
    [[nodiscard]] stated const& formula() const { return of_; }
    [[nodiscard]] bool reads_time() const { return of_.reads(meaning::role::time); }
    /// Its switching times in ]a, b[ (text/stated.hpp): an accurate solution has points there.
    template <class S>
    [[nodiscard]] std::vector<S> switching_times(S const& a, S const& b) const {
        return text::switching_times<S>({of_}, a, b);
    }
    /// The cache of its traced formulas.
    [[nodiscard]] hilger::detail::kept_formulas& kept() const { return *kept_; }

private:
    stated of_;
    std::optional<formula_in_time> in_time_;
    std::shared_ptr<hilger::detail::kept_formulas> kept_ = std::make_shared<hilger::detail::kept_formulas>();
};

/// f(t, q, v) given by a formula for each component.
class stated_force {
public:
    static constexpr bool is_generic_in_time = true;
    /// @throws error::mismatch if there is not one formula for each coordinate
    explicit stated_force(std::vector<stated> components) : of_(std::move(components)) {
        if (of_.empty() or static_cast<int>(of_.size()) != of_.front().words().dimension())
            error::raise<error::mismatch>("a force has one formula for each coordinate, and here are ", of_.size(), " for ",
                                          of_.empty() ? 0 : of_.front().words().dimension());
    }
    template <class T, class Q, class V>
        requires requires(Q const& q) { q(0); }
    auto operator()(T const& t, Q const& q, V const& v) const {
        Eigen::Matrix<plain_t<decltype(q(0) * v(0))>, Eigen::Dynamic, 1> f(static_cast<index_type>(of_.size()));
        for (std::size_t k = 0; k < of_.size(); ++k) f(static_cast<index_type>(k)) = detail::value_at_state(of_[k], t, q, v);
        return f;
    }
    [[nodiscard]] bool reads_time() const {
        return std::any_of(of_.begin(), of_.end(), [](stated const& f) { return f.reads(meaning::role::time); });
    }
    /// The switching times of its components in ]a, b[.
    template <class S>
    [[nodiscard]] std::vector<S> switching_times(S const& a, S const& b) const {
        return text::switching_times<S>(of_, a, b);
    }
    [[nodiscard]] std::vector<stated> const& formulas() const { return of_; }

private:
    std::vector<stated> of_;
};

/// The Lagrangian in a text; `source` is its name in errors. @throws error::unreadable
inline stated_lagrangian lagrangian_in(std::string_view formula, std::shared_ptr<vocabulary const> words, std::string const& source = "L") {
    return stated_lagrangian(stated(read(formula, source), std::move(words), source));
}

} // namespace hilger::text
