// SPDX-License-Identifier: BSL-1.0
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>
#include <string>

#include <CLI/CLI.hpp>

#include "engine/methods.hpp"
#include "extremes.hpp"
#include "hilger/text/vocabulary.hpp"
#include "hilger/version.hpp"
#include "papers.hpp"
#include "prove.hpp"
#include "scenes/ensemble.hpp"
#include "scenes/run.hpp"
#include "scenes/trade.hpp"

namespace {

/// Counts may be written as 1e6.
CLI::Validator count() {
    return {[](std::string& given) -> std::string {
                auto const number = hilger::text::number_in<double>(given);
                if (not number or not(*number >= 1) or *number != std::floor(*number) or *number > 1e15)
                    return "a positive whole number is wanted, as 1000 or 1e3, and here is " + given;
                given = std::to_string(static_cast<long long>(*number));
                return {};
            },
            "COUNT"};
}

CLI::Validator positive() {
    return {[](std::string& given) -> std::string {
                auto const number = hilger::text::number_in<double>(given);
                if (not number or not(*number > 0)) return "a positive number is wanted, as 0.5 or 1e-3, and here is " + given;
                return {};
            },
            "NUMBER"};
}

} // namespace

int main(int argc, char** argv) {
    CLI::App app{"hilger: time-scale calculus as a language"};
    app.set_version_flag("--version", std::to_string(HILGER_VERSION_MAJOR) + "." + std::to_string(HILGER_VERSION_MINOR) + "." +
                                          std::to_string(HILGER_VERSION_PATCH));
    app.require_subcommand(1);

    auto* scenes = app.add_subcommand("scenes", "list the scenes: what can be run");
    auto* methods = app.add_subcommand("methods", "list the methods: order, definition, and the numbers that each is for");
    program::run_options run;
    auto* run_command = app.add_subcommand("run", "run a scene: rows, a summary and a picture; continues what was interrupted");
    run_command->add_option("scene", run.scene, "one of those that `hilger scenes` lists, or a file, my.toml")->required();
    run_command->add_option("--embedding", run.choice.embedding, "embedding or method, as order-one, mid-point, gauss-4");
    run_command->add_option("--scalar", run.choice.scalar, "double, 50-digits, 100-digits");
    run_command->add_option("--steps", run.choice.steps, "number of steps")->transform(count());
    run_command->add_option("--history", run.choice.history, "exponentials, exponentials:TOLERANCE, blocks, direct");
    run_command->add_option("--every", run.every, "write a row at every so many points")->transform(count());
    run_command->add_option("--ensemble", run.ensemble,
                            "a table, members.csv: my.toml from each of its rows, whose columns are coordinates, velocities, parameters");
    run_command->add_option("--threads", run.threads, "threads of an ensemble")->transform(count());
    run_command->add_option("--out", run.out, "directory for what is written")->capture_default_str();
    run_command->add_option("--stop-after", run.stop_after, "stop after so many rows; the same command goes on from there")
        ->transform(count());
    run_command->add_flag("--anew", run.anew, "do not continue an interrupted run");
    program::trade_options trade;
    auto* trade_command = app.add_subcommand("trade", "measure a scene's accuracy against its cost, beside other libraries");
    trade_command->add_option("scene", trade.scene, "one of those that `hilger scenes` lists, or a file, my.toml")->required();
    trade_command->add_option("--accuracy", trade.accuracy, "say what to use for this accuracy")->check(positive());
    trade_command->add_option("--budget", trade.budget, "seconds that one run may take (ten times that in many digits)")
        ->capture_default_str()
        ->check(positive());
    trade_command->add_option("--out", trade.out, "directory for the CSV file and the picture")->capture_default_str();
    program::papers_options about;
    auto* papers = app.add_subcommand("papers", "the tables, figures and theorems of the papers, theirs beside ours");
    papers->add_option("--out", about.out, "directory for the CSV files and the pictures")->capture_default_str();
    papers->add_option("--paper", about.paper, "one of them: bourdin, jimenez, galucio, hariz or cresson");
    auto* identities = app.add_subcommand("identities", "prove the identities behind the embeddings in exact rationals");
    auto* extremes = app.add_subcommand("extremes", "what is promised and what is measured at the extremes of numbers, steps and orders");
    bool quick = false;
    extremes->add_flag("--quick", quick, "fewer points and steps: seconds instead of a minute");

    CLI11_PARSE(app, argc, argv);
    try {
        if (*scenes) program::list_scenes(std::cout);
        if (*methods) engine::list_methods(std::cout);
        if (*run_command) return run.ensemble.empty() ? program::run_scene(run) : program::run_ensemble(run);
        if (*trade_command) return program::run_trade(trade);
        if (*papers) return program::run_papers(about);
        if (*extremes) return program::report_extremes(std::cout, quick) ? 0 : 1;
        if (*identities) return program::prove_identities(std::cout) ? 0 : 1;
    } catch (std::bad_alloc const&) {
        std::fprintf(stderr, "hilger: there is not enough memory for this: fewer steps, or histories of exponentials, take less\n");
        return 1;
    } catch (std::exception const& e) {
        std::fprintf(stderr, "hilger: %s\n", e.what());
        return 1;
    }
    return 0;
}
