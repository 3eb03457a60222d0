// SPDX-License-Identifier: BSL-1.0
// Members of an ensemble, their steps, and their states in lanes.
#pragma once

#include "engine/ensemble/lanes.hpp"
#include "stated.hpp"

namespace hilger::testing::members {

using engine::lanes;
using vector = Eigen::VectorXd;

/// Small numbers that are not each other's: member m, component k.
inline vector some(int d, int m, double size) {
    return vector::NullaryExpr(d, [&](Eigen::Index k) { return size * std::sin(1.0 + 2.0 * static_cast<double>(k) + 0.7 * m); });
}
inline std::vector<lanes::start> starts(int d, double size, int members = 8) {
    std::vector<lanes::start> all;
    for (int m = 0; m < members; ++m) all.push_back({some(d, m, size), some(d, m + 10, size), {}, {}});
    return all;
}
/// The states of one member, at all points.
struct seen {
    std::vector<vector> q, p;
    std::vector<bool> is_well;
};
/// In as many groups as it takes; lanes that are left over begin as the last member.
inline std::vector<seen> walked(lanes const& code, std::vector<lanes::start> const& from, index_type steps) {
    int const d = static_cast<int>(from[0].q.size());
    auto const width = static_cast<std::size_t>(code.width());
    std::vector<seen> all(from.size());
    for (std::size_t first = 0; first < from.size(); first += width) {
        std::vector<lanes::start> some;
        for (std::size_t m = first; m < first + width; ++m) some.push_back(from[std::min(m, from.size() - 1)]);
        lanes::group group(code, some);
        for (index_type i = 0; i <= steps; ++i) {
            if (i > 0) group.walk(1);
            for (int m = 0; m < code.width() and first + static_cast<std::size_t>(m) < from.size(); ++m) {
                vector q(d), p(d);
                for (int k = 0; k < d; ++k) q(k) = group.q(m, k), p(k) = group.p(m, k);
                seen& to = all[first + static_cast<std::size_t>(m)];
                to.q.push_back(q);
                to.p.push_back(p);
                to.is_well.push_back(group.is_well(m));
            }
        }
    }
    return all;
}
inline constexpr index_type steps = 60;
inline engine::points<double> const equal{0.25, 0.0625, steps, {}};
inline engine::points<double> uneven() { return testing::uneven(steps); }

} // namespace hilger::testing::members
