// SPDX-License-Identifier: BSL-1.0
// expect: the end terms of Delta_plus need g where A f lives, on T^{+}, and it lives on T
// <Delta_plus[f], g> has no use for g(b), and its adjoint must not use it either.
#include "hilger/calculus.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    auto const f = function_on(T, [](double t) { return t; });
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const ends = boundary_form(Delta_plus, f, f);
#else
    [[maybe_unused]] auto const ends = boundary_form(Delta_plus, f, restrict_to(f, without_last(T)));
#endif
}
