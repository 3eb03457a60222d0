// SPDX-License-Identifier: BSL-1.0
// A Lagrangian, or a sum of several whose parts have different embeddings.
#pragma once

#include <algorithm>

#include "engine/motions.hpp"

namespace engine {

/// As a function it is the sum of its parts, for the momentum, the energy and the slopes.
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

/// The force acts beside the first Lagrangian, with its embedding.
template <class Force>
struct problem<engine::summed_lagrangian, Force> {
    engine::summed_lagrangian lagrangian;
    [[no_unique_address]] Force force;
    problem<text::stated_lagrangian, Force> first;
    problem(engine::summed_lagrangian L, Force f)
        : lagrangian(std::move(L)), force(std::move(f)), first{lagrangian.parts().front().lagrangian, force} {}
};

namespace detail {

/// Each node evaluates its own Lagrangian; the whole is their sum.
template <class Force, class V>
struct problems_at_nodes<problem<engine::summed_lagrangian, Force>, V> {
    given<problem<text::stated_lagrangian, Force>, V> first;
    std::vector<given<engine::free_problem, V>> others;
    explicit problems_at_nodes(problem<engine::summed_lagrangian, Force> const& what) : first(what.first) {
        auto const& parts = what.lagrangian.parts();
        others.reserve(parts.size() - 1);
        for (std::size_t k = 1; k < parts.size(); ++k) others.emplace_back(parts[k]);
    }
    given_problem<V> const* operator()(int k) const {
        if (k == 0) return &first;
        return &others[static_cast<std::size_t>(k) - 1];
    }
};

} // namespace detail
} // namespace hilger
