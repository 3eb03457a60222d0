// SPDX-License-Identifier: BSL-1.0
// Compile-time text, so that a compiler's error message can be one sentence that names the scales.
#pragma once

#include <cstddef>
#include <string_view>
#include <utility>

namespace hilger {

/// A text as a template argument. g++ prints it literally in its messages.
template <std::size_t N>
struct text_argument {
    char characters[N]{};

    constexpr text_argument() = default;
    constexpr text_argument(char const (&literal)[N]) {
        for (std::size_t i = 0; i < N; ++i) characters[i] = literal[i];
    }
    [[nodiscard]] constexpr std::string_view view() const { return {characters, N - 1}; }
};

namespace detail {
template <std::size_t Number, std::size_t N>
struct piece_of_text {
    char const (&literal)[N];
};
} // namespace detail

/// String literals one after another, as the name of an operator or of a scale.
template <class Numbers, std::size_t... N>
struct fixed_text;
template <std::size_t... Number, std::size_t... N>
struct fixed_text<std::index_sequence<Number...>, N...> : detail::piece_of_text<Number, N>... {
    constexpr fixed_text(char const (&... literals)[N]) : detail::piece_of_text<Number, N>{literals}... {}

    /// use(literals ...)
    template <class Use>
    constexpr auto apply(Use const& use) const {
        return use(static_cast<detail::piece_of_text<Number, N> const&>(*this).literal...);
    }
    [[nodiscard]] constexpr auto text() const {
        text_argument<(1 + ... + (N - 1))> all;
        char* end = all.characters;
        auto const append = [&end](auto const& piece) {
            for (char const* c = piece.literal; *c != '\0'; ++c) *end++ = *c;
        };
        (append(static_cast<detail::piece_of_text<Number, N> const&>(*this)), ...);
        return all;
    }
};
template <std::size_t... N>
fixed_text(char const (&... literals)[N]) -> fixed_text<std::make_index_sequence<sizeof...(N)>, N...>;

template <class P, std::size_t... N, class Q, std::size_t... M>
constexpr auto operator+(fixed_text<P, N...> const& a, fixed_text<Q, M...> const& b) {
    return a.apply(
        [&](char const(&... first)[N]) { return b.apply([&](char const(&... second)[M]) { return fixed_text(first..., second...); }); });
}
template <class P, std::size_t... N, std::size_t M>
constexpr auto operator+(fixed_text<P, N...> const& a, char const (&b)[M]) {
    return a + fixed_text(b);
}
template <std::size_t N, class P, std::size_t... M>
constexpr auto operator+(char const (&a)[N], fixed_text<P, M...> const& b) {
    return fixed_text(a) + b;
}

/// The decimal digits of a small non-negative number.
template <unsigned Number>
constexpr auto digits() {
    if constexpr (Number >= 10)
        return digits<Number / 10>() + digits<Number % 10>();
    else if constexpr (Number >= 5)
        return fixed_text(Number == 5 ? "5" : Number == 6 ? "6" : Number == 7 ? "7" : Number == 8 ? "8" : "9");
    else
        return fixed_text(Number == 0 ? "0" : Number == 1 ? "1" : Number == 2 ? "2" : Number == 3 ? "3" : "4");
}

namespace detail {
/// clang shows the literals of a composed text, as arguments of a call that is no constant expression; of an array of characters it would
/// show the first ten, as numbers.
template <std::size_t N>
struct sentence : text_argument<N> {
    constexpr sentence(char const (&literal)[N]) : text_argument<N>(literal) {}
    template <class Numbers, std::size_t... M>
    constexpr sentence(fixed_text<Numbers, M...> says) : text_argument<N>(says.text()) {
#ifdef __clang__
        throw this;
#endif
    }
};
template <class Numbers, std::size_t... M>
sentence(fixed_text<Numbers, M...>) -> sentence<(1 + ... + (M - 1))>;
} // namespace detail

/// The result of a wrong use of a library function. Both compilers show the sentence: g++ as text, clang as its literals. Names come from
/// template parameters,
///   does_not_compile<"a sum needs one scale, and these live on " + D::name() + " and on " + E::name()>{}
/// The types that it concerns may follow it: a sentence that depends on no template parameter would be an error at once.
template <detail::sentence Sentence, class...>
struct does_not_compile {
    does_not_compile() = delete;
};

} // namespace hilger
