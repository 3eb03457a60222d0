// SPDX-License-Identifier: BSL-1.0
// Initial data of a trajectory: initial_velocity{q0, v0}, initial_momentum{q0, p0}, or the first two positions, initial_positions{q0, q1}.
// As arguments they can be written in braces, with the names of their parts and anything that may be given as a state:
//   solve(EL, T, {.q0 = 1.0, .v0 = 0})        flow.along(T, {.q0 = Eigen::Vector2d(1, 0), .q1 = x})        {.q0 = {1.0, 0.0}, .v0 = ...}
// A list in braces has no type from which the kind of state could be deduced, so there is one overload for each: numbers, vectors of a
// fixed size up to 6, vectors of dynamic size. Other states take the name of the type.
#pragma once

#include "hilger/variational/given_state.hpp"

/// Braces have no type to deduce a size from: functions have an overload for each size of states, 0 for numbers.
#define HILGER_FOR_EACH_SIZE(Overload) Overload(0) Overload(2) Overload(3) Overload(4) Overload(5) Overload(6) Overload(Eigen::Dynamic)

namespace hilger {

/// Initial position and velocity. The momentum is p0 = dL/dv(q0, v0).
template <class V>
struct initial_velocity {
    V q0;
    V v0;
};
/// Initial position and momentum, as along(T, q0, p0) has them.
template <class V>
struct initial_momentum {
    V q0;
    V p0;
};
/// The first two positions. The momentum is p0 = -d_1 L_h(q0, q1).
template <class V>
struct initial_positions {
    V q0;
    V q1;
};
/// The first and the last position: no trajectory starts from these; an equation is solved between them.
template <class V>
struct boundary_values {
    V q0;
    V qN;
};

namespace detail {
template <class Data>
inline constexpr bool starts_a_trajectory = false;
template <class V>
inline constexpr bool starts_a_trajectory<initial_velocity<V>> = true;
template <class V>
inline constexpr bool starts_a_trajectory<initial_momentum<V>> = true;
template <class V>
inline constexpr bool starts_a_trajectory<initial_positions<V>> = true;
} // namespace detail
/// One of the first three above.
template <class Data>
concept initial_data = detail::starts_a_trajectory<Data>;

namespace detail {

/// One type for two parts: numbers in the type of their sum; a vector, evaluated, of the length of both types, or of dynamic length where
/// they differ, to be compared at run time.
template <class X, class Y>
struct common_parts {
    using number = typename given_vector<X>::number;
    using type = std::conditional_t<given_size<X> != given_size<Y> and given_size<Y> == Eigen::Dynamic,
                                    Eigen::Matrix<number, Eigen::Dynamic, 1>, given_state_t<number, X>>;
};
template <class X, class Y>
    requires std::is_arithmetic_v<X> and std::is_arithmetic_v<Y>
struct common_parts<X, Y> {
    using type = std::common_type_t<X, Y>;
};

} // namespace detail

template <class X, class Y>
initial_velocity(X const&, Y const&) -> initial_velocity<typename detail::common_parts<X, Y>::type>;
template <class X, class Y>
initial_momentum(X const&, Y const&) -> initial_momentum<typename detail::common_parts<X, Y>::type>;
template <class X, class Y>
initial_positions(X const&, Y const&) -> initial_positions<typename detail::common_parts<X, Y>::type>;
template <class X, class Y>
boundary_values(X const&, Y const&) -> boundary_values<typename detail::common_parts<X, Y>::type>;

namespace detail {

/// Something given as the state V.
template <class V>
struct braced {
    V value;
    template <class X>
        requires(given_size<X> == 0 and is_exact_state<X, V>)
    constexpr explicit(false) braced(X const& x) : value(as_state<V>(x)) {}
};
template <class S, int Size>
struct braced<Eigen::Matrix<S, Size, 1>> {
    using V = Eigen::Matrix<S, Size, 1>;
    V value;
    template <class X>
        requires(given_size<X> == Size and is_exact_state<X, S>)
    explicit(false) braced(X const& x) : value(as_state<V>(x)) {}
    template <exact_in<S>... X>
        requires(sizeof...(X) == Size)
    explicit(false) braced(X const&... x) : value(as_state<V>(std::array<S, sizeof...(X)>{exactly<S>(x)...})) {}
};
/// The first member of these lists, which cannot be written, so that the others must be named.
struct named {
    explicit named() = default;
};
template <class S, int Size>
struct velocity_in_braces {
    using V = typename state_of_size<S, Size>::type;
    named parts{};
    braced<V> q0;
    braced<V> v0;
    [[nodiscard]] constexpr initial_velocity<V> data() const { return {q0.value, v0.value}; }
};
template <class S, int Size>
struct momentum_in_braces {
    using V = typename state_of_size<S, Size>::type;
    named parts{};
    braced<V> q0;
    braced<V> p0;
    [[nodiscard]] constexpr initial_momentum<V> data() const { return {q0.value, p0.value}; }
};
template <class S, int Size>
struct positions_in_braces {
    using V = typename state_of_size<S, Size>::type;
    named parts{};
    braced<V> q0;
    braced<V> q1;
    [[nodiscard]] constexpr initial_positions<V> data() const { return {q0.value, q1.value}; }
};
template <class S, int Size>
struct ends_in_braces {
    using V = typename state_of_size<S, Size>::type;
    named parts{};
    braced<V> q0;
    braced<V> qN;
    [[nodiscard]] constexpr boundary_values<V> data() const { return {q0.value, qN.value}; }
};

/// Takes every part that nothing above takes. A function of a list of these converts its scale, so that it is the last choice.
struct anything {
    template <class... X>
        requires(sizeof...(X) > 0)
    constexpr explicit(false) anything(X const&...) {}
};
struct anything_in_braces {
    anything q0 = 0, v0 = 0, p0 = 0, q1 = 0;
};
struct any_ends_in_braces {
    named parts{};
    anything q0;
    anything qN;
};
template <class T>
constexpr int not_initial_data() {
    static_assert(
        not std::same_as<T, T>,
        "data in braces are {.q0 = ..., .v0 = ...}, or .p0 or .q1 in place of .v0, for solve also {.q0 = ..., .qN = ...}, of two numbers "
        "or two vectors of one length, in real numbers with no more digits than those of T; vectors of fixed size above 6 are "
        "initial_velocity{q0, v0}");
    return 0;
}

/// along(T, {...}) for data of one kind in states of one size.
template <class Method, template <class, int> class Data, int Size>
struct along_in_braces {
    template <class Scale>
    auto along(Scale const& T, Data<typename Scale::root_type::scalar_type, Size> const& from) const {
        return static_cast<Method const&>(*this).along(T, from.data());
    }
};
template <class Method, int... Sizes>
struct along_in_braces_of : along_in_braces<Method, velocity_in_braces, Sizes>...,
                            along_in_braces<Method, momentum_in_braces, Sizes>...,
                            along_in_braces<Method, positions_in_braces, Sizes>... {
    using along_in_braces<Method, velocity_in_braces, Sizes>::along...;
    using along_in_braces<Method, momentum_in_braces, Sizes>::along...;
    using along_in_braces<Method, positions_in_braces, Sizes>::along...;
};

} // namespace detail
} // namespace hilger
