// SPDX-License-Identifier: BSL-1.0
// The history of a fractional difference at constant cost a step: the first weights directly, all others as a sum of exponentials
// (modes.hpp), each of which is one recurrence of order one. No past values are kept.
#pragma once

#include <algorithm>

#include "hilger/history/direct.hpp"
#include "hilger/history/modes.hpp"
#include "hilger/history/recent.hpp"

namespace hilger {

/// For every n up to `steps` the weight used differs from w_n by at most tolerance |w_n|; without a tolerance 64 epsilon (1024 of a wide
/// scalar). This is checked when the history is made.
struct exponentials {
    double tolerance = 0;
    index_type steps = 1'000'000'000;
};

namespace detail::memory {

/// Weights, rates and coefficients of a generating function and an order.
template <class G, class S>
class exponential_weights {
    using W = modes_scalar<S>;

public:
    /// The smallest tolerance, in epsilon: the rounding of nodes and weights, and the check of wide scalars, which have no double-double.
    static constexpr int least = std::is_floating_point_v<W> ? 32 : 512;
    std::vector<S> first;             ///< w_1, ..., w_T
    line_vector<S> rate, coefficient; ///< w_n = sum_j coefficient_j (1 - rate_j)^{n-T-1} for n > T
    std::size_t brief = 0;            ///< the number of them, the first ones, that decay before rounding in their sums shows

    exponential_weights(S const& alpha, exponentials const& policy) {
        using std::floor;
        W const tolerance = policy.tolerance == 0 ? W(2 * least) * W(epsilon<S>()) : W(policy.tolerance);
        if (not holds(policy.tolerance))
            error::raise<error::invalid_parameter>("the tolerance of exponentials is between ", S(least) * epsilon<S>(), " (", least,
                                                   " epsilon of the scalar) and 1/10, not ", policy.tolerance);
        if (not has(alpha))
            error::raise<error::invalid_parameter>("exponentials represent the history of orders from -9/10 to 2, not ", alpha);
        if (policy.steps < 1) error::raise<error::invalid_parameter>("exponentials are made for one step or more, not for ", policy.steps);
        index_type const degree = static_cast<index_type>(G::template numerator<S>().size()) - 1;
        if (alpha == floor(alpha)) { // the weights end
            auto const all = first_weights<G, S>(alpha, 2 * degree + 1);
            for (index_type n = 1; S(static_cast<int>(n)) <= alpha * S(static_cast<int>(degree)); ++n)
                first.push_back(all[static_cast<std::size_t>(n)]);
            return;
        }
        index_type const taps = recent_values<S>::room(direct_terms(static_cast<double>(tolerance)));
        auto const all = first_weights<G, S>(alpha, taps + 1);
        first.assign(all.begin() + 1, all.end());
        index_type const last = std::max(policy.steps, taps + 1);
        cut_integral<G, W> const integral(W(alpha), taps + 1, last, tolerance);
        auto const rule = integral.rule();
        // A state is a sum of 1/rate terms, whose rounding grows like a random walk: 3/2 epsilon sqrt(1/rate) at most.
        W const terms = tolerance / (W(3) / W(2) * W(epsilon<S>())), least_rate = W(1) / (terms * terms);
        std::vector<std::pair<S, S>> modes, slow;
        for (std::size_t j = 0; j < rule.node.size(); ++j) {
            using std::expm1;
            W const r = -expm1(W(-rule.node[j]));
            (r < least_rate ? slow : modes).emplace_back(static_cast<S>(r), static_cast<S>(W(integral.factor() * rule.weight[j])));
        }
        std::size_t const together = padded<S>(modes.size() + slow.size());
        brief = together - padded<S>(slow.size());
        modes.resize(together - slow.size(), {S(1), S(0)});
        modes.insert(modes.end(), slow.begin(), slow.end());
        for (auto const& [r, c] : modes) rate.push_back(r), coefficient.push_back(c);
        check(alpha, taps + 1, last, tolerance);
    }

