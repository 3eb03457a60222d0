// SPDX-License-Identifier: BSL-1.0
// No text makes the reader of formulas do anything but accept it or throw an error of hilger's; and what it accepts is written as a text
// that it accepts, and is written the same again. By hand, from the root of the project:
//   clang++ -std=gnu++20 -O1 -g -fsanitize=fuzzer,address,undefined -DHILGER_HAS_FLOAT128=0 -Iinclude -Isrc
//     -isystem /usr/include/eigen3 tests/fuzz/formula.cpp src/text/*.cpp -o build/fuzz_formula
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
        auto const read = text::read({reinterpret_cast<char const*>(data), size});
        auto const written = text::written(read, 100'000);
        if (written and text::written(text::read(*written), 200'000) != written) __builtin_trap();
        text::stated const f(read, words, "f");
        auto const half = [](int) { return 0.5; };
        f.value(0.5, half, half);
    } catch (hilger::error::exception const&) {}
    return 0;
}
