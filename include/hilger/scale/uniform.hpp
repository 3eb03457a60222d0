// SPDX-License-Identifier: BSL-1.0
// T = {a + ih, i = 0..N} (Cresson-Safi, definition 1). It stores three numbers and a count: points are computed as a + ih, not by adding h
// repeatedly, and the last one is b exactly.
#pragma once

#include "hilger/scale/interface.hpp"
#include "hilger/whole_number.hpp"

namespace hilger {

/// The interval [a, b], to be divided into equal steps.
template <class S>
struct interval {
    S a, b;
};
template <class A, class B>
interval(A, B) -> interval<std::conditional_t<std::is_integral_v<A> and not std::is_integral_v<B>, B, A>>;
template <std::floating_point A, std::floating_point B>
interval(A, B) -> interval<std::common_type_t<A, B>>;

/// T = {a + ih} from a, h, the last point b and the number of steps; see uniform(). @throws error::invalid_scale
template <ordered_scalar S>
class uniform_scale : public scale_interface<uniform_scale<S>> {
public:
    using scalar_type = S;
    using root_type = uniform_scale;
    using domain_type = hilger::domain<nodes>;
    static constexpr bool is_uniform = true;
    static constexpr auto kind() { return fixed_text("a uniform scale"); }

    constexpr uniform_scale(S a, S h, S b, index_type steps) : a_(std::move(a)), h_(std::move(h)), b_(std::move(b)), steps_(steps) {
        if (steps_ < 1) error::raise<error::invalid_scale>("a time scale needs at least one step, and this one was given ", steps_);
        if (not is_finite(a_) or not is_finite(h_) or not is_finite(b_))
            error::raise<error::invalid_scale>("the points of a time scale are finite, and these start at ", a_, " with step ", h_);
        if (not(S(0) < h_)) error::raise<error::invalid_scale>("the step h of a time scale is positive, and this one is ", h_);
        // Below four units in the last place neighbouring points a + ih, or T and T_half, may round to the same number; next to zero those
        // units are all alike.
        if (h_ < S(4) * std::max(S(epsilon<S>() * std::max(magnitude(a_), magnitude(b_))), smallest()))
            error::raise<error::invalid_scale>("the step h = ", h_, " is lost in rounding beside the points ", a_, " and ", b_);
    }

