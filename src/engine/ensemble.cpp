// SPDX-License-Identifier: BSL-1.0
#include "engine/ensemble.hpp"

#include <algorithm>
#include <limits>
#include <thread>

namespace engine {

namespace {

void walk_one(motion<double> const& path, hilger::index_type steps, initial<double> const& from, hilger::index_type stride, ensemble& to,
              hilger::index_type member, std::atomic<bool> const& stop) {
    hilger::index_type number = 0, kept = 0;
    try {
        path.walk(from, [&](double, vector<double> const& q, vector<double> const& p) {
            if (number % stride == 0 or number == steps) {
                auto const at = static_cast<std::ptrdiff_t>(to.place(member, kept));
                std::copy(q.begin(), q.end(), to.q.begin() + at);
                std::copy(p.begin(), p.end(), to.p.begin() + at);
                ++kept;
            }
            ++number;
            return not stop.load(std::memory_order_relaxed);
        });
        if (number <= steps) to.failures[static_cast<std::size_t>(member)] = "interrupted";
    } catch (std::exception const& why) {
        to.failures[static_cast<std::size_t>(member)] = why.what();
    }
}

} // namespace

ensemble walk_all(motion<double> const& path, std::vector<initial<double>> const& from, hilger::index_type stride, int threads,
                  std::atomic<bool> const& stop, std::atomic<hilger::index_type>& done) {
    if (stride < 1 or threads < 1)
        hilger::error::raise<hilger::error::invalid_parameter>("every so many points and the number of threads are positive, and were ",
                                                               stride, " and ", threads);
    auto const times = path.times();
    auto const steps = static_cast<hilger::index_type>(times.size()) - 1;
    ensemble made;
    made.members = static_cast<hilger::index_type>(from.size());
    made.dimension = from.empty() ? 0 : static_cast<int>(from[0].q0.size());
    made.points = steps / stride + 1 + (steps % stride != 0 ? 1 : 0);
    for (hilger::index_type kept = 0; kept < made.points; ++kept)
        made.t.push_back(times[static_cast<std::size_t>(std::min(kept * stride, steps))]);
    made.q.assign(made.place(made.members, 0), std::numeric_limits<double>::quiet_NaN());
    made.p = made.q;
    made.failures.resize(from.size());
    std::atomic<hilger::index_type> next = 0;
    auto const work = [&] {
        for (hilger::index_type member; (member = next++) < made.members;) {
            walk_one(path, steps, from[static_cast<std::size_t>(member)], stride, made, member, stop);
            ++done;
        }
    };
    std::vector<std::thread> others;
    for (int k = 1; k < std::min<int>(threads, static_cast<int>(from.size())); ++k) others.emplace_back(work);
    work();
    for (auto& thread : others) thread.join();
    return made;
}

} // namespace engine
