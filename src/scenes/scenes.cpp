// SPDX-License-Identifier: BSL-1.0
#include <algorithm>
#include <map>

#include "hilger/error.hpp"
#include "problems/from_file.hpp"
#include "problems/scene.hpp"
#include "problems_in_files.hpp"

namespace program {

namespace {

std::string listed(std::vector<std::string> const& names) {
    std::string text;
    for (auto const& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

/// `chosen`, or by default `usual`. A parameter follows a colon.
void complete(std::string& chosen, std::string const& usual, std::vector<std::string> const& choices, scene const& what,
              char const* option) {
    if (chosen.empty()) chosen = usual;
    auto const same = [&](std::string const& name) {
        auto const colon = name.find(':');
        return chosen == name or (colon != std::string::npos and chosen.compare(0, colon + 1, name, 0, colon + 1) == 0);
    };
    if (choices.empty() and not chosen.empty())
        hilger::error::raise<hilger::error::invalid_parameter>("the scene ", what.name, " has no ", option, " to choose, and it was '",
                                                               chosen, "'");
    if (not choices.empty() and std::none_of(choices.begin(), choices.end(), same))
        hilger::error::raise<hilger::error::invalid_parameter>("--", option, " of the scene ", what.name, " is one of ", listed(choices),
                                                               ", not '", chosen, "'");
}

} // namespace

std::vector<scene> const& all_scenes() {
    static std::vector<scene> const all = [] {
        std::vector<scene> made;
        for (auto const& [name, content] : problems_in_files) made.push_back(scene_from_text(content, std::string(name) + ".toml"));
        return made;
    }();
    return all;
}

scene const& scene_named(std::string const& name) {
    if (name.ends_with(".toml")) {
        static std::map<std::string, scene> files;
        auto const at = files.find(name);
        return at != files.end() ? at->second : files.emplace(name, scene_from_file(name)).first->second;
    }
    std::vector<std::string> names;
    for (auto const& s : all_scenes()) {
        if (s.name == name) return s;
        names.push_back(s.name);
    }
    hilger::error::raise<hilger::error::invalid_parameter>("there is no scene '", name, "'; there are ", listed(names),
                                                           ", and files as my.toml");
}

std::string on_one_line(std::string_view method) {
    std::string line;
    bool in_comment = false, after_space = false;
    for (char const c : method) {
        in_comment = c != '\n' and (in_comment or c == '#');
        bool const is_space = c == ' ' or c == '\t' or c == '\r' or c == '\n';
        if (not in_comment and not is_space) {
            if (after_space and not line.empty()) line += ' ';
            line += c;
        }
        after_space = in_comment ? after_space : is_space;
    }
    return line;
}

configuration completed(scene const& what, configuration c) {
    c.embedding = on_one_line(c.embedding);
    complete(c.scalar, what.usual.scalar, what.scalars, what, "scalar");
    if (c.embedding.empty() or not has_embedding(*what.stated, c.embedding))
        complete(c.embedding, what.usual.embedding, what.embeddings, what, "embedding");
    complete(c.history, what.usual.history, what.histories, what, "history");
    if (c.steps == 0) c.steps = what.usual.steps;
    return c;
}

std::string description(configuration const& c) {
    return c.embedding + (c.history.empty() ? "" : ", " + c.history) + ", " + c.scalar + ", " + std::to_string(c.steps) + " steps";
}

} // namespace program
