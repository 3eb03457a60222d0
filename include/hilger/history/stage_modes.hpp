// SPDX-License-Identifier: BSL-1.0
// The past of D^beta, 0 < beta < 1, as modes. With I the integral of a Runge-Kutta method,
//   D^beta = (sin(pi beta) / pi) Int_0^inf x^{beta-1} (1 + x I)^{-1} dx,
// and y = (1 + x I)^{-1} f is one recurrence for each x: on a step of length nu, with m the mean that the mode has of the values before it,
//   y = (1 + x nu A)^{-1} (f - m 1),   m <- m + x nu b y.
// So D^beta f = (nu A)^-beta f - sum_j weight_j m_j (1 + x_j nu A)^{-1} 1, and the sum has to be right for steps from the shortest one on
// and up to the longest time. The trapezoidal rule in u = ln x converges like exp(-pi^2/step). Where x is below 1 / longest time the
// integrand is smooth in x, and beyond 1 / shortest step in 1/x: there the rule's nodes are replaced by few Gauss nodes.
#pragma once

#include <algorithm>

#include "hilger/history/modes.hpp"
#include "hilger/history/runge_kutta.hpp"

namespace hilger::detail::memory {

template <class W>
class stage_modes {
public:
    std::vector<W> node, weight; ///< the lowest nodes first

