// SPDX-License-Identifier: BSL-1.0
// What scalars of many digits have: the embeddings in one step, and in 50 digits gauss-8, of order 16, to compare all others with. Their
// time goes into loops over digits, and that of a compiler into loops of each kind, so that there are few kinds: all embeddings are made of
// operators in text, and rationals have one kind of scale (with_scale).
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

template <class S, class Embedding>
std::unique_ptr<motion<S>> made_by(Embedding const& how, problem const& what, std::string const& method, points<S> const& T) {
    return with_mechanics(what, [&](auto const& mechanics) {
        auto const flow = hilger::embed(mechanics, how);
        return with_scale(T, [&]<class Scale>(Scale const& scale) -> std::unique_ptr<motion<S>> {
            using made = motion_in_digits<S, std::remove_cvref_t<decltype(flow)>, Scale>;
            return std::make_unique<made>(flow, scale, method, what, T.is_uniform());
        });
    });
}
/// By a Galerkin embedding. @returns nothing for any other method
template <class S>
std::unique_ptr<motion<S>> made_with_inner_points(problem const&, std::string const&, points<S> const&) {
    return nullptr; // rationals, which the nodes are not
}
template <>
std::unique_ptr<motion<hilger::float50>> made_with_inner_points(problem const& what, std::string const& method,
                                                                points<hilger::float50> const& T);

template <class S>
std::unique_ptr<motion<S>> made_in(problem const& what, std::string const& method, points<S> const& T, char const* scalar,
                                   char const* others = "") {
    if (not what.besides.empty()) return summed(what, method, T);
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is for numbers of the processor, and not for ", scalar);
    if (auto made = made_with_inner_points(what, method, T)) return made;
    std::string const operators = in_operators<S>(what, method);
    if (not is_embedding_in_text(operators))
        hilger::error::raise<hilger::error::invalid_parameter>(
            "in ", scalar, " the methods are order-one, order-one-left, mid-point, ", others,
            "theta:0.3 and embeddings, as integral(L(q, Delta_plus[q])), and not '", method, "'");
    return with_own_embedding<S>(what, operators, T.is_uniform(), [&](auto const& how) { return made_by(how, what, method, T); });
}

} // namespace engine
