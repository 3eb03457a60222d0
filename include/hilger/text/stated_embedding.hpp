// SPDX-License-Identifier: BSL-1.0
// Embeddings in text as those of types: the operators of an action that is derived, stepped and printed as all others are.
//   auto const how = text::embedding_in("integral(L((q + sigma[q])/2, Delta_plus[q]))");
//   text::with_embedding<double>(how, T.is_uniform, [&](auto const& e) { return embed(L, e); });
#pragma once

#include "hilger/embedding/embedding.hpp"
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

/// @throws error::invalid_parameter where position and velocity do not read the two ends of one step, are not consistent on uniform scales
///         or on every one, or read that end of a step that the sum does not count
inline void require_one_step(embedding_formula const& e, bool uniform) {
    auto const lost = e.lost();
    if (lost == lost_points{})
        error::raise<error::invalid_parameter>("an embedding reads both ends of a step, and ", e.text, " reads the points of T alone");
    if (lost.front + lost.back > 1)
        error::raise<error::invalid_parameter>("position and velocity of an embedding read the two ends of one step, and those of ", e.text,
                                               " reach further: of T they lose ", lost.front, " points at the beginning and ", lost.back,
                                               " at the end");
    bool const forward = lost.back == 1;
    if (forward != (e.weight == sum_weight::delta))
        error::raise<error::invalid_parameter>(
            forward ? "what reads t and sigma(t) is summed by integral(L(...)), and what reads rho(t) and t by nabla_integral(L(...)): "
                    : "what reads rho(t) and t is summed by nabla_integral(L(...)), and what reads t and sigma(t) by integral(L(...)): ",
            e.text, " has the other one");
    require_consistent(e, uniform);
}

/// Calls use(embedding) with position and velocity as operators over S. @throws as require_one_step does
template <class S, class Use>
auto with_embedding(embedding_formula const& e, bool uniform, Use const& use) {
    require_one_step(e, uniform);
    auto const made = [&]<int Front, int Back, class W>(std::integral_constant<int, Front>, std::integral_constant<int, Back>, W) {
        using op = stated_operator<S, Front, Back, W>;
        return use(embedding<op, op, W, false>{op(e.position, uniform), op(e.velocity, uniform), "the embedding"});
    };
    using zero = std::integral_constant<int, 0>;
    using one = std::integral_constant<int, 1>;
    return e.weight == sum_weight::delta ? made(zero{}, one{}, delta_weight{}) : made(one{}, zero{}, nabla_weight{});
}

/// L((1 - lambda) q + lambda sigma[q], Delta_plus[q]) under the Delta integral.
template <class S>
auto embedding_at(S const& lambda) {
    return make_embedding<delta_weight>(S(S(1) - lambda) * identity_T + lambda * sigma, Delta_plus, "the embedding");
}
/// The lambda with which embedding_at(lambda) makes the steps of an embedding: what is consistent in one step is an interpolation between
/// its ends. @throws as require_one_step does
template <class S>
S lambda_of_step(embedding_formula const& e, bool uniform) {
    require_one_step(e, uniform);
    auto const row = detail::row_of<S>(e.position, true, e.lost());
    return row[1];
}

} // namespace hilger::text

namespace hilger::detail {

template <class S, int Front, int Back, class W>
expression written_alone(text::stated_operator<S, Front, Back, W> const& a, expression const& f) {
    return text::detail::written_on(a.formula(), f, a.is_on_uniform());
}

} // namespace hilger::detail
