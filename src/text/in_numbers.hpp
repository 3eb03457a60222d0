// SPDX-License-Identifier: BSL-1.0
// Templates compiled once for each number type: they read and evaluate formulas, and operators with factors.
#pragma once

#include <charconv>
#include <system_error>

#include "hilger/text/embedding.hpp"
#include "text/evaluate.hpp"
#include "text/operator_in_numbers.hpp"
#include "text/switching.hpp"

namespace hilger::text {

template <class S>
std::optional<S> number_in(std::string_view digits) {
    if (auto const slash = digits.find('/'); slash != std::string_view::npos) {
        auto const above = number_in<S>(digits.substr(0, slash)), below = number_in<S>(digits.substr(slash + 1));
        if (not above or not below or *below == S(0) or digits.find('/', slash + 1) != std::string_view::npos) return {};
        return S(*above / *below);
    }
    // The syntax: a sign, digits with at most one point, an exponent.
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
        S x(0);
        for (char const c : mantissa) x = x * S(10) + S(c - '0');
        x = x * whole_power(S(10), exponent);
        return minus ? S(-x) : x;
    } else if constexpr (std::is_constructible_v<S, std::string>) {
        S const x(mantissa + "e" + std::to_string(exponent));
        return minus ? S(-x) : x;
    } else { // types that stand for doubles
        auto const x = number_in<double>(digits);
        return x ? std::optional<S>(S(*x)) : std::nullopt;
    }
}
template <class S>
S lambda_of_step(embedding_formula const& e, std::optional<S> const& h) {
    require_one_step(e, detail::rounding_of_factors<S>);
    if (not h and depends_on_step(e))
        error::raise<error::invalid_parameter>("the position of ", e.text,
                                               " is another mean of the ends for each length of the step, which is possible here on equal "
                                               "steps alone");
    S const length = h.value_or(S(1));
    return detail::row_on<S>([&](index_type) { return length; }, e.position, e.lost())[1];
}

} // namespace hilger::text

#define HILGER_FORMULAS_AS(T)                                                                                                              \
    template class hilger::text::detail::evaluator<T>;                                                                                     \
    template T hilger::text::stated::evaluate(T const&, components_view<T>, components_view<T>, bool) const;
#define HILGER_TEXT_IN(S)                                                                                                                  \
    HILGER_FORMULAS_AS(S)                                                                                                                  \
    HILGER_FORMULAS_AS(hilger::traced<S>)                                                                                                  \
    template std::optional<S> hilger::text::number_in(std::string_view);                                                                   \
    template S hilger::text::stated::number<S>() const;                                                                                    \
    template std::vector<S> hilger::text::switching_times(std::vector<stated> const&, S const&, S const&);                                 \
    template class hilger::text::operator_in_numbers<S>;                                                                                   \
    template S hilger::text::lambda_of_step(embedding_formula const&, std::optional<S> const&);
