// SPDX-License-Identifier: BSL-1.0
#include "hilger/text/embedding.hpp"

#include "hilger/embedding/one_step.hpp"
#include "hilger/error.hpp"
#include "text/operator_in_numbers.hpp"

namespace hilger::text {

namespace {

/// In rationals; in 50 digits when a factor is irrational.
hilger::detail::consistency consistency_of(embedding_formula const& e, Q const& rounding) {
    auto const in = [&]<class S>(S const& tolerance) {
        return detail::with_operators<S>(e, true, [&]<class W>(auto const& a, auto const& b, W) {
            S const some = S(hilger::detail::some_step.value()) / S(1LL << 60);
            return hilger::detail::examine<W>(a, b, some, [&](S const& x, S const& y) { return magnitude(S(x - y)) <= tolerance; });
        });
    };
    try {
        return in(rounding);
    } catch (error::unreadable const&) {
        return in(float50(rounding) + float50("1e-40"));
    }
}

} // namespace

void require_one_step(embedding_formula const& e, double rounding) {
    auto const refuse = [](auto const&... why) { error::raise<error::invalid_parameter>(why...); };
    auto const lost = e.lost();
    if (e.position.has_weights() or e.velocity.has_weights())
        refuse("position and velocity of an embedding read one step, and mu/nu in ", e.text, " is of two");
    if (lost == lost_points{}) refuse("an embedding reads both ends of a step, and ", e.text, " reads the points of T alone");
    if (lost.front + lost.back > 1)
        refuse("position and velocity of an embedding read the two ends of one step, and those of ", e.text,
               " reach further: of T they lose ", lost.front, " points at the beginning and ", lost.back, " at the end");
    bool const forward = lost.back == 1;
    if (forward != (e.weight == sum_weight::delta))
        refuse(forward ? "what reads t and sigma(t) is summed by integral(L(...)), and what reads rho(t) and t by nabla_integral(L(...)): "
                       : "what reads rho(t) and t is summed by nabla_integral(L(...)), and what reads t and sigma(t) by integral(L(...)): ",
               e.text, " has the other one");
    using hilger::detail::consistency;
    auto const found = consistency_of(e, Q(rounding)); // the weights of both sums add up to the step, and one step has no inner values
    char const* const what = found == consistency::position_of_one    ? "position of an embedding makes 1 of the constant 1"
                             : found == consistency::velocity_of_one  ? "velocity of an embedding makes 0 of the constant 1"
                             : found == consistency::velocity_of_time ? "velocity of an embedding makes 1 of the function t"
                                                                      : nullptr;
    if (what != nullptr) refuse("the ", what, ", and that of ", e.text, " not, so that its steps would follow another system");
}

bool depends_on_step(embedding_formula const& e) {
    auto const differs = [&]<class S>(S const& tolerance) {
        auto const at = [&](S const& h, bool sizes = false) {
            return detail::row_on<S>([&](index_type) { return h; }, e.position, e.lost(), sizes);
        };
        auto const x = at(S(1)), y = at(S(3)), of_x = at(S(1), true), of_y = at(S(3), true);
        for (std::size_t k = 0; k < x.size(); ++k)
            if (magnitude(S(x[k] - y[k])) > tolerance * S(of_x[k] + of_y[k])) return true;
        return false;
    };
    try {
        return differs(Q(0));
    } catch (error::unreadable const&) { // a factor is irrational
        return differs(float50("1e-40"));
    }
}

} // namespace hilger::text
