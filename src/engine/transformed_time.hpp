// SPDX-License-Identifier: BSL-1.0
// Motions in a transformed time dt = g(q) dtau (hilger/variational/time_transformation.hpp): a method steps g (L(q, q'/g) + E) on T, which
// is in tau, with the energy E of the initial values. States are at the times t, the sum of g over the nodes of the method; between them,
// and for the energy, the motion is that of L.
#pragma once

#include <iomanip>
#include <sstream>

#include "engine/motions.hpp"

namespace engine {

/// Adds up the times along a walk in tau.
template <class S>
class cursor_in_time final : public cursor<S> {
public:
    cursor_in_time(std::unique_ptr<cursor<S>> in_tau, step_integral<S> over, std::function<S(vector<S> const&)> rate)
        : in_tau_(std::move(in_tau)), over_(std::move(over)), rate_(std::move(rate)), last_(in_tau_->state()), t_(S(0)) {
        t_.add(last_.t);
    }
    using cursor<S>::advance;
    void advance(hilger::index_type steps, keeper<S> const& keep) override {
        in_tau_->advance(steps, [&](S const& tau, vector<S> const& q, vector<S> const& p) {
            engine::state<S> next{tau, q, p};
            t_.add(over_(number_, last_, next));
            last_ = std::move(next);
            ++number_;
            return not keep or keep(t_.value(), q, p);
        });
    }
    [[nodiscard]] hilger::index_type number() const override { return number_; }
    [[nodiscard]] engine::state<S> state() const override { return {t_.value(), last_.q, last_.p}; }
    [[nodiscard]] vector<S> velocity() const override { return in_tau_->velocity() / rate_(last_.q); }
    /// It repeats the walk instead.
    bool save(std::ostream&) const override { return false; }
    void load(std::istream&, std::string const&) override {}

private:
    std::unique_ptr<cursor<S>> in_tau_;
    step_integral<S> over_;
    std::function<S(vector<S> const&)> rate_;
    engine::state<S> last_; ///< with tau
    hilger::index_type number_ = 0;
    hilger::detail::running_sum<S, S> t_;
};

template <class S>
class motion_in_time final : public motion_of_mechanics<S, free_problem> {
    using base = motion_of_mechanics<S, free_problem>;

public:
    motion_in_time(problem const& what, std::string method, points<S> T)
        : base(free_problem{what.lagrangian, {}}), what_(what), method_(std::move(method)), T_(std::move(T)) {
        require_constant_energy(what);
        in_tau_ = with_energy(S(0)); // reports a wrong method or scale
        in_t_ = make_motion<S>({what_.lagrangian, {}, {}, what_.history}, method_, T_);
    }
    [[nodiscard]] std::unique_ptr<cursor<S>> begin(initial<S> const& from) const override {
        auto const [start, in_tau] = started(from);
        std::function<S(vector<S> const&)> const g = [rate = *what_.time_transformation](vector<S> const& q) {
            return rate.value(S(0), [&](int k) { return S(q(k)); });
        };
        if (S const at_start = g(start.q0); not(S(0) < at_start))
            hilger::error::raise<hilger::error::invalid_parameter>("a transformed time goes on, dt/dtau = g(q) > 0, and at the start g is ",
                                                                   at_start);
        return std::make_unique<cursor_in_time<S>>(in_tau->begin(start), in_tau->integral_of(g), g);
    }
    /// The points of T, in tau.
    [[nodiscard]] std::vector<S> times() const override { return in_tau_->times(); }
    [[nodiscard]] joined<S> between(vector<S> const&, vector<S> const&, std::vector<vector<S>> const&,
                                    std::stop_token const&) const override {
        hilger::error::raise<hilger::error::invalid_parameter>(
            "in a transformed time a motion starts from q0 and v0 or p0, which have its energy: two ends do not");
    }
    [[nodiscard]] S residual(initial<S> const& from, std::vector<vector<S>> const& positions, std::vector<vector<S>> const& momenta,
                             bool absolute) const override {
        auto const [start, in_tau] = started(from);
        return in_tau->residual(start, positions, momenta, absolute);
    }
    /// By L in t.
    [[nodiscard]] state<S> between_states(state<S> const& x, state<S> const& y, S const& t) const override {
        return in_t_->between_states(x, y, t);
    }
    [[nodiscard]] step_integral<S> integral_of(std::function<S(vector<S> const&)> g) const override {
        return in_tau_->integral_of(std::move(g));
    }

private:
    [[nodiscard]] std::unique_ptr<motion<S>> with_energy(S const& E) const {
        if (not hilger::is_finite(E)) hilger::error::raise<hilger::error::not_finite>("the energy at the start is ", E);
        std::ostringstream digits;
        digits << std::setprecision(std::numeric_limits<S>::max_digits10) << E;
        hilger::text::stated const energy(hilger::text::expression::number(digits.str()), hilger::text::no_words(), "the energy");
        return make_motion<S>({what_.lagrangian.in_time(*what_.time_transformation, energy), {}, {}, what_.history}, method_, T_);
    }
    /// The start with a momentum, which is that of L, and the motion of its energy.
    [[nodiscard]] std::pair<initial<S>, std::unique_ptr<motion<S>>> started(initial<S> const& from) const {
        if (from.is == second_datum::next_position)
            hilger::error::raise<hilger::error::invalid_parameter>(
                "in a transformed time a motion starts from q0 and v0 or p0, which have its energy: two positions do not");
        for (vector<S> const* x : {&from.q0, &from.other}) this->require_coordinates(*x);
        initial<S> start = from;
        S const t(0); // L does not contain it
        bool const has_velocity = from.is == second_datum::velocity;
        if (has_velocity) start.other = hilger::momentum_of(hilger::detail::at_time{what_.lagrangian, t}, from.q0, from.other);
        start.is = second_datum::momentum;
        vector<S> const near = has_velocity ? from.other : vector<S>::Zero(from.q0.size());
        return {start, with_energy(this->energy({t, start.q0, start.other}, near))};
    }
    problem what_;
    std::string method_;
    points<S> T_;
    std::unique_ptr<motion<S>> in_tau_; ///< of energy 0
    std::unique_ptr<motion<S>> in_t_;   ///< of L
};
/// The motion of a problem with a transformation of time. @throws hilger::error::invalid_parameter
template <class S>
std::unique_ptr<motion<S>> in_transformed_time(problem const& what, std::string const& method, points<S> const& T) {
    return std::make_unique<motion_in_time<S>>(what, method, T);
}

} // namespace engine