    static bool holds(double tolerance) { return tolerance == 0 or (W(tolerance) >= W(least) * W(epsilon<S>()) and tolerance * 10 <= 1); }
    static bool has(S const& alpha) { return S(-9) <= S(10) * alpha and alpha <= S(2); }

private:
    /// The parasitic roots' share of w_n, rho^n against n^{-1-alpha}, is below the tolerance from here on.
    static index_type direct_terms(double tolerance) {
        double const rho = parasitic_root<G>::modulus;
        return rho > 0 ? static_cast<index_type>((12 - std::log(tolerance)) / -std::log(rho)) : 8;
    }
    /// Against the recurrence for the first hundred n, then against a finer rule at powers of four.
    void check(S const& alpha, index_type n, index_type last, W const& tolerance) const {
        using std::exp, std::log1p;
        using wide = typename wider<W>::type;
        std::vector<wide> decay, term;
        for (std::size_t j = 0; j < rate.size(); ++j) {
            decay.push_back(wide(static_cast<int>(1)) - wide(W(rate[j])));
            term.push_back(wide(W(coefficient[j])));
        }
        weight_sequence<G, W> sequence{W(alpha)};
        for (index_type i = 0; i < n; ++i) sequence.next();
        for (index_type i = n; i < n + 100 and i <= last; ++i) {
            wide sum(static_cast<int>(0));
            for (std::size_t j = 0; j < term.size(); ++j) {
                sum = sum + term[j];
                term[j] = term[j] * decay[j];
            }
            compare(static_cast<W>(sum), sequence.next(), i, tolerance);
        }
        cut_integral<G, W> const integral(W(alpha), n, last, W(tolerance / W(1000)));
        auto const finer = integral.trapezoidal_rule(2);
        for (index_type distance = 64; n + distance <= last; distance *= 4) {
            W const d(static_cast<double>(distance));
            W modes(0), weight(0);
            for (std::size_t j = 0; j < rate.size(); ++j)
                if (rate[j] < S(1)) modes = modes + W(coefficient[j]) * exp(W(d * log1p(W(-W(rate[j])))));
            for (std::size_t j = 0; j < finer.node.size(); ++j)
                if (finer.node[j] * d < W(1000)) weight = weight + finer.weight[j] * exp(W(-finer.node[j] * d));
            compare(modes, W(integral.factor() * weight), n + distance, tolerance);
        }
    }
    static void compare(W const& modes, W const& weight, index_type n, W const& tolerance) {
        using std::abs;
        if (not(abs(W(modes - weight)) <= tolerance * abs(weight)))
            error::raise<error::invalid_parameter>("exponentials do not reach the tolerance ", tolerance, " in this scalar: weight ", n,
                                                   " is ", weight, " and they make it ", modes);
    }
};

} // namespace detail::memory

template <class G, class V>
class exponentials_history {
    using s = detail::shape<V>;
    using S = scalar_of<V>;

public:
    exponentials_history(exponentials const& policy, S const& alpha, V const& like)
        : exponentials_history(detail::memory::exponential_weights<G, S>(alpha, policy), policy.steps, like) {}

    /// sum_{n>=1} w_n x_{m-n} after m values; without the leading weight and h^-alpha.
    V const& past() const { return past_; }
    /// @throws error::mismatch, error::not_finite, error::outside_domain after one value more than the policy has steps
    void push(V const& x) {
        detail::memory::check_value(x, size_, count_);
        if (count_ > steps_)
            error::raise<error::outside_domain>("these exponentials were made for ", steps_, " steps, and this is step ", count_);
        for (int c = 0; c < size_; ++c) {
            auto const i = static_cast<std::size_t>(c);
            S const& value = s::component(x, c);
            s::component(past_, c) = recent_.first() * value + ahead_[i];
            S const entering = recent_.oldest(c);
            std::size_t const all = rate_.size();
            S* const state = state_.data() + i * (2 * all - brief_);
            ahead_[i] =
                recent_.push(value, c, sums_) + sums_.relax(rate_.data(), coefficient_.data(), state, state + all, brief_, all, entering);
        }
        recent_.advance();
        ++count_;
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        each("values", count_);
        recent_.visit(each);
        for (S& x : state_) each("mode", x);
        for (S& x : ahead_) each("ahead", x);
        detail::memory::visit_components("past", past_, each);
    }
    index_type count() const { return count_; }
    void reset() {
        recent_.reset();
        state_.assign(state_.size(), S(0));
        ahead_.assign(ahead_.size(), S(0));
        past_ = s::zero(size_);
        count_ = 0;
    }
    /// Terms of the sum of exponentials, a multiple of the width of the loops.
    index_type modes() const { return static_cast<index_type>(rate_.size()); }
    std::size_t bytes() const { return (rate_.size() + coefficient_.size() + state_.size() + ahead_.size()) * sizeof(S) + recent_.bytes(); }

private:
    exponentials_history(detail::memory::exponential_weights<G, S> w, index_type steps, V const& like)
        : size_(s::dimension(like)), steps_(steps), recent_(w.first, size_), brief_(w.brief), rate_(std::move(w.rate)),
          coefficient_(std::move(w.coefficient)), state_((2 * rate_.size() - brief_) * static_cast<std::size_t>(size_), S(0)),
          ahead_(static_cast<std::size_t>(size_), S(0)), past_(s::zero(size_)) {}

    int size_;
    index_type steps_, count_ = 0;
    detail::memory::recent_values<S> recent_;
    std::size_t brief_;
    detail::memory::line_vector<S> rate_, coefficient_;
    detail::memory::line_vector<S> state_; // of each component, then the rounding errors of the slow ones' sums
    std::vector<S> ahead_;
    V past_;
    detail::memory::sums<S> sums_;
};

/// @throws error::invalid_parameter for a tolerance that the scalar cannot hold, or an order that is not between -9/10 and 2.
template <generating_function G, class S, class V>
auto make_history(exponentials const& policy, S const& alpha, V const& like) {
    if constexpr (not detail::memory::same_scalar<S, V>)
        return detail::memory::scalars_differ<S, V>();
    else if constexpr (not strongly_damped<G>)
        return does_not_compile<
            "exponentials know Gruenwald-Letnikov and the BDF, for this generating function there are direct and blocks", G>{};
    else if constexpr (std::numeric_limits<S>::is_exact)
        return does_not_compile<"exponentials are accurate to a tolerance, for exact scalars there is direct", S>{};
    else
        return exponentials_history<G, plain_t<V>>(policy, alpha, like);
}

} // namespace hilger
