// SPDX-License-Identifier: BSL-1.0
// The operators of an embedding in one step from t to t + h, and their consistency: a scale of two points, a function given by its values
// at them, and the operators applied to it. With nodes k and weights w_k an embedding (A, B, int) is consistent when
//   sum_k w_k = h,   A 1 = 1,   B 1 = 0,   B t = 1   at every node that counts;
// if one of these fails, the steps converge to the motion of another system. The same holds where the velocities at the nodes do not
// determine the values inside the step, so that the matrix sum_k w_k B_kj B_km over these is singular: the other rows are dL/dq = 0, which
// is no motion.
#pragma once

#include <array>

#include "hilger/adjoint/prime_field.hpp"
#include "hilger/error.hpp"
#include "hilger/operator/integral.hpp"

namespace hilger {

/// A scale of one step h, with the members that operators need.
template <class S>
struct single_step {
    using scalar_type = S;
    static constexpr bool is_uniform = true;
    S h;
    static constexpr index_type steps() { return 1; }
    constexpr S const& step(index_type) const { return h; }
    static constexpr bool same_points(single_step const&) { return true; }
};

namespace detail {

/// The function with these values at the points of a step, both ends of it among them; it refers to them.
template <class S, class Base>
struct values_in_step : discrete_function_tag {
    using root_type = single_step<S>;
    using domain_type = hilger::domain<Base>;
    root_type const* step;
    S const* values;
    constexpr values_in_step(root_type const& T, S const* at_points) : step(&T), values(at_points) {}
    constexpr root_type const& root() const { return *step; }
    static constexpr domain_type domain() { return {}; }
    constexpr S const& get(index_type i) const { return values[i]; }
};

template <linear_map A, linear_map B>
inline constexpr bool reads_few_points = (A::reads | B::reads).is_local();
/// True when the values of A and B at a node depend on the two ends of one step, so that a step can be taken.
template <linear_map A, linear_map B>
inline constexpr bool reads_one_step = reads_few_points<A, B> and (A::reads | B::reads).steps() <= 1;

template <linear_map A, linear_map B, class W, class S>
struct on_one_step {
    using from = typename A::from;
    using both = std::remove_cvref_t<decltype(intersect(std::declval<A const&>().image(domain<from>{}),
                                                        std::declval<B const&>().image(domain<from>{})))>;
    static constexpr index_type first = both::front;
    static constexpr index_type last = both::base_type::last(1) - both::back;
    static constexpr int nodes_ = static_cast<int>(last - first + 1);

