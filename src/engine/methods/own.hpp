// SPDX-License-Identifier: BSL-1.0
// Motions under an embedding of one's own, stated as what is summed: integral(L((q + sigma[q])/2, Delta_plus[q])).
#pragma once

#include "engine/methods/lambda.hpp"
#include "engine/motions.hpp"
#include "hilger/text/embedding.hpp"

namespace engine {

/// Calls use(how) with its operators over S. @throws hilger::error::unreadable, hilger::error::invalid_parameter
template <class S, class Use>
auto with_own_embedding(problem const& what, std::string const& method, bool uniform, Use const& use) {
    return hilger::text::with_embedding<S>(own_embedding(what, method), uniform, use);
}
/// What the motion in double prints, on scales of the same kind.
inline std::string equation_in_double(problem const& what, std::string const& method, bool uniform, bool latex_wanted) {
    points<double> const like = uniform ? points<double>{0, 1, 2, {}} : points<double>{0, 0, 2, {0, 1, 3}};
    return make_motion<double>(what, method, like)->equation(latex_wanted);
}

/// A method that has a name, as what is summed. @throws hilger::error::invalid_parameter where theta has another number
template <class S>
std::string in_operators(problem const& what, std::string const& method) {
    if (method == "order-one") return "integral(L(q, Delta_plus[q]))";
    if (method == "order-one-left") return "nabla_integral(L(q, Delta_minus[q]))";
    if (method == "mid-point") return "integral(L((q + sigma[q])/2, Delta_plus[q]))";
    if (method.starts_with("theta:") and lambda_of<S>(what, method)) {
        std::string const lambda = '(' + method.substr(6) + ')';
        return "integral(L((1 - " + lambda + ")*q + " + lambda + "*sigma[q], Delta_plus[q]))";
    }
    return method;
}

} // namespace engine
