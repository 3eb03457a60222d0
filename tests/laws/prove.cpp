// SPDX-License-Identifier: BSL-1.0
#include "prove.hpp"

#include <iomanip>
#include <iostream>
#include <map>

#include <doctest/doctest.h>
#include <rapidcheck.h>

namespace laws {

namespace {

struct record {
    std::string source;
    long cases = 0, comparisons = 0;
    double worst = 0;
    std::uint64_t seed = 0; ///< of the first setting; the others' follow from their names
};
std::map<std::string, record> table;
bool all_exact = true;

std::uint64_t seed_of(std::string const& text) { // FNV-1a: a seed that stays the same from run to run
    std::uint64_t hash = 14695981039346656037ULL;
    for (unsigned char const c : text) hash = (hash ^ c) * 1099511628211ULL;
    return hash;
}

} // namespace

void prove(std::string const& name, std::string const& source, std::string const& setting, bool exact, int times, experiment const& run) {
    auto& row = table[name];
    row.source = source;
    all_exact = all_exact and exact;
    auto const property = [&] {
        auto const numbers =
            *rc::gen::container<std::vector<std::pair<int, int>>>(48, rc::gen::pair(rc::gen::inRange(-99, 100), rc::gen::inRange(1, 20)));
        drawn d(numbers);
        hilger::verdict const v = run(d);
        if (v.comparisons > 0) ++row.cases; // an operator that leaves no point of a short scale proves nothing there
        row.comparisons += v.comparisons;
        row.worst = std::max(row.worst, v.worst);
        if (not v.holds) RC_FAIL(v.first_failure);
    };
    rc::detail::TestParams params;
    params.seed = seed_of(name + source + setting);
    if (row.seed == 0) row.seed = params.seed;
    params.maxSuccess = times;
    auto const result = rc::detail::checkTestable(property, rc::detail::TestMetadata{name, setting}, params);
    if (not result.is<rc::detail::SuccessResult>()) {
        std::ostringstream why;
        rc::detail::printResultMessage(result, why);
        FAIL_CHECK(name << ", " << source << ", on " << setting << ", seed " << params.seed << "\n" << why.str());
    }
}

void report(char const* values) {
    long cases = 0, comparisons = 0;
    std::cout << "\nidentities, " << values
              << (all_exact ? ": proved exactly, left == right\n" : ": within 4 epsilon times the size of the data\n");
    std::cout << std::left << std::setw(44) << "identity" << std::setw(36) << "equation" << std::right << std::setw(22) << "seed"
              << std::setw(8) << "cases" << std::setw(13) << "comparisons" << (all_exact ? "" : "   worst/eps") << '\n';
    for (auto const& entry : table) { // no structured binding: clang 14 cannot capture one
        std::string const& name = entry.first;
        record const& row = entry.second;
        std::cout << std::left << std::setw(44) << name << std::setw(36) << row.source << std::right << std::setw(22) << row.seed
                  << std::setw(8) << row.cases << std::setw(13) << row.comparisons;
        if (not all_exact) std::cout << std::setw(12) << std::setprecision(3) << row.worst;
        std::cout << '\n';
        CHECK_MESSAGE(row.comparisons > 0, name << " compared nothing");
        cases += row.cases;
        comparisons += row.comparisons;
    }
    std::cout << cases << " cases, " << comparisons << " comparisons\n";
    CHECK(cases > 500);
    table.clear();
    all_exact = true;
}

} // namespace laws
