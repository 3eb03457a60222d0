// SPDX-License-Identifier: BSL-1.0
// Linear operators on functions on T that are known at run time only: identity, sigma, rho, Delta_plus, Delta_minus, multiples, sums and
// compositions of them. Algebra and adjoints are those of operator/compose.hpp: between the nabla and the Delta sum
//   adjoint(sigma) = rho,  adjoint(Delta_plus) = -Delta_minus,
// and other sums multiply by the ratio of their weights. A == B compares what both make of one generic function on one generic scale
// (adjoint/normal_form.hpp).
#pragma once

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hilger/function_view.hpp"
#include "hilger/operator/local.hpp"
#include "hilger/printing/expression.hpp"
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

/// An operator: the root of a tree of operators that never changes.
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
    /// c A. @throws error::unreadable if c is no formula of numbers alone
    static operator_formula multiple(stated const& c, operator_formula const& a);
    friend operator_formula operator+(operator_formula const& a, operator_formula const& b);
    /// A B: first B, then A.
    friend operator_formula operator*(operator_formula const& a, operator_formula const& b);
    friend operator_formula operator-(operator_formula const& a) { return multiple(stated_number("-1"), a); }
    friend operator_formula operator-(operator_formula const& a, operator_formula const& b) { return a + -b; }

    [[nodiscard]] node const& root() const { return *root_; }
    [[nodiscard]] bool is(kind k) const { return root_->what == k; }
    /// The two sums of adjoint(); for a sum of operators those of the first one.
    [[nodiscard]] sum_weight from_weight() const { return is(kind::reweight) ? root_->from : weight(true); }
    [[nodiscard]] sum_weight to_weight() const { return is(kind::reweight) ? root_->to : weight(false); }
    [[nodiscard]] operator_formula adjoint() const { return adjoint(from_weight(), to_weight()); }
    /// The operator B with <A f, g> = <f, B g> for all f that vanish at the ends, with weights `to` in the sum on the left and `from` in
    /// that on the right.
    [[nodiscard]] operator_formula adjoint(sum_weight from, sum_weight to) const;
    /// The same operator on uniform scales, where both weights are the step.
    [[nodiscard]] operator_formula on_equal_steps() const;
    /// Whether it contains ratios of the weights mu and nu, as adjoints between sums of other weights do: its values then depend on the
    /// lengths of both steps beside a point.
    [[nodiscard]] bool has_weights() const;
    /// The points lost by A[f], for an f that has lost some.
    [[nodiscard]] lost_points lost(lost_points f = {}) const;

    /// A formula of numbers, as 1/3.
    static stated stated_number(std::string const& digits);

private:
    operator_formula(node n);
    [[nodiscard]] sum_weight weight(bool from) const;
    std::shared_ptr<node const> root_;
};

/// How L is evaluated on T: L(A q, B q) under a sum (embedding/embedding.hpp).
struct embedding_formula {
    operator_formula position, velocity;
    sum_weight weight = sum_weight::delta;
    std::string text; ///< as it was written
    /// The larger losses of the two, at each end.
    [[nodiscard]] lost_points lost() const { return most(position.lost(), velocity.lost()); }
};

/// The operator in a text, "(identity + sigma)/2", written as in C++ (operator/local.hpp); products of operators are compositions.
/// Parameters in its factors are those of `words`. @throws error::unreadable with line and column
operator_formula operator_in(std::string_view text, std::shared_ptr<vocabulary const> words = no_words(),
                             std::string const& source = "the operator");
/// The embedding in a text: the arguments of L, applied to the unknown q, or ((1 + sigma)/2)[q]; `source` and `from` place it in errors:
///   integral(L((q + sigma[q])/2, Delta_plus[q]))
///   nabla_integral(L(q, Delta_minus[q]))           the sum with weights nu
/// @throws error::unreadable
embedding_formula embedding_in(std::string_view text, std::shared_ptr<vocabulary const> words = no_words(),
                               std::string const& source = "the embedding", place from = {1, 1});

