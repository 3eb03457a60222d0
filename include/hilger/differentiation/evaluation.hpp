// SPDX-License-Identifier: BSL-1.0
// The values of a graph's nodes, computed in rounds of equal operations: nodes of one level depend on earlier levels only, and those of
// one kind are one loop, which a compiler makes vectors of. Nodes that nothing asks for are left out. What is asked for may be asked in
// parts; what several parts need is computed before them.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "hilger/differentiation/graph.hpp"

namespace hilger::detail {

template <class S>
class evaluation {
public:
    /// Parts of the results: what is compared and what `momenta` and `forces` have in common, each of these, and what only second
    /// derivatives need, which may need all others.
    enum part : int { shared, momenta, forces, seconds, parts };

    evaluation() = default;
    /// Which nodes are asked for in which part; comparisons are asked for as shared.
    evaluation(formula_graph<S> const& g, int arguments, std::array<std::vector<int>, parts> const& asked) : arguments_(arguments) {
        auto const n = static_cast<std::size_t>(g.size());
        std::vector<std::uint8_t> of(n, 0); // a bit for each part
        for (int p = 0; p < parts; ++p)
            for (int const k : asked[static_cast<std::size_t>(p)]) of[static_cast<std::size_t>(k)] |= static_cast<std::uint8_t>(1 << p);
        for (int k = g.size(); k-- > 0;)
            if (auto const& node = g[k]; node.what != nullptr)
                for (int const x : {node.a, node.b}) of[static_cast<std::size_t>(x)] |= of[static_cast<std::size_t>(k)];
        struct place {
            int part, level;
            traced_operation<S> const* what;
            int node;
        };
        std::vector<place> order;
        std::vector<int> level(n, 0), in(n, 0);
        for (int k = 0; k < g.size(); ++k) {
            auto const at = static_cast<std::size_t>(k);
            auto const& node = g[k];
            if (node.what == nullptr or of[at] == 0) continue;
            bool const m = of[at] >> momenta & 1, f = of[at] >> forces & 1;
            in[at] = (of[at] >> shared & 1) or (m and f) ? shared : m ? momenta : f ? forces : seconds;
            for (int const x : {node.a, node.b})
                if (auto const from = static_cast<std::size_t>(x); g[x].what != nullptr and in[from] == in[at])
                    level[at] = std::max(level[at], level[from] + 1);
            order.push_back({in[at], level[at], node.what, k});
        }
        std::stable_sort(order.begin(), order.end(), [](place const& x, place const& y) {
            if (x.part != y.part) return x.part < y.part;
            if (x.level != y.level) return x.level < y.level;
            return std::less<>()(x.what, y.what);
        });
        place_.assign(n, -1);
        for (int k = 0; k < arguments; ++k) place_[static_cast<std::size_t>(k)] = k;
        for (int k = 0; k < g.size(); ++k)
            if (g.is_number(k) and of[static_cast<std::size_t>(k)] != 0) {
                place_[static_cast<std::size_t>(k)] = arguments + static_cast<int>(numbers_.size());
                numbers_.push_back(g.number(k));
            }
        first_ = arguments + static_cast<int>(numbers_.size());
        for (auto const& o : order) {
            auto const& node = g[o.node];
            place_[static_cast<std::size_t>(o.node)] = first_ + static_cast<int>(a_.size());
            a_.push_back(place_[static_cast<std::size_t>(node.a)]);
            b_.push_back(place_[static_cast<std::size_t>(node.b)]);
        }
        int part_of_last = 0;
        for (std::size_t first = 0; first < order.size();) {
            auto const& o = order[first];
            for (; part_of_last < o.part; ++part_of_last)
                end_of_[static_cast<std::size_t>(part_of_last)] = static_cast<int>(rounds_.size());
            std::size_t last = first;
            while (last < order.size() and order[last].part == o.part and order[last].level == o.level and order[last].what == o.what)
                ++last;
            add_rounds(o.what, static_cast<int>(first), static_cast<int>(last));
            first = last;
        }
        for (; part_of_last < parts; ++part_of_last) end_of_[static_cast<std::size_t>(part_of_last)] = static_cast<int>(rounds_.size());
    }
    /// Where a node's value is in the values; -1 for one that was not asked for.
    [[nodiscard]] int place(int node) const { return place_[static_cast<std::size_t>(node)]; }
    /// Room for all values, with the numbers in their places.
    void prepare(std::vector<S>& values) const {
        values.resize(static_cast<std::size_t>(first_) + a_.size());
        std::copy(numbers_.begin(), numbers_.end(), values.begin() + arguments_);
    }
    void compute(part which, S* values) const {
        int const begin = which == 0 ? 0 : end_of_[static_cast<std::size_t>(which) - 1], end = end_of_[static_cast<std::size_t>(which)];
        for (int k = begin; k < end; ++k) {
            auto const& r = rounds_[static_cast<std::size_t>(k)];
            int const *a = a_.data() + r.first, *b = b_.data() + r.first;
            if (r.in_a_row)
                r.what->run_in_a_row(values + first_ + r.first, r.count, values + *a, r.all_a, values + *b, r.all_b);
            else
                r.what->run(values, first_ + r.first, r.count, a, b);
        }
    }
    [[nodiscard]] std::size_t operations() const { return a_.size(); }

private:
    struct round {
        traced_operation<S> const* what;
        int count, first;
        bool in_a_row = false, all_a = false, all_b = false;
    };
    /// Operations first ... last - 1 are of one kind: where their operands stand one after the other they are a round of their own.
    void add_rounds(traced_operation<S> const* what, int first, int last) {
        constexpr int worth_it = 4;
        auto const step = [](std::vector<int> const& at, int k) {
            return at[static_cast<std::size_t>(k + 1)] - at[static_cast<std::size_t>(k)];
        };
        int rest = first;
        for (int k = first; k < last;) {
            int end = k + 1;
            if (end < last) {
                int const a = step(a_, k), b = step(b_, k);
                if (0 <= a and a <= 1 and 0 <= b and b <= 1 and a + b > 0) {
                    while (end < last and step(a_, end - 1) == a and step(b_, end - 1) == b) ++end;
                    if (end - k >= worth_it) {
                        if (rest < k) rounds_.push_back({what, k - rest, rest});
                        rounds_.push_back({what, end - k, k, true, a == 0, b == 0});
                        rest = end;
                    }
                }
            }
            k = end;
        }
        if (rest < last) rounds_.push_back({what, last - rest, rest});
    }
    int arguments_ = 0, first_ = 0;
    std::vector<S> numbers_;
    std::vector<round> rounds_;
    std::vector<int> a_, b_, place_;
    std::array<int, parts> end_of_{};
};

} // namespace hilger::detail
