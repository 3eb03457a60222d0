// SPDX-License-Identifier: BSL-1.0
#include "engine/ensemble/ensemble.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <thread>

namespace engine {

namespace {

walker walker_of_member(cast const& all, member const& who) {
    if (all.common) return all.common;
    return all.make(with_words(all.what, all.what.lagrangian.formula().words().with(who.parameters)));
}

void walk_one(cast const& all, hilger::index_type steps, member const& who, hilger::index_type stride, ensemble& to,
              hilger::index_type number_of_it, std::atomic<bool> const& stop) {
    hilger::index_type number = 0, kept = 0;
    auto const own = static_cast<std::ptrdiff_t>(to.place(number_of_it, 0)),
               others = static_cast<std::ptrdiff_t>(to.place(number_of_it + 1, 0));
    for (auto* x : {&to.q, &to.p}) std::fill(x->begin() + own, x->begin() + others, std::numeric_limits<double>::quiet_NaN()); // of a lane
    auto const keep = [&](double, vector<double> const& q, vector<double> const& p) {
        if (number % stride == 0 or number == steps) {
            auto const at = static_cast<std::ptrdiff_t>(to.place(number_of_it, kept));
            std::copy(q.begin(), q.end(), to.q.begin() + at);
            std::copy(p.begin(), p.end(), to.p.begin() + at);
            ++kept;
        }
        ++number;
        return not stop.load(std::memory_order_relaxed);
    };
    try {
        walker_of_member(all, who)(who.from, keep);
        if (number <= steps) to.failures[static_cast<std::size_t>(number_of_it)] = "interrupted";
    } catch (std::exception const& why) {
        to.failures[static_cast<std::size_t>(number_of_it)] = why.what();
    }
}

/// Walks the members from `first` on, at most one for each lane.
void walk_group(cast const& all, hilger::index_type steps, std::vector<member> const& from, hilger::index_type stride, ensemble& to,
                hilger::index_type first, std::atomic<bool> const& stop) {
    lanes const& together = *all.together;
    constexpr hilger::index_type at_once = 1024; // steps between two looks at `stop`
    int const count = static_cast<int>(std::min<hilger::index_type>(together.width(), to.members - first));
    std::vector<lanes::start> starts;
    std::vector<bool> alone(static_cast<std::size_t>(count), false);
    for (int lane = 0; lane < count; ++lane) {
        member const& who = from[static_cast<std::size_t>(first + lane)];
        auto const begin = start_of([&] { return walker_of_member(all, who); }, who);
        alone[static_cast<std::size_t>(lane)] = not begin;
        starts.push_back(begin.value_or(lanes::start{}));
    }
    auto const whole = std::find_if(starts.begin(), starts.end(), [](lanes::start const& x) { return x.q.size() > 0; });
    bool interrupted = false;
    if (whole != starts.end()) {
        lanes::start const filling = *whole; // for lanes without a member
        for (lanes::start& x : starts)
            if (x.q.size() == 0) x = filling;
        starts.resize(static_cast<std::size_t>(together.width()), filling);
        lanes::group group(together, starts);
        hilger::index_type number = 0;
        for (hilger::index_type kept = 0; kept < to.points and not interrupted; ++kept) {
            for (hilger::index_type const next = std::min(kept * stride, steps); number < next and not interrupted;) {
                hilger::index_type const more = std::min(next - number, at_once);
                group.walk(more);
                number += more;
                interrupted = stop.load(std::memory_order_relaxed);
            }
            for (int lane = 0; lane < count and not interrupted; ++lane) {
                if (not group.is_well(lane)) continue;
                auto const at = to.place(first + lane, kept);
                for (int k = 0; k < to.dimension; ++k) {
                    to.q[at + static_cast<std::size_t>(k)] = group.q(lane, k);
                    to.p[at + static_cast<std::size_t>(k)] = group.p(lane, k);
                }
            }
        }
        for (int lane = 0; lane < count; ++lane)
            if (not group.is_well(lane)) alone[static_cast<std::size_t>(lane)] = true;
    }
    for (int lane = 0; lane < count; ++lane)
        if (alone[static_cast<std::size_t>(lane)])
            walk_one(all, steps, from[static_cast<std::size_t>(first + lane)], stride, to, first + lane, stop);
        else if (interrupted)
            to.failures[static_cast<std::size_t>(first + lane)] = "interrupted";
}

} // namespace

std::optional<lanes::start> start_of(std::function<walker()> const& alone, member const& who) {
    if (who.from.is == second_datum::velocity) return lanes::start{who.from.q0, who.from.other, {}, who.parameters};
    lanes::start made{{}, {}, {}, who.parameters};
    double t0 = 0;
    auto const look = [&](double t, vector<double> const& q, vector<double> const& p) {
        if (made.q.size() > 0) {
            made.v = (q - made.q) / (t - t0);
            return false;
        }
        t0 = t;
        made.q = q;
        made.p = p;
        return true;
    };
    try {
        alone()(who.from, look);
    } catch (std::exception const&) {
        return {};
    }
    if (made.v.size() == 0) return {};
    return made;
}

problem with_words(problem const& what, hilger::text::vocabulary const& words) {
    auto const shared = std::make_shared<hilger::text::vocabulary const>(words);
    auto const again = [&](hilger::text::stated const& f) { return hilger::text::stated(f.formula(), shared, f.source()); };
    problem made = what;
    made.lagrangian = hilger::text::stated_lagrangian(again(what.lagrangian.formula()));
    if (what.force) {
        std::vector<hilger::text::stated> components;
        for (auto const& f : what.force->formulas()) components.push_back(again(f));
        made.force.emplace(std::move(components));
    }
    return made;
}

cast make_cast(problem const& what, std::string const& method, points<double> const& T, bool in_lanes,
               std::function<walker(problem const&)> make) {
    if (what.time_transformation)
        hilger::error::raise<hilger::error::invalid_parameter>(
            "members of an ensemble have one scale, and in a transformed time each has times of its own: solve them one by one");
    cast made{what, T, std::move(make), nullptr, in_lanes and T.steps > 0 ? lanes::of(what, method, T) : nullptr};
    if (what.lagrangian.formula().words().brought() == 0) made.common = made.make(what);
    return made;
}

ensemble walk_all(cast const& all, std::vector<member> const& from, hilger::index_type stride, int threads, std::atomic<bool> const& stop,
                  std::atomic<hilger::index_type>& done) {
    if (stride < 1 or threads < 1)
        hilger::error::raise<hilger::error::invalid_parameter>("every so many points and the number of threads are positive, and were ",
                                                               stride, " and ", threads);
    auto const& words = all.what.lagrangian.formula().words();
    for (member const& who : from)
        if (who.from.q0.size() != words.dimension() or who.from.other.size() != words.dimension() or
            static_cast<int>(who.parameters.size()) < words.brought())
            hilger::error::raise<hilger::error::mismatch>("a member has ", words.dimension(), " coordinates and brings ", words.brought(),
                                                          " parameters, and here are ", who.from.q0.size(), ", ", who.from.other.size(),
                                                          " and ", who.parameters.size());
    auto const steps = all.T.steps;
    ensemble made;
    made.members = static_cast<hilger::index_type>(from.size());
    made.dimension = words.dimension();
    made.points = points_kept(steps, stride);
    for (hilger::index_type kept = 0; kept < made.points; ++kept) {
        auto const i = std::min(kept * stride, steps);
        made.t.push_back(times_of(all.T, i, i).front());
    }
    made.q.assign(made.place(made.members, 0), std::numeric_limits<double>::quiet_NaN());
    made.p = made.q;
    made.failures.resize(from.size());
    std::atomic<hilger::index_type> next = 0;
    hilger::index_type const group = all.together ? all.together->width() : 1;
    auto const work = [&] {
        for (hilger::index_type first; (first = next.fetch_add(group)) < made.members;) {
            if (all.together)
                walk_group(all, steps, from, stride, made, first, stop);
            else
                walk_one(all, steps, from[static_cast<std::size_t>(first)], stride, made, first, stop);
            done += std::min(group, made.members - first);
        }
    };
    std::vector<std::thread> others;
    for (int k = 1; k < std::min<int>(threads, static_cast<int>(from.size())); ++k) others.emplace_back(work);
    work();
    for (auto& thread : others) thread.join();
    return made;
}

} // namespace engine
