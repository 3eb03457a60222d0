// SPDX-License-Identifier: BSL-1.0
// Problems of few coordinates: the same steps as for vectors of dynamic size, with states of static size.
#pragma once

#include <mutex>

#include "engine/motions.hpp"
#include "engine/small_lagrangian.hpp"

namespace engine {

/// Begins with states of D coordinates, by the flow make(L).
template <int D, class Make>
class small_beginning {
    using V = Eigen::Matrix<double, D, 1>;

public:
    small_beginning(hilger::text::stated_lagrangian L, Make make, hilger::uniform_scale<double> T)
        : lagrangian_(std::move(L)), make_(std::move(make)), T_(std::move(T)) {}
    /// @returns nothing for other sizes, and for two positions that begin no step: the flow of dynamic size reports these
    [[nodiscard]] std::unique_ptr<cursor<double>> operator()(initial<double> const& from) const {
        if (from.q0.size() != D or from.other.size() != D) return nullptr;
        auto const flow = make_(known_at(from));
        V const q0 = from.q0, other = from.other;
        if (from.is == second_datum::momentum) return cursor_along<double>(flow.along(T_, q0, other));
        if (from.is == second_datum::velocity) return cursor_along<double>(flow.along(T_, hilger::initial_velocity<V>{q0, other}));
        if constexpr (starts_from_two_positions<std::remove_const_t<decltype(flow)>>)
            return cursor_along<double>(flow.along(T_, hilger::initial_positions<V>{q0, other}));
        return nullptr;
    }

private:
    /// The Lagrangian for one walk, traced at the first one.
    [[nodiscard]] small_lagrangian<double, D> known_at(initial<double> const& from) const {
        std::lock_guard const lock(tracing_);
        if (not is_traced_) (void)lagrangian_.expand(T_.min(), V(from.q0), V(from.is == second_datum::velocity ? from.other : from.q0));
        is_traced_ = true;
        return lagrangian_;
    }
    small_lagrangian<double, D> lagrangian_;
    Make make_;
    hilger::uniform_scale<double> T_;
    mutable std::mutex tracing_;
    mutable bool is_traced_ = false;
};

/// The beginning of a small problem with one Lagrangian and no force on a uniform scale; nothing for any other.
template <class Make>
beginning_by<double> begin_small(problem const& what, points<double> const& T, Make const& make) {
    if (what.force or not what.besides.empty() or not T.is_uniform()) return {};
    return with_small_size(
        what.lagrangian.formula().words().dimension(), [&]<int D>(std::integral_constant<int, D>) -> beginning_by<double> {
            if constexpr (D == 0)
                return {};
            else {
                auto const begin = std::make_shared<small_beginning<D, Make>>(what.lagrangian, make, uniform_scale_of(T));
                return [begin](initial<double> const& from) { return (*begin)(from); };
            }
        });
}
/// The motion by the flow make(mechanics), with small states if possible.
template <class Make>
made motion_by_making(problem const& what, std::string const& method, points<double> const& T, Make const& make) {
    return with_mechanics(what, [&](auto const& mechanics) { return motion_by(make(mechanics), T, method, begin_small(what, T, make)); });
}

} // namespace engine
