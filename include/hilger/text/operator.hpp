// SPDX-License-Identifier: BSL-1.0
// Linear operators on functions on T that are known at run time only: identity, sigma, rho, Delta_plus, Delta_minus, multiples, sums and
// compositions of them. The algebra is that of operator/compose.hpp, with the same adjoints: between two weighted sums,
//   adjoint(sigma) = rho,  adjoint(Delta_plus) = -Delta_minus  between the nabla and the Delta sum, and what other sums are used is a
//   multiplication by the ratio of their weights,
// and A == B decides by what both make of one generic function on one generic scale (adjoint/normal_form.hpp).
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include "hilger/operator/local.hpp"
#include "hilger/text/stated.hpp"

namespace hilger::text {

/// The weights of a sum over T: mu(t) of the Delta integral, nu(t) of the nabla integral, a missing neighbour counting zero.
enum class sum_weight { delta, nabla };

/// The points that a function loses at each end.
struct lost_points {
    int front = 0, back = 0;
    friend constexpr bool operator==(lost_points, lost_points) = default;
};
constexpr lost_points most(lost_points a, lost_points b) { return {std::max(a.front, b.front), std::max(a.back, b.back)}; }

class operator_formula {
public:
    enum class kind {
        identity,
        shift,      ///< sigma, rho
        derivative, ///< Delta_plus, Delta_minus
        reweight,   ///< times w_from / w_to
        multiple,   ///< of parts[0]
        sum,
        product ///< first parts[1], then parts[0]
    };
    struct node {
        kind what = kind::identity;
        side which = side::plus;
        sum_weight from = sum_weight::delta, to = sum_weight::delta; ///< of a reweight
        std::shared_ptr<stated const> factor{};                      ///< of a multiple: a formula of numbers alone
        std::vector<operator_formula> parts{};
        int depth = 1;
    };

    operator_formula() : operator_formula(node{}) {}
    static operator_formula shift(side which) { return node{kind::shift, which}; }
    static operator_formula derivative(side which) { return node{kind::derivative, which}; }
    static operator_formula reweight(sum_weight from, sum_weight to) {
        return from == to ? operator_formula() : operator_formula(node{kind::reweight, side::plus, from, to});
    }
    /// c A. @throws error::unreadable when c is no formula of numbers alone
    static operator_formula multiple(stated const& c, operator_formula const& a) {
        if (c.reads_state())
            error::raise<error::unreadable>(c.source(), ": the factor of an operator is a number, and this one depends on the state");
        node n{kind::multiple};
        n.factor = std::make_shared<stated const>(c);
        n.parts = {a};
        return n;
    }
    friend operator_formula operator+(operator_formula const& a, operator_formula const& b) {
        node n{kind::sum};
        n.parts = {a, b};
        return n;
    }
    /// A B: first B, then A.
    friend operator_formula operator*(operator_formula const& a, operator_formula const& b) {
        if (a.is(kind::identity)) return b;
        if (b.is(kind::identity)) return a;
        if (a.is(kind::reweight) and b.is(kind::reweight) and a.root().from == b.root().to) return {};
        node n{kind::product};
        n.parts = {a, b};
        return n;
    }
    friend operator_formula operator-(operator_formula const& a) { return multiple(stated_number("-1"), a); }
    friend operator_formula operator-(operator_formula const& a, operator_formula const& b) { return a + -b; }

    [[nodiscard]] node const& root() const { return *root_; }
    [[nodiscard]] bool is(kind k) const { return root_->what == k; }
    /// The two sums between which adjoint() is the adjoint; of a sum of operators those of the first one.
    [[nodiscard]] sum_weight from_weight() const { return is(kind::reweight) ? root_->from : weight(true); }
    [[nodiscard]] sum_weight to_weight() const { return is(kind::reweight) ? root_->to : weight(false); }
    [[nodiscard]] operator_formula adjoint() const { return adjoint(from_weight(), to_weight()); }
    /// The operator B with <A f, g> = <f, B g> for all f that vanish at the ends, with weights `to` in the sum on the left and `from` in
    /// that on the right.
    [[nodiscard]] operator_formula adjoint(sum_weight from, sum_weight to) const;
    /// The same operator on uniform scales, where both weights are the step.
    [[nodiscard]] operator_formula on_equal_steps() const;
    /// Whether ratios of the weights mu and nu stand in it, as in adjoints between sums of other weights: its values then depend on the
    /// lengths of both steps beside a point.
    [[nodiscard]] bool has_weights() const {
        return is(kind::reweight) or std::any_of(root_->parts.begin(), root_->parts.end(), [](auto const& a) { return a.has_weights(); });
    }
    /// What A[f] has lost where f has lost some.
    [[nodiscard]] lost_points lost(lost_points f = {}) const;

