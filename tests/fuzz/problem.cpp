// SPDX-License-Identifier: BSL-1.0
// The same of the reader of problems in TOML, without what toml++ itself shifts out of range. By hand, from the root of the project:
//   clang++ -std=gnu++20 -O1 -g -fsanitize=fuzzer,address -DHILGER_HAS_FLOAT128=0 -Iinclude -Isrc -Isrc/problems
//     -isystem /usr/include/eigen3 tests/fuzz/problem.cpp src/problems/{from_file,observed_in_file}.cpp src/text/*.cpp
//     -o build/fuzz_problem
//   build/fuzz_problem -max_len=1000 -max_total_time=600 -timeout=20 build/corpus tests/fuzz/problems
#include <cstdint>

#include "from_file.hpp"
#include "hilger/error.hpp"

namespace program {

// What is read is not run.
std::vector<std::string> embeddings_of(stated_problem const&) { return {"order-one", "mid-point"}; }
std::vector<std::string> scalars_of(stated_problem const&, std::vector<std::string> const&) { return {"double", "50-digits"}; }
void require_structure(engine::problem const&) {}
bool has_embedding(stated_problem const&, std::string const&) { return false; }
std::string on_one_line(std::string_view method) { return std::string(method); }
bool has_method(stated_problem const&, configuration const&) { return false; }
bool is_for_parts(stated_problem const&, std::string const&) { return false; }
std::unique_ptr<walk> begin_stated(stated_problem const&, configuration const&) { return nullptr; }

} // namespace program

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size) {
    try {
        program::scene_from_text({reinterpret_cast<char const*>(data), size}, "problem.toml");
    } catch (hilger::error::exception const&) {}
    return 0;
}
