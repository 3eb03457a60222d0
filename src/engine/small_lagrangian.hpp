// SPDX-License-Identifier: BSL-1.0
// The Lagrangian of a problem with few coordinates, for states of static size, which stay in registers. Its derivatives come from the
// traced formula, later from machine code.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/machine_code/c_library.hpp"
#include "engine/machine_code/machine_code.hpp"
#include "hilger/text/lagrangian.hpp"
#include "hilger/variational/nodes/node_derivatives.hpp"

namespace engine {

/// Calls use(std::integral_constant<int, d>()) for the sizes of small states, 1 to 3, and with 0 for any other.
template <class Use>
decltype(auto) with_small_size(int d, Use const& use) {
    switch (d) {
    case 1:
        return use(std::integral_constant<int, 1>());
    case 2:
        return use(std::integral_constant<int, 2>());
    case 3:
        return use(std::integral_constant<int, 3>());
    default:
        return use(std::integral_constant<int, 0>());
    }
}

/// The places in a node's values of the derivatives of L with D coordinates: dL/dq, dL/dv, then three blocks of second derivatives by
/// columns.
template <class S, int D>
class small_table {
    static constexpr std::size_t N = static_cast<std::size_t>(D);

public:
    static constexpr std::size_t firsts = 2 * N, size = 2 * N + 3 * N * N;
    using numbers = std::array<S, size>;

    template <class Node>
    explicit small_table(Node const& node) {
        places_.fill(-1);
        auto const& at = node.places();
        std::copy(at.by_q.begin(), at.by_q.end(), places_.begin());
        std::copy(at.by_v.begin(), at.by_v.end(), places_.begin() + D);
        std::size_t first = firsts;
        for (auto const block : {hilger::detail::block_qq, hilger::detail::block_qv, hilger::detail::block_vv}) {
            for (auto const& e : at.entries[block]) places_[first + static_cast<std::size_t>(e.column * D + e.row)] = e.place;
            first += N * N;
        }
        on_ = {at.degree(hilger::detail::block_qq), at.degree(hilger::detail::block_vv), not at.entries[hilger::detail::block_qv].empty()};
    }
    /// Reads the first `count` derivatives.
    template <class Node>
    void read(Node const& node, numbers& to, std::size_t count) const {
        for (std::size_t k = 0; k < count; ++k) to[k] = places_[k] < 0 ? S(0) : node.value(places_[k]);
    }
    [[nodiscard]] hilger::dependence on() const { return on_; }
    [[nodiscard]] std::vector<int> places() const { return {places_.begin(), places_.end()}; }

private:
    std::array<int, size> places_;
    hilger::dependence on_;
};

/// L with its derivatives, for one trajectory at a time: evaluations share a buffer. Copies begin with the trace so far, and share the
/// machine code.
template <class S, int D>
class small_lagrangian {
    using V = Eigen::Matrix<S, D, 1>;
    using M = Eigen::Matrix<S, D, D>;
    using table = small_table<S, D>;
    using wanted = hilger::detail::wanted;
    using problem_type = hilger::problem<hilger::text::stated_lagrangian, hilger::no_force>;

public:
    explicit small_lagrangian(hilger::text::stated_lagrangian of) : of_{std::move(of), {}} {}
    [[nodiscard]] hilger::expansion<V> expand(S t, V const& q, V const& v) const {
        typename table::numbers x;
        if (compiled_ != nullptr) [[likely]]
            compiled_->all(compiled_->numbers.data(), t, q.data(), v.data(), x.data());
        else
            interpret(t, q, v, wanted::with_seconds, x);
        S const* const blocks = x.data() + table::firsts;
        auto const block = [&](int number) { return taken<M>(blocks + number * D * D); };
        return {taken<V>(x.data()), taken<V>(x.data() + D), block(0), block(1), block(2), table_->on()};
    }
    [[nodiscard]] hilger::dependence gradients(S t, V const& q, V const& v, V& by_q, V& by_v) const {
        typename table::numbers x;
        if (compiled_ != nullptr) [[likely]]
            compiled_->first(compiled_->numbers.data(), t, q.data(), v.data(), x.data());
        else
            interpret(t, q, v, wanted::first_order, x);
        by_q = taken<V>(x.data());
        by_v = taken<V>(x.data() + D);
        return table_->on();
    }
    /// dL/dq at n positions and v = 0.
    [[nodiscard]] hilger::dependence forces(S t, V const* q, V* by_q, std::size_t n) const {
        static_assert(sizeof(V) == D * sizeof(S));
        if (compiled_ != nullptr and n == 1) {
            typename table::numbers x;
            V const v = V::Zero();
            compiled_->force(compiled_->numbers.data(), t, q->data(), v.data(), x.data());
            *by_q = taken<V>(x.data());
        } else if (compiled_ != nullptr)
            compiled_->many(compiled_->numbers.data(), t, q->data(), by_q->data(), static_cast<long>(n));
        else
            for (std::size_t k = 0; k < n; ++k) {
                typename table::numbers x;
                interpret(t, q[k], V::Zero(), wanted::first_order, x);
                by_q[k] = taken<V>(x.data());
            }
        return table_->on();
    }
    [[nodiscard]] bool reads_time() const { return of_.lagrangian.reads_time(); }

private:
    using function = void (*)(S const*, S, S const*, S const*, S*);
    struct functions {
        function first, all, force;
        void (*many)(S const*, S, S const*, S*, long);
        std::vector<S> numbers; ///< the constants that the functions read
    };
    struct found {
        std::mutex changes;
        std::shared_ptr<functions const> all;
    };

    /// Copies the numbers one by one, as they were written: a vector load of two scalar stores would stall the processor.
    template <class X>
    static X taken(S const volatile* x) {
        X made;
        for (int k = 0; k < X::SizeAtCompileTime; ++k) made.data()[k] = x[k];
        return made;
    }
    [[gnu::noinline]] void interpret(S t, V const& q, V const& v, wanted which, typename table::numbers& x) const {
        if (node_.evaluate(hilger::detail::given<problem_type, V, true>(of_), t, q, v, which) or not table_) table_.emplace(node_);
        table_->read(node_, x, which == wanted::with_seconds ? table::size : table::firsts);
        if (node_.has_branches()) return;
        bool const is_often = ++interpreted_ == next_look_;
        if (is_often) next_look_ *= 2; // without a compiler, a look costs as much as an interpretation
        std::lock_guard const lock(found_->changes);
        if (is_often and found_->all == nullptr) found_->all = look_for_machine_code();
        compiled_ = found_->all;
    }
    [[nodiscard]] std::shared_ptr<functions const> look_for_machine_code() const {
        std::string text = c_of_node(node_.how(), D, table_->places(), table::firsts);
        auto const* const made = text.empty() ? nullptr : machine_code_of(std::move(text));
        if (made == nullptr) return nullptr;
        auto const find = [&](char const* name, auto& to) { to = reinterpret_cast<std::remove_cvref_t<decltype(to)>>(made->find(name)); };
        auto all = std::make_shared<functions>();
        find("first", all->first);
        find("all", all->all);
        find("force", all->force);
        find("many", all->many);
        all->numbers = node_.values();
        bool const is_whole = all->first != nullptr and all->all != nullptr and all->force != nullptr and all->many != nullptr;
        return is_whole ? all : nullptr;
    }
    problem_type of_;
    std::shared_ptr<found> found_ = std::make_shared<found>();
    mutable hilger::detail::traced_node<V> node_;
    mutable std::optional<table> table_;
    mutable long long interpreted_ = 0, next_look_ = 512;
    mutable std::shared_ptr<functions const> compiled_;
};

} // namespace engine
