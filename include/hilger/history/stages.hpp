// SPDX-License-Identifier: BSL-1.0
// D^alpha, 0 <= alpha <= 2, on any T with the stages of a stiffly accurate Runge-Kutta method, D the inverse of its integral: Runge-Kutta
// convolution quadrature (Lubich, Ostermann 1993), and on uneven T its generalisation (Lopez-Fernandez, Sauter 2013). With one stage it is
// the power of Delta_-, on equal steps Gruenwald-Letnikov's. A step costs the same however many there were: no values are kept, but the
// modes of stage_modes.hpp. For values F_1, ..., F_s of a function that is 0 at t_0 (Caputo: less f(t_0)),
//   (D^alpha F)_i = sum_j leading_ij F_j + past_i,   leading = (nu A)^-alpha.
// Above order 1, D^alpha = D D^{alpha-1} and (D G)_i = sum_j (nu A)^-1_ij (G_j - g), g the last stage of the step before; at order 0, 1 and
// 2 there is no mode.
#pragma once

#include <span>

#include <Eigen/Core>

#include "hilger/history/component.hpp"
#include "hilger/history/stage_modes.hpp"
#include "hilger/history/sums.hpp"

namespace hilger {

namespace detail::memory {

struct stage_loop {
    /// mean <- mean + sum_i gain_i values_i - rate mean for n modes, those from the `brief`-th on compensated (sums.hpp).
    template <class S, int Bytes>
    HILGER_DETAIL_INLINE static void in(S const* gain, S const* rate, S* mean, std::size_t brief, std::size_t n, S const* values,
                                        std::size_t stages) {
        using P = typename pack<S, Bytes>::type;
        constexpr std::size_t width = pack<S, Bytes>::width;
        for (std::size_t j = 0; j < n; j += width) {
            P r, m, g;
            load(r, rate + j);
            load(m, mean + j);
            P change = -(r * m);
            for (std::size_t i = 0; i < stages; ++i) {
                load(g, gain + i * n + j);
                change = change + g * values[i];
            }
            if (j < brief)
                m = m + change;
            else {
                S* const low = mean + n + (j - brief);
                load(g, low);
                change = change + g;
                fast_two_sum(m, change, m, change);
                store(change, low);
            }
            store(m, mean + j);
        }
    }
};

/// A matrix of stages, rounded.
template <class S, class W>
Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> rounded(stage_matrix<W> const& a) {
    auto const size = static_cast<index_type>(a.size());
    Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic> m(size, size);
    for (std::size_t i = 0; i < a.size(); ++i)
        for (std::size_t j = 0; j < a.size(); ++j) m(static_cast<index_type>(i), static_cast<index_type>(j)) = static_cast<S>(a[i][j]);
    return m;
}

} // namespace detail::memory

template <class V>
class stage_history {
    using s = detail::shape<V>;
    using S = scalar_of<V>;
    using M = detail::memory::modes_scalar<S>;
    using W = typename detail::wider<S>::type;

public:
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

    /// For times up to t_0 + longest and steps from `shortest` on: a value's contribution to later ones is right to `tolerance`.
    /// Above order 1 that holds for D^{alpha-1}, of which differences are taken.
    /// @throws error::mismatch, error::invalid_parameter for a method that is not stiffly accurate, an order that is not between 0 and 2, a
    /// tolerance that the scalar cannot hold, and lengths that are not positive
    template <class Given>
    stage_history(runge_kutta<Given> const& given, S const& alpha, S const& tolerance, S const& longest, S const& shortest, V const& like)
        : stage_history(detail::memory::require_stiffly_accurate<S, W>(given), alpha, longest, shortest, s::dimension(like)) {
        if (not(S(least) * epsilon<S>() <= tolerance and S(10) * tolerance <= S(1)))
            error::raise<error::invalid_parameter>("the tolerance of a history of stages is between ", S(least) * epsilon<S>(), " (", least,
                                                   " epsilon of the scalar) and 1/10, not ", tolerance);
        if (not(beta_ == S(0))) make_modes(M(tolerance));
        mean_.assign((2 * rate_.size() - brief_) * static_cast<std::size_t>(past_.cols()), S(0));
    }

