// SPDX-License-Identifier: BSL-1.0
#include "run.hpp"

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <set>
#include <sstream>

#include <boost/crc.hpp>

#include "hilger/error.hpp"
#include "hilger/version.hpp"
#include "plot.hpp"
#include "problems/from_file.hpp"
#include "progress.hpp"

namespace program {

namespace {

namespace files = std::filesystem;
namespace error = hilger::error;
using clock = std::chrono::steady_clock;

std::sig_atomic_t volatile stop_asked = 0;
extern "C" void ask_to_stop(int) { stop_asked = 1; }

/// Whether digits are NaN or an infinity.
bool is_not_finite(std::string const& digits) { return digits.find_first_of("nN") != std::string::npos; }

std::uint32_t checksum(std::string const& text) {
    boost::crc_32_type sum;
    sum.process_bytes(text.data(), text.size());
    return sum.checksum();
}

/// The rows of a run and the checkpoint that belongs to them.
class record_of_run {
public:
    record_of_run(scene const& what, run_options const& options, configuration const& c, hilger::index_type every)
        : fingerprint_(what.fingerprint), head_(what.name + ": " + description(c) + ", a row every " + std::to_string(every)),
          rows_(files::path(options.out) / (what.name + ".csv")), checkpoint_(files::path(options.out) / (what.name + ".checkpoint")) {
        if (options.anew) files::remove(checkpoint_);
    }
    /// Restores the state of an interrupted run, if there is one. @throws hilger::error::mismatch when it was another run
    bool continues(walk& w, hilger::index_type every, hilger::index_type steps, progress_bar& bar) {
        std::ifstream in(checkpoint_);
        if (not in) return false;
        std::string head, fingerprint;
        std::uintmax_t bytes = 0;
        hilger::index_type point = 0;
        bool state = false;
        std::uint32_t sum_of_rows = 0, sum_of_state = 0;
        std::getline(in, head);
        if (not(in >> bytes >> point >> state >> fingerprint >> sum_of_rows >> sum_of_state) or in.get() != '\n')
            error::raise<error::unreadable>("'", checkpoint_.string(), "' is no checkpoint of a run; --anew starts again without it");
        if (head != head_)
            error::raise<error::mismatch>("'", checkpoint_.string(), "' is of an interrupted run of ", head,
                                          "; run that again to continue it, or give --anew or another --out");
        if (fingerprint != fingerprint_)
            error::raise<error::mismatch>("'", checkpoint_.string(),
                                          "' is of an interrupted run of another problem of this name, or of what the "
                                          "file said before; give --anew or another --out");
        if (point < 0 or point > steps)
            error::raise<error::unreadable>("'", checkpoint_.string(), "' is damaged: it is of point ", point, " of ", steps,
                                            "; --anew starts again without it");
        std::string const memory{std::istreambuf_iterator<char>(in), {}};
        if (checksum(memory) != sum_of_state)
            error::raise<error::unreadable>("'", checkpoint_.string(), "' is damaged; --anew starts again without it");
        if (bytes == 0 or not rows_are(bytes, sum_of_rows))
            error::raise<error::unreadable>("'", rows_.string(), "' is not what it was when its run was interrupted; --anew starts again");
        files::resize_file(rows_, bytes);
        std::istringstream remembered(memory);
        if (state)
            w.load(remembered, "'" + checkpoint_.string() + "'");
        else // a walk with a memory is repeated
            while (w.number() < point) {
                (void)w.row();
                w.advance(std::min(every, point - w.number()));
            }
        bar.advance_to(w.number());
        out_.open(rows_, std::ios::app | std::ios::binary);
        return true;
    }
    /// Whether the first so many bytes have that checksum; it then becomes the checksum of the rows.
    bool rows_are(std::uintmax_t bytes, std::uint32_t sum) {
        std::ifstream rows(rows_, std::ios::binary);
        std::array<char, 1 << 16> some{};
        rows_sum_.reset();
        while (bytes > 0 and rows.read(some.data(), static_cast<std::streamsize>(std::min<std::uintmax_t>(bytes, some.size())))) {
            rows_sum_.process_bytes(some.data(), static_cast<std::size_t>(rows.gcount()));
            bytes -= static_cast<std::uintmax_t>(rows.gcount());
        }
        return bytes == 0 and rows_sum_.checksum() == sum;
    }
    void begin(std::vector<std::string> const& columns) {
        out_ = create(rows_.parent_path().string(), rows_.filename().string());
        std::string names = "# ";
        for (std::size_t k = 0; k < columns.size(); ++k) names += (k > 0 ? "," : "") + columns[k];
        rows_sum_.reset();
        put(names + '\n');
    }
    void write(std::string const& row) {
        put(row + '\n');
        if (not is_not_finite(row)) return;
        std::istringstream numbers(row);
        std::string number;
        for (std::size_t k = 0; std::getline(numbers, number, ','); ++k)
            if (is_not_finite(number)) not_finite_.insert(k);
    }
    /// The columns that were not finite in some row.
    [[nodiscard]] std::set<std::size_t> const& not_finite() const { return not_finite_; }
    /// Writes a checkpoint, atomically: the complete file is moved to its place.
    void keep(walk const& w) {
        if (not out_.flush()) refuse();
        auto const beside = checkpoint_.string() + ".new";
        {
            std::ofstream out(beside, std::ios::binary);
            std::ostringstream state;
            bool const kept = w.save(state);
            out << head_ << '\n'
                << files::file_size(rows_) << ' ' << w.number() << ' ' << kept << ' ' << fingerprint_ << ' ' << rows_sum_.checksum() << ' '
                << checksum(state.str()) << '\n'
                << state.str();
            if (not out.flush()) error::raise<error::unreadable>("cannot write '", beside, "'");
        }
        files::rename(beside, checkpoint_);
    }
    void finish() {
        out_.close();
        if (not out_) refuse();
        files::remove(checkpoint_);
    }
    [[nodiscard]] std::string rows() const { return rows_.string(); }

private:
    void put(std::string const& line) {
        rows_sum_.process_bytes(line.data(), line.size());
        if (not(out_ << line)) refuse();
    }
    [[noreturn]] void refuse() const { error::raise<error::unreadable>("cannot write '", rows_.string(), "': is there no room?"); }
    std::string fingerprint_, head_;
    files::path rows_, checkpoint_;
    std::ofstream out_;
    boost::crc_32_type rows_sum_;
    std::set<std::size_t> not_finite_;
};

/// As a string of JSON.
std::string in_json(std::string const& text) {
    std::string all = "\"";
    for (char const c : text) {
        if (c == '"' or c == '\\') all += '\\';
        all += c;
    }
    return all + '"';
}

std::string write_summary(scene const& what, run_options const& options, configuration const& c, walk const& w, double seconds) {
    auto const name = what.name + ".json";
    std::ofstream out = create(options.out, name);
    out << std::setprecision(6) << "{\n  \"scene\": " << in_json(what.name) << ",\n  \"hilger\": \"" << HILGER_VERSION_MAJOR << '.'
        << HILGER_VERSION_MINOR << '.' << HILGER_VERSION_PATCH << "\",\n  \"embedding\": " << in_json(c.embedding) << ",\n  \"scalar\": \""
        << c.scalar << "\",\n  \"history\": \"" << c.history << "\",\n  \"interval\": [" << hilger::round_trip(what.t0) << ", "
        << hilger::round_trip(what.t1) << "],\n  \"steps\": " << c.steps << ",\n  \"seconds\": " << seconds << ",\n  \"largest error\": {";
    auto const drift = w.drift();
    for (std::size_t k = 0; k < what.invariants.size(); ++k) {
        out << (k > 0 ? ", " : "") << in_json(what.invariants[k]) << ": ";
        if (std::isfinite(drift[k]))
            out << drift[k];
        else
            out << "null"; // there is no NaN in JSON, nor infinity
    }
    out << "},\n  \"last\": [";
    std::istringstream last(w.row());
    for (std::string number; std::getline(last, number, ',');) { // there is no NaN in JSON, nor infinity
        out << (is_not_finite(number) ? "null" : number) << (last.eof() ? "" : ", ");
    }
    out << "]\n}\n";
    if (not out.flush()) error::raise<error::unreadable>("cannot write '", (files::path(options.out) / name).string(), "'");
    return (files::path(options.out) / name).string();
}

std::string interval_of(scene const& what) {
    std::ostringstream out;
    out << (what.stated->of.time_transformation ? "tau" : "t") << " = " << what.t0 << " to " << what.t1
        << (what.units.empty() ? "" : " " + what.units);
    return out.str();
}

void say(scene const& what, configuration const& c, walk const& w, double seconds) {
    std::cout << what.name << ": " << description(c) << ", " << interval_of(what) << ", " << std::setprecision(3) << seconds << " s\n";
    auto const drift = w.drift();
    for (std::size_t k = 0; k < what.invariants.size(); ++k)
        std::cout << "  largest error of " << what.invariants[k] << ": " << drift[k] << '\n';
}

} // namespace

int run_scene(run_options const& options) {
    scene const& what = scene_named(options.scene);
    configuration const c = completed(what, options.choice);
    hilger::index_type const every = options.every > 0 ? options.every : std::max<hilger::index_type>(1, c.steps / 2000);
    auto const begin = clock::now();
    auto const w = what.begin(c);
    record_of_run record(what, options, c, every);
    stop_asked = 0;
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
    std::cout << what.title << '\n';
    {
        progress_bar bar(what.name, c.steps);
        if (record.continues(*w, every, c.steps, bar))
            std::cout << "continued at step " << w->number() << '\n';
        else {
            record.begin(what.columns);
            record.write(w->row());
        }
        auto kept = clock::now();
        hilger::index_type rows = 0;
        while (w->number() < c.steps) {
            try {
                // In parts, so that the run can be stopped. A continued run first goes to the next row.
                hilger::index_type const row = std::min(c.steps, (w->number() / every + 1) * every);
                while (w->number() < row and stop_asked == 0) w->advance(std::min<hilger::index_type>(row - w->number(), 1 << 16));
            } catch (error::exception const&) {
                record.keep(*w);
                throw;
            }
            if (w->number() % every == 0 or w->number() == c.steps) record.write(w->row());
            bar.advance_to(w->number());
            if (++rows == options.stop_after) stop_asked = 1;
            if (stop_asked != 0 or clock::now() - kept > std::chrono::seconds(2)) {
                record.keep(*w);
                kept = clock::now();
            }
            if (stop_asked != 0) {
                std::cout << "stopped at step " << w->number() << " of " << c.steps << "; the same command goes on from there\n";
                return 130;
            }
        }
        record.finish();
    }
    double const seconds = std::chrono::duration<double>(clock::now() - begin).count();
    say(what, c, *w, seconds);
    for (std::size_t const k : record.not_finite()) std::cout << "  " << what.columns[k] << " is NaN or infinite in some rows\n";
    auto const summary = write_summary(what, options, c, *w, seconds);
    std::string commands = what.picture;
    std::size_t const first_plot = commands.find('\n', commands.find(rows_of_picture)) + 1;
    std::string first = commands.substr(0, first_plot);
    for (std::string* text : {&commands, &first})
        for (std::size_t at; (at = text->find(rows_of_picture)) != std::string::npos;)
            text->replace(at, rows_of_picture.size(), "'" + what.name + ".csv'");
    std::cout << sketch(options.out, what.name, first);
    std::cout << "Written: " << record.rows() << ", " << summary << " and " << draw(options.out, what.name, "set grid\n" + commands)
              << '\n';
    return 0;
}

void list_scenes(std::ostream& out) {
    for (auto const& s : all_scenes())
        out << std::left << std::setw(23) << s.name << s.title << '\n'
            << std::setw(23) << ""
            << "d = " << s.dimension << ", " << interval_of(s) << "; usually " << description(s.usual) << '\n';
}

} // namespace program
