// SPDX-License-Identifier: BSL-1.0
// `hilger papers`: reruns the tables, figures and theorems of the papers, printed values beside computed ones. The computations are in
// papers/*/*.hpp, shared with the papers' tests.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace program {

struct papers_options {
    std::string out = "out"; ///< directory for the CSV files and the pictures
    std::string paper;       ///< one of bourdin, cresson, galucio, hariz, jimenez; all where empty
};
/// Returns 0 when every number and theorem agrees, or differs for a stated reason; 1 otherwise.
/// @throws hilger::error::invalid_parameter for a paper of another name, unreadable when nothing can be written
int run_papers(papers_options const& options);

/// A known misprint: the number's name, its correct value, and the reason.
struct known_difference {
    std::string where, value, reason;
};

/// Counts how often a paper and this program agree.
class agreement {
public:
    /// A printed number against the computed one. They agree when they differ by at most half a unit of the last printed digit; a known
    /// misprint agrees in the same way with its correct value. Returns the difference and, if any, a mark.
    std::string number(std::string const& where, std::string const& printed, double computed,
                       std::vector<known_difference> const& known = {});
    /// A claimed order against the fitted one: within 0.02.
    std::string order(std::string const& where, int claimed, double fitted);
    /// A statement in exact rationals, tried in so many cases.
    std::string exact(std::string const& where, long cases, long held);
    /// Returns whether every difference has a stated reason.
    bool summarize(std::ostream& out, std::string const& paper) const;

private:
    std::string seen(std::string const& where, bool agrees, std::string const& reason, std::string const& text);

    long numbers_ = 0, agreeing_ = 0, statements_ = 0, holding_ = 0;
    std::vector<std::string> known_, unknown_;
};

/// Each prints, writes its CSV files and pictures into the directory, and counts.
void show_bourdin(std::string const& out, agreement& seen);
void show_cresson(std::string const& out, agreement& seen);
void show_galucio(std::string const& out, agreement& seen);
void show_hariz(std::string const& out, agreement& seen);
void show_jimenez(std::string const& out, agreement& seen);

/// Right-aligned text for a table, and the digits of a number in a table.
std::string right(std::string const& text, std::size_t width);
std::string fixed(double value, int digits);
std::string scientific(double value, int digits);

} // namespace program