    /// Begins a step of length nu. Steps of one length, one after another, have their coefficients in common.
    /// @throws error::outside_domain if it is shorter than `shortest` or ends after `longest`, by more than a thousandth
    void begin(S const& nu) {
        S const slack = S(1) / S(1024);
        if (not(nu >= shortest_ - slack * shortest_))
            error::raise<error::outside_domain>("this history of stages was made for steps of ", shortest_, " and longer, and step ",
                                                count_, " has the length ", nu);
        if (not(time_ + nu <= longest_ + slack * longest_))
            error::raise<error::outside_domain>("this history of stages was made for a time of ", longest_, ", and step ", count_,
                                                " ends at ", time_ + nu);
        if (not(nu == nu_)) prepare(nu);
        for (index_type i = 0; i < past_.rows(); ++i)
            for (index_type c = 0; c < past_.cols(); ++c)
                past_(i, c) = sums_.product_sum(mean(c), answer_.data() + static_cast<std::size_t>(i) * rate_.size(), rate_.size());
        if (last_.rows() > 0) of_modes_ = past_;
        for (index_type k = 0; k < last_.rows(); ++k) past_ = derivative(past_, k);
        begun_ = 1;
    }
    /// Of the step that has begun, s x s.
    matrix const& leading() const { return leading_; }
    /// Of the step that has begun, at stage i = 0, ..., s - 1.
    V past(index_type i) const {
        V x = s::zero(static_cast<int>(past_.cols()));
        for (int c = 0; c < s::dimension(x); ++c) s::component(x, c) = past_(i, c);
        return x;
    }
    /// The values at the stages of the step that has begun, which ends it.
    /// @throws error::mismatch, error::not_finite
    void push(std::span<V const> values) {
        if (begun_ == 0) error::raise<error::mismatch>("step ", count_, " of a history of stages has not begun, and is given its values");
        if (static_cast<index_type>(values.size()) != past_.rows())
            error::raise<error::mismatch>("step ", count_, " of a history of stages has ", past_.rows(), " values, not ", values.size());
        for (index_type i = 0; i < past_.rows(); ++i) {
            V const& x = values[static_cast<std::size_t>(i)];
            detail::memory::check_value(x, static_cast<int>(past_.cols()), count_);
            for (int c = 0; c < past_.cols(); ++c) values_(i, c) = s::component(x, c);
        }
        if (last_.rows() > 0) of_modes_ += of_beta_.lazyProduct(values_); // D^beta F
        for (index_type k = 0; k < last_.rows(); ++k) {
            matrix const end = of_modes_.bottomRows(1);
            if (k + 1 < last_.rows()) of_modes_ = derivative(of_modes_, k);
            last_.row(k) = end;
        }
        for (index_type c = 0; c < past_.cols(); ++c)
            relax_(gain_.data(), rate_.data(), mean(c), brief_, rate_.size(), &values_(0, c), values.size());
        time_ = time_ + nu_;
        ++count_;
        begun_ = 0;
    }
    /// Everything that later values depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        S nu = nu_;
        each("steps", count_);
        each("begun", begun_);
        each("time", time_);
        each("step", nu);
        for (S& x : mean_) each("mode", x);
        for (matrix* m : {&last_, &past_, &of_modes_})
            for (index_type k = 0; k < m->size(); ++k) each("stage", m->data()[k]);
        if (not(nu == nu_)) prepare(nu);
    }
    index_type count() const { return count_; }
    void reset() {
        count_ = begun_ = 0;
        time_ = S(0);
        mean_.assign(mean_.size(), S(0));
        last_.setZero();
    }
    /// A multiple of the width of the loops.
    index_type modes() const { return static_cast<index_type>(rate_.size()); }
    std::size_t bytes() const {
        return 2 * node_.size() * sizeof(M) + (answer_.size() + gain_.size() + rate_.size() + mean_.size()) * sizeof(S);
    }

private:
    static constexpr int least = std::is_floating_point_v<M> ? 32 : 512;

