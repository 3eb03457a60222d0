// SPDX-License-Identifier: BSL-1.0
// The smallest user: the length of T = {0, 1/2, 1} is 1.
#include "hilger/hilger.hpp"

int main() {
    auto const T = hilger::uniform(0.0, 0.5, 2);
    return T.max() - T.min() == 1.0 ? 0 : 1;
}
