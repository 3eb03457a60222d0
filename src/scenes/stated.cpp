// SPDX-License-Identifier: BSL-1.0
#include "engine/machine_code/machine_code.hpp"
#include "stated_walk.hpp"

PROGRAM_IN_NUMBERS(extern, double)
PROGRAM_IN_NUMBERS(extern, float)
PROGRAM_IN_NUMBERS(extern, hilger::float50)
PROGRAM_IN_NUMBERS(extern, hilger::float100)

namespace program {

std::vector<std::string> embeddings_of(stated_problem const& what) {
    if (not what.of.damping.empty()) return {"mid-point"};
    if (what.of.force) return {"order-one", "mid-point", "gauss-4"};
    return {method_names.begin(), method_names.end()};
}
std::vector<std::string> scalars_of(stated_problem const& what) {
    if (not what.of.damping.empty()) return {"double"};
    if (what.of.force) return {"double", "50-digits"};
    return {"double", "float", "50-digits", "100-digits"};
}

bool has_embedding(stated_problem const& what, std::string const& method) {
    return what.of.damping.empty() and engine::lambda_of<double>(what.of, method).has_value();
}

engine::points<double> points_of(stated_problem const& what, hilger::index_type steps) {
    auto const number = [](std::string const& digits) { return *hilger::text::number_in<double>(digits); };
    auto const T = hilger::uniform(hilger::interval<double>{number(what.start), number(what.end)}, steps);
    return {T.min(), T.h(), steps, {}};
}

std::unique_ptr<walk> begin_stated(stated_problem const& what, configuration const& c) {
    engine::prepare_machine_code();
    if (c.scalar == "50-digits") return begin_in_numbers<hilger::float50>(what, c);
    if (c.scalar == "100-digits") return begin_in_numbers<hilger::float100>(what, c);
    int const d = what.of.force or not what.of.damping.empty() ? 0 : what.of.lagrangian.formula().words().dimension();
    auto const in = [&]<class S>(S) {
        return engine::with_small_size(d, [&]<int D>(std::integral_constant<int, D>) {
            if constexpr (D > 0)
                return begin_small<S, D>(what, c);
            else
                return begin_in_numbers<S>(what, c);
        });
    };
    return c.scalar == "float" ? in(float()) : in(double());
}

} // namespace program
