// SPDX-License-Identifier: BSL-1.0
// What the equation of one step (step/equation.hpp) is made of, in magnitudes: how large what it adds up is, and what rounding does to it.
#pragma once

#include <algorithm>
#include <utility>

#include "hilger/step/controls.hpp"
#include "hilger/step/force.hpp"

namespace hilger::detail {

template <class S, class V, class Extra, int Controls>
class step_sizes : public step_controls<S, V, Controls> {
    using s = shape<V>;
    using controls = step_controls<S, V, Controls>;

public:
    using controls::dimension, controls::unknowns;
    using typename controls::vector;

    step_sizes(V const& like, Extra extra_force) : controls(like), extra(std::move(extra_force)) {}
    [[no_unique_address]] Extra extra;

    /// The size of what the forces do in the step.
    [[nodiscard]] S impulses() const {
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k) {
            S f(0);
            for (int c = 0; c < dimension(); ++c) f = std::max(f, S(magnitude(nodes_[at(k)].by_q(c))));
            sum = sum + magnitude(t_.w(k)) * f;
        }
        if constexpr (has_step_force<Extra>) sum = sum + magnitude(h_) * magnitude(extra.constant);
        return sum;
    }
    /// The size of what the residual is a sum of.
    [[nodiscard]] S forces() const {
        S sum = impulses();
        for (int k = 0; k < t_.nodes; ++k) {
            S m(0);
            for (int c = 0; c < dimension(); ++c) m = std::max(m, S(magnitude(nodes_[at(k)].by_v(c))));
            sum = sum + m;
        }
        return sum;
    }
    /// What each component of the residual is a sum of, in magnitudes. Where p_i is in it, it is of the size of what dL/dv adds.
    void put_sizes(state<S, V> const& x, vector& sizes) const {
        for (int j = 0; j < U; ++j) {
            auto&& size = row_of(sizes, j);
            for (int c = 0; c < dimension(); ++c) size(c) = j == 0 ? magnitude(s::component(x.p, c)) : S(0);
            for (int k = 0; k < t_.nodes; ++k) {
                S const wa = magnitude(S(t_.w(k) * t_.a(k, j))), wb = magnitude(S(t_.w(k) * t_.b(k, j)));
                if (not(wa == S(0)))
                    for (int c = 0; c < dimension(); ++c) size(c) = size(c) + wa * magnitude(nodes_[at(k)].by_q(c));
                if (j > 0)
                    for (int c = 0; c < dimension(); ++c) size(c) = size(c) + wb * magnitude(nodes_[at(k)].by_v(c));
            }
            if constexpr (has_step_force<Extra>)
                for (int c = 0; c < dimension(); ++c) size(c) = size(c) + magnitude(S(h_ * s::component(extra.constant, c)));
        }
    }
    /// How much of its weight dL/dq has in the equation at most, beside that in the momentum after the step: what a correction changes
    /// there is as much larger as this is smaller.
    [[nodiscard]] S share_of_force() const {
        S in_equation(0), in_momentum(0);
        for (int k = 0; k < t_.nodes; ++k) {
            in_momentum = std::max(in_momentum, S(magnitude(t_.w(k)) * magnitude(t_.a(k, last))));
            for (int j = 0; j < U; ++j) in_equation = std::max(in_equation, S(magnitude(t_.w(k)) * magnitude(t_.a(k, j))));
        }
        return in_equation < in_momentum ? S(in_equation / in_momentum) : S(1);
    }
    /// What rounding of a position does to the residual, at most.
    [[nodiscard]] S bends() const {
        S most(0);
        for (int k = 0; k < t_.nodes; ++k)
            for (auto const& e : nodes_[at(k)].places().entries[block_qq])
                if (S const size = magnitude(S(t_.w(k) * nodes_[at(k)].value(e.place))); is_finite(size) and most < size) most = size;
        return most;
    }

protected:
    using controls::at, controls::h_, controls::last, controls::nodes_, controls::place_of, controls::t_, controls::U;

    /// The row j of all components.
    struct strided {
        vector& x;
        int j;
        S& operator()(int c) const { return x(c * U + j); }
    };
    static decltype(auto) row_of(vector& x, int j) {
        if constexpr (U == 1)
            return (x);
        else
            return strided{x, j};
    }
    /// What block `b` of node k is multiplied by in row j of the matrix, in the column of U_m.
    [[nodiscard]] S factor(int k, int b, int j, int m) const {
        S const w = t_.w(k) * (b == block_qq or b == block_qv ? t_.a(k, j) : t_.b(k, j));
        return w * (b == block_qq or b == block_vq ? t_.a(k, m) : t_.b(k, m));
    }
    /// How much of the impulse of the extra force row j has.
    [[nodiscard]] S share(int j) const {
        if (U == 1) return h_ / S(2);
        S sum(0);
        for (int k = 0; k < t_.nodes; ++k) sum = sum + t_.w(k) * t_.a(k, j);
        return sum;
    }
};

} // namespace hilger::detail
