// SPDX-License-Identifier: BSL-1.0
// A composition of flows (Hairer-Lubich-Wanner, Geometric Numerical Integration, II.4 and V.3): one step of length h is the first flow
// over c_1 h, then the second over c_2 h, and so on. Compositions of symplectic flows are symplectic.
//   compose(shares<fraction<1, 3>, fraction<2, 3>>{}, f, g)   f over h/3, then g over 2h/3
//   compose(suzuki<4>, f)                                      f over each of the five parts of the step (composition/methods.hpp)
// A flow with a history is refused: its parts would each remember the points of their own kind alone, and their memories would be those of
// another curve.
// With more coefficients than flows the flows take turns. A composition steps as a flow does, and can itself be composed.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "hilger/composition/splitting.hpp"

namespace hilger {

template <parts_of_a_step Parts, class... Flows>
class composed_flow : public stepping<composed_flow<Parts, Flows...>> {
    static constexpr std::size_t turns = Parts::size / sizeof...(Flows);
    static_assert(turns * sizeof...(Flows) == Parts::size, "each flow of a composition has the same number of parts of the step");

    /// One memory for each part: its steps have one length, c_k h, and its guesses are made from its own steps.
    template <class S, class V>
    class by_turns {
        using all = std::index_sequence_for<Flows...>;
        template <class Flow>
        using of_a_turn = std::array<typename Flow::template memory<S, V>, turns>;

    public:
        by_turns(composed_flow const& f, S const& h, V const& like)
            : parts_(detail::whole<S>(f.parts_)), h_(h), lengths_(scaled(parts_, h)), x_{S(0), like, like},
              memories_(made(f, lengths_, like, all{})) {}
        void advance(composed_flow const& f, state<S, V>& x, S const& h) {
            if (not(h == h_)) [[unlikely]] {
                lengths_ = scaled(parts_, h);
                h_ = h;
            }
            x_ = x;
            for (std::size_t turn = 0; turn < turns; ++turn) take(f, turn, all{});
            x_.t = x.t + h;
            x = x_;
        }
        /// Everything that later steps depend on, for checkpoints.
        template <class Visit>
        void visit(composed_flow const& f, Visit& each) {
            each("step", h_);
            lengths_ = scaled(parts_, h_);
            for (std::size_t turn = 0; turn < turns; ++turn) visit(f, each, turn, all{});
        }

    private:
        using numbers = std::array<S, Parts::size>;
        static numbers scaled(numbers c, S const& h) {
            for (S& part : c) part = part * h;
            return c;
        }
        template <std::size_t... J>
        static auto made(composed_flow const& f, numbers const& lengths, V const& like, std::index_sequence<J...>) {
            return std::tuple<of_a_turn<Flows>...>(of_flow<J>(std::get<J>(f.flows_), lengths, like, std::make_index_sequence<turns>{})...);
        }
        template <std::size_t J, class Flow, std::size_t... Turn>
        static of_a_turn<Flow> of_flow(Flow const& flow, numbers const& lengths, V const& like, std::index_sequence<Turn...>) {
            return {typename Flow::template memory<S, V>(flow, lengths[Turn * sizeof...(Flows) + J], like)...};
        }
        template <std::size_t... J>
        void take(composed_flow const& f, std::size_t turn, std::index_sequence<J...>) {
            (std::get<J>(memories_)[turn].advance(std::get<J>(f.flows_), x_, lengths_[turn * sizeof...(Flows) + J]), ...);
        }

        template <class Visit, std::size_t... J>
        void visit(composed_flow const& f, Visit& each, std::size_t turn, std::index_sequence<J...>) {
            (std::get<J>(memories_)[turn].visit(std::get<J>(f.flows_), each), ...);
        }

        numbers parts_;
        S h_;
        numbers lengths_;
        /// Inside the step: handed over when its last part is made.
        state<S, V> x_;
        std::tuple<of_a_turn<Flows>...> memories_;
    };
    struct nothing {
        template <class... Arguments>
        constexpr explicit nothing(Arguments const&...) {}
    };

public:
    /// The check of a Lagrangian before a walk looks at the first flow's.
    using problem_type = typename std::tuple_element_t<0, std::tuple<Flows...>>::problem_type;

    constexpr explicit composed_flow(Parts parts, Flows... flows) : parts_(std::move(parts)), flows_(std::move(flows)...) {}

    /// Kicks and drifts where the composition is made of them; else, or where L turns out to be of another kind, its flows in turns.
    template <class S, class V>
    class memory {
        static constexpr auto ways = detail::splits<composed_flow, S, V>;
        static constexpr bool kicks = ways != detail::kicks_and_drifts::no, turns_too = ways != detail::kicks_and_drifts::always;

    public:
        /// @throws error::invalid_parameter when the parts do not add up to the step
        memory(composed_flow const& f, S const& h, V const& like) : kicks_(f, h, like) {
            if constexpr (not kicks) turns_.emplace(f, h, like);
        }

        /// x one step h further. @throws what the flows throw, and x is as it was; the first guesses, and what compensated sums carry, may
        /// be those of the parts that were made.
        void advance(composed_flow const& f, state<S, V>& x, S const& h) {
            if constexpr (kicks)
                if (kicks_.advance(f, x, h)) return;
            if constexpr (turns_too) {
                if (not turns_) turns_.emplace(f, h, x.q);
                turns_->advance(f, x, h);
            } else
                error::raise<error::not_finite>("the kicks and drifts of the step meet NaN or infinity");
        }
        /// Everything that later steps depend on, for checkpoints.
        template <class Visit>
        void visit(composed_flow const& f, Visit& each) {
            if constexpr (kicks) kicks_.visit(f, each);
            if constexpr (turns_too) {
                int turns = turns_ ? 1 : 0;
                each("turns", turns);
                if (turns != 0 and not turns_) make_turns(f);
                if (turns == 0) turns_.reset();
                if (turns_) turns_->visit(f, each);
            }
        }

