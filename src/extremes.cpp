// SPDX-License-Identifier: BSL-1.0
#include "extremes.hpp"

#include <iomanip>
#include <ostream>

#include "extremes/row.hpp"

namespace program {

namespace {

struct group {
    char const* title;
    extremes::rows (*cases)(extremes::scope);
};
constexpr group groups[]{
    {"Orders of fractional differences next to 0 and 1", extremes::orders},
    {"Histories of such orders", extremes::histories},
    {"Damping at the stages of Radau IIA", extremes::stages},
    {"Many points", extremes::counts},
    {"Steps from 1e-12 to beyond the limit of stability", extremes::steps},
    {"Differences over small steps", extremes::differences},
    {"Numbers from 1e-300 to 1e300", extremes::sizes},
    {"Mass matrices and Legendre maps", extremes::masses},
    {"Close encounters", extremes::encounters},
    {"lambda next to 0 and 1", extremes::ends},
    {"One step, two steps, none", extremes::smallest},
    {"Scalars", extremes::scalars},
    {"NaN and infinity", extremes::not_finite},
};

} // namespace

bool report_extremes(std::ostream& out, bool quick) {
    out << "Errors in epsilons of the scalar (eps), relative to what the case says or to the value, against more digits\n\n"
        << std::left << std::setw(68) << "case" << std::setw(25) << "promised" << std::setw(25) << "measured"
        << "how it ended\n";
    int all = 0, failed = 0, errors = 0;
    for (auto const& [title, cases] : groups) {
        out << '\n' << title << '\n' << std::flush;
        for (auto const& row : cases(quick ? extremes::scope::test : extremes::scope::report)) {
            out << "  " << std::setw(66) << row.what << std::setw(25) << row.promised << std::setw(25) << row.measured << row.how
                << (row.ok ? "\n" : "   FAILED\n");
            ++all;
            if (not row.ok) ++failed;
            if (row.how == "typed error") ++errors;
        }
    }
    out << '\n'
        << all << " cases: " << all - failed << " as promised, of them " << errors << " by a typed error; " << failed << " failed\n";
    return failed == 0;
}

} // namespace program
