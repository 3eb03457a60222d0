// SPDX-License-Identifier: BSL-1.0
// A Lagrangian, or a sum of several whose parts are read in different ways.
#pragma once

#include <algorithm>

#include "engine/motions.hpp"

namespace engine {

/// As a function it is the sum of its parts: what the momentum, the energy and the slopes are of.
class summed_lagrangian {
public:
    static constexpr bool is_generic_in_time = true;
    explicit summed_lagrangian(problem const& what) : parts_{{what.lagrangian, {}}} {
        for (auto const& part : what.besides) parts_.push_back({part.lagrangian, {}});
    }
    template <class T, class Q, class V>
        requires requires(Q const& q) { q(0); }
    auto operator()(T const& t, Q const& q, V const& v) const {
        auto sum = parts_.front().lagrangian(t, q, v);
        for (std::size_t k = 1; k < parts_.size(); ++k) sum = sum + parts_[k].lagrangian(t, q, v);
        return sum;
    }
    [[nodiscard]] bool reads_time() const {
        return std::any_of(parts_.begin(), parts_.end(), [](auto const& part) { return part.lagrangian.reads_time(); });
    }
    [[nodiscard]] hilger::text::stated const& formula() const { return parts_.front().lagrangian.formula(); }
    [[nodiscard]] std::vector<free_problem> const& parts() const { return parts_; }

private:
    std::vector<free_problem> parts_;
};

} // namespace engine

namespace hilger {

/// The force is beside the first Lagrangian, and read where that is.
template <class Force>
struct problem<engine::summed_lagrangian, Force> {
    engine::summed_lagrangian lagrangian;
    [[no_unique_address]] Force force;
    problem<text::stated_lagrangian, Force> first;
    problem(engine::summed_lagrangian L, Force f)
        : lagrangian(std::move(L)), force(std::move(f)), first{lagrangian.parts().front().lagrangian, force} {}
};

namespace detail {

/// The nodes ask for one Lagrangian each, and who asks for the whole for their sum.
template <class Force, class V, bool Traces>
class given<problem<engine::summed_lagrangian, Force>, V, Traces> final
    : public given_whole<problem<engine::summed_lagrangian, Force>, V, Traces> {
    using what_type = problem<engine::summed_lagrangian, Force>;

public:
    explicit given(what_type const& what) : given_whole<what_type, V, Traces>(what), first_(what.first) {
        auto const& parts = what.lagrangian.parts();
        others_.reserve(parts.size() - 1);
        for (std::size_t k = 1; k < parts.size(); ++k) others_.emplace_back(parts[k]);
    }
    [[nodiscard]] given_problem<V> const& part(int k) const override {
        if (k == 0) return first_;
        return others_[static_cast<std::size_t>(k) - 1];
    }

private:
    given<problem<text::stated_lagrangian, Force>, V> first_;
    std::vector<given<engine::free_problem, V>> others_;
};

} // namespace detail
} // namespace hilger
