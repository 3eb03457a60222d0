// SPDX-License-Identifier: BSL-1.0
// `hilger papers`: the tables, figures and theorems of the four papers once more, what was printed beside what is computed here. What
// computes is in papers/*/*.hpp, and the papers' tests use the same.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

namespace program {

struct papers_options {
    std::string out = "out"; ///< directory for the CSV files and the pictures
    std::string paper;       ///< one of bourdin, cresson, galucio, jimenez; all where empty
};
/// Returns 0 when every number and theorem agrees or is known to differ, with the reason said; 1 otherwise.
/// @throws hilger::error::invalid_parameter for a paper of another name, unreadable where nothing can be written
int run_papers(papers_options const& options);

/// A number that is known not to be as it was printed: its name, what it is instead, and why.
struct known_difference {
    std::string where, value, reason;
};

/// How often a paper and this program agree.
class agreement {
public:
    /// A number as it was printed, and as it is computed. They agree when their difference is at most half a unit of the last digit
    /// printed. One of those known to differ agrees with its own value in the same way. Returns the difference and, where there is one, a
    /// mark.
    std::string number(std::string const& where, std::string const& printed, double computed,
                       std::vector<known_difference> const& known = {});
    /// An order as it was claimed and as it was fitted: within 0.02.
    std::string order(std::string const& where, int claimed, double fitted);
    /// A statement in exact rationals, so many times.
    std::string exact(std::string const& where, long cases, long held);
    /// Returns whether nothing differs without a reason.
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
void show_jimenez(std::string const& out, agreement& seen);

/// Right-aligned text in a table of the program, and the digits of a number that a table shows.
std::string right(std::string const& text, std::size_t width);
std::string fixed(double value, int digits);
std::string scientific(double value, int digits);

} // namespace program
