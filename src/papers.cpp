// SPDX-License-Identifier: BSL-1.0
#include "papers.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <iostream>

#include "../papers/table.hpp"

namespace program {

namespace {

struct paper {
    char const *name, *title;
    void (*show)(std::string const& out, agreement& seen);
};
constexpr std::array papers{
    paper{"bourdin", "L. Bourdin, J. Cresson, I. Greff, P. Inizan, Variational integrator for fractional Euler-Lagrange equations (2013)",
          show_bourdin},
    paper{"jimenez", "F. Jimenez, S. Ober-Bloebaum, Local truncation error of low-order fractional variational integrators (2019)",
          show_jimenez},
    paper{"galucio", "A. C. Galucio, J.-F. Deue, F. Dubois, The G^alpha-scheme for approximation of fractional derivatives (2008)",
          show_galucio},
    paper{"hariz",
          "K. Hariz, F. Jimenez, S. Ober-Bloebaum, Runge-Kutta convolution quadrature based fractional variational integrators (2026)",
          show_hariz},
    paper{"cresson", "J. Cresson, R. Safi, Mid-point embedding of Hamiltonian systems and variational integrators (2022)", show_cresson}};

std::string formatted(char const* format, double value, int digits) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, digits, value);
    return text.data();
}

} // namespace

std::string right(std::string const& text, std::size_t width) {
    return text.size() < width ? std::string(width - text.size(), ' ') + text : text;
}
std::string fixed(double value, int digits) { return formatted("%.*f", value, digits); }
std::string scientific(double value, int digits) { return formatted("%.*e", value, digits); }

std::string agreement::seen(std::string const& where, bool agrees, std::string const& reason, std::string const& text) {
    if (agrees) return text;
    (reason.empty() ? unknown_ : known_).push_back(where + (reason.empty() ? ": " + text : ": " + reason));
    return text + (reason.empty() ? " !" : " *");
}

std::string agreement::number(std::string const& where, std::string const& printed, double computed,
                              std::vector<known_difference> const& known) {
    auto const is = [&](std::string const& digits) { return std::abs(hilger::papers::difference_in_units(computed, digits)) <= 0.5; };
    bool const agrees = is(printed);
    ++numbers_;
    agreeing_ += agrees ? 1 : 0;
    auto const difference = std::find_if(known.begin(), known.end(), [&](auto const& d) { return d.where == where and is(d.value); });
    return seen(where + ", printed " + printed + ", computed " + formatted("%.*g", computed, 6), agrees,
                difference == known.end() ? "" : difference->reason, formatted("%+.*e", computed - std::stod(printed), 1));
}

std::string agreement::order(std::string const& where, int claimed, double fitted) {
    bool const agrees = std::abs(fitted - claimed) < 0.02;
    ++statements_;
    holding_ += agrees ? 1 : 0;
    return seen(where, agrees, "", formatted("%+.*e", fitted - claimed, 1));
}

std::string agreement::exact(std::string const& where, long cases, long held) {
    bool const agrees = cases > 0 and held == cases;
    ++statements_;
    holding_ += agrees ? 1 : 0;
    return seen(where, agrees, "", std::to_string(held) + " of " + std::to_string(cases));
}

bool agreement::summarize(std::ostream& out, std::string const& paper) const {
    out << "  " << paper << ": ";
    if (numbers_ > 0) out << agreeing_ << " of " << numbers_ << " numbers agree to the digits printed";
    if (numbers_ > 0 and statements_ > 0) out << ", ";
    if (statements_ > 0) out << holding_ << " of " << statements_ << " statements hold";
    out << '\n';
    for (auto const& text : known_) out << "    * " << text << '\n';
    for (auto const& text : unknown_) out << "    ! " << text << " (not known to differ)\n";
    return unknown_.empty();
}

int run_papers(papers_options const& options) {
    bool found = options.paper.empty(), all = true;
    for (auto const& p : papers) found = found or options.paper == p.name;
    if (not found)
        hilger::error::raise<hilger::error::invalid_parameter>(
            "--paper is one of bourdin, jimenez, galucio, hariz and cresson, or is left out for all of them, and this is '", options.paper,
            "'");
    auto const start = std::chrono::steady_clock::now();
    std::array<agreement, papers.size()> seen;
    for (std::size_t i = 0; i < papers.size(); ++i)
        if (options.paper.empty() or options.paper == papers[i].name) {
            std::cout << papers[i].title << "\n\n";
            papers[i].show(options.out, seen[i]);
        }
    std::cout << "Agreement\n";
    for (std::size_t i = 0; i < papers.size(); ++i)
        if (options.paper.empty() or options.paper == papers[i].name) all = seen[i].summarize(std::cout, papers[i].name) and all;
    std::cout << (all ? "Nothing differs without a reason" : "Something differs that should not") << "; "
              << fixed(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 1) << " s\n";
    return all ? 0 : 1;
}

} // namespace program
