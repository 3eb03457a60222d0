// SPDX-License-Identifier: BSL-1.0
// An arbitrary discrete time scale: any strictly increasing finite set of points (Cresson-Safi, definition 6). Copies share the points.
#pragma once

#include <cmath>
#include <memory>
#include <vector>

#include "hilger/scale/interface.hpp"

namespace hilger {

/// T = {t_0 < ... < t_N} from a table of points.
template <class S>
class time_scale : public scale_interface<time_scale<S>> {
    static_assert(
        not std::is_integral_v<S>,
        "a time scale needs a scalar that can be divided, and its points were given as integers: write 0.0, or time_scale<double>");
    static_assert(
        std::is_integral_v<S> or ordered_scalar<S>,
        "a time scale needs an ordered scalar whose sums and products are scalars of its own type; numbers of Boost.Multiprecision "
        "need expression templates off, as hilger/multiprecision.hpp has them");

public:
    using scalar_type = S;
    using root_type = time_scale;
    using domain_type = hilger::domain<nodes>;
    static constexpr bool is_uniform = false;
    static constexpr auto kind() { return fixed_text("a scale of given points"); }

    /// At least two points, strictly increasing. @throws error::invalid_scale
    explicit time_scale(std::vector<S> points) {
        if (points.size() < 2)
            error::raise<error::invalid_scale>("a time scale needs at least one step, that is two points, and this one has ",
                                               points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (not is_finite(points[i]))
                error::raise<error::invalid_scale>("the points of a time scale are finite, and point ", i, " is ", points[i]);
            if (i > 0 and points[i] == points[i - 1])
                error::raise<error::invalid_scale>("the points of a time scale are distinct, and points ", i - 1, " and ", i, " are both ",
                                                   points[i]);
            if (i > 0 and points[i] < points[i - 1])
                error::raise<error::invalid_scale>("the points of a time scale increase, and point ", i, " = ", points[i], " comes after ",
                                                   points[i - 1]);
        }
        points_ = std::make_shared<std::vector<S> const>(std::move(points));
    }
    time_scale(std::initializer_list<S> points) : time_scale(std::vector<S>(points)) {}

    /// The points of any other scale, as a time scale of its own: half(T), T^+, ...
    template <time_scale_like Scale>
        requires(not std::same_as<Scale, time_scale>)
    explicit time_scale(Scale const& scale) : time_scale(std::vector<S>(scale.begin(), scale.end())) {}

    [[nodiscard]] index_type steps() const { return static_cast<index_type>(points_->size()) - 1; }
    [[nodiscard]] S const& element(index_type i) const { return (*points_)[static_cast<std::size_t>(i)]; }
    [[nodiscard]] S const& point(index_type i) const {
        this->require(i);
        return element(i);
    }
    [[nodiscard]] S step(index_type i) const { return element(i + 1) - element(i); }
    template <class Lambda>
    [[nodiscard]] S between(index_type i, Lambda const& lambda) const {
        S const l = lambda.template as<S>();
        return (S(1) - l) * element(i) + l * element(i + 1);
    }
    [[nodiscard]] time_scale const& root() const { return *this; }
    [[nodiscard]] domain_type domain() const { return {}; }
    [[nodiscard]] bool same_points(time_scale const& other) const { return points_ == other.points_ or *points_ == *other.points_; }

private:
    std::shared_ptr<std::vector<S> const> points_;
};

template <time_scale_like Scale>
time_scale(Scale const&) -> time_scale<typename Scale::root_type::scalar_type>;

/// {q^k, k = first..last}, the scale of quantum calculus. @throws error::invalid_scale when q <= 1 or last <= first.
template <ordered_scalar S>
time_scale<S> powers(S const& q, index_type first, index_type last) {
    if (not(S(1) < q)) error::raise<error::invalid_scale>("the scale q^Z needs q > 1, and this q is ", q);
    if (last <= first)
        error::raise<error::invalid_scale>("the scale q^Z needs exponents first < last, and these are ", first, " and ", last);
    std::vector<S> points;
    for (index_type k = first; k <= last; ++k) {
        S power(1);
        for (index_type j = 0; j < (k < 0 ? -k : k); ++j) power = k < 0 ? S(power / q) : S(power * q);
        points.push_back(std::move(power));
    }
    return time_scale<S>(std::move(points));
}

/// The harmonic numbers H_0 = 0, H_n = 1 + 1/2 + ... + 1/n. @throws error::invalid_scale when n < 1.
template <ordered_scalar S>
time_scale<S> harmonic_numbers(index_type n) {
    std::vector<S> points{S(0)};
    for (index_type k = 1; k <= n; ++k) points.push_back(points.back() + S(1) / S(static_cast<long long>(k)));
    return time_scale<S>(std::move(points));
}

/// t_i = a + (b - a) (i/N)^gamma, i = 0, ..., N: steps that grow from a on, for functions that begin like a broken power of t - a. a = 0
/// keeps all digits of small steps. @throws error::invalid_scale unless a < b, 1 <= gamma and N >= 1, or where steps are lost in rounding
template <ordered_scalar S>
time_scale<S> graded(S const& a, S const& b, index_type N, std::type_identity_t<S> const& gamma) {
    static_assert(not std::numeric_limits<S>::is_exact, "graded points are powers, and exact scalars have whole ones only");
    using std::pow;
    if (not(a < b) or not(S(1) <= gamma) or not is_finite(gamma) or N < 1)
        error::raise<error::invalid_scale>("graded(a, b, N, gamma) needs a < b, one step or more and gamma >= 1, and was given ", a, ", ",
                                           b, ", ", N, " and ", gamma);
    std::vector<S> points;
    for (index_type i = 0; i <= N; ++i) points.push_back(S(a + (b - a) * pow(S(S(i) / S(N)), gamma)));
    points.back() = b;
    return time_scale<S>(std::move(points));
}
/// Graded in the first unit of time, up to steps of about h, and equal afterwards. @throws as above, and unless 0 < h
template <ordered_scalar S>
time_scale<S> graded_start(S const& a, S const& b, std::type_identity_t<S> const& h, std::type_identity_t<S> const& gamma) {
    using std::ceil;
    if (not(S(0) < h) or not is_finite(h)) error::raise<error::invalid_scale>("a graded start needs steps 0 < h, and they are ", h);
    S const end = b < a + S(1) ? b : S(a + S(1));
    auto const first = graded(a, end, static_cast<index_type>(ceil(S(gamma * (end - a) / h))), gamma); // the last step is gamma/N
    std::vector<S> points(first.begin(), first.end());
    auto const rest = static_cast<index_type>(ceil(S((b - end) / h)));
    for (index_type i = 1; i <= rest; ++i) points.push_back(i == rest ? b : S(end + (b - end) * (S(i) / S(rest))));
    return time_scale<S>(std::move(points));
}

} // namespace hilger
