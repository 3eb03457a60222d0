// SPDX-License-Identifier: BSL-1.0
// A scene is a system, its scale, embedding, forces or memory, scalar, and what is observed. Here its types are erased: what is chosen on
// the command line is a configuration, and what is under way is a walk.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/engine.hpp"

namespace program {

/// What can be chosen. An empty text or no steps stand for what the scene usually has.
struct configuration {
    std::string embedding, scalar, history;
    hilger::index_type steps = 0;
    friend bool operator==(configuration const&, configuration const&) = default;
};

/// A trajectory on its way along T.
class walk {
public:
    virtual ~walk() = default;
    /// So many steps further, or up to the last point. @throws what steps throw; the walk is then at its last good point
    virtual void advance(hilger::index_type steps) = 0;
    [[nodiscard]] virtual hilger::index_type number() const = 0;
    /// The numbers of this point under the scene's columns, in digits that read back exactly.
    [[nodiscard]] virtual std::string row() const = 0;
    /// Position at this point, all components.
    [[nodiscard]] virtual std::vector<hilger::float100> position() const = 0;
    /// The largest amounts by which what should be constant has changed, at the points where row() was asked for.
    [[nodiscard]] virtual std::vector<double> drift() const = 0;
    /// Writes all that the rest depends on; false where a walk is repeated from its start instead, because it has a memory.
    virtual bool save(std::ostream&) const { return false; }
    /// Goes on from what save has written. @throws hilger::error::unreadable
    virtual void load(std::istream&, std::string const& source) { (void)source; }
};

struct stated_problem;
/// What stands for the file of rows in a picture's commands.
inline constexpr std::string_view rows_of_picture = "<rows>";

struct scene {
    std::string name, title;
    std::string fingerprint; ///< of the text that states it
    std::string units;       ///< of the interval, "" where there are none
    int dimension = 1;
    double t0 = 0, t1 = 1;
    configuration usual;
    std::vector<std::string> embeddings, scalars, histories;
    std::vector<std::string> columns, invariants; ///< all columns of a row; those of them that should be zero
    std::string picture;                          ///< gnuplot's commands, in which <rows> is the file of rows
    std::function<std::unique_ptr<walk>(configuration const&)> begin;
    /// The position at t1 in 100 digits; or a configuration to compute it with.
    std::function<std::vector<hilger::float100>()> exact;
    std::string exact_source;
    double exact_error = 1e-95;
    configuration reference;
    std::shared_ptr<stated_problem const> stated; ///< of what a file states
};

/// All scenes, those of examples/problems.
std::vector<scene> const& all_scenes();
/// The scene of this name, or the one that a file my.toml states. @throws hilger::error::invalid_parameter that lists the names there are,
/// hilger::error::unreadable
scene const& scene_named(std::string const& name);
/// What is empty in a configuration, as the scene usually has it. @throws hilger::error::invalid_parameter that says what can be chosen
configuration completed(scene const& what, configuration choice);
std::string description(configuration const& c);
/// A method without the comments and the ends of lines that a text of operators may have: it stands in titles and in names.
std::string on_one_line(std::string_view method);

} // namespace program
