// SPDX-License-Identifier: BSL-1.0
// A problem as the nodes of a step ask it, its types forgotten: what steps in general is compiled once for all problems of the same states.
#pragma once

#include <memory>

#include "hilger/differentiation/traced/trace.hpp"
#include "hilger/variational/nodes/gradients.hpp"
#include "hilger/variational/nodes/model_list.hpp"
#include "hilger/variational/problem.hpp"

namespace hilger::detail {

template <class Problem, class V>
inline constexpr bool has_own_derivatives = requires(Problem const& what, scalar_of<V> const& t, V const& x) {
    at_time{what.lagrangian, t}.expand(x, x);
};
/// Whether a formula is traced for states V.
template <class Problem, class V>
inline constexpr bool is_traced_at = is_traced_state<V> and not has_own_derivatives<Problem, V>;

/// For the length of one call. Of a problem that is traced only a formula is asked for, and of any other one never.
template <class V>
class given_problem {
protected:
    using S = scalar_of<V>;
    using formula = std::shared_ptr<traced_formula<S> const>;
    constexpr given_problem(bool traced, bool of_one_time, bool force) : is_traced(traced), is_of_one_time(of_one_time), has_force(force) {}
    ~given_problem() = default;

public:
    bool const is_traced;      ///< or asked for derivatives
    bool const is_of_one_time; ///< a formula holds at the time for which it was traced
    bool const has_force;

    [[nodiscard]] virtual formula traced_at(S const&, V const&, V const&) const { return {}; }
    /// As expand_at and gradients_at.
    [[nodiscard]] virtual node_table<V> expand(S const&, V const&, V const&) const { return {}; }
    virtual dependence gradients(S const&, V const&, V const&, V& /*by_q*/, V& /*by_v*/) const { return {}; }
    /// Of a model: its derivatives as a list (model_list.hpp). False of any other L.
    virtual bool list(V const&, V const&, bool /*seconds*/, V& /*room*/, std::vector<S>& /*values*/,
                      std::shared_ptr<derivative_places const>& /*places*/) const {
        return false;
    }
    /// Whether L or the force takes the time, unless L says that it does not read it.
    [[nodiscard]] virtual bool reads_time() const { return true; }
    /// The Lagrangian with this number where there are several (step/sum_of_embeddings.hpp).
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

/// Whether the problem is a model alone, of states that are vectors.
template <class Problem, class V>
inline constexpr bool is_listed = false;
template <class F, class V>
inline constexpr bool is_listed<problem<F, no_force>, V> = is_mechanical<F> and not shape<V>::is_scalar;

template <class Problem, class V, bool Traces>
class given_whole;
template <class F, class Force, class V, bool Traces>
class given_whole<problem<F, Force>, V, Traces> : public given_problem<V> {
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
    explicit given_whole(Problem const& what)
        : base(Traces, Traces and (told_time<F> or (forced and told_time<Force>)), forced), what_(what) {}

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
    bool list([[maybe_unused]] V const& q, [[maybe_unused]] V const& v, [[maybe_unused]] bool seconds, [[maybe_unused]] V& room,
              [[maybe_unused]] std::vector<S>& values, [[maybe_unused]] std::shared_ptr<derivative_places const>& places) const override {
        constexpr bool lists = is_listed<Problem, V> and not Traces;
        if constexpr (lists) list_model(what_.lagrangian, q, v, seconds, room, values, places);
        return lists;
    }
    bool reads_time() const override { return reads_time_in<S, V>(what_.lagrangian) or is_timed<no_force, Force, S, V>; }

protected:
    ~given_whole() = default;

private:
    Problem const& what_;
};
template <class Problem, class V, bool Traces = is_traced_at<Problem, V> and not is_listed<Problem, V>>
class given final : public given_whole<Problem, V, Traces> {
public:
    using given_whole<Problem, V, Traces>::given_whole;
};

} // namespace hilger::detail
