// SPDX-License-Identifier: BSL-1.0
// A formula as an acyclic graph of operations on its arguments and on numbers, in which equal operations on equal operands are one node.
// Operands precede results: the order of the nodes is an order of evaluation. Operations - value, loop over many operands, derivative - are
// defined in arithmetic.hpp and functions.hpp; a node points to one.
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

/// The operation of a node. One object for each operation and scalar, so that equality is equality of addresses.
template <class S>
struct traced_operation {
    char const* name; ///< as C has it: an operator of two operands, "-x", or a function
    bool commutes;
    /// x[out + i] = f(x[a[i]], x[b[i]]) for i = 0 ... count - 1
    void (*run)(S* x, int out, int count, int const* a, int const* b);
    /// out[i] = f(a[i], b[i]) for contiguous operands; a or b is one number for all if `all_a`, `all_b`. Nothing overlaps.
    void (*run_in_a_row)(S* out, int count, S const* a, bool all_a, S const* b, bool all_b);
    /// The two operands' parts of an adjoint: adjoint df/dx and adjoint df/dy.
    std::pair<traced<S>, traced<S>> (*pull_back)(traced<S> const& x, traced<S> const& y, traced<S> const& result, traced<S> const& adjoint);
};

/// The arguments that a node depends on.
enum depends : std::uint8_t { on_nothing = 0, on_position = 1, on_velocity = 2, on_time = 4 };

template <class S>
class formula_graph {
public:
    struct node {
        traced_operation<S> const* what; ///< null for arguments and numbers
        int a, b;                        ///< operands; of a number its place in numbers(), of an argument a = -1 and its number
        std::uint8_t on;
    };
    /// A comparison and its outcome in the trace: the formula holds for the same outcomes only.
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

    /// The node of a number. A NaN gets a node of its own.
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
    /// Adds an argument, by which nothing is differentiated. @returns its node
    int new_argument() {
        nodes_.push_back({nullptr, -1, arguments_++, on_nothing});
        return size() - 1;
    }
    void watch(relation how, int a, int b, bool outcome) { guards_.push_back({how, a, b, outcome}); }

    /// Whether values are computed in the trace of a callable, for its comparisons: not while derivatives are made, nor for a formula that
    /// is written out, where abs, min and max are operations (choices.hpp).
    bool has_values = true;
    static formula_graph*& of_this_thread() {
        static thread_local formula_graph* current = nullptr;
        return current;
    }

private:
    static constexpr int none = -1;
    /// The slot of an operation: from its hash on, the first one that is its own or free.
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
    std::vector<int> slots_;                          ///< hash table of operations: its size is a power of two, at least half of it free
    std::map<std::pair<S, bool>, int> known_numbers_; ///< -0 and 0 are equal, and two
};

/// Makes g the graph of this thread's traced numbers.
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
