// SPDX-License-Identifier: BSL-1.0
// Problems of few coordinates: the same steps as of vectors of any size, with states of a size that the compiler knows.
#pragma once

#include <mutex>

#include "engine/motions.hpp"
#include "engine/small_lagrangian.hpp"

namespace engine {

/// Walks with small states, by the flow that Make makes of a Lagrangian; all else is asked of the motion of any size, which may be derived
/// of other operators with the same steps.
template <int D, class Make, class Flow, class Scale>
class small_motion final : public motion_of<double, Flow, Scale> {
    using any_size = motion_of<double, Flow, Scale>;
    using V = Eigen::Matrix<double, D, 1>;
    using seen = std::function<bool(double const&, vector<double> const&, vector<double> const&)>;

public:
    small_motion(Flow of_any_size, Make make, Scale T, std::string name)
        : any_size(std::move(of_any_size), std::move(T), std::move(name)), make_(std::move(make)),
          lagrangian_(this->flow_.mechanics().lagrangian) {}
    void walk(initial<double> const& from, seen const& keep) const override {
        if (from.q0.size() != D or from.other.size() != D) return any_size::walk(from, keep); // which says so
        auto const flow = make_(known_at(from));
        V const q0 = from.q0, other = from.other;
        switch (from.is) {
        case second_datum::momentum:
            return pass(flow.along(this->T_, q0, other), keep);
        case second_datum::velocity:
            return pass(flow.along(this->T_, hilger::initial_velocity<V>{q0, other}), keep);
        case second_datum::next_position:
            if constexpr (starts_from_two_positions<Flow>)
                return pass(flow.along(this->T_, hilger::initial_positions<V>{q0, other}), keep);
            else
                return any_size::walk(from, keep);
        }
    }

private:
    template <class Path>
    static void pass(Path const& path, seen const& keep) {
        vector<double> q(D), p(D);
        for (auto const& x : path) {
            q = x.q;
            p = x.p;
            if (not keep(x.t, q, p)) return;
        }
    }
    /// The Lagrangian for one walk. It is traced at the first one, and others begin with what is known.
    [[nodiscard]] small_lagrangian<double, D> known_at(initial<double> const& from) const {
        std::lock_guard const lock(tracing_);
        if (not is_traced_)
            (void)lagrangian_.expand(this->T_.min(), V(from.q0), V(from.is == second_datum::velocity ? from.other : from.q0));
        is_traced_ = true;
        return lagrangian_;
    }
    Make make_;
    small_lagrangian<double, D> lagrangian_;
    mutable std::mutex tracing_;
    mutable bool is_traced_ = false;
};

/// The motion of a flow of the problem, with small states, in steps of make(L), where it is small, free and on a uniform scale.
template <class Mechanics, class Flow, class Make>
made embedded_small(Mechanics const& mechanics, Flow const& flow, Make const& make, points<double> const& T, std::string const& name) {
    if constexpr (std::same_as<Mechanics, free_problem>)
        if (T.is_uniform())
            return with_small_size(mechanics.lagrangian.formula().words().dimension(), [&]<int D>(std::integral_constant<int, D>) -> made {
                if constexpr (D > 0) {
                    auto const scale = hilger::uniform(T.start, T.step, T.steps);
                    return std::make_unique<small_motion<D, Make, Flow, std::remove_cvref_t<decltype(scale)>>>(flow, make, scale, name);
                } else
                    return on_scale(flow, T, name);
            });
    return on_scale(flow, T, name);
}
template <class Mechanics, class Make>
made embedded_small(Mechanics const& mechanics, Make const& make, points<double> const& T, std::string const& name) {
    return embedded_small(mechanics, make(mechanics), make, T, name);
}
/// The same of an embedding.
template <class Mechanics, class Embedding>
made embedded_small_by(Mechanics const& mechanics, Embedding const& how, points<double> const& T, std::string const& name) {
    auto const make = [how](auto const& L) { return hilger::embed(L, how); };
    return embedded_small(mechanics, make, T, name);
}

} // namespace engine