    stage_history(runge_kutta<W> const& method, S const& alpha, S const& longest, S const& shortest, int size)
        : stage_history(detail::memory::stage_resolvent<S, W>(method.A), method.b, alpha, longest, shortest, size) {}
    stage_history(detail::memory::stage_resolvent<S, W> const& resolvent, std::vector<W> const& b, S const& alpha, S const& longest,
                  S const& shortest, int size)
        : alpha_(alpha), longest_(longest), shortest_(shortest), functions_(resolvent, b) {
        using std::floor;
        if (not(S(0) <= alpha and alpha <= S(2)))
            error::raise<error::invalid_parameter>("a history of stages has an order from 0 to 2, not ", alpha);
        if (not(is_finite(S(S(1) / (epsilon<S>() * epsilon<S>() * shortest))) and S(0) < shortest and shortest <= longest and
                is_finite(longest)))
            error::raise<error::invalid_parameter>(
                "a history of stages is made for steps above 0 and a time that is not below them, not for ", shortest, " and ", longest);
        beta_ = alpha - floor(alpha);
        auto const inverse = resolvent.inverse();
        auto power = resolvent.inverse_power(beta_), zero = power;
        power_of_beta_ = detail::memory::rounded<S>(power);
        for (auto& row : zero) row.assign(row.size(), W(0));
        index_type whole = 0;
        for (S rest = alpha; S(1) <= rest; rest = rest - S(1), ++whole) power = detail::memory::multiply_add(zero, W(1), inverse, power);
        inverse_ = detail::memory::rounded<S>(inverse);
        power_ = detail::memory::rounded<S>(power);
        values_ = of_modes_ = past_ = matrix::Zero(power_.rows(), size);
        last_ = matrix::Zero(whole, size);
    }
    /// In whole packs, the slow ones last: a mean is a sum of 1/rate terms, whose rounding grows like a random walk (exponentials.hpp).
    void make_modes(M const& tolerance) {
        detail::memory::stage_modes<M> const modes(functions_, M(beta_), tolerance, M(longest_), M(shortest_));
        M const terms = tolerance / (M(3) / M(2) * M(epsilon<S>())), least_rate = M(1) / (terms * terms);
        std::size_t const count = modes.node.size(), all = detail::memory::padded<S>(count);
        std::size_t slow = 0;
        while (slow < count and modes.node[slow] * M(shortest_) < least_rate) ++slow;
        brief_ = all - detail::memory::padded<S>(slow);
        node_.assign(all - count, modes.node.back());
        weight_.assign(all - count, M(0));
        node_.insert(node_.end(), modes.node.rbegin(), modes.node.rend());
        weight_.insert(weight_.end(), modes.weight.rbegin(), modes.weight.rend());
        rate_.resize(all);
        answer_.resize(all * functions_.stages());
        gain_.resize(all * functions_.stages());
    }
    void prepare(S const& nu) {
        using std::pow;
        nu_ = nu;
        leading_ = power_ * S(pow(nu, S(-alpha_)));
        of_beta_ = power_of_beta_ * S(pow(nu, S(-beta_)));
        std::vector<M> answer, gain, rate(rate_.size(), M(0));
        functions_.evaluate(node_, M(nu), answer, gain);
        for (std::size_t i = 0, n = rate.size(); i < functions_.stages(); ++i)
            for (std::size_t j = 0; j < n; ++j) {
                answer_[i * n + j] = static_cast<S>(M(-weight_[j] * answer[i * n + j]));
                gain_[i * n + j] = static_cast<S>(gain[i * n + j]);
                rate[j] = rate[j] + gain[i * n + j];
            }
        for (std::size_t j = 0; j < rate.size(); ++j) rate_[j] = static_cast<S>(rate[j]);
    }
    S* mean(index_type component) { return mean_.data() + static_cast<std::size_t>(component) * (2 * rate_.size() - brief_); }
    /// (nu A)^-1 (G - g), with g the last stage of the step before, of the k-th derivative.
    matrix derivative(matrix const& G, index_type k) const {
        matrix const change = G.rowwise() - last_.row(k);
        return inverse_.lazyProduct(change) / nu_;
    }

    S alpha_, beta_{}, longest_, shortest_, nu_{0}, time_{0};
    index_type count_ = 0, begun_ = 0;
    matrix inverse_, power_of_beta_, power_, of_beta_, leading_; ///< A^-1, A^-beta, A^-alpha; with nu: (nu A)^-beta, (nu A)^-alpha
    matrix values_, of_modes_, past_, last_;                     ///< stages x components; last_: of each whole order
    detail::memory::stage_functions<M> functions_;
    std::vector<M> node_, weight_;
    std::size_t brief_ = 0;
    detail::memory::line_vector<S> answer_, gain_, rate_, mean_; ///< mean_: of each component, then rounding errors of the slow ones
    detail::memory::sums<S> sums_;
    using loop = detail::memory::loop_for<detail::memory::stage_loop, S,
                                          void(S const*, S const*, S*, std::size_t, std::size_t, S const*, std::size_t)>;
    typename loop::function relax_ = loop::chosen();
};

} // namespace hilger
