// SPDX-License-Identifier: BSL-1.0
// Every time scale and every discrete function is a sized C++20 random-access range; those of a uniform scale are constants.
#include <algorithm>
#include <array>
#include <ranges>

#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

template <class R>
concept sized_and_random = std::ranges::random_access_range<R> and std::ranges::sized_range<R> and std::ranges::common_range<R>;

template <class Scale>
constexpr bool a_scale_and_all_that_come_from_it(Scale const& T) {
    auto const one = [](auto const& scale) {
        using S = std::remove_cvref_t<decltype(scale)>;
        static_assert(sized_and_random<S> and time_scale_like<S> and std::regular<std::ranges::iterator_t<S>>);
        static_assert(std::same_as<std::ranges::range_value_t<S>, typename Scale::scalar_type>);
        using F = decltype(function_on(scale, [](auto const& t) { return t; }));
        static_assert(sized_and_random<F> and discrete_function<F> and not time_scale_like<F>);
    };
    one(T), one(without_last(T)), one(without_first(T)), one(interior(T)), one(half(T)), one(circ(T)), one(without_last(circ(T))),
        one(without_first(half(T)));
    one(at_lambda<1, 3>(T)), one(circ<1, 3>(T)), one(at_lambda<0, 1>(T));
    one(at_lambda(T, typename Scale::scalar_type(1) / 3)), one(circ(T, typename Scale::scalar_type(1) / 3));
    return true;
}
static_assert(a_scale_and_all_that_come_from_it(uniform(0.0, 0.1, 10)));
static_assert(a_scale_and_all_that_come_from_it(uniform(0.0f, 0.1f, 10)));
static_assert(a_scale_and_all_that_come_from_it(uniform(0.0L, 0.1L, 10)));
template bool a_scale_and_all_that_come_from_it(time_scale<double> const&);

// A uniform scale can be walked by the compiler.
constexpr auto T = uniform(1.0, 0.25, 4);
static_assert(T.size() == 5 and without_last(T).size() == 4 and interior(T).size() == 3 and half(T).size() == 4 and circ(T).size() == 9);
static_assert(interior(half(T)).size() == 2 and without_last(without_last(T)).size() == 3 and without_first(circ(T)).size() == 8);
static_assert(std::ranges::equal(T, std::array{1.0, 1.25, 1.5, 1.75, 2.0}));
static_assert(std::ranges::equal(half(T), std::array{1.125, 1.375, 1.625, 1.875}));
static_assert(std::ranges::equal(circ(T), std::array{1.0, 1.125, 1.25, 1.375, 1.5, 1.625, 1.75, 1.875, 2.0}));
static_assert(std::ranges::equal(at_lambda<1, 4>(uniform(0.0, 1.0, 2)), std::array{0.25, 1.25}));
static_assert(std::ranges::equal(circ<1, 4>(uniform(0.0, 1.0, 2)), std::array{0.0, 0.25, 1.0, 1.25, 2.0}));
constexpr auto T_o = circ(T);
static_assert(*std::ranges::lower_bound(T_o, 1.4) == 1.5);
static_assert(T.sigma(1.25) == 1.5 and T.rho(1.25) == 1.0 and T.mu(1.0) == 0.25 and T.nu(2.0) == 0.25);
static_assert(half(T).sigma(1.125) == 1.375 and circ(T).sigma(1.0) == 1.125 and circ(T).mu(1.0) == 0.125);
static_assert(T.contains(1.75) and not T.contains(1.8) and not T.contains(2.25) and not without_last(T).contains(2.0));
static_assert(T == uniform(1.0, 0.25, 4) and T == uniform(interval{1.0, 2.0}, 4) and not(T == uniform(1.0, 0.25, 5)));
static_assert(without_last(T) == uniform(1.0, 0.25, 3) and without_first(T) == uniform(1.25, 0.25, 3) and
              half(T) == uniform(1.125, 0.25, 3));
static_assert(circ(T) == uniform(1.0, 0.125, 8) and not(circ(T) == T));

// Fractions in lowest terms: there is one T_half.
static_assert(std::same_as<decltype(at_lambda<2, 4>(T)), decltype(half(T))>);
static_assert(std::same_as<decltype(circ<3, 6>(T)), decltype(circ(T))>);
static_assert(std::same_as<decltype(at_lambda<0, 5>(T)), decltype(at_lambda<0, 1>(T))>);

} // namespace
