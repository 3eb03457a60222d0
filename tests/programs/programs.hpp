// SPDX-License-Identifier: BSL-1.0
// Programs as a user writes them on the first day, and what judges them: the equation that was derived from their action, at the
// positions that they return; the same walk in 50 digits; and the equation there.
#pragma once

#include <doctest/doctest.h>

#include "hilger/integrator/residual.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::programs {

/// What rounding leaves of an equation in which numbers of the size p / h and m q / h^2 cancel: each of them has a few epsilons of itself.
/// m is the largest mass d2L/dv2 there is.
template <class Path>
auto rounding_along(Path const& path, double mass) {
    using state_type = std::remove_cvref_t<decltype(*path.begin())>;
    using S = decltype(state_type::t);
    S q(0), p(0), h(0);
    state_type last = *path.begin();
    for (auto const& x : path) {
        q = std::max(q, S(magnitude(x.q)));
        p = std::max(p, S(magnitude(x.p)));
        S const step = x.t - last.t;
        if (S(0) < step and (h == S(0) or step < h)) h = step;
        last = x;
    }
    return S(S(32) * epsilon<S>() * (p + S(mass) * q / h) / h);
}

/// The path solves its equation to rounding, and moves.
template <class Path>
void is_a_solution(Path const& path, double mass = 1) {
    auto const bound = rounding_along(path, mass);
    auto const residual = largest_residual(path);
    CAPTURE(residual);
    CAPTURE(bound);
    CHECK(residual <= bound);
    CHECK(residual == residual);
    auto const start = *path.begin();
    auto moved = magnitude(plain_t<decltype(start.q)>(start.q - start.q));
    for (auto const& x : path) moved = std::max(moved, magnitude(plain_t<decltype(start.q)>(x.q - start.q)));
    CHECK(moved > 0.1);
}

/// The same program in double and in 50 digits: in both its equation holds, and the positions agree to the rounding of N steps. What a
/// system makes of a difference, `growth` says.
template <class Program>
void is_the_same_in_50_digits(Program const& program, double growth = 16, double mass = 1) {
    auto const path = program.template path<double>();
    auto const exact = program.template path<float50>();
    is_a_solution(path, mass);
    is_a_solution(exact, mass);
    double worst = 0, size = 0;
    auto y = exact.begin();
    for (auto const& x : path) {
        using s = detail::shape<std::remove_cvref_t<decltype(x.q)>>;
        using t = detail::shape<std::remove_cvref_t<decltype(y->q)>>;
        for (int k = 0; k < s::dimension(x.q); ++k) {
            float50 const q = t::component(y->q, k);
            worst = std::max(worst, static_cast<double>(abs(float50(s::component(x.q, k)) - q)));
            size = std::max(size, static_cast<double>(abs(q)));
        }
        ++y;
    }
    CAPTURE(worst);
    CHECK(worst <= growth * static_cast<double>(path.scale().size()) * epsilon<double>() * size);
}

} // namespace hilger::programs
