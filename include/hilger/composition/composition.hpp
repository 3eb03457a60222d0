// SPDX-License-Identifier: BSL-1.0
// A composition of flows (Hairer-Lubich-Wanner, Geometric Numerical Integration, II.4 and V.3): one step of length h is the first flow
// over c_1 h, then the second over c_2 h, and so on. Compositions of symplectic flows are symplectic.
//   compose(shares<fraction<1, 3>, fraction<2, 3>>{}, f, g)   f over h/3, then g over 2h/3
//   compose(suzuki<4>, f)                                      f over each of the five parts of the step (composition/methods.hpp)
// A flow with a history is refused: each part would remember its own points only, which lie on another curve. With more coefficients than
// flows the flows are repeated in order. A composition steps as a flow does, and can itself be composed.
#pragma once

#include <array>
#include <optional>
#include <tuple>

#include "hilger/composition/sequential_composition.hpp"
#include "hilger/composition/splitting.hpp"

namespace hilger {

namespace detail {
template <class Flow>
concept has_a_problem = requires {
    typename Flow::problem_type;
};
} // namespace detail

/// The composition of Flows over the Parts of a step; see compose().
template <parts_of_a_step Parts, class... Flows>
class composed_flow : public stepping<composed_flow<Parts, Flows...>> {
    static_assert(Parts::size % sizeof...(Flows) == 0, "each flow of a composition has the same number of parts of the step");
    struct nothing {
        template <class... Arguments>
        constexpr explicit nothing(Arguments const&...) {}
    };

public:
    /// The Lagrangian of the first flow is checked before a trajectory begins.
    using problem_type = typename std::tuple_element_t<0, std::tuple<Flows...>>::problem_type;

    constexpr explicit composed_flow(Parts parts, Flows... flows) : parts_(std::move(parts)), flows_(std::move(flows)...) {}

    /// The kicks and drifts of the composition where it has them; else, or where L turns out to be of another kind, its flows in sequence.
    template <class S, class V>
    class memory {
        static constexpr auto ways = detail::splits<composed_flow, S, V>;
        static constexpr bool kicks = ways != detail::kicks_and_drifts::no, turns_too = ways != detail::kicks_and_drifts::always;

        static constexpr bool in_registers = [] {
            if constexpr (kicks)
                return detail::splitting<composed_flow, S, V>::in_registers;
            else
                return false;
        }();

    public:
        /// @throws error::invalid_parameter when the parts do not add up to the step
        memory(composed_flow const& f, S const& h, V const& like) : kicks_(f, h, like) {
            if constexpr (not kicks) turns_->made(f, h, state<S, V>{S(0), like, like});
        }
        /// The velocity that the first step begins with, at x, or one near it.
        void start_with(composed_flow const& f, state<S, V> const& x, V const& v) {
            if constexpr (turns_too) turns_->start_with(f, x, v);
        }
        /// Advances x by one step h. @throws what the flows throw, with x unchanged; first guesses and compensation may be those of the
        /// parts done.
        void advance(composed_flow const& f, state<S, V>& x, S const& h) {
            if constexpr (kicks)
                if (kicks_.advance(f, x, h)) return;
            in_turns(f, turns_.get(), x, h);
        }
        void begin(composed_flow const& f, state<S, V> const& x, S const& h) requires in_registers { kicks_.begin(f, x, h); }
        /// Advances x by one step of the first length. Neither the state nor the kicks and drifts have their address taken, so that both
        /// can live in registers. @throws the same as a step_failure
        HILGER_ALWAYS_INLINE void advance_equally(composed_flow const& f, state<S, V>& x) requires in_registers {
            if (not kicks_.advance_equally(f, x)) [[unlikely]]
                x = in_turns_saying_where(f, turns_.get(), x, kicks_.h());
        }
        /// Everything that later steps depend on, for checkpoints.
        template <class Visit>
        void visit(composed_flow const& f, Visit& each) {
            if constexpr (kicks) kicks_.visit(f, each);
            if constexpr (turns_too) {
                auto& flows = turns_->flows;
                int in_turn = flows ? 1 : 0;
                each("turns", in_turn);
                if (in_turn == 0) flows.reset();
                // A checkpoint may have been written after the change to flows in sequence.
                if constexpr (kicks)
                    if (in_turn != 0 and not flows) flows.emplace(f, kicks_.h(), detail::shape<V>::zero(kicks_.dimension()));
                if (flows) flows->visit(f, each);
            }
        }

