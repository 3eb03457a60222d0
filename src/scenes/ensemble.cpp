// SPDX-License-Identifier: BSL-1.0
#include "ensemble.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <sstream>
#include <thread>

#include <fcntl.h>
#include <unistd.h>

#include "engine/machine_code/machine_code.hpp"
#include "problems/from_file.hpp"

namespace program {

namespace {

namespace error = hilger::error;
using hilger::index_type;
using hilger::text::meaning;

std::atomic<bool> stop_asked = false;
extern "C" void ask_members_to_stop(int) { stop_asked = true; }

/// This process' share of the members: a launcher of several processes gives each its number in its environment.
struct share {
    index_type rank = 0, ranks = 1;
    [[nodiscard]] index_type first(index_type members) const { return members * rank / ranks; }
    [[nodiscard]] index_type end(index_type members) const { return members * (rank + 1) / ranks; }
};
share share_here() {
    for (auto const& [rank, ranks] : {std::pair{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"}, std::pair{"PMI_RANK", "PMI_SIZE"},
                                      std::pair{"SLURM_PROCID", "SLURM_NTASKS"}}) {
        char const *const r = std::getenv(rank), *const n = std::getenv(ranks);
        if (r == nullptr or n == nullptr) continue;
        share const here{std::atoll(r), std::atoll(n)};
        if (0 <= here.rank and here.rank < here.ranks) return here;
    }
    return {};
}

/// The rows of a table as members.
class table_of_members {
public:
    table_of_members(std::string path, stated_problem const& what) : path_(std::move(path)), words_(what.of.lagrangian.formula().words()) {
        std::ifstream in(path_);
        std::string line;
        if (not in or std::filesystem::is_directory(path_)) error::raise<error::unreadable>("cannot read members from '", path_, "'");
        if (not std::getline(in, line)) refuse("the first line names columns, as 'q, v', and this file is empty");
        if (line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3); // the byte order mark of some programs
        read_names(line);
        engine::vector<double> const q = numbers_of(what.q), v = numbers_of(what.v);
        if (words_.brought() > 0) {
            q_of_ = with_what_members_bring(what.q_formulas);
            v_of_ = with_what_members_bring(what.v_formulas);
        }
        for (number_ = 2; std::getline(in, line); ++number_)
            if (line.find_first_not_of(" \t\r") != std::string::npos) members_.push_back(read_member(line, q, v));
    }
    [[nodiscard]] std::vector<engine::member> const& members() const { return members_; }
    /// The vocabulary with the members' parameters.
    [[nodiscard]] hilger::text::vocabulary const& words() const { return words_; }

private:
    struct column {
        meaning::role is;
        int at; ///< among the coordinates, the velocities or the members' parameters
    };
    static std::vector<std::string> fields(std::string const& line) {
        constexpr char const* blank = " \t\r";
        std::vector<std::string> all;
        std::istringstream in(line + ',');
        for (std::string field; std::getline(in, field, ',');) {
            auto const begin = std::min(field.find_first_not_of(blank), field.size());
            all.push_back(field.substr(begin, field.find_last_not_of(blank) + 1 - begin));
        }
        return all;
    }
    void read_names(std::string const& line) {
        auto const names = fields(line.substr(line.find_first_not_of("# ") == std::string::npos ? 0 : line.find_first_not_of("# ")));
        auto const before = words_; // with all parameters as common ones
        for (std::string const& field : names) {
            auto const bracket = field.find('[');
            std::string const name = field.substr(0, bracket);
            meaning const* const means = before.find(name);
            if (means != nullptr and means->is == meaning::role::time)
                refuse("'" + name + "' is the time, and all members begin where the interval of the file does");
            if (means == nullptr) refuse("'" + name + "' is no coordinate, velocity or parameter: there are " + before.known());
            int component = 0;
            if (bracket != std::string::npos) component = std::atoi(field.c_str() + bracket + 1);
            std::string const full = means->size > 0 ? name + '[' + std::to_string(component) + ']' : name;
            if (field != full or (means->size > 0 and not(0 <= component and component < means->size)))
                refuse("'" + field + "' is none of the components of " + name + ", " +
                       (means->size > 0 ? name + "[0] to " + name + '[' + std::to_string(means->size - 1) + ']' : name));
            if (std::count(names.begin(), names.end(), field) > 1) refuse("'" + field + "' is there twice");
            if (means->is == meaning::role::parameter and words_.find(name)->is == meaning::role::parameter) {
                int const size = std::max(means->size, 1);
                words_.bring_with_states(name);
                for (int k = 0; k < size; ++k) usual_.push_back(*hilger::text::number_in<double>(before.digits(means->first + k)));
            }
            int const first = means->is == meaning::role::parameter ? words_.find(name)->first - words_.dimension() : means->first;
            columns_.push_back({means->is, first + component});
        }
    }
    engine::member read_member(std::string const& line, engine::vector<double> const& q, engine::vector<double> const& v) const {
        auto const found = fields(line);
        if (found.size() != columns_.size())
            refuse("there are " + std::to_string(columns_.size()) + " columns, and here are " + std::to_string(found.size()));
        engine::member made{{q, engine::second_datum::velocity, v}, usual_};
        std::vector<double> numbers;
        for (std::size_t k = 0; k < found.size(); ++k) {
            auto const x = hilger::text::number_in<double>(found[k]);
            if (not x) refuse("a number was expected, as 1, 0.5 or 1/3, and here is '" + found[k] + "'");
            numbers.push_back(*x);
            if (columns_[k].is == meaning::role::parameter) made.parameters[static_cast<std::size_t>(columns_[k].at)] = *x;
        }
        // First the formulas of its parameters, then its own values.
        int const d = words_.dimension();
        auto const bring = [&](int k) { return k < d ? 0.0 : made.parameters[static_cast<std::size_t>(k - d)]; };
        for (auto const& [formulas, to] : {std::pair{&q_of_, &made.from.q0}, std::pair{&v_of_, &made.from.other}})
            for (auto const& f : *formulas) {
                double const x = f.of.value(0.0, bring, [](int) { return 0.0; });
                if (not std::isfinite(x)) refuse("an initial value of this member is not a finite number");
                (*to)(static_cast<Eigen::Index>(f.at)) = x;
            }
        for (std::size_t k = 0; k < found.size(); ++k)
            if (columns_[k].is != meaning::role::parameter)
                (columns_[k].is == meaning::role::position ? made.from.q0 : made.from.other)(columns_[k].at) = numbers[k];
        return made;
    }
    /// The same formulas, as functions of the members' parameters.
    [[nodiscard]] std::vector<initial_formula> with_what_members_bring(std::vector<initial_formula> const& formulas) const {
        std::vector<initial_formula> all;
        for (auto const& f : formulas)
            all.push_back({f.at, f.i, hilger::text::stated(f.of.formula(), words_for_component(words_, f.i), f.of.source())});
        return all;
    }
    [[noreturn]] void refuse(std::string const& why) const { error::raise<error::unreadable>(path_, ", line ", number_, ": ", why); }
    std::string path_;
    hilger::text::vocabulary words_;
    std::vector<column> columns_;
    std::vector<initial_formula> q_of_, v_of_;
    std::vector<double> usual_; ///< the values in the problem's file of the members' parameters
    std::vector<engine::member> members_;
    int number_ = 1;
};

/// One array of doubles in numpy's format; several processes may write parts of it.
class array_file {
public:
    array_file(std::string const& path, std::vector<index_type> const& shape) : path_(path) {
        static_assert(std::endian::native == std::endian::little);
        std::string said = "{'descr': '<f8', 'fortran_order': False, 'shape': (";
        index_type size = static_cast<index_type>(sizeof(double));
        for (index_type const n : shape) {
            said += std::to_string(n) + ", ";
            size *= n;
        }
        said += "), }";
        constexpr std::size_t before = 10, unit = 64;
        said += std::string(unit - (before + said.size() + 1) % unit, ' ') + '\n';
        head_ = std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(said.size() % 256) + static_cast<char>(said.size() / 256) + said;
        file_ = ::open(path.c_str(), O_RDWR | O_CREAT, 0666);
        if (file_ < 0 or ::ftruncate(file_, static_cast<off_t>(head_.size()) + size) != 0) refuse();
        put(0, head_.data(), head_.size());
    }
    ~array_file() { ::close(file_); }
    array_file(array_file const&) = delete;
    array_file& operator=(array_file const&) = delete;
    /// Writes the numbers from number `first` on.
    void write(index_type first, std::vector<double> const& numbers) const {
        put(head_.size() + static_cast<std::size_t>(first) * sizeof(double), numbers.data(), numbers.size() * sizeof(double));
    }

private:
    void put(std::size_t at, void const* data, std::size_t size) const {
        auto const* bytes = static_cast<char const*>(data);
        while (size > 0) {
            auto const done = ::pwrite(file_, bytes, size, static_cast<off_t>(at));
            if (done <= 0) refuse();
            at += static_cast<std::size_t>(done);
            bytes += done;
            size -= static_cast<std::size_t>(done);
        }
    }
    [[noreturn]] void refuse() const { error::raise<error::unreadable>("cannot write '", path_, "'"); }
    std::string path_, head_;
    int file_;
};

} // namespace

int run_ensemble(run_options const& options) {
    auto const begin = std::chrono::steady_clock::now();
    scene const& what = scene_named(options.scene);
    if (not what.stated->last.empty())
        error::raise<error::invalid_parameter>("--ensemble is of initial values, and ", what.name, " is solved between two ends");
    if (options.stop_after > 0) error::raise<error::invalid_parameter>("--stop-after is for one run, and --ensemble is of many");
    configuration const c = completed(what, options.choice);
    if (c.scalar != "double")
        error::raise<error::invalid_parameter>("the members of an ensemble are stepped in double, and not in ", c.scalar);
    table_of_members const table(options.ensemble, *what.stated);
    auto const members = static_cast<index_type>(table.members().size());
    if (members == 0) error::raise<error::unreadable>("'", options.ensemble, "' has no members: below the names there is a row for each");
    share const ours = share_here();
    index_type const first = ours.first(members), end = ours.end(members);
    int const threads = options.threads > 0 ? options.threads
                        : ours.ranks > 1    ? 1
                                            : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    index_type const stride = options.every > 0 ? options.every : c.steps;
    auto const T = points_of(*what.stated, c.steps);
    auto const problem = engine::with_words(what.stated->of, table.words());
    engine::prepare_machine_code();
    auto const all = engine::make_cast(problem, c.embedding, T, true,
                                       [&](engine::problem const& one) { return walker_of_member(*what.stated, one, c); });

    index_type const points = engine::points_kept(c.steps, stride);
    int const d = what.dimension;
    std::filesystem::create_directories(options.out);
    // Several processes write one file. A single process keeps the old file until it has a new result.
    std::string const path = (std::filesystem::path(options.out) / (what.name + ".npy")).string();
    bool const beside = ours.ranks == 1 and std::filesystem::exists(path);
    std::string written = beside ? (std::filesystem::path(options.out) / (what.name + ".interrupted.npy")).string() : path;
    stop_asked = false;
    std::signal(SIGINT, ask_members_to_stop);
    std::signal(SIGTERM, ask_members_to_stop);
    array_file const file(written, {members, points, 2 * d});
    std::vector<double> numbers(static_cast<std::size_t>((end - first) * points * 2 * d), std::numeric_limits<double>::quiet_NaN());
    file.write(first * points * 2 * d, numbers); // after a crash, an older file cannot pass for the result
    std::atomic<index_type> done = 0;
    auto const made =
        engine::walk_all(all, {table.members().begin() + first, table.members().begin() + end}, stride, threads, stop_asked, done);
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        std::size_t const row = k / static_cast<std::size_t>(2 * d), at = k % static_cast<std::size_t>(2 * d);
        numbers[k] = at < static_cast<std::size_t>(d) ? made.q[row * static_cast<std::size_t>(d) + at]
                                                      : made.p[row * static_cast<std::size_t>(d) + at - static_cast<std::size_t>(d)];
    }
    file.write(first * points * 2 * d, numbers);
    if (beside and not stop_asked) {
        std::filesystem::rename(written, path);
        written = path;
    }

    double const seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::ostringstream said; // printed at once, since other ranks print too
    index_type failed = 0;
    for (std::size_t m = 0; m < made.failures.size(); ++m)
        if (auto const& why = made.failures[m]; not why.empty() and ++failed > 0)
            said << "  member " << first + static_cast<index_type>(m) << ": " << why << '\n';
    std::cout << what.name + (first < end ? ": members " + std::to_string(first) + " to " + std::to_string(end - 1) : ": none") + " of " +
                     std::to_string(members) + ", " + description(c) + ", " +
                     (all.together ? std::to_string(all.together->width()) + " lanes, " : "") + std::to_string(threads) +
                     (threads == 1 ? " thread, " : " threads, ") + std::to_string(seconds) + " s; " + std::to_string(failed) + " failed\n" +
                     said.str() +
                     (ours.rank == 0 ? "Written: " + written + ", q and p of " + std::to_string(members) + " members at " +
                                           std::to_string(points) + " points, every " + std::to_string(stride) + "\n"
                                     : "")
              << std::flush;
    return stop_asked ? 130 : first < end and failed == end - first ? 1 : 0;
}

} // namespace program
