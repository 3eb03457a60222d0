// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace program {

/// Pictures side by side, one for each line of plot commands, by gnuplot from CSV files in the directory. Returns the name of the picture,
/// or of the script when there is no gnuplot.
std::string draw(std::string const& directory, std::string const& name, std::string const& commands);
/// One picture in characters, as text. Empty without gnuplot, and when curves cover more than an eighth of the picture: a curve with more
/// than a dozen oscillations is illegible in characters.
std::string sketch(std::string const& directory, std::string const& name, std::string const& commands);
/// Opens a file for writing in the directory, which is created if missing. @throws hilger::error::unreadable when that fails
std::ofstream create(std::string const& directory, std::string const& name);
/// Draws orbits and energy errors from the demonstration's CSV files with gnuplot. Returns the name of the picture, or of the script when
/// there is no gnuplot.
std::string plot_solar_system(std::string const& directory, std::vector<std::string> const& bodies);

} // namespace program
