// SPDX-License-Identifier: BSL-1.0
// Methods with numbers in them: theta:0.3, and embeddings in text. What is derived and judged is each one's own; steps of few coordinates
// are those of one embedding with lambda as a number.
#include "engine/methods/own.hpp"
#include "engine/methods/small.hpp"

namespace engine {

made embedded_with_numbers(problem const& what, std::string const& method, points<double> const& T) {
    bool const has_several = not T.is_uniform() and has_lambda_of_step(what, method);
    auto const lambda = has_several ? std::nullopt : lambda_of<double>(what, method, T.equal_step());
    if (not lambda and not has_several) return nullptr;
    return with_mechanics(what, [&](auto const& mechanics) -> made {
        auto const small = [lambda = lambda.value_or(0)](auto const& L) { return hilger::embed(L, hilger::text::embedding_at(lambda)); };
        auto const by = [&](auto const& how) -> made {
            auto const flow = hilger::embed(mechanics, how);
            // steps of vectors of any size see where the position is an end of the step, and are explicit
            if (has_several or *lambda == 0 or *lambda == 1) return on_scale(flow, T, method);
            return embedded_small(mechanics, flow, small, T, method);
        };
        if (is_embedding_in_text(method)) return with_own_embedding<double>(what, method, T.is_uniform(), by);
        return by(hilger::theta_at(*lambda));
    });
}

} // namespace engine