    private:
        /// What was read from a checkpoint says that there are turns.
        void make_turns(composed_flow const& f) {
            if constexpr (kicks) turns_.emplace(f, kicks_.h(), detail::shape<V>::zero(kicks_.dimension()));
        }
        [[no_unique_address]] std::conditional_t<kicks, detail::splitting<composed_flow, S, V>, nothing> kicks_;
        /// Made when it is needed.
        [[no_unique_address]] std::conditional_t<turns_too, std::optional<by_turns<S, V>>, nothing> turns_;
    };

    /// p = dL/dv(t, q, v), where the flows have one Lagrangian.
    template <class S, class V>
    [[nodiscard]] V momentum(S const& t, V const& q, V const& v) const {
        (void)mechanics();
        return std::get<0>(flows_).momentum(t, q, v);
    }
    template <class S, class V>
    [[nodiscard]] V momentum_between(S const&, V const&, V const&, S const&) const {
        static_assert(sizeof(V) == 0, "two positions give a momentum where a step has no positions between them: give q0 and p0 or v0");
    }
    /// The problem that the flows have in common.
    [[nodiscard]] auto const& mechanics() const {
        using first = std::remove_cvref_t<decltype(std::get<0>(flows_).mechanics())>;
        static_assert((std::same_as<first, std::remove_cvref_t<decltype(std::declval<Flows const&>().mechanics())>> and ...),
                      "a velocity has a momentum where all flows of a composition have the same Lagrangian: give q0 and p0");
        return std::get<0>(flows_).mechanics();
    }
    [[nodiscard]] Parts const& parts() const { return parts_; }
    [[nodiscard]] std::tuple<Flows...> const& flows() const { return flows_; }

private:
    [[no_unique_address]] Parts parts_;
    std::tuple<Flows...> flows_;
};

/// The flows over the parts of each step, in turns: flow 1 over c_1 h, flow 2 over c_2 h, ..., flow 1 again when all had their turn.
template <parts_of_a_step Parts, class... Flows>
    requires(sizeof...(Flows) > 0 and not(detail::has_history<Flows> or ...))
constexpr auto compose(Parts const& parts, Flows const&... flows) { return composed_flow<Parts, Flows...>(parts, flows...); }

template <parts_of_a_step Parts, class First, class... Flows>
    requires(detail::has_history<First> or (detail::has_history<Flows> or ...))
constexpr auto compose(Parts const&, First const& f, Flows const&...) {
    static_assert(sizeof(First) == 0, "flows with a history (fractional damping, Newmark) walk steps of one length from their first point "
                                      "on: they are not composed of parts of a step");
    return f;
}

namespace detail {

template <class C>
constexpr backwards<C> turned_parts(C const& c) {
    return {c};
}
template <class C>
constexpr C turned_parts(backwards<C> const& c) {
    return c.of;
}

} // namespace detail

/// (g_{c h} f_{b h})^* = f^*_{b h} g^*_{c h}
template <class Parts, class... Flows>
auto adjoint(composed_flow<Parts, Flows...> const& f) {
    return [&]<std::size_t... J>(std::index_sequence<J...>) {
        return compose(detail::turned_parts(f.parts()), adjoint(std::get<sizeof...(Flows) - 1 - J>(f.flows()))...);
    }
    (std::index_sequence_for<Flows...>{});
}

/// Refused: (Phi_{-h})^{-1} of a step that depends on all steps before it.
template <class Flow>
    requires detail::has_history<Flow>
auto adjoint(Flow const& f) {
    static_assert(sizeof(Flow) == 0, "a flow with a history (fractional damping, Newmark) has no adjoint: its steps depend on all steps "
                                     "before them");
    return f;
}

/// f over h/2, then its adjoint over h/2: symmetric, so of even order, whatever f is.
template <class Flow>
auto symmetrized(Flow const& f) {
    if constexpr (detail::has_history<Flow>)
        return compose(halves, f);
    else
        return compose(detail::one_problem<std::remove_const_t<decltype(halves)>>{halves}, f, adjoint(f));
}
/// adjoint(f) over c_1 h, f over c_2 h, adjoint(f) over c_3 h, and so on (Hairer-Lubich-Wanner, II (4.6)).
template <parts_of_a_step Parts, class Flow>
auto compose_with_adjoint(Parts const& parts, Flow const& f) {
    if constexpr (detail::has_history<Flow>)
        return compose(parts, f);
    else
        return compose(detail::one_problem<Parts>{parts}, adjoint(f), f);
}

/// Stoermer-Verlet in its velocity form, order 2: for L = v.v/2 - U(q) half a kick p - h/2 U', the drift q + h p, half a kick. Any
/// Lagrangian or forced problem will do. `how` is compensated, or nothing.
template <class L, class... How>
auto stoermer_verlet(L const& lagrangian, How const&... how) {
    return symmetrized(embed(lagrangian, order_one, how...));
}
/// Its position form: half a drift, the kick, half a drift.
template <class L, class... How>
auto position_verlet(L const& lagrangian, How const&... how) {
    return symmetrized(adjoint(embed(lagrangian, order_one, how...)));
}

} // namespace hilger
