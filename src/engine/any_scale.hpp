// SPDX-License-Identifier: BSL-1.0
// A scale of equal steps or of given points, chosen at run time: states of dynamic size are stepped and judged on this one type of scale.
#pragma once

#include <optional>

#include "engine/engine.hpp"
#include "hilger/integrator/rows.hpp"
#include "hilger/integrator/two_ends.hpp"

namespace engine {

/// The scale of equal steps. @throws hilger::error::invalid_scale
template <class S>
hilger::uniform_scale<S> uniform_scale_of(points<S> const& T) {
    if (T.last) return {T.start, T.step, *T.last, T.steps};
    return hilger::uniform(T.start, T.step, T.steps);
}

template <class S>
class any_scale : public hilger::scale_interface<any_scale<S>> {
    using equal_steps = hilger::uniform_scale<S>;
    using given_points = hilger::time_scale<S>;

public:
    using scalar_type = S;
    using root_type = any_scale;
    using domain_type = hilger::domain<hilger::nodes>;
    static constexpr bool is_uniform = false; // by its type, even with equal steps
    static constexpr auto kind() { return hilger::fixed_text("a scale of points"); }

    /// @throws hilger::error::invalid_scale
    explicit any_scale(points<S> const& T) {
        if (T.is_uniform())
            equal_.emplace(uniform_scale_of(T));
        else
            given_.emplace(T.given);
    }
    [[nodiscard]] hilger::index_type steps() const { return equal_ ? equal_->steps() : given_->steps(); }
    [[nodiscard]] S element(hilger::index_type i) const { return equal_ ? equal_->element(i) : given_->element(i); }
    [[nodiscard]] S point(hilger::index_type i) const {
        this->require(i);
        return element(i);
    }
    [[nodiscard]] S step(hilger::index_type i) const { return equal_ ? equal_->h() : given_->step(i); }
    template <class Lambda>
    [[nodiscard]] S between(hilger::index_type i, Lambda const& lambda) const {
        return equal_ ? equal_->between(i, lambda) : given_->between(i, lambda);
    }
    [[nodiscard]] any_scale const& root() const { return *this; }
    [[nodiscard]] domain_type domain() const { return {}; }
    [[nodiscard]] bool same_points(any_scale const& other) const {
        if (equal_ and other.equal_) return equal_->same_points(*other.equal_);
        return given_ and other.given_ and given_->same_points(*other.given_);
    }
    /// A coarser scale of about every second point (hilger/integrator/two_ends.hpp).
    friend any_scale coarsened(any_scale const& T) {
        return T.with([](auto const& scale) { return hilger::detail::coarsened(scale); });
    }
    /// The same start, with steps shortened by the factor `part` (hilger/integrator/rows.hpp).
    friend any_scale shortened(any_scale const& T, S const& part) {
        return T.with([&](auto const& scale) { return hilger::detail::shortened(scale, part); });
    }

private:
    template <class Change>
    any_scale with(Change const& change) const {
        any_scale other = *this;
        if (equal_)
            other.equal_.emplace(change(*equal_));
        else
            other.given_.emplace(change(*given_));
        return other;
    }
    std::optional<equal_steps> equal_;
    std::optional<given_points> given_;
};

} // namespace engine
