// SPDX-License-Identifier: BSL-1.0
// Differences at steps as small as the scale allows: the function's rounding divided by h, and no more.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;

/// f at the points of T in double, and at the exact points a + ih in 50 digits.
struct sampled {
    double a, h;
    static constexpr index_type N = 64;
    auto scale() const { return uniform(a, h, N); }
    auto values() const {
        return tabulate(function_on(scale(), [](double t) { return std::exp(t); }));
    }
    float50 exact(index_type i) const { return exp(float50(a) + float50(i) * float50(h)); }
    /// Rounding of a value in epsilons: of exp, and of its argument t.
    double rounding() const { return 1 + std::abs(a) + N * h; }
};

/// The largest error of a local difference, in epsilons of |f| / h.
template <class Operator>
double local(sampled const& f, Operator const& difference, index_type first, index_type last, index_type before) {
    auto const d = difference[f.values()];
    double worst = 0;
    for (index_type i = first; i <= last; ++i) {
        float50 const exact = (f.exact(i + 1 - before) - f.exact(i - before)) / f.h;
        worst = std::max(worst, in_epsilons(d[i], exact, float50(f.exact(i) / f.h)));
    }
    return worst;
}
/// The same of the fractional one, in epsilons of |f| h^-alpha.
double fractional(sampled const& f, double alpha) {
    auto const d = Delta_minus(alpha)[f.values()];
    float50 const scale = pow(float50(f.h), -float50(alpha));
    auto const w = first_weights<grunwald_letnikov>(float50(alpha), f.N + 1);
    double worst = 0;
    for (index_type k = 0; k <= f.N; ++k) {
        float50 sum(0);
        for (index_type n = 0; n <= k; ++n) sum += w[static_cast<std::size_t>(n)] * f.exact(k - n);
        worst = std::max(worst, in_epsilons(d[k], float50(sum * scale), float50(f.exact(f.N) * scale)));
    }
    return worst;
}

} // namespace

rows differences(scope) {
    rows all;
    for (auto const& [a, h] : {std::pair{0.0, 1e-3}, {0.0, 1e-12}, {1.0, 1e-12}, {1.0, 2e-15}, {0.0, 1e-200}, {0.0, 1e-300}}) {
        sampled const f{a, h};
        std::string const at = " of exp at a = " + few_digits(a) + ", h = " + few_digits(h) + ", of |f|/h";
        // Both values round, and so do three operations.
        double const bound = 2 * f.rounding() + 2;
        all.push_back(kept("Delta_+" + at, local(f, Delta_plus, 0, f.N - 1, 0), bound));
        all.push_back(kept("Delta_-" + at, local(f, Delta_minus, 1, f.N, 1), bound));
    }
    for (auto const& [a, h] : {std::pair{0.0, 1e-3}, {1.0, 1e-12}, {0.0, 1e-300}}) {
        sampled const f{a, h};
        // The weights decrease, and their magnitudes add up to 2; products and sums round in epsilons of them.
        for (double const alpha : {0.25, 0.75})
            all.push_back(
                kept("Delta_-^" + few_digits(alpha) + " of exp at a = " + few_digits(a) + ", h = " + few_digits(h) + ", of |f|/h^alpha",
                     fractional(f, alpha), 2 * f.rounding() + 4));
    }
    all.push_back(refused<error::invalid_scale>("h = 1e-16 beside a = 1", [] { (void)uniform(1.0, 1e-16, 4); }));
    all.push_back(refused<error::invalid_scale>("h = 5e-324, which has no half", [] { (void)uniform(0.0, 5e-324, 4); }));
    return all;
}

} // namespace extremes
