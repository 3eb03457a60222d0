// SPDX-License-Identifier: BSL-1.0
// Histories of orders next to 0 and 1 against the sum in 50 digits, as the direct sum, in blocks, and by exponentials.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;

constexpr int count = 3000;
double value(int n) { return 1 + std::cos(0.1 * n); }

/// sum_{n>=1} w_n x_{m-n} after m = count values, in 50 digits, and the sum of the magnitudes.
struct reference {
    float50 sum{0}, size{0};
    explicit reference(double alpha) {
        float50 w(1);
        for (int n = 1; n <= count; ++n) {
            w *= (n - 1 - float50(alpha)) / n;
            sum += w * value(count - n);
            size += abs(w) * value(count - n);
        }
    }
};
template <class Policy>
row one(char const* name, Policy const& policy, double alpha, char const* order, reference const& exact, double bound) {
    auto history = make_history<grunwald_letnikov>(policy, alpha, 0.0);
    for (int n = 0; n < count; ++n) history.push(value(n));
    return kept(std::string("history of 3000 values, ") + name + ", order " + order, in_epsilons(history.past(), exact.sum, exact.size),
                bound);
}

} // namespace

rows histories(scope) {
    rows all;
    struct {
        double alpha;
        char const* name;
        double of_blocks; ///< the transform rounds in epsilons of the largest weights
    } const orders[]{{1e-300, "1e-300", 4}, {1e-15, "1e-15", 16}, {1 - 1e-15, "1 - 1e-15", 32}, {1, "1 at run time", 32}};
    for (auto const& [alpha, name, of_blocks] : orders) {
        reference const exact(alpha);
        // The weights decrease, so most of the 3000 additions round in epsilons of small terms.
        all.push_back(one("direct", direct{}, alpha, name, exact, 4));
        all.push_back(one("blocks", blocks{}, alpha, name, exact, of_blocks));
        all.push_back(one("exponentials", exponentials{}, alpha, name, exact, 4));
    }
    all.push_back(refused<error::invalid_parameter>(
        "exponentials of order 2 + eps", [] { (void)make_history<grunwald_letnikov>(exponentials{}, 2 * (1 + epsilon<double>()), 0.0); }));
    all.push_back(refused<error::invalid_parameter>("exponentials to a tolerance below epsilon",
                                                    [] { (void)make_history<grunwald_letnikov>(exponentials{1e-17}, 0.5, 0.0); }));
    return all;
}

} // namespace extremes