    /// @throws error::invalid_parameter where the scalar does not reach the tolerance
    stage_modes(stage_functions<W> const& functions, W const& beta, W const& tolerance, W const& longest, W const& shortest)
        : functions_(functions), beta_(beta), longest_(longest), shortest_(shortest) {
        using std::log, std::pow;
        W const s = W(static_cast<int>(functions.stages()));
        W const size = pow(magnitude(functions.determinant()), W(W(1) / s)); // of the eigenvalues of A, as a mean
        low_ = std::min(W(8), W(W(2) / size)) / longest;
        high_ = W(1) / (size * shortest);
        auto const exact = kernels(trapezoidal_rule(W(W(8) - log(tolerance) * W(5) / W(4))));
        W error(0);
        for (int more = 0; more < 12; ++more) {
            auto const modes = rule(W(W(more) - log(tolerance)), W(W(1) + W(more) / W(4)));
            error = distance(kernels(modes), exact);
            if (not(error <= tolerance)) continue;
            node = modes.node;
            weight = modes.weight;
            return;
        }
        error::raise<error::invalid_parameter>("the modes of a history of stages do not reach the tolerance ", tolerance,
                                               " in this scalar, they miss it by ", error);
    }

private:
    struct kernel {
        W value, size; ///< size: the sum of the magnitudes
    };
    /// The trapezoidal rule to these digits (base e), nodes increasing. The last one stands for all from there on, whose terms are
    /// geometric: in 1/x it has their sum and their mean.
    quadrature<W> trapezoidal_rule(W const& digits) const {
        using std::atan, std::exp, std::expm1, std::log, std::pow;
        using wide = typename wider<W>::type;
        W const pi = W(4) * atan(W(1));
        W y(1); // as in modes.hpp, of x^{1+beta} e^{-x t}
        for (int i = 0; i < 20; ++i) y = W(2) * (digits + W(3) + (W(3) / W(2) + beta_) * log(W(y + W(1)))) / pi;
        W const ratio = exp(W(W(2) * pi / y)), step = log(ratio);
        W const lowest = low_ * exp(-(digits + W(2)) / (W(1) + beta_)), highest = high_ * exp(W(digits / W(2) + W(4)));
        W const factor = sine_of_pi_times(beta_) / pi * step;
        quadrature<W> rule;
        wide x = wide(high_);
        while (lowest < static_cast<W>(x)) x = x / wide(ratio);
        while (static_cast<W>(x) < highest) {
            x = x * wide(ratio);
            rule.node.push_back(static_cast<W>(x));
            rule.weight.push_back(factor * pow(rule.node.back(), beta_));
        }
        W const mass = -expm1(W((beta_ - W(1)) * step)), farther = -expm1(W((beta_ - W(2)) * step)) / mass;
        rule.node.back() = rule.node.back() * farther;
        rule.weight.back() = rule.weight.back() * farther / mass;
        return rule;
    }
    /// The same with Gauss nodes at both ends: in x for means that are x times integrals, and in 1/x for answers that are 1/x times
    /// (1/x + nu A)^{-1} 1.
    quadrature<W> rule(W const& digits, W const& between) const {
        auto const all = trapezoidal_rule(digits);
        quadrature<W> low, middle, high;
        for (std::size_t k = 0; k + 1 < all.node.size(); ++k) {
            W const &x = all.node[k], &w = all.weight[k];
            if (x * between < low_)
                add(low, x, W(w * x));
            else if (high_ * between < x)
                add(high, W(W(1) / x), W(w / x));
            else
                add(middle, x, w);
        }
        // The functions' poles are half of the interval's length below 0 or farther, and all of it on both sides of 0: Gauss's rule with n
        // nodes misses by 13.9^-n and by 21^-n.
        auto const few = [&](int percent) { return static_cast<std::size_t>(static_cast<double>(digits) * 100 / percent) + 1; };
        quadrature<W> result = gauss(low, few(263));
        for (std::size_t k = 0; k < result.node.size(); ++k) result.weight[k] = result.weight[k] / result.node[k];
        for (std::size_t k = 0; k < middle.node.size(); ++k) add(result, middle.node[k], middle.weight[k]);
        high = gauss(high, few(304));
        for (std::size_t k = 0; k < high.node.size(); ++k) add(result, W(W(1) / high.node[k]), W(high.weight[k] / high.node[k]));
        add(result, all.node.back(), all.weight.back()); // it has almost all of the mass next to order one
        return result;
    }
    static void add(quadrature<W>& q, W const& node, W const& weight) {
        q.node.push_back(node);
        q.weight.push_back(weight);
    }
    /// What a value at one stage contributes to another, over 1, 4, 16, ... steps of the shortest length between them, and from one step
    /// to the next where either or both have the length longest, longest/4, ...
    std::vector<kernel> kernels(quadrature<W> const& rule) const {
        std::size_t const s = functions_.stages(), count = rule.node.size();
        std::vector<W> answer, gain, far_answer, far_gain, decay(rule.weight);
        std::vector<kernel> result;
        auto const pair = [&](std::vector<W> const& weights, std::vector<W> const& a, std::vector<W> const& g) {
            for (std::size_t i = 0; i < s; ++i)
                for (std::size_t j = 0; j < s; ++j) {
                    kernel sum{W(0), W(0)};
                    for (std::size_t k = 0; k < count; ++k) {
                        W const term = weights[k] * (a[i * count + k] * g[j * count + k]);
                        sum.value = sum.value + term;
                        sum.size = sum.size + magnitude(term);
                    }
                    result.push_back(sum);
                }
        };
        std::vector<W> rate(count, W(0)), left(count, W(1)); // 1 - rate is left of a mode after 1, 4, 16, ... short steps
        functions_.evaluate(rule.node, shortest_, answer, gain);
        for (std::size_t k = 0; k < count; ++k) {
            left[k] = answer[(s - 1) * count + k]; // which is the stability function
            for (std::size_t j = 0; j < s; ++j) rate[k] = rate[k] + gain[j * count + k];
        }
        for (W time = longest_; shortest_ <= time; time = time / W(4)) {
            functions_.evaluate(rule.node, time, far_answer, far_gain);
            for (std::size_t k = 0; k < count; ++k) decay[k] = rule.weight[k] * left[k];
            pair(decay, answer, gain);
            pair(rule.weight, far_answer, far_gain);
            pair(rule.weight, far_answer, gain);
            pair(rule.weight, answer, far_gain);
            for (std::size_t k = 0; k < count; ++k)
                for (int twice = 0; twice < 2; ++twice) {
                    bool const is_slow = W(2) * rate[k] < W(1);
                    rate[k] = rate[k] * (W(2) - rate[k]);
                    left[k] = is_slow ? W(W(1) - rate[k]) : W(left[k] * left[k]);
                }
        }
        return result;
    }
    static W distance(std::vector<kernel> const& a, std::vector<kernel> const& b) {
        W worst(0);
        for (std::size_t k = 0; k < a.size(); ++k)
            if (W const error = magnitude(W(a[k].value - b[k].value)) / b[k].size; not(error <= worst)) worst = error;
        return worst;
    }
    stage_functions<W> const& functions_;
    W beta_, longest_, shortest_;
    W low_, high_; ///< the nodes below and above are replaced, or those farther out
};

} // namespace hilger::detail::memory
