// SPDX-License-Identifier: BSL-1.0
// How digits are read in any scalar.
#pragma once

#include <charconv>
#include <limits>
#include <system_error>
#include <type_traits>

#include "hilger/text/vocabulary.hpp"

namespace hilger::text {

template <class S>
std::optional<S> number_in(std::string_view digits) {
    if (auto const slash = digits.find('/'); slash != std::string_view::npos) {
        auto const above = number_in<S>(digits.substr(0, slash)), below = number_in<S>(digits.substr(slash + 1));
        if (not above or not below or *below == S(0) or digits.find('/', slash + 1) != std::string_view::npos) return {};
        return S(*above / *below);
    }
    // What is read: a sign, digits with a point in or around them, an exponent.
    std::string_view rest = digits;
    bool const minus = rest.starts_with('-');
    if (minus or rest.starts_with('+')) rest.remove_prefix(1);
    std::string mantissa;
    int exponent = 0;
    bool point = false;
    std::size_t k = 0;
    for (; k < rest.size() and ((rest[k] >= '0' and rest[k] <= '9') or (rest[k] == '.' and not point)); ++k) {
        if (rest[k] == '.')
            point = true;
        else {
            mantissa += rest[k];
            if (point) --exponent;
        }
    }
    if (mantissa.empty()) return {};
    if (k < rest.size()) {
        if (rest[k] != 'e' and rest[k] != 'E') return {};
        std::string_view power = rest.substr(k + 1);
        if (power.starts_with('+')) power.remove_prefix(1);
        int given = 0;
        auto const [end, wrong] = std::from_chars(power.data(), power.data() + power.size(), given);
        if (power.empty() or wrong != std::errc() or end != power.data() + power.size() or given < -10'000 or 10'000 < given) return {};
        exponent += given;
    }
    if constexpr (std::is_floating_point_v<S>) {
        S x{};
        std::string const plain = mantissa + "e" + std::to_string(exponent);
        if (auto const [end, wrong] = std::from_chars(plain.data(), plain.data() + plain.size(), x); wrong != std::errc()) return {};
        return minus ? -x : x;
    } else if constexpr (std::numeric_limits<S>::is_exact) {
        S x(0), power(1);
        for (char const c : mantissa) x = x * S(10) + S(c - '0');
        S square(10);
        for (int n = exponent < 0 ? -exponent : exponent; n > 0; n /= 2, square = square * square)
            if (n % 2 == 1) power = power * square;
        x = exponent < 0 ? S(x / power) : S(x * power);
        return minus ? S(-x) : x;
    } else if constexpr (std::is_constructible_v<S, std::string>) {
        S const x(mantissa + "e" + std::to_string(exponent));
        return minus ? S(-x) : x;
    } else { // what stands for doubles
        auto const x = number_in<double>(digits);
        return x ? std::optional<S>(S(*x)) : std::nullopt;
    }
}

} // namespace hilger::text
