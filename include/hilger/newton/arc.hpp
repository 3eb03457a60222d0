// SPDX-License-Identifier: BSL-1.0
// A root of F along the path F(x) = (1 - s) F(x_0) that begins with x_0 and s = 0. As far as the derivative is regular that is Newton's
// path. Where it is not s turns back, and the path, followed by its length, goes on, to roots that no correction leads to and that are near
// in the sense that all on the way is nearly a motion (Allgower and Georg, Introduction to Numerical Continuation Methods, 2003, chapter
// 6).
#pragma once

#include <optional>

#include "hilger/newton/newton.hpp"

namespace hilger::detail {

template <class V, class Jacobian>
class arc {
    using S = scalar_of<V>;

public:
    arc(newton_function<V, Jacobian> const& system, V const& from) : system_(system), from_(from) {}

    /// x where s = 1, to the accuracy of the path; nothing where it does not come there.
    std::optional<V> end() {
        auto at = system_(from_);
        if (not all_finite(at.residual)) return {};
        first_ = at.residual;
        V unit = from_;
        if (magnitude(first_) == S(0) or (magnitude(from_) == S(0) and not solve_linear(at.jacobian, first_, unit))) return {};
        unit_ = length(unit);
        place here{from_, S(0)}, along{zero_like(from_), S(1)};
        if (not(S(0) < unit_) or not is_finite(unit_) or not put_tangent(at, along)) return {};
        S step = S(1) / S(16);
        for (int made = 0; made < 400; ++made) {
            std::optional<place> const next = step_from(here, along, step);
            if (not next) {
                step = step / S(2);
                if (S(1e6) * step < S(1)) return {};
                continue;
            }
            if (not(next->s < S(1))) {
                S const share = (S(1) - here.s) / (next->s - here.s);
                return V(here.x + V(next->x - here.x) * share);
            }
            here = *next;
            along = next_along_;
            step = std::min(S(S(rounds_ < 4 ? 1.5 : 1) * step), S(1) / S(2));
        }
        return {};
    }

private:
    struct place {
        V x;
        S s;
    };
    [[nodiscard]] S length(V const& x) const {
        using std::sqrt;
        return S(sqrt(S(dot_product(x, x))));
    }
    [[nodiscard]] S inner(place const& a, place const& b) const { return S(dot_product(V(a.x / unit_), V(b.x / unit_))) + a.s * b.s; }
    /// d in J d.x + F(x_0) d.s = r with inner(along, d) = rest; false where there is none.
    bool solve_with(newton_system<V, Jacobian>& at, V const* r, S const& rest, place const& along, place& d) {
        V b = first_;
        if (not solve_linear(at.jacobian, first_, b)) return false;
        S const divisor = along.s - inner({along.x, S(0)}, {b, S(0)});
        V a = zero_like(b);
        if (r != nullptr and not solve_linear(at.jacobian, *r, a)) return false;
        d.s = (rest - inner({along.x, S(0)}, {a, S(0)})) / divisor;
        d.x = a - d.s * b;
        return is_finite(d.s) and all_finite(d.x);
    }
    /// The direction of the path, as `along` points.
    bool put_tangent(newton_system<V, Jacobian>& at, place& along) {
        using std::sqrt;
        place d = along;
        if (not solve_with(at, nullptr, S(1), along, d)) return false;
        S const size = S(sqrt(inner(d, d)));
        if (not(S(0) < size) or not is_finite(size)) return false;
        along = {V(d.x / size), S(d.s / size)};
        return true;
    }
    /// The point of the path at this distance in the direction `along`; nothing where it turns by more than a little on the way.
    std::optional<place> step_from(place const& here, place const& along, S const& step) {
        place y{V(here.x + along.x * step), S(here.s + along.s * step)}, d = y;
        for (rounds_ = 0; rounds_ < 6; ++rounds_) {
            auto at = system_(y.x);
            if (not all_finite(at.residual)) return {};
            V const r = at.residual - first_ * S(S(1) - y.s);
            S const left = step - inner(along, {V(y.x - here.x), S(y.s - here.s)});
            if (not solve_with(at, &r, S(-left), along, d)) return {};
            y = {V(y.x - d.x), S(y.s - d.s)};
            if (not(S(1e12) * inner(d, d) <= S(1) + inner(y, y))) continue;
            next_along_ = along;
            if (not put_tangent(at, next_along_) or inner(next_along_, along) < S(0.9)) return {};
            return y;
        }
        return {};
    }
    newton_function<V, Jacobian> const& system_;
    V const& from_;
    V first_{};
    S unit_{1};
    place next_along_{};
    int rounds_ = 0;
};

} // namespace hilger::detail
