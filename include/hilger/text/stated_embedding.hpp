// SPDX-License-Identifier: BSL-1.0
// Embeddings in text as those of types: the operators of an action that is derived, stepped and printed as all others are.
//   auto const how = text::embedding_in("integral(L((q + sigma[q])/2, Delta_plus[q]))");
//   text::with_embedding<double>(how, T.is_uniform, [&](auto const& e) { return embed(L, e); });
#pragma once

#include "hilger/embedding/embedding.hpp"
#include "hilger/text/operator_in_numbers.hpp"
#include "hilger/text/operator_reading.hpp"
#include "hilger/text/operator_writing.hpp"

namespace hilger::text {

/// An operator on T known at run time that loses at most so many points at the ends, between two sums with weights W. On a uniform scale
/// what it is adjoint to is written without weights.
template <class S, int Front, int Back, class W>
class stated_operator : public linear_operator<stated_operator<S, Front, Back, W>> {
    static constexpr sum_weight weight = W::vanishes_last ? sum_weight::delta : sum_weight::nabla;

public:
    using from = nodes;
    using to = nodes;
    using from_weight = W;
    using to_weight = W;
    static constexpr reach reads = reach::local(Front, Back).template at<nodes>();
    static constexpr auto name() { return fixed_text("the operator"); }

