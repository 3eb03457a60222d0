// SPDX-License-Identifier: BSL-1.0
// What scalars of many digits have: the embeddings in one step, verlet, and in 50 digits kahan-li-8 and gauss-8, of order 16, to compare
// all others with. Their time goes into loops over digits, and that of a compiler into loops of each kind, so that there are few kinds: the
// embeddings in one step are made of operators in text, and rationals have one kind of scale (with_scale).
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

/// By the flow that make(mechanics) is.
template <class S, class Make>
std::unique_ptr<motion<S>> made_by(Make const& make, problem const& what, std::string const& method, points<S> const& T) {
    return with_mechanics(what, [&](auto const& mechanics) {
        auto const flow = make(mechanics);
        return with_scale(T, [&]<class Scale>(Scale const& scale) -> std::unique_ptr<motion<S>> {
            using made = motion_in_digits<S, std::remove_cvref_t<decltype(flow)>, Scale>;
            return std::make_unique<made>(flow, scale, method, what, T.is_uniform());
        });
    });
}
/// By a method that is not made of operators in text, compiled in a file of its own. @returns nothing for any other
template <class S>
std::unique_ptr<motion<S>> made_by_name(problem const& what, std::string const& method, points<S> const& T);
template <>
std::unique_ptr<motion<hilger::Q>> made_by_name(problem const& what, std::string const& method, points<hilger::Q> const& T);
template <>
std::unique_ptr<motion<hilger::float50>> made_by_name(problem const& what, std::string const& method, points<hilger::float50> const& T);

template <class S>
std::unique_ptr<motion<S>> made_in(problem const& what, std::string const& method, points<S> const& T, char const* scalar,
                                   char const* others) {
    if (not what.besides.empty()) return summed(what, method, T);
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is for numbers of the processor, and not for ", scalar);
    if (auto made = made_by_name(what, method, T)) return made;
    std::string const operators = in_operators<S>(what, method);
    if (not is_embedding_in_text(operators))
        hilger::error::raise<hilger::error::invalid_parameter>(
            "in ", scalar, " the methods are order-one, order-one-left, mid-point, ", others,
            "theta:0.3 and embeddings, as integral(L(q, Delta_plus[q])), and not '", method, "'");
    return with_own_embedding<S>(what, operators, T.is_uniform(), [&](auto const& how) {
        return made_by([&](auto const& mechanics) { return hilger::embed(mechanics, how); }, what, method, T);
    });
}

} // namespace engine
