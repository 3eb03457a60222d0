// SPDX-License-Identifier: BSL-1.0
// What an operator that is known at run time only makes of functions on a scale: a value, or the row of numbers that the value is made
// with.
#pragma once

#include <map>

#include "hilger/text/operator.hpp"
#include "hilger/text/write.hpp"

namespace hilger::text {

/// An operator with its factors in numbers S, to be applied.
template <class S>
class operator_in_numbers {
    using kind = operator_formula::kind;

public:
    /// @throws error::unreadable where a factor is no number of type S, as a root in rationals; error::not_finite where it is NaN or
    /// infinite
    explicit operator_in_numbers(operator_formula const& a) { add(a); }

    /// A[f] at point i of T, of a function with values get(i) on the scale root().
    template <class F>
    [[nodiscard]] auto value(F const& f, index_type i) const {
        return item_value(items_.size() - 1, asked<F>{&f}, i);
    }
    /// Numbers by points.
    using row_type = std::map<index_type, S>;
    /// The numbers c_j of A[f](t_i) = sum_j c_j f(t_j) on the scale T. As `sizes` those of all terms that they are sums of, without signs:
    /// what they round by. In a time that grows with the number of parts, where a value of a product asks its parts again and again.
    template <class T>
    [[nodiscard]] row_type row(T const& scale, index_type i, bool sizes = false) const {
        return before(items_.size() - 1, scale, {{i, S(1)}}, sizes);
    }

private:
    struct item {
        kind what;
        side which;
        sum_weight from, to;
        S factor;
        std::size_t first, second;
    };
    std::size_t add(operator_formula const& a) {
        auto const& n = a.root();
        item made{n.what, n.which, n.from, n.to, S(1), 0, 0};
        if (n.factor) made.factor = n.factor->template number<S>();
        if (not is_finite(made.factor))
            error::raise<error::not_finite>(n.factor->source(), ": ", written(n.factor->formula(), 80).value_or("a factor"),
                                            " is no finite number");
        if (not n.parts.empty()) made.first = add(n.parts[0]);
        if (n.parts.size() > 1) made.second = add(n.parts[1]);
        items_.push_back(std::move(made));
        return items_.size() - 1;
    }
    /// What a part is applied to: f, or another part of what that one is applied to.
    template <class F>
    struct asked {
        F const* f;
        operator_in_numbers const* op = nullptr;
        std::size_t part = 0;
        asked const* below = nullptr;
        using value_type = plain_t<decltype(f->get(0))>;
        [[nodiscard]] value_type get(index_type i) const { return op == nullptr ? value_type(f->get(i)) : op->item_value(part, *below, i); }
    };
    template <class F>
    [[nodiscard]] typename asked<F>::value_type item_value(std::size_t k, asked<F> const& f, index_type i) const {
        using value = typename asked<F>::value_type;
        item const& n = items_[k];
        auto const& T = f.f->root();
        switch (n.what) {
        case kind::shift:
            return f.get(n.which == side::plus ? i + 1 : i - 1);
        case kind::derivative: {
            index_type const left = n.which == side::plus ? i : i - 1;
            return value((f.get(left + 1) - f.get(left)) / S(T.step(left)));
        }
        case kind::reweight:
            return value(f.get(i) * ratio_of_weights(n, T, i));
        case kind::multiple:
            return value(item_value(n.first, f, i) * n.factor);
        case kind::sum:
            return value(item_value(n.first, f, i) + item_value(n.second, f, i));
        case kind::product: {
            asked<F> const below{f.f, this, n.second, &f};
            return item_value(n.first, below, i);
        }
        default:
            return f.get(i);
        }
    }
    /// The row of `after` behind the part.
    template <class T>
    [[nodiscard]] row_type before(std::size_t k, T const& scale, row_type after, bool sizes) const {
        item const& n = items_[k];
        row_type made;
        switch (n.what) {
        case kind::shift:
            for (auto const& [i, c] : after) made[n.which == side::plus ? i + 1 : i - 1] += c;
            return made;
        case kind::derivative:
            for (auto const& [i, c] : after) {
                index_type const left = n.which == side::plus ? i : i - 1;
                S const slope = c / S(scale.step(left));
                made[left + 1] += slope;
                made[left] += sizes ? slope : S(-slope);
            }
            return made;
        case kind::reweight:
            for (auto& [i, c] : after) c *= ratio_of_weights(n, scale, i);
            return after;
        case kind::multiple:
            for (auto& [i, c] : after) c *= sizes and S(0) > n.factor ? S(-n.factor) : n.factor;
            return before(n.first, scale, std::move(after), sizes);
        case kind::sum:
            made = before(n.first, scale, after, sizes);
            for (auto const& [i, c] : before(n.second, scale, std::move(after), sizes)) made[i] += c;
            return made;
        case kind::product:
            return before(n.second, scale, before(n.first, scale, std::move(after), sizes), sizes);
        default:
            return after;
        }
    }
    template <class T>
    static S ratio_of_weights(item const& n, T const& scale, index_type i) {
        if (n.from == n.to) return S(1);
        auto const weight = [&](sum_weight w) { // a missing neighbour counts zero
            if (w == sum_weight::delta) return i < scale.steps() ? S(scale.step(i)) : S(0);
            return i > 0 ? S(scale.step(i - 1)) : S(0);
        };
        return weight(n.from) / weight(n.to);
    }
    std::vector<item> items_;
};

} // namespace hilger::text