/// Whether A and B make the same of every function on every scale, or on every uniform one, and lose the same points at the ends.
bool equal(operator_formula const& a, operator_formula const& b, bool uniform = false);
inline bool operator==(operator_formula const& a, operator_formula const& b) { return equal(a, b); }

/// The operator applied to a function f, for a terminal or in LaTeX; `uniform`: on a scale of equal steps.
std::string written(operator_formula const& a, print_style style, bool uniform = false);
/// The text that operator_in reads the same operator from, applied to the name `on`, or as an operator if that is "".
/// @throws error::invalid_parameter if it is too long
std::string text_of(operator_formula const& a, std::string const& on = "q");
/// The same, if it has at most `longest` characters.
std::optional<std::string> written(operator_formula const& a, std::string const& on, std::size_t longest);

namespace detail {
/// The lengths of the steps of a scale, and how many there are.
template <class S>
struct steps_view {
    hilger::detail::function_view<S(index_type)> step;
    index_type count;
    [[nodiscard]] index_type steps() const { return count; }
};
} // namespace detail

/// An operator with its factors in numbers S, to be applied: double, float, long double, float50, float100 or Q.
template <class S>
class operator_in_numbers {
    using kind = operator_formula::kind;

public:
    /// @throws error::unreadable if a factor is no number of type S, as a root in rationals; error::not_finite if it is NaN or infinite
    explicit operator_in_numbers(operator_formula const& a);

    /// A[f] at point i of T, of a function with values get(i) on the scale root().
    template <class F>
    [[nodiscard]] auto value(F const& f, index_type i) const {
        using V = plain_t<decltype(f.get(0))>;
        auto const step = [&T = f.root()](index_type j) { return S(T.step(j)); };
        return part_value<V>(
            items_.size() - 1, [&f](index_type j) { return V(f.get(j)); }, {step, f.root().steps()}, i);
    }
    /// Numbers by points.
    using row_type = std::map<index_type, S>;
    /// The numbers c_j of A[f](t_i) = sum_j c_j f(t_j) on the scale T; with `sizes` the sums of the absolute values of their terms, which
    /// bound their rounding. Linear in the number of parts, while a value of a product evaluates its parts again and again.
    template <class T>
    [[nodiscard]] row_type row(T const& scale, index_type i, bool sizes = false) const {
        auto const step = [&scale](index_type j) { return S(scale.step(j)); };
        return before(items_.size() - 1, {step, scale.steps()}, {{i, S(1)}}, sizes);
    }

private:
    struct item {
        kind what;
        side which;
        sum_weight from, to;
        S factor;
        std::size_t first, second;
    };
    std::size_t add(operator_formula const& a);
    /// The part, applied to the function f of a point.
    template <class V>
    [[nodiscard]] V part_value(std::size_t k, hilger::detail::function_view<V(index_type)> f, detail::steps_view<S> const& T,
                               index_type i) const {
        item const& n = items_[k];
        switch (n.what) {
        case kind::shift:
            return f(n.which == side::plus ? i + 1 : i - 1);
        case kind::derivative: {
            index_type const left = n.which == side::plus ? i : i - 1;
            return V((f(left + 1) - f(left)) / T.step(left));
        }
        case kind::reweight:
            return V(f(i) * ratio_of_weights(n, T, i));
        case kind::multiple:
            return V(part_value(n.first, f, T, i) * n.factor);
        case kind::sum:
            return V(part_value(n.first, f, T, i) + part_value(n.second, f, T, i));
        case kind::product:
            return part_value<V>(
                n.first, [&](index_type j) { return part_value(n.second, f, T, j); }, T, i);
        default:
            return f(i);
        }
    }
    /// The row of `after` behind the part.
    [[nodiscard]] row_type before(std::size_t k, detail::steps_view<S> const& T, row_type after, bool sizes) const;
    static S ratio_of_weights(item const& n, detail::steps_view<S> const& T, index_type i);
    std::vector<item> items_;
};

} // namespace hilger::text
