// SPDX-License-Identifier: BSL-1.0
// Compile-time text, so that a compiler's error message can be one sentence that names the scales.
#pragma once

#include <cstddef>
#include <string_view>

namespace hilger {

/// A string usable as a template argument. g++ prints it literally in its messages.
template <std::size_t N>
struct fixed_text {
    char characters[N]{};

    constexpr fixed_text() = default;
    constexpr fixed_text(char const (&literal)[N]) {
        for (std::size_t i = 0; i < N; ++i) characters[i] = literal[i];
    }
    [[nodiscard]] constexpr std::string_view view() const { return {characters, N - 1}; }
};

template <std::size_t N, std::size_t M>
constexpr fixed_text<N + M - 1> operator+(fixed_text<N> const& a, fixed_text<M> const& b) {
    fixed_text<N + M - 1> joined;
    for (std::size_t i = 0; i + 1 < N; ++i) joined.characters[i] = a.characters[i];
    for (std::size_t i = 0; i < M; ++i) joined.characters[N - 1 + i] = b.characters[i];
    return joined;
}

template <std::size_t N, std::size_t M>
constexpr auto operator+(fixed_text<N> const& a, char const (&b)[M]) {
    return a + fixed_text<M>(b);
}

template <std::size_t N, std::size_t M>
constexpr auto operator+(char const (&a)[N], fixed_text<M> const& b) {
    return fixed_text<N>(a) + b;
}

/// The decimal digits of a small non-negative number.
template <unsigned Number>
constexpr auto digits() {
    if constexpr (Number < 10) {
        char const digit[2] = {static_cast<char>('0' + Number), '\0'};
        return fixed_text<2>(digit);
    } else {
        return digits<Number / 10>() + digits<Number % 10>();
    }
}

/// What the wrong use of a library function makes. The line with `error:` shows the sentence: g++ as text, clang 14 as the expression that
/// it is written as. So it is written where the object is made, and names come from template parameters,
///   does_not_compile<"a sum needs one scale, and these live on " + D::name() + " and on " + E::name()>{}
/// A variable with the sentence would be shown as the variable's name. Types that the sentence is about may follow it: a sentence that
/// depends on nothing would be an error before anything was used wrongly.
template <fixed_text Sentence, class...>
struct does_not_compile {
    does_not_compile() = delete;
};

} // namespace hilger