    [[nodiscard]] constexpr index_type steps() const { return steps_; }
    [[nodiscard]] constexpr S const& h() const { return h_; }
    [[nodiscard]] constexpr S point(index_type i) const {
        this->require(i);
        return element(i);
    }
    [[nodiscard]] constexpr S element(index_type i) const { return i == steps_ ? b_ : S(a_ + number(i) * h_); }
    [[nodiscard]] constexpr S const& step(index_type) const { return h_; }
    /// (1 - lambda) t_i + lambda t_{i+1}
    template <class Lambda>
    [[nodiscard]] constexpr S between(index_type i, Lambda const& lambda) const {
        return a_ + (number(i) + lambda.template as<S>()) * h_;
    }
    [[nodiscard]] constexpr uniform_scale const& root() const { return *this; }
    [[nodiscard]] constexpr domain_type domain() const { return {}; }
    [[nodiscard]] constexpr bool same_points(uniform_scale const& other) const {
        return a_ == other.a_ and h_ == other.h_ and b_ == other.b_ and steps_ == other.steps_;
    }

private:
    static constexpr S smallest() {
        if constexpr (std::numeric_limits<S>::is_specialized and not std::numeric_limits<S>::is_exact)
            return (std::numeric_limits<S>::min)();
        else
            return S(0);
    }
    static constexpr S number(index_type i) { return S(static_cast<long long>(i)); }
    S a_, h_, b_;
    index_type steps_;
};

namespace detail {

/// The common scalar of two numbers: the scalar beside a whole number, the wider of two floats.
template <class A, class B>
consteval auto common_scalar() {
    if constexpr (std::same_as<A, B> and ordered_scalar<A>)
        return std::type_identity<A>{};
    else if constexpr (std::integral<A> and ordered_scalar<B>)
        return std::type_identity<B>{};
    else if constexpr (std::integral<B> and ordered_scalar<A>)
        return std::type_identity<A>{};
    else if constexpr (std::floating_point<A> and std::floating_point<B>)
        return std::type_identity<std::common_type_t<A, B>>{};
    else if constexpr (ordered_scalar<A> and std::convertible_to<B, A>)
        return std::type_identity<A>{};
    else if constexpr (ordered_scalar<B> and std::convertible_to<A, B>)
        return std::type_identity<B>{};
    else
        return std::type_identity<void>{};
}
template <class A, class B>
using common_scalar_t = typename decltype(common_scalar<A, B>())::type;

/// A number of steps given as a floating number, as 1e6. @throws error::invalid_scale where it is not whole
template <std::floating_point N>
constexpr index_type whole_steps(N steps) {
    auto const count = whole(steps);
    if (not count)
        error::raise<error::invalid_scale>("the number of steps of a time scale is a whole number, and ", steps,
                                           " is none: std::lround(b / h) is, or uniform(interval{a, b}, N)");
    return *count;
}
/// Why two numbers make no scale, in one sentence.
template <class A, class H>
constexpr auto no_common_scalar() {
    if constexpr (std::integral<A> and std::integral<H>)
        return does_not_compile<"a time scale needs a scalar that can be divided, and its numbers were given as integers: write 0.0", A>{};
    else if constexpr (ordered_scalar<A> and ordered_scalar<H>)
        return does_not_compile<"the start and the step of a time scale are numbers of one scalar, and these are of two that do not mix",
                                A>{};
    else
        return does_not_compile<"a time scale needs an ordered scalar whose sums and products are scalars of its own type; numbers of "
                                "Boost.Multiprecision need expression templates off, as hilger/multiprecision.hpp has them",
                                A>{};
}

} // namespace detail

/// Refused: two numbers leave the end of T, or the length of its steps, open.
template <class A>
constexpr auto uniform(A const&, index_type) {
    static_assert(
        not std::same_as<A, A>,
        "a uniform T has a start, the length of a step and the number of steps, uniform(a, h, N), or it is uniform(interval{a, b}, N)");
    return uniform_scale<double>(0, 1, 1, 1); // so that no other error follows
}
/// T = {a + ih, i = 0..N}: the start, the length of a step and the number of steps, uniform(0.0, 0.1, 1000), in the common scalar of a and
/// h: uniform(0, 0.1, 10) is of doubles. The second number is not the end: [a, b] in N steps is uniform(interval{a, b}, N).
/// @throws error::invalid_scale when h <= 0, N < 1, or a point is not finite; error::invalid_parameter for a whole number without an equal
/// in that scalar.
template <class A, class H>
constexpr auto uniform(A const& a, H const& h, index_type steps) {
    using S = detail::common_scalar_t<A, H>;
    if constexpr (std::is_void_v<S>)
        return detail::no_common_scalar<A, H>();
    else {
        S start = detail::exactly<S>(a), step = detail::exactly<S>(h);
        S b = start + S(static_cast<long long>(steps)) * step;
        return uniform_scale<S>(std::move(start), std::move(step), std::move(b), steps);
    }
}

template <class A, class H, std::floating_point N>
constexpr auto uniform(A const& a, H const& h, N steps) {
    return uniform(a, h, detail::whole_steps(steps));
}

/// [a, b] in N equal steps; t_N is b exactly. @throws error::invalid_scale when b <= a or N < 1.
template <class S>
constexpr auto uniform(interval<S> ab, index_type steps) {
    if constexpr (not ordered_scalar<S>)
        return detail::no_common_scalar<S, S>();
    else {
        if (ab.b <= ab.a)
            error::raise<error::invalid_scale>("an interval ends after it begins, and this one goes from ", ab.a, " to ", ab.b);
        S h = steps < 1 ? S(1) : S((ab.b - ab.a) / S(static_cast<long long>(steps)));
        return uniform_scale<S>(std::move(ab.a), std::move(h), std::move(ab.b), steps);
    }
}

template <class S, std::floating_point N>
constexpr auto uniform(interval<S> ab, N steps) {
    return uniform(std::move(ab), detail::whole_steps(steps));
}

} // namespace hilger