    /// @throws error::unreadable when a factor is no number of type S
    stated_operator(operator_formula of, bool uniform) : formula_(std::move(of)), in_numbers_(formula_), uniform_(uniform) {}
    template <int F, int B>
    constexpr auto image(domain<nodes, F, B> const&) const {
        return domain<nodes, F + Front, B + Back>{};
    }
    template <class F>
    auto evaluate(F const& f, index_type i) const {
        return in_numbers_.value(f, i);
    }
    [[nodiscard]] auto adjoint() const {
        auto const mirrored = formula_.adjoint(weight, weight);
        return stated_operator<S, Back, Front, W>(uniform_ ? mirrored.on_equal_steps() : mirrored, uniform_);
    }
    [[nodiscard]] operator_formula const& formula() const { return formula_; }
    [[nodiscard]] bool is_on_uniform() const { return uniform_; }

private:
    operator_formula formula_;
    operator_in_numbers<S> in_numbers_;
    bool uniform_;
};

namespace detail {

/// Calls use(position, velocity, W()) with the operators over S of an embedding that reads the two ends of one step.
template <class S, class Use>
auto with_operators(embedding_formula const& e, bool uniform, Use const& use) {
    auto const made = [&]<int Front, int Back, class W>(std::integral_constant<int, Front>, std::integral_constant<int, Back>, W weight) {
        using op = stated_operator<S, Front, Back, W>;
        return use(op(e.position, uniform), op(e.velocity, uniform), weight);
    };
    using zero = std::integral_constant<int, 0>;
    using one = std::integral_constant<int, 1>;
    return e.weight == sum_weight::delta ? made(zero{}, one{}, delta_weight{}) : made(one{}, zero{}, nabla_weight{});
}
/// How far factors that are stated for numbers S may be off: 1 - c and c in the digits of doubles add up to 1 but for rounding.
template <class S>
Q rounding_of_factors() {
    return std::is_floating_point_v<S> ? Q(1, 1LL << 50) : Q(0);
}
/// In rationals, and in 50 digits where a factor is none.
template <std::same_as<Q> Exact>
hilger::detail::consistency consistency_of(embedding_formula const& e, Exact const& rounding) {
    auto const in = [&]<class S>(S const& tolerance) {
        return with_operators<S>(e, true, [&]<class W>(auto const& a, auto const& b, W) {
            S const some = S(hilger::detail::some_step.value()) / S(1LL << 60);
            return hilger::detail::examine<W>(a, b, some, [&](S const& x, S const& y) { return magnitude(S(x - y)) <= tolerance; });
        });
    };
    try {
        return in(rounding);
    } catch (error::unreadable const&) {
        return in(float50(rounding) + float50("1e-40"));
    }
}

} // namespace detail

/// @throws error::invalid_parameter where position and velocity do not read the two ends of one step, or that end of it that the sum does
///         not count, or are not consistent (embedding/one_step.hpp) up to this rounding
inline void require_one_step(embedding_formula const& e, Q const& rounding = Q(0)) {
    auto const refuse = [](auto const&... why) { error::raise<error::invalid_parameter>(why...); };
    auto const lost = e.lost();
    if (e.position.has_weights() or e.velocity.has_weights())
        refuse("position and velocity of an embedding read one step, and mu/nu in ", e.text, " is of two");
    if (lost == lost_points{}) refuse("an embedding reads both ends of a step, and ", e.text, " reads the points of T alone");
    if (lost.front + lost.back > 1)
        refuse("position and velocity of an embedding read the two ends of one step, and those of ", e.text,
               " reach further: of T they lose ", lost.front, " points at the beginning and ", lost.back, " at the end");
    bool const forward = lost.back == 1;
    if (forward != (e.weight == sum_weight::delta))
        refuse(forward ? "what reads t and sigma(t) is summed by integral(L(...)), and what reads rho(t) and t by nabla_integral(L(...)): "
                       : "what reads rho(t) and t is summed by nabla_integral(L(...)), and what reads t and sigma(t) by integral(L(...)): ",
               e.text, " has the other one");
    auto const fails = [&](char const* what) {
        refuse("the ", what, ", and that of ", e.text, " not, so that its steps would follow another system");
    };
    using hilger::detail::consistency;
    switch (detail::consistency_of(e, rounding)) {
    case consistency::holds:
    case consistency::weights:       // those of both sums add up to the step
    case consistency::values_inside: // one step of this kind has none
        break;
    case consistency::position_of_one:
        return fails("position of an embedding makes 1 of the constant 1");
    case consistency::velocity_of_one:
        return fails("velocity of an embedding makes 0 of the constant 1");
    case consistency::velocity_of_time:
        return fails("velocity of an embedding makes 1 of the function t");
    }
}

/// Calls use(embedding) with position and velocity as operators over S, on uniform scales or on every one.
/// @throws as require_one_step does
template <class S, class Use>
auto with_embedding(embedding_formula const& e, bool uniform, Use const& use) {
    require_one_step(e, detail::rounding_of_factors<S>());
    return detail::with_operators<S>(e, uniform, [&]<class Op, class W>(Op const& position, Op const& velocity, W) {
        return use(embedding<Op, Op, W, false>{position, velocity, "the embedding"});
    });
}

/// L((1 - lambda) q + lambda sigma[q], Delta_plus[q]) under the Delta integral.
template <class S>
auto embedding_at(S const& lambda) {
    return make_embedding<delta_weight>(S(S(1) - lambda) * identity_T + lambda * sigma, Delta_plus, "the embedding");
}
/// Whether the position is another mean of the ends for each length of the step, as q + Delta_plus[q]/20.
inline bool depends_on_step(embedding_formula const& e) {
    auto const differs = [&]<class S>(S const& tolerance) {
        auto const at = [&](S const& h, bool sizes = false) {
            return detail::row_on<S>(detail::equal_steps<S>{h}, e.position, e.lost(), sizes);
        };
        auto const x = at(S(1)), y = at(S(3)), of_x = at(S(1), true), of_y = at(S(3), true);
        for (std::size_t k = 0; k < x.size(); ++k)
            if (magnitude(S(x[k] - y[k])) > tolerance * S(of_x[k] + of_y[k])) return true;
        return false;
    };
    try {
        return differs(Q(0));
    } catch (error::unreadable const&) { // a factor is no rational number
        return differs(float50("1e-40"));
    }
}
/// The lambda with which embedding_at(lambda) makes the steps of length h of an embedding: what is consistent in one step is an
/// interpolation between its ends. Without h that of steps of any length.
/// @throws as require_one_step does; error::invalid_parameter where there is no h and lambda depends on it
template <class S>
S lambda_of_step(embedding_formula const& e, std::optional<S> const& h = {}) {
    require_one_step(e, detail::rounding_of_factors<S>());
    if (not h and depends_on_step(e))
        error::raise<error::invalid_parameter>("the position of ", e.text,
                                               " is another mean of the ends for each length of the step, which is possible here on equal "
                                               "steps alone");
    return detail::row_on<S>(detail::equal_steps<S>{h.value_or(S(1))}, e.position, e.lost())[1];
}

} // namespace hilger::text

namespace hilger::detail {

template <class S, int Front, int Back, class W>
expression written_alone(text::stated_operator<S, Front, Back, W> const& a, expression const& f) {
    return text::detail::written_on(a.formula(), f, a.is_on_uniform());
}

} // namespace hilger::detail
