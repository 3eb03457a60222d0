// SPDX-License-Identifier: BSL-1.0
#include "trade.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <iterator>
#include <optional>

#include "hilger/error.hpp"
#include "measure.hpp"
#include "peers.hpp"
#include "plot.hpp"
#include "problems/from_file.hpp"
#include "progress.hpp"

namespace program {

namespace {

using hilger::float100;
using numbers = std::vector<float100>;

struct point {
    std::string method; ///< all choices except the number of steps
    std::string steps;  ///< or the tolerance
    double seconds, error;
    bool ours = true;
};

float100 distance(numbers const& x, numbers const& y) {
    float100 largest = 0;
    for (std::size_t k = 0; k < x.size(); ++k) largest = std::max(largest, float100(abs(x[k] - y[k])));
    return largest;
}
numbers position_at_end(scene const& what, configuration const& c) {
    auto const w = what.begin(c);
    w->advance(c.steps);
    return w->position();
}

/// The reference position, and its accuracy.
struct truth {
    numbers position;
    double own_error;
    std::string how;
    /// An error of the size of the position, or of 1 if that is larger, is no approximation.
    [[nodiscard]] double largest_error() const {
        return std::max(1.0, static_cast<double>(distance(position, numbers(position.size(), float100(0)))));
    }
};
truth find_truth(scene const& what) {
    if (what.exact) return {what.exact(), what.exact_error, what.exact_source};
    configuration c = what.reference;
    c.steps += c.steps % 2; // between two ends the reported position is the middle one, which must be a point
    numbers const coarse = position_at_end(what, c);
    c.steps *= 2;
    numbers fine = position_at_end(what, c);
    double const own = static_cast<double>(distance(coarse, fine));
    return {std::move(fine), own, description(c) + ", and half as many"};
}

/// Measurements of one configuration count once, at their fastest.
void keep(std::vector<point>& points, point p) {
    auto const known =
        std::find_if(points.begin(), points.end(), [&](point const& q) { return q.method == p.method and q.steps == p.steps; });
    if (known == points.end())
        points.push_back(std::move(p));
    else
        known->seconds = std::min(known->seconds, p.seconds);
}

/// Keeps a measurement whose end approximates the reference.
void keep_end(std::vector<point>& points, truth const& reference, numbers const& end, point p) {
    p.error = static_cast<double>(distance(end, reference.position));
    if (not(p.error < reference.largest_error())) return;
    p.error = std::max(p.error, reference.own_error);
    keep(points, std::move(p));
}

/// Increases the number of steps (8, 10, 12, 14, 16, 20, ...; for many digits 8, 12, 16, 24, ...) of one configuration, until it is too
/// slow or rounding dominates. Many digits begin where steps are short enough for the iterations of high orders.
void climb(scene const& what, configuration c, truth const& reference, double budget, std::vector<point>& points) {
    double best = 1e300, fine = reference.own_error * 4, before = 1e300;
    double const most = reference.largest_error();
    int worse = 0, slower = 0;
    bool const many_digits = c.scalar.ends_with("digits");
    hilger::index_type first = 8;
    if (many_digits) {
        budget *= 10;
        first = std::max(first, what.reference.steps / 4);
    }
    for (c.steps = first; c.steps <= 1 << 22; c.steps = next_number(c.steps, many_digits ? 2 : 4)) {
        try {
            numbers end;
            double const seconds = fastest([&] { end = position_at_end(what, c); }, std::min(0.2, 50 * budget));
            double const error = static_cast<double>(distance(end, reference.position));
            if (std::isfinite(error) and error < most)
                keep(points, {c.embedding + (c.history.empty() ? "" : ", " + c.history) + (c.scalar == "double" ? "" : ", " + c.scalar),
                              std::to_string(c.steps), seconds, std::max(error, reference.own_error)});
            worse = error < best / 1.05 ? 0 : worse + 1;
            best = std::min(best, error);
            // Few steps may be so long that they need Newton's method; more steps then take less time.
            slower += seconds > budget and seconds > before;
            before = seconds;
            if (slower > 1 or (best < most and worse > 6) or error < fine) return;
        } catch (hilger::error::exception const&) { // the steps are too long
        }
    }
}

/// Measures steps that adapt to tolerances 1, 1e-1, ..., 1e-13, for motions from initial values, in t and without memory.
void adapt(scene const& what, truth const& reference, double budget, std::vector<point>& points) {
    auto const& one = *what.stated;
    if (one.of.has_memory() or one.of.time_transformation or not one.last.empty()) return;
    double const a = number_of(one.start), b = number_of(one.end);
    for (std::string const method : {"gauss-6", "gauss-8"}) {
        auto const walk = engine::walk_in_adapted_steps(one.of, method, a, b, numbers_of(one.q), numbers_of(one.v));
        double seconds = 0;
        for (int digits = 0; digits <= 13 and seconds <= budget; ++digits) {
            double const tolerance = std::pow(10.0, -digits);
            try {
                engine::vector<double> end;
                seconds = fastest([&] { end = walk(tolerance); }, std::min(0.2, 50 * budget));
                keep_end(points, reference, {end.begin(), end.end()},
                         {method + ", adapted", (std::ostringstream() << tolerance).str(), seconds, 0});
            } catch (hilger::error::exception const&) { // a tolerance that the method cannot keep
            }
        }
    }
}

/// Cheapest first; each is more accurate than all cheaper ones.
std::vector<point> front_of(std::vector<point> points, bool (*belongs)(point const&)) {
    std::erase_if(points, [&](point const& p) { return not belongs(p); });
    std::sort(points.begin(), points.end(), [](point const& a, point const& b) { return a.seconds < b.seconds; });
    std::vector<point> front;
    for (auto const& p : points)
        if (front.empty() or p.error < front.back().error) front.push_back(p);
    return front;
}
std::optional<point> cheapest(std::vector<point> const& front, double accuracy) {
    for (auto const& p : front)
        if (p.error <= accuracy) return p;
    return {};
}

std::string told(std::optional<point> const& p) {
    if (not p) return "-";
    std::ostringstream out;
    out << std::setprecision(3) << p->seconds * 1e3 << " ms  " << p->method << ' ' << p->steps;
    return out.str();
}

void compare(std::vector<point> const& ours, std::vector<point> const& theirs) {
    std::cout << "\n  accuracy   hilger" << std::setw(42) << ""
              << "the fastest peer\n";
    int below = 0, asked = 0;
    for (int digits = 1; digits <= 40; digits += digits < 14 ? 1 : 5) {
        double const accuracy = std::pow(10.0, -digits);
        auto const a = cheapest(ours, accuracy), b = cheapest(theirs, accuracy);
        if (not a and not b) continue;
        std::cout << "  1e-" << std::setw(2) << std::setfill('0') << digits << std::setfill(' ') << "     " << std::left << std::setw(48)
                  << told(a) << std::setw(40) << told(b) << std::right;
        if (a and b) std::cout << std::setprecision(2) << std::setw(6) << a->seconds / b->seconds;
        std::cout << '\n';
        if (digits >= 3 and digits <= 13 and not theirs.empty()) {
            ++asked;
            below += a and (not b or a->seconds <= b->seconds);
        }
    }
    if (asked > 0) std::cout << "  below every peer at " << below << " of " << asked << " accuracies from 1e-3 to 1e-13\n";
}

/// A picture for double and shorter numbers and, if any, one for longer ones: all measurements as points, the fronts of hilger and of the
/// fastest peer as lines, and the name of a method at its first point on a front. The first as text, too.
void picture(std::string const& out, scene const& what, std::vector<point> const& points) {
    auto const name = "trade_" + what.name;
    std::ofstream rows = create(out, name + ".csv");
    rows << "# method, steps or tolerance, seconds, error; two blank lines after all of hilger, its front, the names on it, and of peers; "
            "in double, then in more digits\n";
    int blocks = 0;
    auto const write = [&](std::vector<point> const& all) {
        for (auto const& p : all) rows << '"' << p.method << "\"," << p.steps << ',' << p.seconds << ',' << p.error << '\n';
        rows << "\n\n";
        return all.empty() ? 0 : ++blocks;
    };
    auto const data = [&](int block) { return "'" + name + ".csv' index " + std::to_string(block - 1) + " using 3:4"; };
    std::string plots, letters;
    for (bool const is_long : {false, true}) {
        std::string panel, in_letters;
        double least = 1e300, most = 0;
        for (bool const ours : {true, false}) {
            std::vector<point> all;
            std::copy_if(points.begin(), points.end(), std::back_inserter(all),
                         [&](point const& p) { return p.ours == ours and p.method.ends_with("digits") == is_long; });
            if (all.empty()) continue;
            for (auto const& p : all) least = std::min(least, p.seconds), most = std::max(most, p.seconds);
            auto const front = front_of(all, [](point const&) { return true; });
            std::vector<point> names;
            std::unique_copy(front.begin(), front.end(), std::back_inserter(names),
                             [](point const& a, point const& b) { return a.method == b.method; });
            std::string const who = ours ? "hilger" : "the fastest peer", colour = ours ? " lc rgb '#0072b2'" : " lc rgb '#d55e00'",
                              measured = data(write(all)), fastest = data(write(front));
            panel += (panel.empty() ? "" : ", ") + measured + " with points pt 7 ps 0.4" + colour + " notitle, " + fastest +
                     " with steps lw 2" + colour + " title '" + who + "', " + data(write(names)) + ":1 with labels point pt 7 ps 0.8" +
                     colour + " font ',9'" + (ours ? " right offset -0.7,-0.4" : " left offset 0.7,0.4") + " noenhanced tc" +
                     colour.substr(3) + " notitle";
            in_letters += (in_letters.empty() ? "" : ", ") + fastest + " with points pt '" + (ours ? 'h' : 'p') + "' title '" + who + "'";
        }
        if (panel.empty()) continue;
        std::ostringstream range; // with room for names
        range << "set xrange [" << least / 20 << ':' << most * 20 << "]; ";
        plots +=
            range.str() + "set title '" + what.name + (is_long ? ", more digits than double" : "") + "' noenhanced\nplot " + panel + '\n';
        if (letters.empty()) letters = "plot " + in_letters + '\n';
    }
    if (not rows.flush()) hilger::error::raise<hilger::error::unreadable>("cannot write '", name, ".csv'");
    std::string const axes = "set logscale xy; set xlabel 'seconds'; set ylabel 'error' offset 1; set key top right\n";
    std::cout << '\n' << sketch(out, name, axes + "set format '1e%L'\n" + letters);
    std::cout << "Written: " << draw(out, name, axes + "set grid; set format '10^{%L}'\n" + plots) << '\n';
}

} // namespace

int run_trade(trade_options const& options) {
    scene const& what = scene_named(options.scene);
    truth const reference = find_truth(what);
    std::cout << what.title << "\nagainst " << reference.how << ", itself within " << std::setprecision(2) << reference.own_error << '\n';
    std::vector<point> points;
    std::vector<std::string> const none{""};
    auto const& histories = what.histories.empty() ? none : what.histories;
    {
        progress_bar bar(what.name, static_cast<long>(2 * what.scalars.size() * what.embeddings.size() * histories.size()));
        // Two rounds, alternating with the peers: a temporary load of the machine affects both.
        for (bool const first : {true, false}) {
            for (auto const& scalar : what.scalars)
                for (auto const& embedding : what.embeddings)
                    for (auto const& history : histories) {
                        if (first or not scalar.ends_with("digits"))
                            climb(what, {embedding, scalar, history, 0}, reference, options.budget, points);
                        bar.advance();
                    }
            adapt(what, reference, options.budget, points);
            for (auto const& run : run_peers(what))
                keep_end(points, reference, {run.position.begin(), run.position.end()},
                         {"peer " + run.method, (std::ostringstream() << run.parameter).str(), run.seconds, 0, false});
        }
    }
    auto const ours = front_of(points, [](point const& p) { return p.ours; });
    auto const theirs = front_of(points, [](point const& p) { return not p.ours; });
    std::cout << "\nPareto front\n";
    for (auto const& p : ours)
        std::cout << "  " << std::scientific << std::setprecision(1) << p.error << std::defaultfloat << std::setprecision(3)
                  << std::setw(11) << p.seconds * 1e3 << " ms  " << p.method << ", " << p.steps << '\n';
    compare(ours, theirs);
    if (options.accuracy > 0) {
        auto const best = cheapest(ours, options.accuracy);
        std::cout << "\nfor " << options.accuracy << ": " << (best ? told(best) : std::string("nothing here is as accurate")) << '\n';
    }
    picture(options.out, what, points);
    return 0;
}

} // namespace program
