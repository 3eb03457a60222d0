// SPDX-License-Identifier: BSL-1.0
// A formula as an acyclic graph of operations on its arguments and on numbers, in which equal operations on equal operands are one node.
// Operands come before what is made of them, so that the order of the nodes is an order to evaluate them in. What an operation is - its
// value, its loop over many operands, its derivative - stands in arithmetic.hpp and functions.hpp; a node only points there.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "hilger/differentiation/branches.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

template <class S>
class traced;

namespace detail {

/// What a node does. One object for each operation and scalar, so that equality is equality of addresses.
template <class S>
struct traced_operation {
    char const* name; ///< as C has it: an operator of two operands, "-x", or a function
    bool commutes;
    /// x[out + i] = f(x[a[i]], x[b[i]]) for i = 0 ... count - 1
    void (*run)(S* x, int out, int count, int const* a, int const* b);
    /// out[i] = f(a[i], b[i]) for operands one after the other; a or b is one number for all where `all_a`, `all_b`. Nothing overlaps.
    void (*run_in_a_row)(S* out, int count, S const* a, bool all_a, S const* b, bool all_b);
    /// The two operands' parts of an adjoint: adjoint df/dx and adjoint df/dy.
    std::pair<traced<S>, traced<S>> (*pull_back)(traced<S> const& x, traced<S> const& y, traced<S> const& result, traced<S> const& adjoint);
};

/// Which arguments a node depends on.
enum depends : std::uint8_t { on_nothing = 0, on_position = 1, on_velocity = 2, on_time = 4 };

template <class S>
class formula_graph {
public:
    struct node {
        traced_operation<S> const* what; ///< none for arguments and numbers
        int a, b;                        ///< operands; of a number its place in numbers(), of an argument a = -1 and its number
        std::uint8_t on;
    };
    /// A comparison, and how it came out where the formula was traced: elsewhere the formula holds where it comes out the same.
    struct guard {
        relation how;
        int a, b;
        bool outcome;
    };

    /// The arguments are the first nodes: d positions, then d velocities, then the time. Others may follow.
    explicit formula_graph(int d) : arguments_(arguments(d)) {
        for (int k = 0; k < 2 * d; ++k) nodes_.push_back({nullptr, -1, k, static_cast<std::uint8_t>(k < d ? on_position : on_velocity)});
        nodes_.push_back({nullptr, -1, 2 * d, on_time});
    }
    [[nodiscard]] static constexpr int arguments(int d) { return 2 * d + 1; }
    [[nodiscard]] int size() const { return static_cast<int>(nodes_.size()); }
    [[nodiscard]] node const& operator[](int k) const { return nodes_[static_cast<std::size_t>(k)]; }
    [[nodiscard]] bool is_number(int k) const { return (*this)[k].what == nullptr and (*this)[k].a >= 0; }
    [[nodiscard]] S const& number(int k) const { return numbers_[static_cast<std::size_t>((*this)[k].a)]; }
    [[nodiscard]] std::vector<guard> const& guards() const { return guards_; }

    /// The node of a number. Numbers that do not equal themselves have a node each.
    int place_of(S const& x) {
        if (not(x == x)) return new_number(x);
        auto const [at, is_new] = known_numbers_.try_emplace({x, has_minus_sign(x)}, size());
        return is_new ? new_number(x) : at->second;
    }
    int make(traced_operation<S> const& what, int a, int b) {
        if (what.commutes and b < a) std::swap(a, b);
        if (slots_.size() < 2 * (nodes_.size() + 1)) make_room();
        int& slot = slot_of(what, a, b);
        if (slot == none) {
            slot = size();
            nodes_.push_back({&what, a, b, static_cast<std::uint8_t>((*this)[a].on | (*this)[b].on)});
        }
        return slot;
    }
    /// One more argument, by which nothing is differentiated. @returns its node
    int new_argument() {
        nodes_.push_back({nullptr, -1, arguments_++, on_nothing});
        return size() - 1;
    }
    void watch(relation how, int a, int b, bool outcome) { guards_.push_back({how, a, b, outcome}); }

    /// Values are computed along while a callable is traced, for what it compares; not while derivatives are made, nor for a formula that
    /// is written out: that has no comparisons, and abs, min and max are operations of it (choices.hpp).
    bool has_values = true;
    static formula_graph*& of_this_thread() {
        static thread_local formula_graph* current = nullptr;
        return current;
    }

private:
    static constexpr int none = -1;
    /// Where the operation's number is, or is to be put: from its hash on, the first place that is its own or nobody's.
    int& slot_of(traced_operation<S> const& what, int a, int b) {
        auto const operands = static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U | static_cast<std::uint32_t>(b);
        auto const hash = (operands * 0x9e3779b97f4a7c15U ^ reinterpret_cast<std::uintptr_t>(&what)) * 0xbf58476d1ce4e5b9U;
        for (auto at = static_cast<std::size_t>(hash >> 32U);; ++at) { // its upper half, which depends on both operands
            int& slot = slots_[at & (slots_.size() - 1)];
            if (slot == none) return slot;
            if (auto const& n = (*this)[slot]; n.what == &what and n.a == a and n.b == b) return slot;
        }
    }
    void make_room() {
        slots_.assign(std::bit_ceil(4 * (nodes_.size() + 1)), none);
        for (int k = 0; k < size(); ++k)
            if (auto const& n = (*this)[k]; n.what != nullptr) slot_of(*n.what, n.a, n.b) = k;
    }
    int new_number(S const& x) {
        nodes_.push_back({nullptr, static_cast<int>(numbers_.size()), -1, on_nothing});
        numbers_.push_back(x);
        return size() - 1;
    }
    int arguments_;
    std::vector<node> nodes_;
    std::vector<S> numbers_;
    std::vector<guard> guards_;
    std::vector<int> slots_; ///< the numbers of operations by their hash, a power of two of them and at least half of them free
    std::map<std::pair<S, bool>, int> known_numbers_; ///< -0 and 0 are equal, and two
};

/// Makes a graph the one that this thread's traced numbers are part of.
template <class S>
class tracing {
public:
    explicit tracing(formula_graph<S>& g) : before_(std::exchange(formula_graph<S>::of_this_thread(), &g)) {}
    tracing(tracing const&) = delete;
    tracing& operator=(tracing const&) = delete;
    ~tracing() { formula_graph<S>::of_this_thread() = before_; }

private:
    formula_graph<S>* before_;
};

} // namespace detail
} // namespace hilger
