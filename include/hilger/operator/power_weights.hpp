// SPDX-License-Identifier: BSL-1.0
// Powers of the difference on any T. With the graininess w_k > 0 at the points of T, C f_k = (f_k - f_{k-1}) / w_k is a triangle with the
// eigenvalues 1/w_k: it has one power C^alpha with positive eigenvalues. From C^alpha = (sin(pi alpha)/pi) Int x^{alpha-1} C (x + C)^-1 dx,
//   (C^alpha)_kk = w_k^-alpha,   (C^alpha)_kj = -(sin(pi alpha)/pi) w_j Int_0^inf x^alpha / prod_{m=j..k} (1 + x w_m) dx   for j < k,
// 0 < |alpha| < 1 (the divided differences of z^alpha, Opitz 1964, without their cancellation; Lopez-Fernandez and Sauter 2013). The
// integral is symmetric in the w_m, so that the same holds for C f_k = (f_k - f_{k+1}) / w_k. Below, a row begins at its own point k, and
// w(n) is the graininess n points further on.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <optional>

#include "hilger/operator/weights.hpp"

namespace hilger::detail {

/// The trapezoidal rule in ln x for one alpha in ]0, 1[: nodes 1/x from the largest on, and values x^alpha dx/x, kept.
template <class S>
class power_nodes {
    using wide = typename wider<S>::type;

public:
    struct node {
        S at, value;
    };
    /// 1/prod (1 + x w_m) is the mean of e^{-x t} over a positive t, so that steps of length 2 pi/y miss the integral by its share
    /// 2 |Gamma(1 + alpha + iy)| / Gamma(1 + alpha) < 6 y^{3/2} e^{-pi y/2} at most, whatever T is.
    explicit power_nodes(S const& alpha) : alpha_(alpha) {
        using std::atan, std::exp, std::log;
        S const pi = S(4) * atan(S(1)), ratio = exp(S(pi * pi / (S(12) - log(epsilon<S>()))));
        ratio_ = wide(ratio);
        step_ = log(ratio);
        nodes_.push_back(weighted(wide(1)));
    }
    /// Those of one alpha, kept for each thread.
    static power_nodes& of(S const& alpha) {
        thread_local std::map<S, power_nodes> kept;
        return kept.try_emplace(alpha, alpha).first->second;
    }
    /// At least those between two numbers.
    std::deque<node> const& covering(S const& smallest, S const& largest) {
        while (nodes_.front().at < largest) nodes_.push_front(weighted(first_ = first_ * ratio_));
        while (smallest < nodes_.back().at) nodes_.push_back(weighted(last_ = last_ / ratio_));
        return nodes_;
    }
    [[nodiscard]] S const& step() const { return step_; } ///< in ln x

private:
    node weighted(wide const& at) const {
        using std::pow;
        return {static_cast<S>(at), S(step_ * pow(static_cast<S>(at), S(-alpha_)))};
    }
    S alpha_, step_;
    wide ratio_, first_{1}, last_{1};
    std::deque<node> nodes_;
};

/// The integral over products of at least three factors 1 + x w_m, one more at a time, as a sum of positive terms. For alpha < 0 it is
/// integrated by parts: x^{delta-1} / prod becomes x^delta sigma / (delta prod), delta = 1 + alpha, sigma the sum of the w_m / (1 + x w_m).
template <class S>
class power_integral {
public:
    /// For steps >= smallest with the sum `total`. Below 1/total the integrand grows like x^{1+delta}; above 1/smallest it falls like
    /// x^{delta-2} or faster; delta is alpha for alpha > 0.
    power_integral(S const& alpha, S const& smallest, S const& total) : by_parts_(alpha < S(0)), delta_(by_parts_ ? S(1) + alpha : alpha) {
        using std::atan, std::exp, std::log, std::sin;
        using limits = std::numeric_limits<S>;
        // Margin: from what is no longer a number.
        S const digits = -log(epsilon<S>()), margin = S(1) / epsilon<S>(), pi = S(4) * atan(S(1));
        S const rest = by_parts_ ? S(-alpha) : S(S(1) - alpha); // 1 - delta, which may be more exact
        factor_ = by_parts_ ? S(sin(S(pi * std::min(delta_, rest))) / (pi * delta_)) : S(-sin(S(pi * std::min(delta_, rest))) / pi);
        S const above = total * exp(S((digits + S(1)) / (S(1) + delta_))), first = std::min(above, S((limits::max)() / margin));
        S const below = smallest * exp(S(-(digits + S(6)) / (S(2) - delta_))), last = std::max(below, S((limits::min)() * margin));
        for (auto const& x : power_nodes<S>::of(delta_).covering(last, first))
            if (not(x.at < last or first < x.at)) terms_.push_back({x.at, x.value, S(0)});
    }
    /// The entry of C^alpha for one more factor 1 + x w.
    S next(S const& w) {
        S sum(0), sum_by_parts(0);
        for (term& t : terms_) {
            S const inverse = S(1) / (t.node + w), share = w * inverse; // x w may be too large a number, and so may value inverse
            sum = sum + t.value * share;
            t.value = t.value * (t.node * inverse);
            if (not by_parts_) continue;
            t.shares = t.shares + share;
            sum_by_parts = sum_by_parts + t.value * t.shares;
        }
        // The share of the largest x in all later entries is at most that of value/node, and falls with each factor.
        while (terms_.size() > 1 and S(1024) * w * terms_.back().value < epsilon<S>() * sum * terms_.back().node) terms_.pop_back();
        return factor_ * (by_parts_ ? S(w * sum_by_parts) : sum);
    }

private:
    struct term {
        S node, value, shares; ///< 1/x; the value of the rule, divided by the factors so far; x sigma
    };
    bool by_parts_;
    S delta_, factor_;
    std::vector<term> terms_;
};

/// The entry beside the diagonal: a divided difference of two points, by expm1 without cancellation.
template <class S>
S first_neighbour(S const& alpha, S const& own, S const& w) {
    using std::expm1, std::log1p, std::pow;
    S const smaller = std::min(own, w), larger = std::max(own, w), difference = larger - smaller;
    if (difference == S(0)) return S(-alpha * pow(w, S(-alpha)));
    S const entry = w / difference * expm1(S(-magnitude(alpha) * log1p(S(difference / smaller))));
    return alpha < S(0) ? S(-entry * pow(larger, S(-alpha))) : S(entry * pow(smaller, S(-alpha)));
}

/// The first `count` entries of a row of C^alpha, 0 < |alpha| < 1, each with an error of some epsilon, and one more for each factor.
template <class S, class Steps>
std::vector<S> power_row(S const& alpha, index_type count, Steps const& w) {
    using std::pow;
    std::vector<S> row{S(pow(w(0), S(-alpha)))};
    if (count > 1) row.push_back(first_neighbour(alpha, S(w(0)), S(w(1))));
    if (count < 3) return row;
    S smallest = w(0), total(0);
    for (index_type n = 0; n < count; ++n) {
        smallest = std::min(smallest, S(w(n)));
        total = total + w(n);
    }
    power_integral<S> integral(alpha, smallest, total);
    for (index_type n = 0; n < count; ++n) {
        S const entry = integral.next(w(n));
        if (n >= 2) row.push_back(entry);
    }
    return row;
}

/// x^n.
template <class N>
N whole_power(N const& x, int n) {
    N power(1);
    for (; n > 0; --n) power = power * x;
    return power;
}
/// The whole n-th root of a positive integer, if there is one: by Newton's method from above.
template <class N>
std::optional<N> whole_root(N const& x, int n) {
    N root(1);
    while (whole_power(root, n) < x) root = root * N(2);
    for (N next = root;; root = next) {
        next = ((n - 1) * root + x / whole_power(root, n - 1)) / n;
        if (not(next < root)) break;
    }
    return whole_power(root, n) == x ? std::optional(root) : std::nullopt;
}
/// The n-th root of a positive number of an exact scalar with numerator() and denominator(), if it is a number of that scalar.
template <class S>
std::optional<S> exact_root(S const& x, int n) {
    if (x == S(1) or n == 1) return x;
    if constexpr (requires { S(numerator(x)) / S(denominator(x)); })
        if (auto const above = whole_root(numerator(x), n), below = whole_root(denominator(x), n); above and below)
            return S(*above) / S(*below);
    return std::nullopt;
}

/// The first `count` entries of a row of R^p, R the q-th root of C, from the roots r(n) of 1/w(n): the entries of R follow from R^q = C,
/// the nearest to the diagonal first (Bjoerck and Hammarling 1983 for q = 2). Nothing is divided by a difference of steps.
template <class S>
std::vector<S> row_of_root(std::vector<S> const& r, int p, int q, bool inverse = false) {
    std::size_t const count = r.size();
    std::vector<std::vector<std::vector<S>>> R(static_cast<std::size_t>(q) + 1, {count, std::vector<S>(count, S(0))}); // R[i]: R^i
    std::vector<S> own(R.size()), slope(R.size()); // an entry of R^i is own + slope times the same entry of R
    for (std::size_t d = 0; d < count; ++d)
        for (std::size_t a = 0, b = d; b < count; ++a, ++b) {
            own[1] = d == 0 ? r[a] : S(0);
            slope[1] = S(1);
            for (std::size_t i = 2; i < R.size(); ++i) {
                own[i] = r[a] * own[i - 1];
                for (std::size_t m = a + 1; m < b; ++m) own[i] = own[i] + R[1][a][m] * R[i - 1][m][b];
                if (d > 0) slope[i] = r[a] * slope[i - 1] + R[i - 1][b][b];
            }
            S const wanted = inverse ? whole_power(r[b], q) : d == 1 ? S(-whole_power(r[a], q)) : S(0);
            S const entry = d == 0 ? S(0) : S((wanted - own.back()) / slope.back());
            for (std::size_t i = 1; i < R.size(); ++i) R[i][a][b] = d == 0 ? own[i] : S(own[i] + slope[i] * entry);
        }
    return R[static_cast<std::size_t>(p)][0];
}

/// The same row in an exact scalar, alpha = p/q. @throws error::invalid_parameter where a step has no q-th root
template <class S, class Steps>
std::vector<S> exact_power_row(int p, int q, index_type count, Steps const& w) {
    std::vector<S> roots;
    for (index_type n = 0; n < count; ++n) {
        auto const root = exact_root(S(w(n)), q);
        if (not root)
            error::raise<error::invalid_parameter>("in an exact scalar a fractional difference of order ", p, "/", q,
                                                   " takes steps that are powers of rational numbers with the exponent ", q,
                                                   ", and this one is ", w(n));
        roots.push_back(p < 0 ? *root : S(S(1) / *root));
    }
    return row_of_root(roots, p < 0 ? -p : p, q, p < 0);
}

} // namespace hilger::detail
