// SPDX-License-Identifier: BSL-1.0
#include <cstdio>
#include <exception>
#include <iostream>

#include <CLI/CLI.hpp>

#include "beam.hpp"
#include "demo.hpp"
#include "hilger/version.hpp"
#include "prove.hpp"

int main(int argc, char** argv) {
    CLI::App app{"hilger: time-scale calculus as a language"};
    app.set_version_flag("--version", std::to_string(HILGER_VERSION_MAJOR) + "." + std::to_string(HILGER_VERSION_MINOR) + "." +
                                          std::to_string(HILGER_VERSION_PATCH));
    app.require_subcommand(1);

    program::demo_options options;
    auto* demo = app.add_subcommand("demo", "the outer solar system: equations, identities, 200 000 days, drift and a picture");
    demo->add_option("--days", options.days, "length of the integration in days")->capture_default_str();
    demo->add_option("--step", options.step, "step h in days")->capture_default_str();
    demo->add_option("--data", options.data, "initial data, a CSV file like src/data/outer_solar_system.csv");
    demo->add_option("--out", options.out, "directory for the CSV files and the picture")->capture_default_str();
    auto* beam = app.add_subcommand("beam", "a viscoelastic cantilever with memory: the tip's deflection and phase diagram");
    beam->add_option("--out", options.out, "directory for the CSV file and the picture")->capture_default_str();
    auto* identities = app.add_subcommand("identities", "prove the identities behind the embeddings in exact rationals");

    CLI11_PARSE(app, argc, argv);
    try {
        if (*demo) return program::run_demo(options);
        if (*beam) return program::run_beam(options.out);
        if (*identities) return program::prove_identities(std::cout) ? 0 : 1;
    } catch (std::exception const& e) {
        std::fprintf(stderr, "hilger: %s\n", e.what());
        return 1;
    }
    return 0;
}
