// SPDX-License-Identifier: BSL-1.0
// Derivatives of a Lagrangian at a node of a step as a list of values and of their places, whoever computes them.
#pragma once

#include <vector>

#include "hilger/differentiation/traced/trace.hpp"

namespace hilger::detail {

/// What of a node is computed.
enum class wanted { first_order, with_seconds, momenta_only, forces_only };

/// The values of derivatives, at the places that Derived says: by_q and by_v of d components, and the entries of the second derivatives
/// that are not zero.
template <class S, class Derived>
class node_values {
public:
    [[nodiscard]] S const& value(int place) const { return values_[static_cast<std::size_t>(place)]; }
    [[nodiscard]] std::vector<S> const& values() const { return values_; }
    [[nodiscard]] S const& by_q(int k) const { return value(self().places().by_q[static_cast<std::size_t>(k)]); }
    [[nodiscard]] S const& by_v(int k) const { return value(self().places().by_v[static_cast<std::size_t>(k)]); }

    /// to = c dL/dq, force included; to += a dL/dq + b dL/dv
    template <class X>
    void put_by_q(S const& c, X& to) const {
        S const* const x = values_.data();
        int const* const place = self().places().by_q.data();
        for (int k = 0, d = static_cast<int>(self().places().by_q.size()); k < d; ++k) to(k) = c * x[place[k]];
    }
    template <class X>
    void add_both(S const& a, S const& b, X& to) const {
        S const* const x = values_.data();
        int const *const place = self().places().by_q.data(), *const other = self().places().by_v.data();
        for (int k = 0, d = static_cast<int>(self().places().by_q.size()); k < d; ++k) to(k) = to(k) + a * x[place[k]] + b * x[other[k]];
    }
    /// to += c dL/dq, force included; to += c dL/dv
    template <class X>
    void add_by_q(S const& c, X& to) const {
        add(self().places().by_q, c, to);
    }
    template <class X>
    void add_by_v(S const& c, X& to) const {
        add(self().places().by_v, c, to);
    }

protected:
    std::vector<S> values_;

private:
    [[nodiscard]] Derived const& self() const { return static_cast<Derived const&>(*this); }
    template <class X>
    void add(std::vector<int> const& from, S const& c, X& to) const {
        S const* const x = values_.data();
        int const* const place = from.data();
        for (int k = 0, d = static_cast<int>(from.size()); k < d; ++k) to(k) = to(k) + c * x[place[k]];
    }
};

} // namespace hilger::detail
