// SPDX-License-Identifier: BSL-1.0
// A problem as the nodes of a step see it, type-erased: general steps are compiled once for all problems of the same states.
#pragma once

#include <memory>
#include <vector>

#include "hilger/differentiation/traced/trace.hpp"
#include "hilger/models/mechanical.hpp"
#include "hilger/variational/nodes/gradients.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

template <class Problem, class V>
inline constexpr bool has_own_derivatives = requires(Problem const& what, scalar_of<V> const& t, V const& x) {
    at_time{what.lagrangian, t}.expand(x, x);
};
/// Whether L is traced to a formula for states V.
template <class Problem, class V>
inline constexpr bool is_traced_at = is_traced_state<V> and not has_own_derivatives<Problem, V>;

/// Lives for one call. A traced problem provides formulas only, any other one derivatives only.
template <class V>
class given_problem {
protected:
    using S = scalar_of<V>;
    using formula = std::shared_ptr<traced_formula<S> const>;
    constexpr given_problem(bool traced, bool of_one_time, bool force) : is_traced(traced), is_of_one_time(of_one_time), has_force(force) {}
    ~given_problem() = default;

public:
    bool const is_traced;      ///< else it provides derivatives
    bool const is_of_one_time; ///< a formula holds only at the time of its trace
    bool const has_force;

    [[nodiscard]] virtual formula traced_at(S const&, V const&, V const&) const { return {}; }
    /// As expand_at and gradients_at.
    [[nodiscard]] virtual node_table<V> expand(S const&, V const&, V const&) const { return {}; }
    virtual dependence gradients(S const&, V const&, V const&, V& /*by_q*/, V& /*by_v*/) const { return {}; }
    /// The derivatives of a model, as a list. @returns false for any other L
    virtual bool list(V const&, V const&, bool /*seconds*/, V& /*room*/, std::vector<S>& /*values*/,
                      std::shared_ptr<derivative_places const>& /*places*/) const {
        return false;
    }
    /// Whether L or the force takes the time, unless L tells that it does not read it.
    [[nodiscard]] virtual bool reads_time() const { return true; }
    /// The Lagrangian with this number in a sum (step/sum_of_embeddings.hpp).
    [[nodiscard]] virtual given_problem const& part(int) const { return *this; }
};

template <class F, class Force, class S, class V>
traced_formula<S> trace_problem(problem<F, Force> const& what, S const& t, V const& q, V const& v) {
    using T = traced<S>;
    auto const value = [&](auto const& f, T const& time, auto const& x, auto const& y) {
        if constexpr (is_generic_in_time<std::remove_cvref_t<decltype(f)>>)
            return value_from(f, time, x, y);
        else
            return at_time{f, t}(x, y);
    };
    return trace<S>(t, q, v, on_position | on_velocity, [&](T const& time, auto const& x, auto const& y, std::vector<T>& force) {
        if constexpr (not std::same_as<Force, no_force>) put_force<V>(value(what.force, time, x, y), shape<V>::dimension(q), force);
        return as_jet<T>(value(what.lagrangian, time, x, y));
    });
}

