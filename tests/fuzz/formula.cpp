// SPDX-License-Identifier: BSL-1.0
// No text makes the reader of formulas do anything but accept it or throw an error of hilger's. By hand, from the root of the project:
//   clang++ -std=gnu++20 -O1 -g -fsanitize=fuzzer,address,undefined -DHILGER_HAS_FLOAT128=0 -Iinclude -isystem /usr/include/eigen3
//     tests/fuzz/formula.cpp -o build/fuzz_formula
//   build/fuzz_formula -max_len=400 -max_total_time=600 -timeout=20 build/corpus tests/fuzz/formulas
#include <cstdint>

#include "hilger/text/lagrangian.hpp"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    namespace text = hilger::text;
    static auto const words = [] {
        auto made = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", 0}, {"x", "u", 3}});
        made->set("n", "3");
        made->set("w", std::vector<std::string>{"1", "1/2", "0.25"});
        return made;
    }();
    try {
        text::stated const f(text::read({reinterpret_cast<char const*>(data), size}), words, "f");
        auto const half = [](int) { return 0.5; };
        f.value(0.5, half, half);
    } catch (hilger::error::exception const&) {}
    return 0;
}
