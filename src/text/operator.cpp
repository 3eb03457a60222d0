// SPDX-License-Identifier: BSL-1.0
// Operators are equal, as in adjoint/normal_form.hpp at compile time, when they map a generic function on a generic scale to the same
// values: in rationals, or in 50 digits when a factor is irrational, as sqrt(2).
#include "hilger/text/operator.hpp"

#include <limits>

#include "hilger/adjoint/normal_form.hpp"
#include "hilger/error.hpp"
#include "text/operator_in_numbers.hpp"

namespace hilger::text {

operator_formula::operator_formula(node n) {
    for (auto const& part : n.parts) n.depth = std::max(n.depth, part.root().depth + 1);
    if (n.depth > deepest)
        error::raise<error::invalid_parameter>("an operator has at most ", deepest, " levels of parts in parts, and this one has more");
    root_ = std::make_shared<node const>(std::move(n));
}
operator_formula operator_formula::multiple(stated const& c, operator_formula const& a) {
    if (c.reads_state())
        error::raise<error::unreadable>(c.source(), ": the factor of an operator is a number, and this one depends on the state");
    node n{kind::multiple};
    n.factor = std::make_shared<stated const>(c);
    n.parts = {a};
    return n;
}
operator_formula operator+(operator_formula const& a, operator_formula const& b) {
    operator_formula::node n{operator_formula::kind::sum};
    n.parts = {a, b};
    return n;
}
operator_formula operator*(operator_formula const& a, operator_formula const& b) {
    if (a.is(operator_formula::kind::identity)) return b;
    if (b.is(operator_formula::kind::identity)) return a;
    if (a.is(operator_formula::kind::reweight) and b.is(operator_formula::kind::reweight) and a.root().from == b.root().to) return {};
    operator_formula::node n{operator_formula::kind::product};
    n.parts = {a, b};
    return n;
}
bool operator_formula::has_weights() const {
    return is(kind::reweight) or std::any_of(root_->parts.begin(), root_->parts.end(), [](auto const& a) { return a.has_weights(); });
}
stated operator_formula::stated_number(std::string const& digits) {
    bool const minus = digits.starts_with('-');
    auto const size = expression::number(minus ? digits.substr(1) : digits);
    return stated(minus ? -size : size, no_words(), "the number");
}
sum_weight operator_formula::weight(bool from) const {
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

operator_formula operator_formula::adjoint(sum_weight from, sum_weight to) const {
    node const& n = *root_;
    auto const between = [&](operator_formula const& own) { // an adjoint with respect to sums with the weights of n
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
    case kind::product: { // the intermediate sum may have any weights
        sum_weight const middle = n.parts[0].from_weight();
        return n.parts[1].adjoint(from, middle) * n.parts[0].adjoint(middle, to);
    }
    }
    return *this;
}
operator_formula operator_formula::on_equal_steps() const {
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
lost_points operator_formula::lost(lost_points f) const {
    node const& n = *root_;
    bool const plus = n.which == side::plus;
    switch (n.what) {
    case kind::identity:
        return f;
    case kind::shift:
        return plus ? lost_points{std::max(f.front - 1, 0), f.back + 1} : lost_points{f.front + 1, std::max(f.back - 1, 0)};
    case kind::derivative:
        return {f.front + (plus ? 0 : 1), f.back + (plus ? 1 : 0)};
    case kind::reweight: // there is no ratio where w_to vanishes
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

namespace {

/// The row on a scale with random or with equal steps. In floating scalars the steps have size 1: quotients by long steps would be lost in
/// rounding.
template <class S>
std::vector<S> row_of(operator_formula const& a, bool uniform, lost_points reach, bool sizes = false) {
    auto const step = [&](index_type i) {
        S const some(static_cast<long long>(hilger::detail::random_element(uniform ? 7 : static_cast<std::uint64_t>(i) + 100).value()));
        return std::numeric_limits<S>::is_exact ? some : S(some / S(1LL << 60));
    };
    return detail::row_on<S>(step, a, reach, sizes);
}
bool equal_rows(operator_formula const& a, operator_formula const& b, bool uniform, lost_points reach) {
    auto const x = row_of<float50>(a, uniform, reach), y = row_of<float50>(b, uniform, reach);
    auto const of_x = row_of<float50>(a, uniform, reach, true), of_y = row_of<float50>(b, uniform, reach, true);
    for (std::size_t k = 0; k < x.size(); ++k)
        if (abs(float50(x[k] - y[k])) > (of_x[k] + of_y[k]) * float50("1e-40")) return false;
    return true;
}

} // namespace

std::optional<std::vector<Q>> detail::exact_row_of(operator_formula const& a, bool uniform, lost_points reach) {
    try {
        return row_of<Q>(a, uniform, reach);
    } catch (error::unreadable const&) {
        return {};
    }
}
bool equal(operator_formula const& a, operator_formula const& b, bool uniform) {
    if (not(a.lost() == b.lost())) return false;
    auto const reach = a.lost();
    auto const x = detail::exact_row_of(a, uniform, reach), y = detail::exact_row_of(b, uniform, reach);
    return x and y ? *x == *y : equal_rows(a, b, uniform, reach);
}

} // namespace hilger::text
