// SPDX-License-Identifier: BSL-1.0
// Derivatives of a Lagrangian at a node of a step as a list of values and of their places, whoever computes them.
#pragma once

#include <memory>
#include <vector>

#include "hilger/differentiation/traced/trace.hpp"

namespace hilger::detail {

/// What of a node is computed.
enum class wanted { first_order, with_seconds, momenta_only, forces_only };

/// The values of derivatives, at their places: by_q and by_v of d components, and the entries of the second derivatives that are not zero.
template <class S>
class node_values {
public:
    /// Of what was evaluated.
    [[nodiscard]] derivative_places const& places() const { return *places_; }
    /// Whether the formula holds where comparisons come out as they did.
    [[nodiscard]] bool has_branches() const { return has_branches_; }
    [[nodiscard]] S const& value(int place) const { return values_[static_cast<std::size_t>(place)]; }
    [[nodiscard]] std::vector<S> const& values() const { return values_; }
    [[nodiscard]] S const& by_q(int k) const { return value(places_->by_q[static_cast<std::size_t>(k)]); }
    [[nodiscard]] S const& by_v(int k) const { return value(places_->by_v[static_cast<std::size_t>(k)]); }

    /// to = c dL/dq, force included; to += a dL/dq + b dL/dv
    template <class X>
    void put_by_q(S const& c, X& to) const {
        put(places_->by_q, places_->by_q_whole, to, [&](auto const&, auto const& x) { return c * x; });
    }
    template <class X>
    void add_both(S const& a, S const& b, X& to) const {
        if (can_add_whole(to)) {
            add_by_q(a, to);
            add_by_v(b, to);
            return;
        }
        S const* const x = values_.data();
        int const *const place = places_->by_q.data(), *const other = places_->by_v.data();
        for (int k = 0, d = static_cast<int>(places_->by_q.size()); k < d; ++k) to(k) = to(k) + a * x[place[k]] + b * x[other[k]];
    }
    /// to += c dL/dq, force included; to += c dL/dv
    template <class X>
    void add_by_q(S const& c, X& to) const {
        put(places_->by_q, places_->by_q_whole, to, [&](auto const& before, auto const& x) { return before + c * x; });
    }
    template <class X>
    void add_by_v(S const& c, X& to) const {
        put(places_->by_v, places_->by_v_whole, to, [&](auto const& before, auto const& x) { return before + c * x; });
    }

protected:
    std::vector<S> values_;
    std::shared_ptr<derivative_places const> places_;
    bool has_branches_ = false;

private:
    using whole = Eigen::Map<Eigen::Matrix<S, Eigen::Dynamic, 1> const>;
    template <class X>
    static constexpr bool stands_together = std::is_base_of_v<Eigen::PlainObjectBase<X>, X>;
    template <class X>
    [[nodiscard]] bool can_add_whole(X const&) const {
        return stands_together<X> and not places_->by_q_whole.empty() and not places_->by_v_whole.empty();
    }
    /// to = use(to, x), component by component, where x is at these places: as vectors where that makes fewer of them.
    template <class X, class Use>
    void put(std::vector<int> const& places, std::vector<derivative_places::stretch> const& stretches, X& to, Use const& use) const {
        S const* const x = values_.data();
        if constexpr (stands_together<X>)
            if (not stretches.empty()) {
                for (auto const& e : stretches) {
                    auto&& part = to.segment(e.component, e.count);
                    part = use(part, whole(x + e.place, e.count));
                }
                return;
            }
        int const* const place = places.data();
        for (int k = 0, d = static_cast<int>(places.size()); k < d; ++k) to(k) = use(to(k), x[place[k]]);
    }
};

} // namespace hilger::detail
