// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace program {

/// Pictures side by side, one for each line of commands that plots, by gnuplot, from CSV files in the directory. Returns the name of the
/// picture, or of the script when there is no gnuplot.
std::string draw(std::string const& directory, std::string const& name, std::string const& commands);
/// One picture made of letters, as text. Empty when there is no gnuplot, and where curves cover more than an eighth of the picture: a curve
/// that goes up and down more than a dozen times has no shape in letters.
std::string sketch(std::string const& directory, std::string const& name, std::string const& commands);
/// A file to be written in the directory, which is made where it is not there. @throws hilger::error::unreadable where it cannot be
std::ofstream create(std::string const& directory, std::string const& name);
/// Draws orbits and energy errors from the demonstration's CSV files with gnuplot. Returns the name of the picture, or of the
/// script when there is no gnuplot.
std::string plot_solar_system(std::string const& directory, std::vector<std::string> const& bodies);

} // namespace program
