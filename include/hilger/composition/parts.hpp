// SPDX-License-Identifier: BSL-1.0
// The parts of a step over which a composition (composition.hpp) applies its flows.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>

#include "hilger/error.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

/// The parts c_1, ..., c_size of a step, in the digits of any scalar: values<S>() is a std::array<S, size> with the sum 1.
template <class C>
concept parts_of_a_step = requires(C const& c) {
    { C::size } -> std::convertible_to<std::size_t>;
    c.template values<double>();
};

/// Parts that are rational numbers, exact in every scalar.
template <class... Fractions>
struct shares {
    static constexpr std::size_t size = sizeof...(Fractions);
    template <class S>
    std::array<S, size> values() const {
        return {Fractions::template as<S>()...};
    }
};
/// Two halves of a step.
inline constexpr shares<fraction<1, 2>, fraction<1, 2>> halves{};

/// The parts C from the last to the first.
template <parts_of_a_step C>
struct backwards {
    static constexpr std::size_t size = C::size;
    [[no_unique_address]] C of;
    template <class S>
    std::array<S, size> values() const {
        auto c = of.template values<S>();
        std::reverse(c.begin(), c.end());
        return c;
    }
};

namespace detail {

/// The parts c_1, ..., c_size. @throws error::invalid_parameter when they do not add up to the step
template <class S, parts_of_a_step Parts>
std::array<S, Parts::size> whole(Parts const& parts) {
    auto const c = parts.template values<S>();
    S sum(0), size(0);
    for (S const& part : c) {
        sum = sum + part;
        size = size + magnitude(part);
    }
    if (not(magnitude(S(sum - S(1))) <= S(64) * epsilon<S>() * size))
        error::raise<error::invalid_parameter>("the parts of a composed step add up to 1, and these add up to ", sum);
    return c;
}

} // namespace detail
} // namespace hilger
