// SPDX-License-Identifier: BSL-1.0
// m u'' + c D^beta u + k u = f, u(0) = u0, u'(0) = v0, as a double power series, m = 1: from its Laplace transform
//   (s^2 + c s^beta + k) U = s u0 + v0 + f / s + c D,   D = u0 s^{beta-1} + v0 s^{beta-2}  (Caputo; the second where beta > 1),   D = 0
// (Riemann-Liouville, u = 0 before t = 0), with 1 / (s^2 + c s^beta + k) = sum_n (-1)^n (c s^beta + k)^n s^{-2n-2}, and s^-e the transform
// of t^{e-1} / Gamma(e). Nothing here is from the library but the scalars.
#pragma once

#include <cmath>

#include <boost/math/special_functions/gamma.hpp>

#include "../../../papers/table.hpp"
#include "hilger/multiprecision.hpp"

namespace hilger::testing {

template <class S>
struct fractional_oscillator {
    S c, beta, k, u0, v0, f;
    bool caputo = true;

    struct value {
        S u, v;
    };
    /// u(t) and u'(t), t > 0. Sums of size e^(sqrt(k) t) cancel: of d digits some d - t / 2 are right.
    value at(S const& t) const {
        value sum{S(0), S(0)};
        auto const add = [&](S const& factor, S const& power_of_s) {
            if (not(factor == S(0))) add_terms(sum, factor, power_of_s, t);
        };
        add(u0, S(1));
        add(v0, S(0));
        add(f, S(-1));
        if (caputo) add(S(c * u0), S(beta - 1));
        if (caputo and S(1) < beta) add(S(c * v0), S(beta - 2));
        return sum;
    }

private:
    /// factor s^power / (s^2 + c s^beta + k): terms (-1)^n C(n, j) c^j k^(n-j) s^(power - 2 - 2n + beta j), n from j on.
    void add_terms(value& sum, S const& factor, S const& power, S const& t) const {
        using boost::math::tgamma;
        using std::abs;
        using std::pow;
        S const tiny = std::numeric_limits<S>::epsilon() / 1000;
        S cj(factor);
        for (int j = 0;; ++j) {
            S e = S(2) - power + (S(2) - beta) * S(j);
            S term = cj * S(j % 2 == 0 ? 1 : -1) * pow(t, S(e - 1)) / tgamma(e);
            S largest(0);
            for (int n = j;; ++n) {
                sum.u += term;
                sum.v += term * S(e - 1) / t;
                S const size = abs(term) * (S(1) + abs(S(e - 1)) / t);
                if (largest < size) largest = size;
                if (size < tiny and S(n) > t) break;
                term = term * (-k) * S(n + 1) / S(n + 1 - j) * t * t / (e * (e + 1));
                e += 2;
            }
            if (largest < tiny and S(j) > t) break;
            cj *= c;
        }
    }
};

using papers::fitted_slope;

} // namespace hilger::testing
