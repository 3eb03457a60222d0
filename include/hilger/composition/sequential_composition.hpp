// SPDX-License-Identifier: BSL-1.0
// A composition by its flows, part after part of each step, where it does not consist of kicks and drifts (splitting.hpp).
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "hilger/composition/parts.hpp"
#include "hilger/step/state.hpp"

namespace hilger {

template <parts_of_a_step Parts, class... Flows>
class composed_flow;

namespace detail {
/// A value on the heap, so that its owner can live in registers.
template <class T>
class boxed : public std::unique_ptr<T> {
public:
    boxed() : std::unique_ptr<T>(std::make_unique<T>()) {}
    boxed(boxed const& other) : std::unique_ptr<T>(std::make_unique<T>(*other)) {}
    boxed& operator=(boxed const& other) {
        **this = *other;
        return *this;
    }
    boxed(boxed&&) = default;
    boxed& operator=(boxed&&) = default;
};

/// Calls use(k, flow, list) for the parts k = 0, 1, ... of a step: with the flow that takes the part, and the list that is its own.
template <class Parts, class... Flows, class Lists, class Use>
void for_each_part(composed_flow<Parts, Flows...> const& f, Lists& lists, Use const& use) {
    auto const turn = [&]<std::size_t... J>(std::size_t k, std::index_sequence<J...>) {
        (use(k + J, std::get<J>(f.flows()), std::get<J>(lists)), ...);
    };
    for (std::size_t k = 0; k < Parts::size; k += sizeof...(Flows)) turn(k, std::index_sequence_for<Flows...>{});
}

/// The memory of a composition by its flows: one for each part, whose steps have the length c_k h and give its first guesses.
template <class S, class V, class Parts, class... Flows>
class sequential_composition {
    using composed = composed_flow<Parts, Flows...>;

public:
    sequential_composition(composed const& f, S const& h, V const& like)
        : parts_(whole<S>(f.parts())), h_(h), lengths_(scaled(parts_, h)), x_{S(0), like, like} {
        for_each_part(f, memories_, [&](std::size_t k, auto const& flow, auto& list) { list.emplace_back(flow, lengths_[k], like); });
    }
    /// The initial velocity of the first step; each later part of that step begins with the mean velocity of the part before.
    void start_with(composed const& f, state<S, V> const& x, V const& v) {
        begin_part(std::get<0>(f.flows()), std::get<0>(memories_)[0], x, v);
    }
    void advance(composed const& f, state<S, V>& x, S const& h) {
        if (not(h == h_)) [[unlikely]] {
            lengths_ = scaled(parts_, h);
            h_ = h;
        }
        x_ = x;
        mean_.reset();
        for_each_part(f, memories_, [&](std::size_t k, auto const& flow, auto& list) { part(flow, list[k / sizeof...(Flows)], k); });
        x_.t = x.t + h;
        x = x_;
        has_begun_ = true;
    }
    /// Everything that later steps depend on, for checkpoints.
    template <class Visit>
    void visit(composed const& f, Visit& each) {
        each("step", h_);
        lengths_ = scaled(parts_, h_);
        for_each_part(f, memories_, [&](std::size_t k, auto const& flow, auto& list) { list[k / sizeof...(Flows)].visit(flow, each); });
    }

private:
    using numbers = std::array<S, Parts::size>;
    static numbers scaled(numbers c, S const& h) {
        for (S& part : c) part = part * h;
        return c;
    }
    template <class Flow, class Memory>
    void part(Flow const& flow, Memory& memory, std::size_t k) {
        S const& length = lengths_[k];
        if (has_begun_) return memory.advance(flow, x_, length);
        if (mean_) begin_part(flow, memory, x_, *mean_);
        V const before = x_.q;
        memory.advance(flow, x_, length);
        if (not(length == S(0))) mean_ = V((x_.q - before) / length);
    }
    template <class Flow, class Memory>
    static void begin_part(Flow const& flow, Memory& memory, state<S, V> const& x, V const& v) {
        if constexpr (requires { memory.start_with(flow, x, v); }) memory.start_with(flow, x, v);
    }

    numbers parts_;
    S h_;
    numbers lengths_;
    /// The state inside the step, returned after its last part.
    state<S, V> x_;
    std::tuple<std::vector<typename Flows::template memory<S, V>>...> memories_; ///< of the turns of each flow
    bool has_begun_ = false;                                                     ///< a step was made
    std::optional<V> mean_;                                                      ///< the velocity of the part before, in that step
};

} // namespace detail
} // namespace hilger
