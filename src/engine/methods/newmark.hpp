// SPDX-License-Identifier: BSL-1.0
// Newmark's scheme for linear structures with a memory: a Lagrangian of second degree, a force of the time alone, and one fractional term
// or a fractional Zener material.
#pragma once

#include "engine/methods/histories.hpp"
#include "engine/motions.hpp"
#include "engine/second_degree.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/zener.hpp"

namespace engine {

inline bool is_newmark(std::string const& method) { return method == "g-alpha-newmark" or method == "gl-newmark"; }

/// f + the force at t: a number for one coordinate, in any scalar.
template <class S, bool IsNumber>
class load_of_structure {
public:
    load_of_structure(vector<S> constant, std::optional<hilger::text::stated_force> force)
        : constant_(std::move(constant)), force_(std::move(force)) {}
    template <class T>
    auto operator()(T const& t) const {
        vector<T> f = constant_.template cast<T>();
        if (force_) {
            vector<T> const rest = vector<T>::Zero(f.size()); // the force does not read the state
            f += (*force_)(t, rest, rest);
        }
        if constexpr (IsNumber)
            return f(0);
        else
            return f;
    }
    /// The times of its jumps and kinks.
    template <class T>
    [[nodiscard]] std::vector<T> switching_times(T const& a, T const& b) const {
        return force_ ? force_->switching_times(a, b) : std::vector<T>{};
    }

private:
    vector<S> constant_;
    std::optional<hilger::text::stated_force> force_;
};

/// A problem as a linear structure.
template <class S>
class structure_of_problem {
public:
    /// @throws hilger::error::invalid_parameter naming a nonlinear term, or for other than one fractional term
    explicit structure_of_problem(problem const& what)
        : what_(what), parts_(second_degree_of<S>(what.lagrangian, what.lagrangian.formula().words().dimension())) {
        using hilger::text::meaning;
        if (what.force)
            for (auto const& f : what.force->formulas())
                if (f.reads(meaning::role::position) or f.reads(meaning::role::velocity))
                    hilger::error::raise<hilger::error::invalid_parameter>(
                        "the force on a linear structure depends on the time alone, and a spring belongs into the Lagrangian");
        if (what.damping.size() + (what.material ? 1 : 0) != 1)
            hilger::error::raise<hilger::error::invalid_parameter>(
                "Newmark's scheme has one fractional term or one material, and here are ", what.damping.size() + (what.material ? 1 : 0));
    }
    /// Checks the material's parameters. @throws hilger::error::invalid_parameter, hilger::error::mismatch
    void require_valid() const {
        if (what_.material) zener().require_valid();
    }
    /// Calls use(scheme), with the weights of the method, or those of G.
    template <class Policy, class Use>
    void with_scheme(std::string const& method, Policy const& policy, Use const& use) const {
        if (method == "gl-newmark")
            with_weights<hilger::grunwald_letnikov>(policy, use);
        else
            with_weights<hilger::bdf<2>>(policy, use);
    }
    template <hilger::generating_function G, class Policy, class Use>
    void with_weights(Policy const& policy, Use const& use) const {
        auto const with = [&]<bool IsNumber>(std::bool_constant<IsNumber>, auto const& structure) {
            use(hilger::newmark<G>(structure, load_of_structure<S, IsNumber>(parts_.load, what_.force), hilger::average_acceleration,
                                   policy));
        };
        if (what_.material) return with(std::false_type(), zener());
        if constexpr (std::same_as<S, double>) // in many digits, a vector of one component costs nothing more
            if (parts_.load.size() == 1) return with(std::true_type(), damped(parts_.mass(0, 0), parts_.stiffness(0, 0), S(1)));
        with(std::false_type(), damped(parts_.mass, parts_.stiffness, identity()));
    }

private:
    using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;
    [[nodiscard]] matrix identity() const { return matrix::Identity(parts_.load.size(), parts_.load.size()); }
    template <class B>
    auto damped(B const& mass, B const& stiffness, B const& one) const {
        auto const& term = what_.damping.front();
        return hilger::fractional_structure{mass, B(one * S(term.rho)), stiffness, S(1), S(term.alpha)};
    }
    auto zener() const {
        auto const& m = *what_.material;
        return hilger::zener_structure{parts_.mass,          parts_.stiffness, S(m.relaxed_modulus), S(m.unrelaxed_modulus),
                                       S(m.relaxation_time), S(m.alpha)};
    }
    problem what_;
    second_degree<S> parts_;
};

/// A state as the scheme stores it: a number for a scalar structure.
template <class S, class Scheme>
auto taken_by(Scheme const& scheme, vector<S> const& x) {
    if constexpr (requires {
                      { scheme.structure().mass } -> std::convertible_to<S>;
                  })
        return x(0);
    else
        return x;
}

/// The motion of a structure, on equal steps.
template <class S>
class structure_motion final : public motion<S> {
public:
    structure_motion(problem what, std::string method, points<S> const& T)
        : what_(std::move(what)), method_(std::move(method)), structure_(what_), energy_(hilger::energy(what_.lagrangian)),
          T_(uniform_scale_of(T)) {
        structure_.require_valid();
    }

    [[nodiscard]] std::unique_ptr<cursor<S>> begin(initial<S> const& from) const override {
        if (from.is == second_datum::next_position) refuse("starts from q0 and v0 or p0, and not from two positions");
        std::unique_ptr<cursor<S>> made;
        with_history(what_.history, T_.steps(), [&](auto const& policy) {
            structure_.with_scheme(method_, policy, [&](auto const& scheme) {
                auto const q = taken_by<S>(scheme, from.q0), other = taken_by<S>(scheme, from.other);
                auto const p = from.is == second_datum::momentum ? other : scheme.momentum(T_.point(0), q, other);
                made = cursor_along<S>(scheme.along(T_, q, p));
            });
        });
        return made;
    }
    [[nodiscard]] std::vector<S> times() const override { return elements_of<S>(T_); }
    [[nodiscard]] joined<S> between(vector<S> const&, vector<S> const&, std::vector<vector<S>> const&,
                                    std::stop_token const&) const override {
        refuse("is solved from initial values");
    }
    [[nodiscard]] S residual(initial<S> const&, std::vector<vector<S>> const&, std::vector<vector<S>> const&, bool) const override {
        refuse("has no discrete Euler-Lagrange equation");
    }
    [[nodiscard]] S energy(state<S> const& x, vector<S> const&) const override {
        return energy_(hilger::state<S, vector<S>>{x.t, x.q, x.p});
    }
    [[nodiscard]] state<S> between_states(state<S> const&, state<S> const&, S const&) const override {
        refuse("has a memory, which is no part of a state: there is nothing between the points of T");
    }

private:
    [[noreturn]] void refuse(char const* why) const {
        hilger::error::raise<hilger::error::invalid_parameter>("the method ", method_, " ", why);
    }
    problem what_;
    std::string method_;
    structure_of_problem<S> structure_;
    decltype(hilger::energy(std::declval<hilger::text::stated_lagrangian const&>())) energy_;
    hilger::uniform_scale<S> T_;
};

/// @throws hilger::error::invalid_parameter
template <class S>
std::unique_ptr<motion<S>> by_newmark(problem const& what, std::string const& method, points<S> const& T) {
    if (not is_newmark(method)) return nullptr;
    if (not T.is_uniform()) hilger::error::raise<hilger::error::invalid_parameter>("the method ", method, " is for uniform scales");
    return std::make_unique<structure_motion<S>>(what, method, T);
}

} // namespace engine
