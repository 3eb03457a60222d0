// SPDX-License-Identifier: BSL-1.0
// expect 1: bdf<2>_minus_alpha<1/2> has the weights of one step h, and this function lives on
// expect 2: Delta_minus_alpha<1/2> has the weights of one step h, and this integral is over
// Gruenwald and Letnikov's differences are powers of the difference on every T; other generating functions are not, and neither are
// histories.
#include "hilger/calculus.hpp"
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    constexpr unknown q;
    constexpr unknown<"y"> y;
    auto const equal = uniform(0.0, 1.0, 2);
    time_scale<double> const given{0.0, 1.0, 2.0};
    [[maybe_unused]] auto const on_every_scale = Delta_minus_alpha<1, 2>[function_on(given, [](double t) { return t; })];
    auto const& T = [&]() -> auto const& {
#ifdef MUST_NOT_COMPILE
        return given;
#else
        return equal;
#endif
    }
    ();
#if not defined(MUST_NOT_COMPILE) || MUST_NOT_COMPILE == 1
    (void)minus_alpha<bdf<2>, 1, 2>[function_on(T, [](double t) { return t; })];
#endif
#if not defined(MUST_NOT_COMPILE) || MUST_NOT_COMPILE == 2
    (void)integral(Delta_minus_alpha<1, 2>[q] * Delta_plus_alpha<1, 2>[y], T);
#endif
    (void)equal;
}
