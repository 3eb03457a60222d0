// SPDX-License-Identifier: BSL-1.0
// What scalars of many digits have: the embeddings in one step. Their time goes into loops over digits, and that of a compiler into loops
// of each kind, so that there are few kinds: all embeddings are made of operators in text, and rationals have one kind of scale
// (with_scale).
#pragma once

#include "engine/methods/summed.hpp"

namespace engine {

/// A motion that prints as the method that it was asked for.
template <class S, class Flow, class Scale>
class motion_in_digits final : public motion_of<S, Flow, Scale> {
public:
    motion_in_digits(Flow flow, Scale T, std::string const& method, problem const& what, bool uniform)
        : motion_of<S, Flow, Scale>(std::move(flow), std::move(T), method), what_(what), method_(method), uniform_(uniform) {}
    [[nodiscard]] std::string equation(bool latex_wanted) const override {
        return equation_in_double(what_, method_, uniform_, latex_wanted);
    }

private:
    problem what_;
    std::string method_;
    bool uniform_;
};

template <class S>
std::unique_ptr<motion<S>> made_in(problem const& what, std::string const& method, points<S> const& T, char const* scalar) {
    if (not what.besides.empty()) return summed(what, method, T);
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is for numbers of the processor, and not for ", scalar);
    std::string const operators = in_operators<S>(what, method);
    if (not is_embedding_in_text(operators))
        hilger::error::raise<hilger::error::invalid_parameter>(
            "in ", scalar,
            " the methods are order-one, order-one-left, mid-point, theta:0.3 and embeddings, as integral(L(q, Delta_plus[q])), and not '",
            method, "'");
    auto const on = [&]<class Scale>(auto const& flow, Scale const& scale) -> std::unique_ptr<motion<S>> {
        using flow_type = std::remove_cvref_t<decltype(flow)>;
        return std::make_unique<motion_in_digits<S, flow_type, Scale>>(flow, scale, method, what, T.is_uniform());
    };
    return with_own_embedding<S>(what, operators, T.is_uniform(), [&](auto const& how) {
        return with_mechanics(what, [&](auto const& mechanics) {
            auto const flow = hilger::embed(mechanics, how);
            return with_scale(T, [&](auto const& scale) { return on(flow, scale); });
        });
    });
}

} // namespace engine
