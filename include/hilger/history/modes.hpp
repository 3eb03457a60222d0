// SPDX-License-Identifier: BSL-1.0
// The discrete weights as a sum of exponentials. With omega(z)/omega(0) = (1 - z) q(z), Cauchy's integral for w_n shrinks on to the cut
// [1, inf[ of (1 - z)^alpha; with z = e^s,
//   w_n = -(sin(pi alpha)/pi) Int_0^inf e^{-ns} ((e^s - 1) q(e^s))^alpha ds + O(rho^n),   n > alpha > -1,
// rho the largest modulus of the reciprocal zeros of q (the parasitic roots of a BDF): the zeros add cuts of their own. For
// Gruenwald-Letnikov q = 1, rho = 0 and the integral is a Beta function; for G^alpha the cut ends at z = 3. The trapezoidal rule in u = ln
// s converges like exp(-pi^2/step), the singularities of e^{-n e^u} being pi/2 away; the nodes far below 1/n for the largest n are replaced
// by few Gauss nodes. Cut weights have one sign, so that a sum of modes is as accurate as its terms.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "hilger/history/gauss.hpp"
#include "hilger/operator/weights.hpp"

namespace hilger {

/// rho above. A generating function without it has no modes: its other singularities lie on the unit circle, or are not known.
template <class G>
struct parasitic_root {};
template <>
struct parasitic_root<grunwald_letnikov> {
    static constexpr double modulus = 0;
};
template <int K>
struct parasitic_root<bdf<K>> {
    static constexpr double modulus = std::array{0.0, 0.0, 0.3334, 0.4265, 0.5609, 0.7088, 0.8634}[K]; // rounded up
};
/// A generating function whose weights have a sum of exponentials here.
template <class G>
concept strongly_damped = generating_function<G> and requires {
    parasitic_root<G>::modulus;
};

namespace detail::memory {

/// The scalar in which modes are computed: double for float; S itself for others, with nodes by double-double products.
template <class S>
struct modes_in {
    using type = std::conditional_t<std::is_same_v<S, float>, double, S>;
};
template <class S>
using modes_scalar = typename modes_in<S>::type;

template <class S>
S sine_of_pi_times(S const& alpha) { // accurate next to whole numbers
    using std::atan, std::floor, std::sin;
    S const half = S(1) / S(2), whole = floor(S(alpha + half)), even = S(2) * floor(S(whole / S(2)));
    S const value = sin(S(S(4) * atan(S(1)) * (alpha - whole)));
    return even == whole ? value : S(-value);
}

/// w_n = -(sin(pi alpha)/pi) sum_j weight_j exp(-node_j (n - first)) for first <= n <= last.
template <class G, class W>
class cut_integral {
public:
    cut_integral(W const& alpha, index_type first, index_type last, W const& tolerance) : alpha_(alpha), first_(first), last_(last) {
        using std::atan, std::log;
        auto const p = G::template numerator<W>();
        W sum(0);
        for (std::size_t i = 0; i + 1 < p.size(); ++i) {
            sum = sum + p[i] / p[0];
            q_.push_back(sum);
        }
        digits_ = -log(tolerance);
        factor_ = -sine_of_pi_times(alpha) / pi();
    }
    /// The trapezoidal rule in ln s with steps `refinement` times as short as the tolerance asks for.
    quadrature<W> trapezoidal_rule(int refinement = 1) const {
        using std::exp, std::log;
        using wide = typename wider<W>::type;
        W y(1); // the rule with steps 2 pi/y misses s^alpha by 2 |Gamma(1 + alpha + iy)| / Gamma(1 + alpha) < 6 y^{1/2 + alpha} e^{-pi y/2}
        for (int i = 0; i < 20; ++i) y = W(2) * (digits_ + W(3) + (W(1) / W(2) + alpha_) * log(W(y + W(1)))) / pi();
        W const ratio = exp(W(W(2) * pi() / (y * W(refinement)))), step = log(ratio);
        // Below: s^{1+alpha} against its value at 1/last. Above: e^{-s(first - alpha)} against the largest of the integrand.
        W const lowest = exp(-(digits_ + W(2)) / (W(1) + alpha_)) / W(static_cast<double>(last_));
        W const positive = alpha_ < W(0) ? W(0) : alpha_, lead = W(static_cast<double>(first_)) - positive;
        W highest = (digits_ + W(3) + positive * log(digits_)) / lead;
        // q has no zero up to a parasitic root; beyond it there is no contribution to the weights from `first` on.
        if (parasitic_root<G>::modulus > 0) highest = std::min(highest, W(W(99) / W(100) * -log(W(parasitic_root<G>::modulus))));
        quadrature<W> rule;
        wide s(static_cast<int>(1));
        while (static_cast<W>(s) < highest) s = s * wide(ratio);
        for (; lowest < static_cast<W>(s); s = s / wide(ratio)) {
            W const node = static_cast<W>(s);
            if (node > highest) continue;
            rule.node.push_back(node);
            rule.weight.push_back(step * node * density(node));
        }
        return rule;
    }
    /// The same with the nodes below reach/last merged.
    quadrature<W> rule() const {
        quadrature<W> all = trapezoidal_rule(), low, result;
        W const limit = W(reach) / W(static_cast<double>(last_));
        for (std::size_t i = 0; i < all.node.size(); ++i) {
            auto& to = all.node[i] < limit ? low : result;
            to.node.push_back(all.node[i]);
            to.weight.push_back(all.weight[i]);
        }
        // The best polynomial of degree 2m - 1 misses e^{-x}, 0 <= x <= X, by 2 e^{-X/2} (X/4)^{2m} / (2m)! e^{X^2/(32m + 16)} at most, and
        // there is X^{1+alpha}/Gamma(2+alpha) times as much of it as of the weight: for X = 8 less than 5 (X/4)^{2m} / (2m)! in all.
        std::size_t m = 1;
        for (W left(5); left > exp_of_minus_digits() / W(4); ++m)
            left = left * W(reach * reach) / W(static_cast<int>(16 * (2 * m - 1) * (2 * m)));
        auto const merged = gauss(low, m);
        result.node.insert(result.node.end(), merged.node.begin(), merged.node.end());
        result.weight.insert(result.weight.end(), merged.weight.begin(), merged.weight.end());
        return result;
    }
    W const& factor() const { return factor_; }

private:
    static constexpr int reach = 8; // where one more Gauss node gains as much as one of the trapezoidal rule
    static W pi() {
        using std::atan;
        return W(4) * atan(W(1));
    }
    W exp_of_minus_digits() const {
        using std::exp;
        return exp(W(-digits_));
    }
    /// e^{-first s} ((e^s - 1) q(e^s))^alpha = e^{-s(first - alpha)} ((1 - e^{-s}) q(e^s))^alpha.
    W density(W const& s) const {
        using std::exp, std::expm1, std::pow;
        W const z = exp(s);
        W q(0);
        for (std::size_t i = q_.size(); i-- > 0;) q = q * z + q_[i];
        return exp(W(-s * (W(static_cast<double>(first_)) - alpha_))) * pow(W(-expm1(W(-s)) * q), alpha_);
    }
    W alpha_, digits_, factor_;
    index_type first_, last_;
    std::vector<W> q_;
};

} // namespace detail::memory
} // namespace hilger
