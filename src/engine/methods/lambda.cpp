// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/lambda.hpp"

#include "hilger/text/embedding.hpp"

namespace engine {

bool has_lambda_of_step(problem const& what, std::string const& method) {
    return is_embedding_in_text(method) and hilger::text::depends_on_step(own_embedding(what, method));
}
template <class S>
std::optional<S> lambda_of(problem const& what, std::string const& method, std::optional<S> const& h) {
    if (is_embedding_in_text(method)) return hilger::text::lambda_of_step<S>(own_embedding(what, method), h);
    if (not method.starts_with("theta:")) return {};
    auto const lambda = hilger::text::number_in<S>(method.substr(6));
    if (not lambda) hilger::error::raise<hilger::error::invalid_parameter>("theta takes a number, as theta:0.3, and not '", method, "'");
    if (not(S(0) < *lambda and *lambda < S(1)))
        hilger::error::raise<hilger::error::invalid_parameter>("theta takes a number between 0 and 1, and here is ", method.substr(6));
    return lambda;
}

template std::optional<double> lambda_of(problem const&, std::string const&, std::optional<double> const&);
template std::optional<float> lambda_of(problem const&, std::string const&, std::optional<float> const&);
template std::optional<hilger::float50> lambda_of(problem const&, std::string const&, std::optional<hilger::float50> const&);
template std::optional<hilger::float100> lambda_of(problem const&, std::string const&, std::optional<hilger::float100> const&);
template std::optional<hilger::Q> lambda_of(problem const&, std::string const&, std::optional<hilger::Q> const&);

} // namespace engine
