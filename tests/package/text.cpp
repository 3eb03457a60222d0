// SPDX-License-Identifier: BSL-1.0
// The smallest user of what is compiled: v^2/2 - q at q = v = 3 is 3/2.
#include "hilger/text/stated.hpp"

int main() {
    namespace text = hilger::text;
    auto const words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 0}});
    auto const three = [](int) { return 3.0; };
    return text::stated(text::read("v^2/2 - q"), words, "f").value(0.0, three, three) == 1.5 ? 0 : 1;
}
