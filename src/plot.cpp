// SPDX-License-Identifier: BSL-1.0
#include "plot.hpp"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <sstream>

#include "hilger/error.hpp"

namespace program {

namespace {

/// Quotes a word for the shell.
std::string quoted(std::string const& word) {
    std::string all = "'";
    for (char const c : word) all += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return all + "'";
}
/// Writes the script and runs it in the directory of its files.
bool run_gnuplot(std::filesystem::path const& directory, std::string const& script, std::string const& commands) {
    std::ofstream(directory / script) << "set datafile separator ','\nset encoding utf8\n" << commands;
    std::string const command = "cd " + quoted(directory.string()) + " && gnuplot " + quoted(script) + " >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
}

} // namespace

std::string draw(std::string const& directory, std::string const& name, std::string const& commands) {
    std::filesystem::path const folder(directory);
    std::string const script = name + ".gp", picture = name + ".png";
    int plots = 0;
    std::istringstream lines(commands);
    for (std::string line; std::getline(lines, line);) plots += line.starts_with("plot ") or line.starts_with("splot ") ? 1 : 0;
    return run_gnuplot(folder, script,
                       "set terminal pngcairo size " + std::to_string(750 * plots) + ",720 font 'sans,12'\nset output '" + picture +
                           "'\nset multiplot layout 1," + std::to_string(plots) + '\n' + commands + "unset multiplot\n")
               ? (folder / picture).string()
               : (folder / script).string() + " (a gnuplot script: gnuplot itself did not run)";
}

std::string sketch(std::string const& directory, std::string const& name, std::string const& commands) {
    std::filesystem::path const folder(directory);
    if (not run_gnuplot(folder, name + ".txt.gp", "set terminal dumb size 100,28\nset output '" + name + ".txt'\n" + commands)) return "";
    std::string text;
    {
        std::ifstream written(folder / (name + ".txt"));
        text.assign(std::istreambuf_iterator<char>(written), {});
    }
    std::erase(text, '\f'); // gnuplot begins a page with it
    auto const marks =
        std::count_if(text.begin(), text.end(), [](char c) { return std::string_view("*#$%@&=").find(c) != std::string::npos; });
    if (8 * marks > 100 * 28) text.clear();
    std::ofstream(folder / (name + ".txt")) << text;
    return text;
}

std::ofstream create(std::string const& directory, std::string const& name) {
    auto const path = (std::filesystem::path(directory) / name).string();
    std::error_code ignored; // the missing file shows the failure
    std::filesystem::create_directories(directory, ignored);
    std::ofstream file(path);
    if (not file) hilger::error::raise<hilger::error::unreadable>("cannot write '", path, "'");
    file.precision(12);
    return file;
}

std::string plot_solar_system(std::string const& directory, std::vector<std::string> const& bodies) {
    std::ostringstream out;
    out << "set title 'Mid-point embedding: orbits seen from the Sun'\n"
           "set xlabel 'x / au'; set ylabel 'y / au'; set zlabel 'z / au'\n"
           "set view 60, 35; set xyplane relative 0.1; set key left top\n"
           "splot ";
    for (std::size_t i = 1; i < bodies.size(); ++i) {
        std::size_t const column = 4 + 3 * i;
        out << (i > 1 ? ", " : "") << "'midpoint.csv' using " << column << ':' << column + 1 << ':' << column + 2 << " with lines title '"
            << bodies[i] << "'";
    }
    out << "\nset title 'Relative energy error'\n"
           "set xlabel 't / 1000 days'; set ylabel '|H - H_0| / |H_0|' offset 1; set logscale y; set format y '10^{%L}'\n"
           "set yrange [1e-10:10]; set grid; set key right bottom opaque\n"
           "plot 'euler.csv' using ($1/1000):2 with lines title 'explicit Euler', "
           "'runge_kutta.csv' using ($1/1000):2 with lines title 'Runge-Kutta 4', "
           "'order_one.csv' using ($1/1000):2 with lines title 'hilger, order one', "
           "'midpoint.csv' using ($1/1000):2 with lines title 'hilger, mid-point'\n";
    return draw(directory, "outer_solar_system", out.str());
}

} // namespace program
