// SPDX-License-Identifier: BSL-1.0
// A few objects of different types. std::tuple asks of each how it may be converted, assigned and compared, and of expressions of
// expressions that is most of what they cost to compile.
#pragma once

#include <cstddef>
#include <utility>

namespace hilger::detail {

template <std::size_t I, class F>
struct operand {
    [[no_unique_address]] F value;
};
template <class Indices, class... Fs>
struct operand_list;
template <std::size_t... I, class... Fs>
struct operand_list<std::index_sequence<I...>, Fs...> : operand<I, Fs>... {
    constexpr explicit operand_list(Fs... fs) : operand<I, Fs>{std::move(fs)}... {}
    /// what(f, g, ...)
    template <class What>
    constexpr decltype(auto) apply(What const& what) const {
        return what(operand<I, Fs>::value...);
    }
};
template <class... Fs>
using operands = operand_list<std::index_sequence_for<Fs...>, Fs...>;

} // namespace hilger::detail
