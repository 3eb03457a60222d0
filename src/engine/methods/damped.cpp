// SPDX-License-Identifier: BSL-1.0
#include "engine/methods/damped.hpp"

#include <cmath>

#include "hilger/accuracy/pieces.hpp"

namespace engine {

namespace {

/// With the same ends and as many steps: the first eighth is graded.
points<double> graded_at_start(points<double> T, double gamma) {
    if (T.steps < 2 or not T.is_uniform()) return T;
    double const share = gamma / (gamma + 7);
    auto const first = std::clamp<hilger::index_type>(std::lround(share * static_cast<double>(T.steps)), 1, T.steps - 1);
    auto const ends = hilger::detail::with_starts(std::vector{T.start, *T.last});
    T.given = elements_of<double>(hilger::detail::joined_pieces(ends, {first, T.steps - first}, gamma));
    return T;
}
template <int Stages>
made at_nodes(problem const& what, std::string const& method, points<double> const& T) {
    made result;
    with_history(what.history, T.steps, [&]<class Policy>(Policy const& policy) {
        if constexpr (std::same_as<Policy, hilger::exponentials>) {
            auto const flow = hilger::embed(hilger::with_fractional_damping(with_any_force(what), fractional_terms_of(what), policy),
                                            hilger::galerkin<Stages, hilger::radau>);
            result = motion_by(flow, T.may_be_graded ? graded_at_start(T, flow.damping().template grading<double>()) : T, method);
        } else
            hilger::error::raise<hilger::error::invalid_parameter>("the history of ", method, " is exponentials, and not ", what.history);
    });
    return result;
}

} // namespace

made damped(problem const& what, std::string const& method, points<double> const& T) {
    if (method == "radau-3") return at_nodes<3>(what, method, T);
    if (method == "radau-4") return at_nodes<4>(what, method, T);
    if (method == "radau-5") return at_nodes<5>(what, method, T);
    if (method != "mid-point") return nullptr;
    made result;
    with_damped(what, with_any_force(what), T.steps, [&](auto const& flow) { result = motion_by(flow, T, method); });
    return result;
}

} // namespace engine
