// SPDX-License-Identifier: BSL-1.0
// Types accepted as a state, and their conversion without loss of a digit. A state over times S is a number S or a column of S, made of
//   a number that has an equal in S     int and float for double, double for rationals and wide floats
//   an Eigen vector of such, or an expression of one, as 2 * x; a row or a column, of fixed or dynamic size
//   an array of such                    std::array and C arrays are of fixed size, std::vector and std::span of dynamic size
// A number with more digits than S - long double for double, double for float - is refused: round it first.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "hilger/shape.hpp"
#include "hilger/whole_number.hpp"

namespace hilger {

namespace detail {

template <class X, class S>
inline constexpr bool keeps_digits = std::numeric_limits<X>::is_integer or std::numeric_limits<S>::is_exact or
                                     (not std::numeric_limits<X>::is_exact and
                                      std::numeric_limits<X>::digits <= std::numeric_limits<S>::digits);

} // namespace detail

/// Each X has an equal in S. Whole numbers of more digits than S are checked when they are converted.
template <class X, class S>
concept exact_in = std::same_as<X, S> or(std::numeric_limits<std::decay_t<X>>::is_specialized and not std::same_as<X, bool> and
                                         std::constructible_from<S, X> and detail::keeps_digits<X, S>);

namespace detail {

/// The numbers and the size of a type accepted as a vector; size 0 for others.
template <class X>
struct given_vector {
    using number = X;
    static constexpr int size = 0;
};
template <class X>
    requires std::derived_from<X, Eigen::DenseBase<X>>
struct given_vector<X> {
    using number = typename X::Scalar;
    static constexpr int size = X::IsVectorAtCompileTime ? int(X::SizeAtCompileTime) : 0;
};
template <class X, std::size_t N>
struct given_vector<std::array<X, N>> {
    using number = X;
    static constexpr int size = static_cast<int>(N);
};
template <class X, std::size_t N>
struct given_vector<X[N]> : given_vector<std::array<X, N>> {};
template <class X, class A>
struct given_vector<std::vector<X, A>> {
    using number = X;
    static constexpr int size = Eigen::Dynamic;
};
template <class X, std::size_t N>
struct given_vector<std::span<X, N>> {
    using number = std::remove_const_t<X>;
    static constexpr int size = N == std::dynamic_extent ? Eigen::Dynamic : static_cast<int>(N);
};
template <class X>
inline constexpr int given_size = given_vector<X>::size;

/// Whether X is accepted as a state, of whatever numbers; whether these have equals in S.
template <class X>
inline constexpr bool is_given_state = scalar<X> or std::numeric_limits<std::decay_t<X>>::is_specialized;
template <class X>
    requires(given_size<X> != 0)
inline constexpr bool is_given_state<X> = true;
template <class X, class S>
inline constexpr bool is_exact_state = exact_in<typename given_vector<X>::number, S>;

/// The state over times S made from X.
template <class S, int Size>
struct state_of_size {
    using type = std::conditional_t<Size == 0, S, Eigen::Matrix<S, Size, 1>>;
};
template <class S, class X>
struct given_state : state_of_size<S, given_size<X>> {};
template <class S, int D, int O, int M>
struct given_state<S, Eigen::Matrix<S, D, 1, O, M, 1>> {
    using type = Eigen::Matrix<S, D, 1, O, M, 1>;
};
template <class S, class X>
using given_state_t = typename given_state<S, X>::type;

/// Whether X and Y make one state: numbers, or vectors of one length as far as their types say.
template <class X, class Y>
inline constexpr bool fit_together = (given_size<X> == 0) == (given_size<Y> == 0) and
                                     (given_size<X> == given_size<Y> or given_size<X> == Eigen::Dynamic or given_size<Y> == Eigen::Dynamic);

template <class S, class X, class Y>
consteval bool are_given_states() {
    return is_given_state<X> and is_given_state<Y> and is_exact_state<X, S> and is_exact_state<Y, S> and fit_together<X, Y>;
}
/// Explains in one sentence why they are not.
template <class S, class X, class Y>
constexpr void refuse_states() {
    if constexpr (not is_given_state<X> or not is_given_state<Y>)
        static_assert(is_given_state<X> and is_given_state<Y>,
                      "a state is a number or a vector, one of Eigen (row or column) or an array of numbers, and this is neither");
    else if constexpr (not is_exact_state<X, S> or not is_exact_state<Y, S>)
        static_assert(is_exact_state<X, S> and is_exact_state<Y, S>,
                      "a state is given in real numbers with no more digits than those of T: round them first, or make T of such numbers");
    else
        static_assert(fit_together<X, Y>, "the two parts of a state are two numbers or two vectors of one length, and these are not");
}

/// x as a state V. @throws error::mismatch if it has another length, error::invalid_parameter as exactly()
template <class V, class X>
constexpr V as_state(X const& x) {
    using s = shape<V>;
    using S = typename s::scalar_type;
    if constexpr (std::same_as<V, X>)
        return x;
    else if constexpr (s::is_scalar)
        return exactly<S>(x);
    else {
        decltype(auto) values = [&]() -> decltype(auto) {
            if constexpr (requires { typename X::PlainObject; })
                return typename X::PlainObject(x);
            else
                return std::span(x);
        }();
        V v;
        int const size = static_cast<int>(std::size(values));
        if constexpr (s::size == Eigen::Dynamic)
            v.resize(size);
        else if (size != s::size)
            error::raise<error::mismatch>("the parts of a state have one dimension, and these have ", int(s::size), " and ", size);
        for (int k = 0; k < size; ++k) v(k) = exactly<S>(values[static_cast<std::size_t>(k)]);
        return v;
    }
}

} // namespace detail
} // namespace hilger
