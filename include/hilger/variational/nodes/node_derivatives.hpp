// SPDX-License-Identifier: BSL-1.0
// The derivatives of a Lagrangian, and of a force, at nodes: by jets or the callable's own derivatives, else traced. A step has a node of
// its own; evaluations without steps keep their formula here: tracing takes as long as some hundred evaluations.
#pragma once

#include <atomic>
#include <memory>

#include "hilger/variational/nodes/node.hpp"

namespace hilger::detail {

/// The node type of states V.
template <class V>
using node_derivatives = std::conditional_t<is_traced_state<V>, traced_node<V>, asked_node<V>>;

/// A node for any arguments and states; its formula is traced on first use and shared by copies. A thread that finds it in use traces anew.
template <class Problem>
class kept_derivatives {
    struct kept {
        std::atomic_flag is_taken;
        void const* states = nullptr; ///< kind of the node's states, with their dimension
        int dimension = 0;
        std::shared_ptr<void> node;
    };
    struct taking {
        std::atomic_flag& flag;
        bool const is_mine = not flag.test_and_set(std::memory_order_acquire);
        ~taking() {
            if (is_mine) flag.clear(std::memory_order_release);
        }
    };
    template <class V>
    static constexpr char kind_of_states = 0;

public:
    explicit kept_derivatives(Problem what) : what_(std::move(what)) {}
    [[nodiscard]] Problem const& what() const { return what_; }
    /// Returns use(node) with the derivatives `which` at (t, q, v), for traced states.
    template <class S, class V, class Use>
    auto at(S const& t, V const& q, V const& v, wanted which, Use const& use) const {
        using node = traced_node<V>;
        given<Problem, V, is_traced_at<Problem, V>> const what(what_); // a formula, which is asked for all at once
        taking const here{kept_->is_taken};
        if (not here.is_mine) {
            node own;
            own.evaluate(what, t, q, v, which);
            return use(std::as_const(own));
        }
        if (int const d = shape<V>::dimension(q); kept_->states != &kind_of_states<V> or kept_->dimension != d) {
            kept_->node = std::make_shared<node>();
            kept_->states = &kind_of_states<V>;
            kept_->dimension = d;
        }
        auto& known = *static_cast<node*>(kept_->node.get());
        known.evaluate(what, t, q, v, which);
        return use(std::as_const(known));
    }
    /// dL/dq, with the force, and dL/dv, for states of any kind. The first argument numbers the Lagrangians of a sum.
    template <class S, class V>
    std::pair<V, V> gradients(int, S const& t, V const& q, V const& v) const {
        if constexpr (is_traced_at<Problem, V>)
            return at(t, q, v, wanted::first_order, [&](auto const& node) {
                return std::pair(vector_like(q, [&](int k) { return node.by_q(k); }), vector_like(q, [&](int k) { return node.by_v(k); }));
            });
        else {
            V by_q = zero_like(q), by_v = by_q;
            gradients_at(what_, t, q, v, by_q, by_v);
            return {std::move(by_q), std::move(by_v)};
        }
    }
    /// dL/dq, with the force, and dL/dv
    template <class S, class V>
    V by_q(S const& t, V const& q, V const& v) const {
        return at(t, q, v, wanted::forces_only, [&](auto const& node) { return vector_like(q, [&](int k) { return node.by_q(k); }); });
    }
    template <class S, class V>
    V by_v(S const& t, V const& q, V const& v) const {
        return at(t, q, v, wanted::momenta_only, [&](auto const& node) { return vector_like(q, [&](int k) { return node.by_v(k); }); });
    }
    /// All derivatives, as expand_at, which is used for states that are not traced.
    template <class S, class V>
    node_table<V> expand(S const& t, V const& q, V const& v) const {
        if constexpr (not is_traced_at<Problem, V>)
            return expand_at(what_, t, q, v);
        else
            return expand_traced(t, q, v);
    }

    template <class S, class V>
    node_table<V> expand(int, S const& t, V const& q, V const& v) const {
        return expand(t, q, v);
    }

private:
    template <class S, class V>
    node_table<V> expand_traced(S const& t, V const& q, V const& v) const {
        return at(t, q, v, wanted::with_seconds, [&](auto const& node) {
            int const d = shape<V>::dimension(q);
            auto const block = [&](block_number number) {
                block_of<V> made = shape<V>::zero_block(d);
                for (auto const& e : node.places().entries[number]) shape<V>::entry(made, e.row, e.column) = node.value(e.place);
                return made;
            };
            expansion<V> e{vector_like(q, [&](int k) { return node.by_q(k); }),
                           vector_like(q, [&](int k) { return node.by_v(k); }),
                           block(block_qq),
                           block(block_qv),
                           block(block_vv),
                           {}};
            return node_table<V>{std::move(e), block(block_vq)};
        });
    }
    template <class V, class Component>
    static V vector_like(V const& q, Component const& component) {
        V x = zero_like(q);
        for (int k = 0; k < shape<V>::dimension(q); ++k) shape<V>::component(x, k) = component(k);
        return x;
    }
    Problem what_;
    std::shared_ptr<kept> kept_ = std::make_shared<kept>();
};

} // namespace hilger::detail
