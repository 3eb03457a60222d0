// SPDX-License-Identifier: BSL-1.0
// Embeddings in text as those of types: their operators make an action that is derived, stepped and printed like all others.
//   auto const how = text::embedding_in("integral(L((q + sigma[q])/2, Delta_plus[q]))");
//   text::with_embedding<double>(how, T.is_uniform, [&](auto const& e) { return embed(L, e); });
#pragma once

#include <optional>
#include <type_traits>

#include "hilger/embedding/embedding.hpp"
#include "hilger/text/operator.hpp"

namespace hilger::text {

/// An operator on T known at run time that loses at most so many points at the ends, between two sums with weights W. On a uniform scale
/// its adjoint is written without weights.
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
/// Admissible error of factors in numbers S: 1 - c and c in the digits of doubles add up to 1 but for rounding.
template <class S>
constexpr double rounding_of_factors = std::is_floating_point_v<S> ? 1.0 / (1LL << 50) : 0;
/// The operator on f, for printing.
hilger::detail::expression written_on(operator_formula const& a, hilger::detail::expression const& f, bool uniform);

} // namespace detail

/// @throws error::invalid_parameter if position and velocity do not read the two ends of the step that the sum counts, or are not
/// consistent (embedding/one_step.hpp) up to this rounding
void require_one_step(embedding_formula const& e, double rounding = 0);

/// Calls use(embedding) with position and velocity as operators over S, on uniform scales or on every one.
/// @throws as require_one_step
template <class S, class Use>
auto with_embedding(embedding_formula const& e, bool uniform, Use const& use) {
    require_one_step(e, detail::rounding_of_factors<S>);
    return detail::with_operators<S>(e, uniform, [&]<class Op, class W>(Op const& position, Op const& velocity, W) {
        return use(embedding<Op, Op, W, false>{position, velocity, "the embedding"});
    });
}

/// The embedding L((1 - lambda) q + lambda sigma[q], Delta_plus[q]) under the Delta integral.
template <class S>
auto embedding_at(S const& lambda) {
    return make_embedding<delta_weight>(S(S(1) - lambda) * identity_T + lambda * sigma, Delta_plus, "the embedding");
}
/// Whether the position is a mean of the ends that depends on the length of the step, as q + Delta_plus[q]/20.
bool depends_on_step(embedding_formula const& e);
/// The lambda whose embedding_at(lambda) makes the same steps of length h: an embedding that is consistent in one step interpolates between
/// its ends. Without h for steps of any length. In the numbers of operator_in_numbers. @throws as require_one_step;
/// error::invalid_parameter if there is no h and lambda depends on it
template <class S>
S lambda_of_step(embedding_formula const& e, std::optional<S> const& h = {});

} // namespace hilger::text

namespace hilger::detail {

template <class S, int Front, int Back, class W>
expression written_alone(text::stated_operator<S, Front, Back, W> const& a, expression const& f) {
    return text::detail::written_on(a.formula(), f, a.is_on_uniform());
}

} // namespace hilger::detail
