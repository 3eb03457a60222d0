// SPDX-License-Identifier: BSL-1.0
// Convolution weights of fractional differences (Lubich 1986): the power series of omega(z)^alpha for a generating function omega(z) =
// (1 - z) + O((1 - z)^2), a quotient of polynomials. Times h^-alpha they approximate the derivative of order alpha.
//   grunwald_letnikov   1 - z                            (Bourdin et al. (1), order 1)
//   bdf<K>              sum_{j=1..K} (1 - z)^j / j       (order K; bdf<2> is the G^alpha-scheme of Galucio, Deue, Dubois (1), (2))
//   trapezoid           2 (1 - z) / (1 + z)              (order 2)
// A user's own generating function is a type with numerator<S>() and denominator<S>(), as these have.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/fixed_text.hpp"
#include "hilger/operator/double_double.hpp"
#include "hilger/scalar.hpp"

namespace hilger {

/// Coefficients of two polynomials in z as arrays, lowest power first; neither vanishes at z = 0.
template <class G>
concept generating_function = requires {
    G::template numerator<double>()[0];
    G::template denominator<double>()[0];
};

struct grunwald_letnikov {
    static constexpr auto name() { return fixed_text("Delta"); }
    template <class S>
    static constexpr std::array<S, 2> numerator() {
        return {S(1), S(-1)};
    }
    template <class S>
    static constexpr std::array<S, 1> denominator() {
        return {S(1)};
    }
};
template <int K>
    requires(K >= 1 and K <= 6)
struct bdf {
    static constexpr auto name() { return fixed_text("bdf<") + digits<K>() + ">"; }
    template <class S>
    static constexpr auto numerator() {
        std::array<S, static_cast<std::size_t>(K + 1)> sum{}, power{S(1)}; // power: (1 - z)^j
        for (int j = 1; j <= K; ++j) {
            for (std::size_t i = static_cast<std::size_t>(j); i > 0; --i) power[i] = power[i] - power[i - 1];
            for (std::size_t i = 0; i <= static_cast<std::size_t>(j); ++i) sum[i] = sum[i] + power[i] / S(j);
        }
        return sum;
    }
    template <class S>
    static constexpr std::array<S, 1> denominator() {
        return {S(1)};
    }
};
struct trapezoid {
    static constexpr auto name() { return fixed_text("trapezoid"); }
    template <class S>
    static constexpr std::array<S, 2> numerator() {
        return {S(2), S(-2)};
    }
    template <class S>
    static constexpr std::array<S, 2> denominator() {
        return {S(1), S(1)};
    }
};

namespace detail {

/// x^alpha. In an exact scalar x is 1 or alpha a whole number; else `refuse` throws.
template <class S, class Refuse>
constexpr S power_or(S const& x, S const& alpha, Refuse const& refuse) {
    if (x == S(1)) return S(1);
    if (alpha == S(1)) return x;
    if constexpr (std::numeric_limits<S>::is_exact) {
        if (alpha < S(0)) return S(1) / power_or(x, S(-alpha), refuse);
        S result(1), left = alpha;
        for (; not(left < S(1)); left = left - S(1)) result = result * x;
        if (not(left == S(0))) refuse();
        return result;
    } else {
        using std::pow;
        return S(pow(x, alpha));
    }
}

} // namespace detail

/// omega(0)^alpha, the weight of the present: 1 for Gruenwald-Letnikov, (3/2)^alpha for G^alpha. In exact scalars it is 1 or alpha is a
/// whole number. @throws error::invalid_parameter where it is not a number of type S.
template <generating_function G, class S>
S leading_weight(S const& alpha) {
    S const base = S(G::template numerator<S>()[0] / G::template denominator<S>()[0]);
    return detail::power_or(
        base, alpha, [&] { error::raise<error::invalid_parameter>("the leading weight ", base, "^", alpha, " is no rational number"); });
}

/// The weights divided by the leading one, w_0 = 1, w_1, w_2, ..., one at a time: each from the last few by the linear recurrence that
/// omega(z)^alpha satisfies, n a_0 w_n = sum_j (b_{j-1} - (n - j) a_j) w_{n-j} with a = p q, b = alpha (p' q - p q') for omega = p / q. The
/// recurrence of processor floats runs in double-double numbers, where the cancellation near alpha = 0 and 1 costs nothing.
template <generating_function G, class S>
class weight_sequence {
    using wide = typename detail::wider<S>::type;
    static constexpr std::size_t P = std::tuple_size_v<decltype(G::template numerator<wide>())>;
    static constexpr std::size_t Q = std::tuple_size_v<decltype(G::template denominator<wide>())>, taps = P + Q - 1;

public:
    /// @throws error::invalid_parameter when alpha is not finite, or omega no generating function of a derivative.
    constexpr explicit weight_sequence(S const& alpha) {
        if (not is_finite(alpha)) error::raise<error::invalid_parameter>("the order of a fractional difference is a finite number");
        auto const p = G::template numerator<wide>();
        auto const q = G::template denominator<wide>();
        if constexpr (ordered_scalar<S>) require_consistent(); // operators are compared in numbers without an order
        for (std::size_t i = 0; i < P; ++i)
            for (std::size_t j = 0; j < Q; ++j) {
                wide const both = p[i] * q[j], slope = wide(static_cast<int>(i)) - wide(static_cast<int>(j));
                a_[i + j] = a_[i + j] + both;
                if (i + j > 0) b_[i + j - 1] = b_[i + j - 1] + wide(alpha) * slope * both; // of z^(i+j-1) in alpha (p' q - p q')
            }
        wide const first = a_[0];
        for (std::size_t j = 0; j < taps; ++j) {
            a_[j] = a_[j] / first;
            b_[j] = b_[j] / first;
        }
    }
    /// w_0, then w_1, ...
    constexpr S next() {
        wide w(1);
        if (n_ > 0) {
            w = wide(0);
            for (std::size_t j = 1; j < taps; ++j)
                w = w + (b_[j - 1] - a_[j] * S(static_cast<int>(n_ - static_cast<index_type>(j)))) * last_[j - 1];
            w = w / S(static_cast<int>(n_));
        }
        for (std::size_t j = taps - 1; j-- > 1;) last_[j] = last_[j - 1];
        if constexpr (taps > 1) last_[0] = w;
        ++n_;
        return static_cast<S>(w);
    }

private:
    /// Checks that omega(z) is (1 - z) + O((1 - z)^2), and that omega(0) has a power. @throws error::invalid_parameter
    static constexpr void require_consistent() {
        auto const p = G::template numerator<S>();
        auto const q = G::template denominator<S>();
        S value(0), slope(0), below(0), size(0);
        for (std::size_t i = 0; i < P; ++i) {
            S const x = p[i];
            value = value + x;
            slope = slope + x * S(static_cast<int>(i));
            size = size + (x < S(0) ? S(-x) : x) * S(static_cast<int>(i + 1));
        }
        for (std::size_t j = 0; j < Q; ++j) below = below + q[j];
        S const rounding = S(64) * epsilon<S>() * size;
        auto const is_zero = [&](S const& x) { return not(rounding < x) and not(rounding < -x); };
        if (not is_zero(value) or not is_zero(S(slope + below)) or not(S(0) < p[0] / q[0]))
            error::raise<error::invalid_parameter>(
                "a generating function is omega(z) = (1 - z) + O((1 - z)^2), and positive at z = 0; here "
                "omega(1) is ",
                S(value / below), ", omega'(1) ", S(slope / below), " and omega(0) ", S(p[0] / q[0]));
    }
    std::array<wide, taps> a_{}, b_{}, last_{}; // last_[j - 1] = w_{n-j}
    index_type n_ = 0;
};

/// w_0 = 1, ..., w_{count-1}, without the leading weight.
template <generating_function G, class S>
std::vector<S> first_weights(S const& alpha, index_type count) {
    weight_sequence<G, S> sequence(alpha);
    std::vector<S> w;
    w.reserve(static_cast<std::size_t>(count));
    for (index_type n = 0; n < count; ++n) w.push_back(sequence.next());
    return w;
}

} // namespace hilger
