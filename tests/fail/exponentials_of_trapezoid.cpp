// SPDX-License-Identifier: BSL-1.0
// expect: exponentials know Gruenwald-Letnikov and the BDF, for this generating function there are direct and blocks
// Its weights oscillate: 1 + z vanishes on the unit circle.
#include "hilger/history/history.hpp"

using namespace hilger;

int main() {
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const history = make_history<trapezoid>(exponentials{}, 0.5, 0.0);
#else
    [[maybe_unused]] auto const history = make_history<trapezoid>(blocks{}, 0.5, 0.0);
#endif
}