    /// A formula of numbers, as 1/3.
    static stated stated_number(std::string const& digits) {
        bool const minus = digits.starts_with('-');
        auto const size = expression::number(minus ? digits.substr(1) : digits);
        return stated(minus ? -size : size, no_words(), "the number");
    }

private:
    operator_formula(node n) {
        for (auto const& part : n.parts) n.depth = std::max(n.depth, part.root().depth + 1);
        if (n.depth > deepest)
            error::raise<error::invalid_parameter>("an operator has at most ", deepest, " levels of parts in parts, and this one has more");
        root_ = std::make_shared<node const>(std::move(n));
    }
    [[nodiscard]] sum_weight weight(bool from) const {
        switch (root_->what) {
        case kind::shift:
        case kind::derivative:
            return (root_->which == side::plus) == from ? sum_weight::nabla : sum_weight::delta;
        case kind::multiple:
        case kind::sum:
            return from ? root_->parts[0].from_weight() : root_->parts[0].to_weight();
        case kind::product:
            return from ? root_->parts[1].from_weight() : root_->parts[0].to_weight();
        default:
            return sum_weight::delta;
        }
    }
    std::shared_ptr<node const> root_;
};

inline operator_formula operator_formula::adjoint(sum_weight from, sum_weight to) const {
    node const& n = *root_;
    auto const between = [&](operator_formula const& own) { // an adjoint between the sums with the weights of n
        return reweight(from_weight(), from) * (own * reweight(to, to_weight()));
    };
    switch (n.what) {
    case kind::identity:
        return reweight(to, from);
    case kind::reweight:
        return reweight(n.from, n.to) * reweight(to, from);
    case kind::shift:
        return between(shift(opposite_of(n.which)));
    case kind::derivative:
        return between(-derivative(opposite_of(n.which)));
    case kind::multiple:
        return multiple(*n.factor, n.parts[0].adjoint(from, to));
    case kind::sum:
        return n.parts[0].adjoint(from, to) + n.parts[1].adjoint(from, to);
    case kind::product: { // the sum in the middle may have any weights
        sum_weight const middle = n.parts[0].from_weight();
        return n.parts[1].adjoint(from, middle) * n.parts[0].adjoint(middle, to);
    }
    }
    return *this;
}
inline operator_formula operator_formula::on_equal_steps() const {
    node const& n = *root_;
    switch (n.what) {
    case kind::reweight:
        return {};
    case kind::multiple:
        return multiple(*n.factor, n.parts[0].on_equal_steps());
    case kind::sum:
        return n.parts[0].on_equal_steps() + n.parts[1].on_equal_steps();
    case kind::product:
        return n.parts[0].on_equal_steps() * n.parts[1].on_equal_steps();
    default:
        return *this;
    }
}
inline lost_points operator_formula::lost(lost_points f) const {
    node const& n = *root_;
    bool const plus = n.which == side::plus;
    switch (n.what) {
    case kind::identity:
        return f;
    case kind::shift:
        return plus ? lost_points{std::max(f.front - 1, 0), f.back + 1} : lost_points{f.front + 1, std::max(f.back - 1, 0)};
    case kind::derivative:
        return {f.front + (plus ? 0 : 1), f.back + (plus ? 1 : 0)};
    case kind::reweight: // where w_to vanishes there is no ratio
        return most(f, n.to == sum_weight::nabla ? lost_points{1, 0} : lost_points{0, 1});
    case kind::multiple:
        return n.parts[0].lost(f);
    case kind::sum:
        return most(n.parts[0].lost(f), n.parts[1].lost(f));
    case kind::product:
        return n.parts[0].lost(n.parts[1].lost(f));
    }
    return f;
}

} // namespace hilger::text
