// SPDX-License-Identifier: BSL-1.0
// The powers of the difference on every T: compositions that are not added up in the type, compared on steps that are all different.
#include "hilger/calculus.hpp"

using namespace hilger;

namespace {

template <auto A, auto B>
constexpr composition<std::remove_const_t<decltype(A)>, std::remove_const_t<decltype(B)>> after{A, B};

static_assert(not Delta_minus_alpha<1, 2>.needs_uniform and minus_alpha<bdf<2>, 1, 2>.needs_uniform);

// The semigroup of each of the four operators: two sides, with the graininess nu or mu.
template <auto Quarter, auto Half, auto Third, auto Whole>
constexpr bool is_semigroup = after<Half, Half> == Whole and after<Quarter, Quarter> == Half and after<Third, after<Third, Third>> ==
                                  Whole and after<Half, Whole> == Half* Whole and after<Third, Half> == after<Half, Third> and
                              not(after<Quarter, Half> == Whole);
static_assert(is_semigroup<Delta_minus_alpha<1, 4>, Delta_minus_alpha<1, 2>, Delta_minus_alpha<1, 3>, Delta_minus_alpha<1, 1>>);
static_assert(is_semigroup<Delta_plus_alpha<1, 4>, Delta_plus_alpha<1, 2>, Delta_plus_alpha<1, 3>, Delta_plus_alpha<1, 1>>);
static_assert(
    is_semigroup<minus_Delta_plus_alpha<1, 4>, minus_Delta_plus_alpha<1, 2>, minus_Delta_plus_alpha<1, 3>, minus_Delta_plus_alpha<1, 1>>);
static_assert(is_semigroup<adjoint(minus_Delta_plus_alpha<1, 4>), adjoint(minus_Delta_plus_alpha<1, 2>),
                           adjoint(minus_Delta_plus_alpha<1, 3>), adjoint(minus_Delta_plus_alpha<1, 1>)>);
static_assert(after<Delta_minus_alpha<3, 4>, Delta_minus_alpha<3, 4>> == Delta_minus_alpha<1, 2> * Delta_minus_alpha<1, 1>);
static_assert(after<Delta_minus_alpha<1, 3>, Delta_minus_alpha<1, 4>> == Delta_minus_alpha<7, 12>);

// Any order, in both directions.
static_assert(after<Delta_minus_alpha<1, 2>, Delta_minus_alpha<-1, 2>> == identity_T);
static_assert(after<Delta_plus_alpha<-5, 3>, Delta_plus_alpha<2, 3>> == Delta_plus_alpha<-1, 1>);
static_assert(after<minus_Delta_plus_alpha<5, 2>, minus_Delta_plus_alpha<1, 2>> == minus_Delta_plus_alpha<3, 1>);
static_assert(Delta_minus * Delta_minus_alpha<-1, 1> == Delta_minus * antiderivative_nabla);

// The adjoint has the same graininess and the other side. On equal steps the four operators are two.
static_assert(adjoint(Delta_minus_alpha<2, 3>) == Delta_plus_alpha<2, 3> and adjoint(Delta_plus_alpha<2, 3>) == Delta_minus_alpha<2, 3>);
static_assert(adjoint(adjoint(minus_Delta_plus_alpha<2, 3>)) == minus_Delta_plus_alpha<2, 3>);
static_assert(not(minus_Delta_plus_alpha<1, 2> == Delta_plus_alpha<1, 2>));
static_assert(not(adjoint(minus_Delta_plus_alpha<1, 2>) == Delta_minus_alpha<1, 2>));
static_assert(uniformly(minus_Delta_plus_alpha<1, 2>) == Delta_plus_alpha<1, 2>);
static_assert(uniformly(adjoint(minus_Delta_plus_alpha<1, 2>)) == Delta_minus_alpha<1, 2>);
// One operator with needs_uniform compares on equal steps.
static_assert(minus_alpha<bdf<1>, 1, 2> == Delta_minus_alpha<1, 2>);

} // namespace
