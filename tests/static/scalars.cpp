// SPDX-License-Identifier: BSL-1.0
// What is a scalar and what is not. Boost's numbers with expression templates on are refused: an auto variable or a lambda that holds one
// of their results refers to temporaries.
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_dec_float.hpp>
#include <complex>
#include <string>

#include "hilger/adjoint/prime_field.hpp"
#include "hilger/calculus.hpp"
#include "hilger/multiprecision.hpp"

using namespace hilger;

namespace {

static_assert(ordered_scalar<float> and ordered_scalar<double> and ordered_scalar<long double>);
static_assert(ordered_scalar<Q> and ordered_scalar<float50> and ordered_scalar<float100>);
static_assert(scalar<prime_field> and not ordered_scalar<prime_field>);

// expression templates
static_assert(not scalar<boost::multiprecision::cpp_rational> and not scalar<boost::multiprecision::cpp_dec_float_50>);
static_assert(not scalar<mp::number<mp::cpp_bin_float<50>, mp::et_on>>);
static_assert(scalar<boost::multiprecision::number<boost::multiprecision::cpp_dec_float<50>, boost::multiprecision::et_off>>);

// The integers are not closed under division: half(T) of an integer scale would be T itself.
static_assert(not scalar<int> and not scalar<long long> and not scalar<unsigned> and not scalar<bool> and not scalar<char> and
              not scalar<short>);
static_assert(not scalar<mp::number<mp::cpp_int_backend<>, mp::et_off>>);
// Complex numbers may be values and not points, for they have no order. A text, a pointer and a reference are no numbers.
static_assert(scalar<std::complex<double>> and not ordered_scalar<std::complex<double>> and not scalar<std::string> and
              not scalar<double*> and not scalar<double const>);
static_assert(not scalar<double&>);

// The distance from 1 to the next number, 0 where there is none.
static_assert(epsilon<double>() == std::numeric_limits<double>::epsilon() and epsilon<float>() == std::numeric_limits<float>::epsilon());
static_assert(epsilon<prime_field>() == prime_field(0));

// Constants in the type are exact in every scalar.
static_assert(fraction<1, 4>::as<double>() == 0.25 and fraction<-3>::as<float>() == -3.0f and fraction<3, 1>::as<double>() == 3.0);
static_assert(fraction<1, 3>::as<prime_field>() * prime_field(3) == prime_field(1) and fraction<-2, 7>::as<double>() == -2.0 / 7.0);
static_assert(std::same_as<reduced<6, 4>, fraction<3, 2>> and std::same_as<reduced<-6, 4>, fraction<-3, 2>> and
              std::same_as<reduced<0, 9>, fraction<0>>);
static_assert(run_time<double>{0.3}.as<double>() == 0.3 and run_time<double>{0.3} != run_time<double>{0.4});

// Integers as values of functions become scalars; vectors and other scalars stay what they are.
static_assert(std::same_as<value_on<int, double>, double> and std::same_as<value_on<bool const&, float>, float>);
static_assert(std::same_as<value_on<float, double>, float> and std::same_as<value_on<std::complex<double>, double>, std::complex<double>>);
constexpr auto T = uniform(0.0, 0.1, 10);
static_assert(std::same_as<value_of<std::remove_const_t<decltype(function_on(T, [](double) { return 1; }))>>, double>);
static_assert(std::same_as<value_of<decltype(function_on(T, std::vector<int>(11)))>, double>);
static_assert(
    std::same_as<value_of<decltype(apply_pointwise([](double x) { return x > 0; }, function_on(T, std::vector<float>(11))))>, double>);

// finite, absolute value, product, zero
static_assert(is_finite(1.0) and is_finite(std::numeric_limits<double>::max()) and is_finite(prime_field(3)));
static_assert(magnitude(-2.0) == 2.0 and magnitude(2.0f) == 2.0f and dot_product(2.0, 3.0) == 6.0 and zero_like(7.0) == 0.0);

} // namespace