/// The derivatives of a model L = v.Mv / 2 - U(q) (models/mechanical.hpp) at (q, v): dL/dq, dL/dv, workspace for a gradient, and the second
/// derivatives of its potential and mass, term by term, if `seconds`; the first call also sets their places. `room` is as long as q.
template <class L, class V, class S = scalar_of<V>>
void list_model(L const& of, V const& q, V const& v, bool seconds, V& room, std::vector<S>& values,
                std::shared_ptr<derivative_places const>& places) {
    index_type const d = q.size();
    derivative_places made;
    bool const is_first = not places;
    if (is_first) values.assign(static_cast<std::size_t>(3 * d + 1), S(0));
    std::size_t place = static_cast<std::size_t>(3 * d + 1);
    auto const add_to = [&](block_number block, int sign) {
        return [&, block, sign](index_type j, index_type k, S const& x) {
            if (is_first) {
                auto& entries = made.entries[static_cast<std::size_t>(block)];
                int const row = static_cast<int>(j), column = static_cast<int>(k), here = static_cast<int>(place);
                entries.push_back({row, column, here});
                if (j != k) entries.push_back({column, row, here});
                values.push_back(S(0));
            }
            values[place++] = sign < 0 ? S(-x) : x;
        };
    };
    if (is_first or seconds) of.potential().hessian(q, add_to(block_qq, -1));
    if (is_first) {
        of.template put_mass<S>(d, add_to(block_vv, 1));
        made.constant = {false, true, true, true};
        for (int k = 0; k < static_cast<int>(d); ++k) {
            made.by_q.push_back(k);
            made.by_v.push_back(static_cast<int>(d) + k);
        }
        made.find_stretches();
        places = std::make_shared<derivative_places const>(std::move(made));
    }
    using part = Eigen::Map<Eigen::Matrix<S, Eigen::Dynamic, 1>>;
    part tensions(values.data() + 2 * d, d + 1);
    of.potential().gradient(q, room, tensions);
    part(values.data(), d) = -room;
    of.put_momentum(v, part(values.data() + d, d));
}

/// Whether the problem is a model without a force, of vectors.
template <class Problem, class V>
inline constexpr bool is_listed = false;
template <class F, class V>
inline constexpr bool is_listed<problem<F, no_force>, V> = is_mechanical<F> and not shape<V>::is_scalar;

/// The problems of nodes by the numbers of their Lagrangians; null for a single Lagrangian.
template <class Problem, class V>
struct problems_at_nodes {
    explicit problems_at_nodes(Problem const&) {}
    given_problem<V> const* operator()(int) const { return nullptr; }
};

template <class Problem, class V, bool Traces = is_traced_at<Problem, V> and not is_listed<Problem, V>>
class given;
template <class F, class Force, class V, bool Traces>
class given<problem<F, Force>, V, Traces> final : public given_problem<V> {
    using base = given_problem<V>;
    using typename base::formula;
    using typename base::S;
    using Problem = problem<F, Force>;
    static constexpr bool forced = not std::same_as<Force, no_force>;
    template <class X>
    static constexpr bool told_time = [] {
        using x = typename shape<V>::template with<traced<S>>;
        return std::invocable<X const&, S const&, x const&, x const&> and not is_generic_in_time<X>;
    }();

public:
    explicit given(Problem const& what)
        : base(Traces, Traces and (told_time<F> or (forced and told_time<Force>)), forced), what_(what), parts_(what) {}

    formula traced_at(S const& t, V const& q, V const& v) const override {
        if constexpr (Traces) {
            auto const make = [&] { return trace_problem(what_, t, q, v); };
            if constexpr (not forced and requires { what_.lagrangian.kept(); })
                return what_.lagrangian.kept().template of<S>(make);
            else
                return std::make_shared<traced_formula<S> const>(make());
        } else
            return {};
    }
    node_table<V> expand(S const& t, V const& q, V const& v) const override {
        if constexpr (Traces)
            return {};
        else
            return expand_at(what_, t, q, v);
    }
    dependence gradients(S const& t, V const& q, V const& v, V& by_q, V& by_v) const override {
        if constexpr (Traces)
            return {};
        else
            return gradients_at(what_, t, q, v, by_q, by_v);
    }
    bool list(V const& q, V const& v, bool seconds, V& room, std::vector<S>& values,
              std::shared_ptr<derivative_places const>& places) const override {
        if constexpr (is_listed<Problem, V> and not Traces) {
            list_model(what_.lagrangian, q, v, seconds, room, values, places);
            return true;
        } else
            return base::list(q, v, seconds, room, values, places);
    }
    bool reads_time() const override { return reads_time_in<S, V>(what_.lagrangian) or is_timed<no_force, Force, S, V>; }
    given_problem<V> const& part(int k) const override {
        given_problem<V> const* const one = parts_(k);
        return one == nullptr ? *this : *one;
    }

private:
    Problem const& what_;
    [[no_unique_address]] problems_at_nodes<Problem, V> parts_;
};

} // namespace hilger::detail
