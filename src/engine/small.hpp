// SPDX-License-Identifier: BSL-1.0
// Problems of few coordinates: the same steps as of vectors of any size, with states of a size that the compiler knows, which it keeps in
// registers. L is what the traced formula says, there and then.
#pragma once

#include <algorithm>
#include <array>
#include <mutex>
#include <optional>

#include "engine/motions.hpp"

namespace engine {

/// Where in a node's values the derivatives of an L of D coordinates are.
template <int D>
class small_table {
    using V = Eigen::Matrix<double, D, 1>;

public:
    template <class Node>
    explicit small_table(Node const& node) {
        qq_.fill(zero);
        qv_ = vv_ = qq_;
        auto const& at = node.places();
        std::copy(at.by_q.begin(), at.by_q.end(), by_q_.begin());
        std::copy(at.by_v.begin(), at.by_v.end(), by_v_.begin());
        for (auto const& [block, to] : {std::pair{hilger::detail::block_qq, &qq_}, std::pair{hilger::detail::block_qv, &qv_},
                                        std::pair{hilger::detail::block_vv, &vv_}})
            for (auto const& e : at.entries[block]) (*to)[static_cast<std::size_t>(e.column * D + e.row)] = e.place;
        on_ = {at.degree(hilger::detail::block_qq), at.degree(hilger::detail::block_vv), not at.entries[hilger::detail::block_qv].empty()};
    }
    template <class Node>
    void read(Node const& node, hilger::expansion<V>& e) const {
        e.on = on_;
        auto const value = [&](int place) { return place == zero ? 0.0 : node.value(place); };
        for (int k = 0; k < D; ++k) e.by_q(k) = node.value(by_q_[static_cast<std::size_t>(k)]);
        for (int k = 0; k < D; ++k) e.by_v(k) = node.value(by_v_[static_cast<std::size_t>(k)]);
        for (int k = 0; k < D * D; ++k) {
            auto const at = static_cast<std::size_t>(k);
            e.qq.data()[k] = value(qq_[at]);
            e.qv.data()[k] = value(qv_[at]);
            e.vv.data()[k] = value(vv_[at]);
        }
    }

private:
    static constexpr int zero = -1;
    std::array<int, D> by_q_, by_v_;
    std::array<int, static_cast<std::size_t>(D*D)> qq_, qv_, vv_;
    hilger::dependence on_;
};

/// L with its derivatives. For one trajectory at a time: it computes where it has computed before.
template <int D>
class small_lagrangian {
    using V = Eigen::Matrix<double, D, 1>;

public:
    explicit small_lagrangian(free_problem of) : of_(std::move(of)) {}
    [[nodiscard]] hilger::expansion<V> expand(double t, V const& q, V const& v) const {
        if (node_.evaluate(of_, t, q, v, hilger::detail::wanted::with_seconds) or not table_) table_.emplace(node_);
        hilger::expansion<V> e;
        table_->read(node_, e);
        return e;
    }

private:
    free_problem of_;
    mutable hilger::detail::traced_node<free_problem, V> node_;
    mutable std::optional<small_table<D>> table_;
};

/// Walks with small states; all else is asked of the motion of any size.
template <int D, class Embedding, class Flow, class Scale>
class small_motion final : public motion_of<double, Flow, Scale> {
    using any_size = motion_of<double, Flow, Scale>;
    using V = Eigen::Matrix<double, D, 1>;
    using seen = std::function<bool(double const&, vector<double> const&, vector<double> const&)>;

public:
    small_motion(free_problem const& of, Embedding how, Scale T, std::string name)
        : any_size(hilger::embed(of, how), std::move(T), std::move(name)), how_(std::move(how)), lagrangian_(of) {}
    void walk(initial<double> const& from, seen const& keep) const override {
        if (from.q0.size() != D or from.other.size() != D) return any_size::walk(from, keep); // which says so
        auto const flow = hilger::embed(known_at(from), how_);
        V const q0 = from.q0, other = from.other;
        switch (from.is) {
        case second_datum::momentum:
            return pass(flow.along(this->T_, q0, other), keep);
        case second_datum::velocity:
            return pass(flow.along(this->T_, hilger::initial_velocity<V>{q0, other}), keep);
        case second_datum::next_position:
            return pass(flow.along(this->T_, hilger::initial_positions<V>{q0, other}), keep);
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
    [[nodiscard]] small_lagrangian<D> known_at(initial<double> const& from) const {
        std::lock_guard const lock(tracing_);
        if (not is_traced_)
            (void)lagrangian_.expand(this->T_.min(), V(from.q0), V(from.is == second_datum::velocity ? from.other : from.q0));
        is_traced_ = true;
        return lagrangian_;
    }
    Embedding how_;
    small_lagrangian<D> lagrangian_;
    mutable std::mutex tracing_;
    mutable bool is_traced_ = false;
};

/// A motion of the problem, with small states where it is small, free and on a uniform scale.
template <class Mechanics, class Embedding>
made embedded_small(Mechanics const& mechanics, Embedding const& how, points<double> const& T, std::string const& name) {
    if constexpr (std::same_as<Mechanics, free_problem>)
        if (T.is_uniform()) {
            auto const with = [&]<int D>(std::integral_constant<int, D>) -> made {
                auto const scale = hilger::uniform(T.start, T.step, T.steps);
                using flow = decltype(hilger::embed(mechanics, how));
                return std::make_unique<small_motion<D, Embedding, flow, std::remove_cvref_t<decltype(scale)>>>(mechanics, how, scale,
                                                                                                                name);
            };
            switch (mechanics.lagrangian.formula().words().dimension()) {
            case 1:
                return with(std::integral_constant<int, 1>{});
            case 2:
                return with(std::integral_constant<int, 2>{});
            case 3:
                return with(std::integral_constant<int, 3>{});
            default:
                break;
            }
        }
    return on_scale(hilger::embed(mechanics, how), T, name);
}

} // namespace engine
