// SPDX-License-Identifier: BSL-1.0
#include "hilger/text/c_code.hpp"

#include "engine/methods/lambda.hpp"
#include "engine/motions.hpp"

namespace engine {

std::string c_code_of(problem const& what, std::string const& method, std::string const& name) {
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("C code is for Lagrangians and forces, without fractional damping");
    if (what.time_transformation)
        hilger::error::raise<hilger::error::invalid_parameter>("C code is of a Lagrangian in t, and this one has a transformed time");
    if (not what.besides.empty())
        hilger::error::raise<hilger::error::invalid_parameter>("C code is of one Lagrangian, and this is a sum of ",
                                                               what.besides.size() + 1);
    auto const lambda = lambda_of<double>(what, method);
    int const d = what.lagrangian.formula().words().dimension();
    return with_mechanics(what, [&](auto const& mechanics) {
        auto const written = [&](auto const& how) { return hilger::c_code<vector<double>>(hilger::embed(mechanics, how), name, d); };
        if (method == "order-one") return written(hilger::order_one);
        if (method == "order-one-left") return written(hilger::order_one_left);
        if (method == "mid-point") return written(hilger::mid_point);
        if (lambda) return written(hilger::text::embedding_at(*lambda));
        hilger::error::raise<hilger::error::invalid_parameter>("C code is written of embeddings with one node in a step, order-one, "
                                                               "order-one-left, mid-point, theta and those of operators, and not of ",
                                                               method);
    });
}

} // namespace engine
