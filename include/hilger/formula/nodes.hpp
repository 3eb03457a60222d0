// SPDX-License-Identifier: BSL-1.0
// The nodes of a formula: an acyclic graph of operations, numbers and variables in which equal parts are one node (hash-consing), so that
// equality is equality of pointers and what a formula shares is known without searching. Nodes never change once made.
//
// The table of all nodes belongs to a thread: formulas of different threads do not share, and may be passed between them.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <unordered_map>

#include "hilger/error.hpp"

namespace hilger {

enum class operation : unsigned char {
    number,
    variable,
    plus,
    minus,
    times,
    over,
    over_norm, ///< x/y, and 0 where y is, but for an x without bounds: the slope of a norm at 0 is taken for 0, as everywhere
    negative,
    power, ///< the exponent is a number, in `value`
    atan2,
    maximum,
    minimum,
    where,     ///< y where x >= 0, else 0: what is not taken may be infinite
    elsewhere, ///< y where x < 0, else 0
    sin,
    cos,
    tan,
    exp,
    log,
    sqrt,
    sinh,
    cosh,
    tanh,
    asin,
    acos,
    atan,
    asinh,
    acosh,
    atanh,
    cbrt,
    expm1,
    log1p,
    erf,
    abs,
    sign ///< the derivative of abs; sign(0) is 1
};

struct formula {
    using pointer = std::shared_ptr<formula const>;
    operation op = operation::number;
    double value = 0;  ///< of a number, or the exponent of a power
    std::string name;  ///< of a variable
    int component = 0; ///< of a variable that is part of a vector; -1 for one that is not
    pointer a, b;
    int depth = 1; ///< of operations in operations, which the table counts

    [[nodiscard]] bool is_leaf() const { return op == operation::number or op == operation::variable; }
};

namespace detail {

/// The value of an elementary function.
inline double call(operation op, double x) {
    switch (op) {
    case operation::sin:
        return std::sin(x);
    case operation::cos:
        return std::cos(x);
    case operation::tan:
        return std::tan(x);
    case operation::exp:
        return std::exp(x);
    case operation::log:
        return std::log(x);
    case operation::sqrt:
        return std::sqrt(x);
    case operation::sinh:
        return std::sinh(x);
    case operation::cosh:
        return std::cosh(x);
    case operation::tanh:
        return std::tanh(x);
    case operation::asin:
        return std::asin(x);
    case operation::acos:
        return std::acos(x);
    case operation::atan:
        return std::atan(x);
    case operation::asinh:
        return std::asinh(x);
    case operation::acosh:
        return std::acosh(x);
    case operation::atanh:
        return std::atanh(x);
    case operation::cbrt:
        return std::cbrt(x);
    case operation::expm1:
        return std::expm1(x);
    case operation::log1p:
        return std::log1p(x);
    case operation::erf:
        return std::erf(x);
    case operation::abs:
        return std::abs(x);
    case operation::sign:
        return x < 0 ? -1 : 1;
    default:
        return std::nan("");
    }
}

/// The same of two arguments.
inline double call(operation op, double x, double y) {
    switch (op) {
    case operation::atan2:
        return std::atan2(x, y);
    case operation::over_norm:
        return y == 0 ? x * y : x / y;
    case operation::where:
        return x >= 0 ? y : x < 0 ? 0 : x;
    case operation::elsewhere:
        return x < 0 ? y : x >= 0 ? 0 : x;
    case operation::maximum:
        return std::max(x, y);
    default:
        return std::min(x, y);
    }
}
/// What is not one formula: it has branches, and so have its derivatives.
constexpr bool has_branches(operation op) {
    switch (op) {
    case operation::maximum:
    case operation::minimum:
    case operation::where:
    case operation::elsewhere:
    case operation::abs:
    case operation::sign:
        return true;
    default:
        return false;
    }
}

/// Formulas are differentiated, written and let go by recursion, and a stack has room for more levels than these.
inline constexpr int deepest_formula = 2000;

/// The thread's nodes, held as long as somebody holds them.
class formula_table {
public:
    static formula_table& of_this_thread() {
        thread_local formula_table table;
        return table;
    }
    /// The node that equals f; a + b and b + a are one node, the first that was made. @throws error::no_formula where it is too deep
    formula::pointer node(formula f) {
        bool const commutes = f.op == operation::plus or f.op == operation::times;
        if (commutes)
            if (auto const found = find({f.op, f.value, f.name, f.component, f.b, f.a})) return found;
        if (auto const found = find(f)) return found;
        f.depth = 1 + std::max(f.a ? f.a->depth : 0, f.b ? f.b->depth : 0);
        if (f.depth > deepest_formula)
            error::raise<error::no_formula>("a formula has at most ", deepest_formula,
                                            " operations inside of each other, as a sum of so many terms has, and this one has more: sums "
                                            "of partial sums are less deep");
        if (nodes_.size() >= sweep_at_) sweep();
        auto made = std::make_shared<formula const>(std::move(f));
        nodes_.insert_or_assign(key(*made), made);
        return made;
    }

private:
    /// Two live nodes with equal keys are equal: the parts of a live node live.
    struct key {
        explicit key(formula const& f)
            : op(f.op), value(std::bit_cast<std::uint64_t>(f.value)), name(f.name), component(f.component), a(f.a.get()), b(f.b.get()) {}
        operation op;
        std::uint64_t value;
        std::string name;
        int component;
        formula const *a, *b;
        friend bool operator==(key const&, key const&) = default;
    };
    struct hash {
        std::size_t operator()(key const& k) const {
            std::size_t seed = static_cast<std::size_t>(k.op);
            for (std::size_t const part : {std::hash<std::uint64_t>{}(k.value), std::hash<std::string>{}(k.name),
                                           std::hash<int>{}(k.component), std::hash<void const*>{}(k.a), std::hash<void const*>{}(k.b)})
                seed = seed * 0x9e3779b97f4a7c15u + (part ^ (seed >> 29));
            return seed;
        }
    };
    formula::pointer find(formula const& f) const {
        auto const at = nodes_.find(key(f));
        return at == nodes_.end() ? nullptr : at->second.lock();
    }
    void sweep() {
        std::erase_if(nodes_, [](auto const& entry) { return entry.second.expired(); });
        sweep_at_ = 2 * nodes_.size() + 1024;
    }
    std::unordered_map<key, std::weak_ptr<formula const>, hash> nodes_;
    std::size_t sweep_at_ = 1024;
};

} // namespace detail
} // namespace hilger
