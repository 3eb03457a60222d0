// SPDX-License-Identifier: BSL-1.0
// A scene is a system, its scale, embedding, forces or memory, scalar, and observed quantities. Here its types are erased: a configuration
// holds the choices of the command line, and a walk is a run in progress.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/engine.hpp"

namespace program {

/// The choices for a run. An empty text or zero steps mean the scene's default.
struct configuration {
    std::string embedding, scalar, history;
    hilger::index_type steps = 0;
    friend bool operator==(configuration const&, configuration const&) = default;
};

/// A position on a trajectory along T.
class walk {
public:
    virtual ~walk() = default;
    /// Advances by so many steps, or to the last point. @throws the errors of steps; the walk is then at its last good point
    virtual void advance(hilger::index_type steps) = 0;
    [[nodiscard]] virtual hilger::index_type number() const = 0;
    /// The values of the scene's columns at this point, in digits that read back exactly.
    [[nodiscard]] virtual std::string row() const = 0;
    /// Position at this point, all components.
    [[nodiscard]] virtual std::vector<hilger::float100> position() const = 0;
    /// The largest changes of the invariants, over the points where row() was called.
    [[nodiscard]] virtual std::vector<double> drift() const = 0;
    /// Writes the state of the walk; false when there is a memory: such a walk is repeated from its start instead.
    virtual bool save(std::ostream&) const { return false; }
    /// Continues from the output of save. @throws hilger::error::unreadable
    virtual void load(std::istream&, std::string const& source) { (void)source; }
};

struct stated_problem;
/// The placeholder for the file of rows in a picture's commands.
inline constexpr std::string_view rows_of_picture = "<rows>";

struct scene {
    std::string name, title;
    std::string fingerprint; ///< of the problem's text
    std::string units;       ///< of the interval, or ""
    int dimension = 1;
    double t0 = 0, t1 = 1;
    configuration usual;
    std::vector<std::string> embeddings, scalars, histories;
    std::vector<std::string> columns, invariants; ///< all columns of a row; the ones that should be zero
    std::string picture;                          ///< gnuplot's commands, in which <rows> is the file of rows
    std::function<std::unique_ptr<walk>(configuration const&)> begin;
    /// The position at t1 in 100 digits; or a configuration to compute it with.
    std::function<std::vector<hilger::float100>()> exact;
    std::string exact_source;
    double exact_error = 1e-95;
    configuration reference;
    std::shared_ptr<stated_problem const> stated; ///< the problem, for a scene from a file
};

/// All scenes, those of examples/problems.
std::vector<scene> const& all_scenes();
/// The scene of this name, or of a file my.toml. @throws hilger::error::invalid_parameter with the known names, hilger::error::unreadable
scene const& scene_named(std::string const& name);
/// Fills the empty choices with the scene's defaults. @throws hilger::error::invalid_parameter with the possible choices
configuration completed(scene const& what, configuration choice);
std::string description(configuration const& c);
/// A method without comments and line breaks, which a text of operators may have, for titles and names.
std::string on_one_line(std::string_view method);

} // namespace program
