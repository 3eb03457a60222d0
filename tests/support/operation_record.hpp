// SPDX-License-Identifier: BSL-1.0
// The operations that a computation was made of, written down one after the other, and which of them were needed: those on which the
// numbers that are asked for, or a branch that was taken, depend. Operations with the same operands are one.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <utility>
#include <vector>

namespace hilger::testing {

enum class operation_kind : std::uint8_t { plus, minus, times, over, sign, function };
/// Names of the functions that are counted one by one; others have larger names.
inline constexpr std::uint32_t sine_name = 0, cosine_name = 1;

/// The operations of a record that were needed.
struct counts {
    long long arithmetic = 0; ///< + - * /
    long long divisions = 0;  ///< of these
    long long functions = 0;  ///< sqrt, sin, ...
    long long sines = 0, cosines = 0;
};

/// The operations of one thread. A number is known by what made it: 0 is a constant, others count up, and those from before the record
/// began are its variables.
class record_of_operations {
    struct operation {
        std::int64_t a, b;
        std::uint32_t name; // which function
        operation_kind kind;
        friend bool operator==(operation const&, operation const&) = default;
    };
    struct hash {
        std::size_t operator()(operation const& o) const {
            auto const mixed = static_cast<std::uint64_t>(o.a) * 0x9e3779b97f4a7c15U ^ static_cast<std::uint64_t>(o.b);
            return static_cast<std::size_t>((mixed ^ o.name << 3U ^ static_cast<std::uint64_t>(o.kind)) * 0xbf58476d1ce4e5b9U >> 16U);
        }
    };

public:
    static record_of_operations& of_this_thread() {
        static thread_local record_of_operations record;
        return record;
    }
    long long numbers = 0; ///< how many there are at this moment

    std::int64_t variable() {
        if (recording_) operations_.push_back({0, 0, 0, operation_kind::sign}); // a place with its number, and nothing to do
        return ++last_;
    }
    /// The result of an operation; operands that are constants stand for their values.
    std::int64_t made(operation_kind kind, std::uint32_t name, std::int64_t a, double x, std::int64_t b, double y) {
        if (a == 0 and b == 0) return 0;
        if (not recording_) return ++last_;
        operation o{operand(a, x), operand(b, y), name, kind};
        if ((kind == operation_kind::plus or kind == operation_kind::times) and o.b < o.a) std::swap(o.a, o.b);
        auto const [known, is_new] = this_step_.try_emplace(o, last_ + 1);
        if (not is_new) return known->second;
        operations_.push_back(o);
        return ++last_;
    }
    void need(std::int64_t a) {
        if (recording_ and a > first_) needed_.push_back(a);
    }
    void begin() {
        *this = record_of_operations(numbers, last_);
        recording_ = true;
    }
    /// Operations are found again within a step only.
    void next_step() { this_step_.clear(); }
    /// From here on only what becomes of the numbers is of interest.
    void stop_counting() { counted_until_ = last_; }
    /// What was counted and is needed.
    counts end();

private:
    record_of_operations() = default;
    record_of_operations(long long alive, std::int64_t last) : numbers(alive), first_(last), last_(last) {}
    std::int64_t operand(std::int64_t a, double x) {
        return a != 0 ? a : constants_.try_emplace(x == 0 ? 0.0 : x, -1 - static_cast<std::int64_t>(constants_.size())).first->second;
    }
    bool recording_ = false;
    std::int64_t first_ = 0, last_ = 0, counted_until_ = 0;
    std::vector<operation> operations_; // number first_ + 1, ...
    std::unordered_map<operation, std::int64_t, hash> this_step_;
    std::unordered_map<double, std::int64_t> constants_;
    std::vector<std::int64_t> needed_;
};

inline counts record_of_operations::end() {
    counts result;
    std::vector<bool> alive(operations_.size());
    auto const at = [&](std::int64_t a) { return static_cast<std::size_t>(a - first_ - 1); };
    for (std::int64_t const a : needed_) alive[at(a)] = true;
    for (std::size_t i = operations_.size(); i-- > 0;) {
        if (not alive[i]) continue;
        operation const& o = operations_[i];
        if (o.a > first_) alive[at(o.a)] = true;
        if (o.b > first_) alive[at(o.b)] = true;
        if (first_ + 1 + static_cast<std::int64_t>(i) > counted_until_ or o.kind == operation_kind::sign) continue;
        ++(o.kind == operation_kind::function ? result.functions : result.arithmetic);
        result.divisions += o.kind == operation_kind::over;
        if (o.kind != operation_kind::function) continue;
        result.sines += o.name == sine_name;
        result.cosines += o.name == cosine_name;
    }
    *this = record_of_operations(numbers, last_);
    return result;
}

} // namespace hilger::testing
