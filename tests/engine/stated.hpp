// SPDX-License-Identifier: BSL-1.0
// Problems in text, and a folder for what is compiled of them.
#pragma once

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>

#include <unistd.h>

#include "engine/machine_code/machine_code.hpp"
#include "engine/motions.hpp"
#include "support/there.hpp"

namespace hilger::testing {

/// While it lives, what is compiled is kept in a folder of its own.
class kept_here {
public:
    kept_here() : path_(std::filesystem::temp_directory_path() / ("hilger_kept_" + std::to_string(::getpid()))) {
        std::filesystem::create_directory(path_);
        ::setenv("XDG_CACHE_HOME", path_.c_str(), 1);
        engine::set_machine_code(engine::machine_code::on);
    }
    ~kept_here() {
        engine::set_machine_code(engine::machine_code::off);
        std::filesystem::remove_all(path_);
    }
    kept_here(kept_here const&) = delete;
    kept_here& operator=(kept_here const&) = delete;

private:
    std::filesystem::path path_;
};

/// Of d coordinates q and velocities v. Parameters are g = 1 and k = {1, 2}.
inline engine::problem stated(std::string const& L, int d, std::vector<std::string> const& force = {},
                              std::vector<std::string> const& brought = {}) {
    auto const words = std::make_shared<text::vocabulary>(std::vector<text::coordinate>{{"q", "v", d}});
    words->set("g", "1");
    words->set("k", std::vector<std::string>{"1", "2"});
    for (auto const& name : brought) words->bring_with_states(name);
    engine::problem made{text::lagrangian_in(L, words), {}, {}, "direct"};
    std::vector<text::stated> components;
    for (auto const& f : force) components.emplace_back(text::read(f, "the force"), words, "the force");
    if (not force.empty()) made.force.emplace(components);
    return made;
}

/// Points whose distances are from 3/4 to 5/4 of 1/16.
inline engine::points<double> uneven(index_type steps) {
    engine::points<double> T{0, 0, steps, {}};
    for (index_type i = 0; i <= steps; ++i)
        T.given.push_back(0.25 + 0.0625 * (static_cast<double>(i) + 0.25 * std::sin(static_cast<double>(i))));
    return T;
}

} // namespace hilger::testing
