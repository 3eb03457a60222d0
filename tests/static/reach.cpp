// SPDX-License-Identifier: BSL-1.0
// The reach of every operator is a fact of its type, and it is the true one: exactly the points that change the value.
#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

using detail::generic_scale;

/// 1 at one point, 0 elsewhere, on a scale of generic steps.
template <bool Uniform, class Base>
struct unit : discrete_function_tag {
    using root_type = generic_scale<Uniform, 10>;
    using domain_type = hilger::domain<Base>;
    hilger::index_type at = 0;
    Base base{};
    static constexpr root_type root() { return {}; }
    constexpr domain_type domain() const { return {base}; }
    constexpr prime_field get(hilger::index_type i) const { return i == at ? 1 : 0; }
};
/// Twice the place of point i, t_0 = 0.
template <class Base>
constexpr int place(hilger::index_type i) {
    if constexpr (std::same_as<Base, nodes>)
        return static_cast<int>(2 * i);
    else if constexpr (requires(Base b) { [](joined<std::remove_cvref_t<decltype(b.lambda)>>) {}(b); })
        return static_cast<int>(i);
    else
        return static_cast<int>(2 * i + 1);
}
/// What an operator reads at the middle of ten steps, found by trying every point.
template <class A>
constexpr reach found(A const& a) {
    constexpr bool uniform = A::needs_uniform;
    constexpr int last_point = static_cast<int>(A::from::last(10)), middle = 10;
    auto const at = [&](bool between) {
        reach::span s{};
        int const p = between ? middle + 1 : middle;
        for (int i = 0; i <= A::to::last(10); ++i)
            if (place<typename A::to>(i) == p)
                for (int j = 0; j <= last_point; ++j)
                    if (not(a.evaluate(unit<uniform, typename A::from>{{}, j}, i) == prime_field(0))) {
                        int const d = place<typename A::from>(j) - p;
                        s = s.is_empty() ? reach::span{d, d} : reach::span{std::min(s.first, d), std::max(s.last, d)};
                    }
        if (not s.is_empty() and s.first + p <= place<typename A::from>(0) + 2) s.first = reach::causal().on_T.first;
        if (not s.is_empty() and s.last + p >= place<typename A::from>(last_point) - 1) s.last = reach::anticausal().on_T.last;
        return s;
    };
    return reach{at(false), at(true)};
}
template <class... As>
constexpr bool reaches_are_true(As const&... a) {
    return ((As::reads == found(a)) and ...);
}
template <class... As>
constexpr bool adjoints_mirror(As const&... a) {
    return ((decltype(adjoint(a))::reads == reach::mirrored<typename As::from, typename As::to>(As::reads)) and ...);
}

static_assert(identity_T.reads == reach::local(0, 0).at<nodes>() and Delta_plus.reads == reach::local(0, 1).at<nodes>());
static_assert(sigma.reads == reach::local(-1, 1).at<nodes>() and rho.reads == reach::local(1, -1).at<nodes>());
static_assert((sigma * rho).reads == identity_T.reads and (Delta_plus * Delta_plus).reads == reach::local(0, 2).at<nodes>());
static_assert((Delta_minus + Delta_plus).reads == reach::local(1, 1).at<nodes>() and (-Delta_plus).reads == Delta_plus.reads);
static_assert((on_half * extend).reads == reach::local(0.5, 0.5).at<between<fraction<1, 2>>>());
static_assert((on_half * Delta_o_plus * extend).reads == (pi_inverse * Delta_plus).reads);
static_assert((on_T * extend).reads == identity_T.reads);

static_assert(reaches_are_true(identity_T, identity_h, identity_o, sigma, rho, sigma_h, rho_h, sigma_o, rho_o));
static_assert(reaches_are_true(Delta_plus, Delta_minus, Delta_h_plus, Delta_h_minus, Delta_o_plus, Delta_o_minus));
static_assert(reaches_are_true(mean_h_minus, mean_h_plus, mean_o, extend, on_T, on_half, pi_half, pi_inverse, step_mean));
static_assert(reaches_are_true(insertion<fraction<1, 2>, true>{}, insertion<fraction<1, 2>, false>{}, extend_lambda<1, 3>, on_lambda<1, 3>,
                               projection<fraction<1, 3>, false>{}, pi_lambda_inverse<1, 3>,
                               derivative<between<fraction<1, 3>>, side::plus>{}));
static_assert(reaches_are_true(on_half * extend, on_T* extend, on_half* Delta_o_plus* extend, on_T* Delta_o_minus* extend,
                               Delta_plus* Delta_plus, Delta_minus* rho, mean_o* extend, pi_half* mean_h_minus* on_half* extend));
static_assert(reaches_are_true(antiderivative_h, antiderivative, antiderivative_nabla, tail_integral_at<fraction<1, 2>>{}, minus_start));
static_assert(reaches_are_true(Delta_minus_alpha<1, 2>, Delta_plus_alpha<1, 3>, minus_alpha<trapezoid, 1, 1>, Delta_minus_alpha<1, 2>* rho,
                               sigma* Delta_minus_alpha<1, 2>, Delta_plus_alpha<1, 2>* Delta_minus));
// Orders that add up to a whole one are local again, and what is neither causal nor anticausal is global.
static_assert(reaches_are_true(Delta_minus_alpha<1, 2> * Delta_minus_alpha<1, 2>, minus_alpha<bdf<2>, 1, 1>,
                               adjoint(minus_alpha<bdf<3>, 1, 1>)));
static_assert((Delta_minus_alpha<1, 2> * Delta_minus_alpha<1, 2>).reads == Delta_minus.reads);
static_assert((Delta_minus_alpha<1, 2> * Delta_plus_alpha<1, 2>).reads == reach::everywhere().at<nodes>());
static_assert(Delta_minus(0.75).reads == reach::causal().at<nodes>() and Delta_plus(0.75).reads == reach::anticausal().at<nodes>());
static_assert(not Delta_minus(0.75).reads.is_local() and not Delta_plus(0.75).reads.is_local());
static_assert((sigma * Delta_minus_alpha<1, 2>).reads == reach::causal(1).at<nodes>()); // causal after local: a step ahead

static_assert(adjoints_mirror(identity_T, sigma, rho_h, sigma_o, Delta_plus, Delta_h_minus, Delta_o_plus, extend, on_T, on_half));
static_assert(adjoints_mirror(pi_half, pi_inverse, step_mean, antiderivative_h, tail_integral_at<fraction<1, 2>>{},
                              Delta_minus_alpha<1, 2>));
static_assert(adjoints_mirror(on_half * extend, pi_inverse* Delta_plus, Delta_minus* Delta_plus, sigma* Delta_minus_alpha<1, 2>,
                              -Delta_plus, Delta_plus + sigma));

// Weights of two sums differ by the lengths of the steps at both sides.
static_assert(reweight<nodes, nabla_weight, delta_weight>::reads.steps() == 2 and Delta_plus.reads.steps() == 1 and
              identity_T.reads.steps() == 0);
/// An operator that does not say what it reads counts as one that reads everything.
struct silent : linear_operator<silent> {};
static_assert(silent::reads == reach::everywhere());

} // namespace
