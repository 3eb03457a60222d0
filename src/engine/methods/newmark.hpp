// SPDX-License-Identifier: BSL-1.0
// Linear structures with a memory - a Lagrangian of second degree, a force of the time alone, one fractional term or a fractional Zener
// material - by Newmark's scheme.
#pragma once

#include "engine/engine.hpp"
#include "engine/second_degree.hpp"
#include "hilger/fractional/newmark.hpp"
#include "hilger/fractional/zener.hpp"

namespace engine {

inline bool is_newmark(std::string const& method) { return method == "g-alpha-newmark" or method == "gl-newmark"; }

/// f + the force at t: a number where there is one coordinate, in any scalar.
template <class S, bool IsNumber>
class load_of_structure {
public:
    load_of_structure(vector<S> constant, std::optional<hilger::text::stated_force> force)
        : constant_(std::move(constant)), force_(std::move(force)) {}
    template <class T>
    auto operator()(T const& t) const {
        vector<T> f = constant_.template cast<T>();
        if (force_) {
            vector<T> const rest = vector<T>::Zero(f.size()); // which is not read
            f += (*force_)(t, rest, rest);
        }
        if constexpr (IsNumber)
            return f(0);
        else
            return f;
    }
    /// Where it jumps, or has a kink.
    template <class T>
    [[nodiscard]] std::vector<T> switching_times(T const& a, T const& b) const {
        return force_ ? force_->switching_times(a, b) : std::vector<T>{};
    }

private:
    vector<S> constant_;
    std::optional<hilger::text::stated_force> force_;
};

/// What a problem is as a structure.
template <class S>
class structure_of_problem {
public:
    /// @throws hilger::error::invalid_parameter that says what is not linear, or not one term
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
    /// Whether its numbers are what they have to be. @throws hilger::error::invalid_parameter, hilger::error::mismatch
    void require_valid() const {
        if (what_.material) zener().require_valid();
    }
    /// Calls use(scheme), with the weights that the method says; with those of G.
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
        if constexpr (std::same_as<S, double>) // of many digits, a vector of one costs nothing more
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

/// A state as that scheme takes it: a number where the structure is made of numbers.
template <class S, class Scheme>
auto taken_by(Scheme const& scheme, vector<S> const& x) {
    if constexpr (requires {
                      { scheme.structure().mass } -> std::convertible_to<S>;
                  })
        return x(0);
    else
        return x;
}

} // namespace engine