    /// The points of a step at which a function is known: its ends, and those inside of it.
    static constexpr int controls = static_cast<int>(from::last(1)) + 1;
    using values = std::array<S, static_cast<std::size_t>(controls)>;
    static constexpr values constant(S const& c) {
        values f{};
        f.fill(c);
        return f;
    }
    /// 1 at point j, 0 at the others.
    static constexpr values unit(int j) {
        values f = constant(S(0));
        f[static_cast<std::size_t>(j)] = S(1);
        return f;
    }
    /// The time since the beginning of a step h.
    static constexpr values time(S const& h) {
        single_step<S> const T{h};
        values f = constant(S(0));
        for (int j = 1; j < controls; ++j) f[static_cast<std::size_t>(j)] = f[static_cast<std::size_t>(j - 1)] + from{}.step(T, j - 1);
        return f;
    }
    /// Op on the function with these values in a step h, at the node k.
    template <linear_map Op>
    static constexpr S value(Op const& op, S const& h, values const& f, int k) {
        single_step<S> const T{h};
        values_in_step<S, from> const q(T, f.data());
        return S(op.evaluate(q, first + k));
    }
    static constexpr S weight(A const& a, B const& b, S const& h, int k) {
        single_step<S> const T{h};
        domain<from> const here;
        return S(W::at(T, intersect(a.image(here), b.image(here)).base, first + k));
    }
};

/// A step in the prime field, unlikely to occur by chance.
inline constexpr prime_field some_step = prime_field::residue(1'311'768'467'463'790'321);

enum class consistency { holds, weights, position_of_one, velocity_of_one, velocity_of_time, values_inside };

/// Whether the velocities at the nodes determine the values inside the step.
template <class W, class F, linear_map A, linear_map B, class Near>
constexpr bool determines_values_inside(A const& a, B const& b, F const& h, Near const& near) {
    using step = on_one_step<A, B, W, F>;
    constexpr int n = step::controls - 2;
    if constexpr (n <= 0)
        return true;
    else {
        F const zero(0);
        F largest(1);
        std::array<std::array<F, static_cast<std::size_t>(n)>, static_cast<std::size_t>(n)> K{};
        auto const at = [&K](int j, int m) -> F& { return K[static_cast<std::size_t>(j)][static_cast<std::size_t>(m)]; };
        for (int k = 0; k < step::nodes_; ++k) {
            std::array<F, static_cast<std::size_t>(n)> v{};
            for (int j = 0; j < n; ++j) v[static_cast<std::size_t>(j)] = step::value(b, h, step::unit(j + 1), k);
            F const w = step::weight(a, b, h, k);
            for (int j = 0; j < n; ++j)
                for (int m = 0; m < n; ++m) at(j, m) = at(j, m) + w * v[static_cast<std::size_t>(j)] * v[static_cast<std::size_t>(m)];
        }
        if constexpr (not std::same_as<F, prime_field>) {
            largest = zero;
            for (int j = 0; j < n; ++j)
                for (int m = 0; m < n; ++m)
                    if (F const size(magnitude(at(j, m))); largest < size) largest = size;
            if (largest == zero) return false;
        }
        for (int c = 0; c < n; ++c) {
            int pivot = c;
            while (pivot < n and near(F(at(pivot, c) / largest), zero)) ++pivot;
            if (pivot == n) return false;
            std::swap(K[static_cast<std::size_t>(pivot)], K[static_cast<std::size_t>(c)]);
            for (int j = c + 1; j < n; ++j) {
                F const factor = at(j, c) / at(c, c);
                for (int m = c; m < n; ++m) at(j, m) = at(j, m) - factor * at(c, m);
            }
        }
        return true;
    }
}

/// The first condition that fails by more than the tolerance, relative to the value required.
template <class W, class S, linear_map A, linear_map B, class Near>
constexpr consistency examine(A const& a, B const& b, S const& h, Near const& near) {
    using step = on_one_step<A, B, W, S>;
    S const zero(0), one(1);
    auto const ones = step::constant(one), time = step::time(h);
    S sum(0);
    for (int k = 0; k < step::nodes_; ++k) sum = sum + step::weight(a, b, h, k);
    if (not near(S(sum / h), one)) return consistency::weights;
    for (int k = 0; k < step::nodes_; ++k) {
        if (step::weight(a, b, h, k) == zero) continue;
        if (not near(step::value(a, h, ones, k), one)) return consistency::position_of_one;
        if (not near(S(step::value(b, h, ones, k) * h), zero)) return consistency::velocity_of_one;
        if (not near(step::value(b, h, time, k), one)) return consistency::velocity_of_time;
    }
    return determines_values_inside<W>(a, b, h, near) ? consistency::holds : consistency::values_inside;
}

/// Consistency by the type, exactly, over a finite field. Operators without a step are refused elsewhere, and numbers known at run time
/// only are checked then.
template <linear_map A, linear_map B>
inline constexpr bool has_numbers = not std::is_empty_v<A> or not std::is_empty_v<B>;
/// Operators that are consistent by definition are not computed with.
template <linear_map A, linear_map B, class W>
inline constexpr bool is_consistent_by_construction = false;
template <linear_map A, linear_map B, class W>
consteval consistency consistency_by_type() {
    if constexpr (is_consistent_by_construction<A, B, W>)
        return consistency::holds;
    else if constexpr (not has_numbers<A, B> and reads_one_step<A, B> and std::same_as<typename A::to, typename B::to>)
        return examine<W>(A{}, B{}, some_step, [](prime_field x, prime_field y) { return x == y; });
    else
        return consistency::holds;
}

} // namespace detail

} // namespace hilger