    private:
        /// Made when needed, and boxed.
        using turns = detail::sequential_composition<S, V, Parts, Flows...>;
        struct in_turns_of {
            std::optional<turns> flows;
            std::optional<std::pair<state<S, V>, V>> start;
            turns& made(composed_flow const& f, S const& h, state<S, V> const& x) {
                if (not flows) {
                    flows.emplace(f, h, x.q);
                    if (start and start->first == x) flows->start_with(f, x, start->second);
                }
                return *flows;
            }
            void start_with(composed_flow const& f, state<S, V> const& x, V const& v) {
                if (flows)
                    flows->start_with(f, x, v);
                else
                    start.emplace(x, v);
            }
        };
        using flows_in_turns = std::conditional_t<turns_too, in_turns_of, nothing>;
        static void in_turns(composed_flow const& f, flows_in_turns* turns, state<S, V>& x, S const& h) {
            if constexpr (turns_too)
                turns->made(f, h, x).advance(f, x, h);
            else
                error::raise<error::not_finite>("the kicks and drifts of the step meet NaN or infinity");
        }
        [[gnu::noinline]] static state<S, V> in_turns_saying_where(composed_flow const& f, flows_in_turns* turns, state<S, V> x, S h) {
            saying_where(x, h, [&] { in_turns(f, turns, x, h); });
            return x;
        }
        [[no_unique_address]] std::conditional_t<kicks, detail::splitting<composed_flow, S, V>, nothing> kicks_;
        detail::boxed<flows_in_turns> turns_;
    };

    /// p = dL/dv(t, q, v), where the flows have one Lagrangian.
    template <class S, class V>
    [[nodiscard]] V momentum(S const& t, V const& q, V const& v) const {
        (void)mechanics();
        V p = std::get<0>(flows_).momentum(t, q, v);
        std::apply([&](auto const&, auto const&... other) { (require_the_same(p, other.momentum(t, q, v)), ...); }, flows_);
        return p;
    }
    template <class S, class V>
    [[nodiscard]] V momentum_between(S const&, V const&, V const&, S const&) const {
        static_assert(sizeof(V) == 0, "two positions give a momentum where a step has no positions between them: give q0 and p0 or v0");
    }
    /// The problem that the flows have in common.
    [[nodiscard]] auto const& mechanics() const {
        using first = std::remove_cvref_t<decltype(std::get<0>(flows_).mechanics())>;
        static_assert((std::same_as<first, std::remove_cvref_t<decltype(std::declval<Flows const&>().mechanics())>> and ...),
                      "velocities are those of one Lagrangian, and this composition has several: it walks from q0 and p0");
        return std::get<0>(flows_).mechanics();
    }
    [[nodiscard]] Parts const& parts() const { return parts_; }
    [[nodiscard]] std::tuple<Flows...> const& flows() const { return flows_; }

private:
    template <class V>
    static void require_the_same(V const& a, V const& b) {
        if (not(a == b) and is_finite(a) and is_finite(b))
            error::raise<error::mismatch>(
                "velocities are those of one Lagrangian, and this composition has several: it walks from q0 and p0");
    }
    [[no_unique_address]] Parts parts_;
    std::tuple<Flows...> flows_;
};

/// The composition of the flows over the parts of each step: flow 1 over c_1 h, flow 2 over c_2 h, ..., and flow 1 again after the last.
template <parts_of_a_step Parts, class First, class... Flows>
constexpr auto compose(Parts const& parts, First const& f, Flows const&... flows) {
    constexpr bool remembers = detail::has_history<First> or (detail::has_history<Flows> or ...),
                   are_flows = detail::has_a_problem<First> and (detail::has_a_problem<Flows> and ...);
    static_assert(not remembers,
                  "flows with a history (fractional damping, Newmark) walk steps of one length from their first point on: they "
                  "are not composed of parts of a step");
    static_assert(are_flows or remembers, "what is composed are flows, as embed(L, mid_point), and not Lagrangians or embeddings");
    if constexpr (are_flows and not remembers)
        return composed_flow<Parts, First, Flows...>(parts, f, flows...);
    else
        return f;
}
/// Refused: numbers that are known at run time.
template <class S, std::size_t N, class First, class... Flows>
auto compose(std::array<S, N> const&, First const& f, Flows const&...) {
    static_assert(sizeof(First) == 0,
                  "the parts of a step are those of its type: compose(shares<fraction<1, 3>, fraction<2, 3>>{}, f, g), or "
                  "those of a method as suzuki<4>");
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

/// Stoermer-Verlet in its velocity form, order 2: for L = v.v/2 - U(q) half a kick p - h/2 U', the drift q + h p, half a kick. L may be any
/// Lagrangian or forced problem; `how` is compensated or omitted.
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
