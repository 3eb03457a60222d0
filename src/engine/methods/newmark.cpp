// SPDX-License-Identifier: BSL-1.0
// Linear structures with a memory by Newmark's scheme, known at run time only.
#include "engine/methods/newmark.hpp"

#include "engine/methods/histories.hpp"
#include "engine/motions.hpp"

namespace engine {

namespace {

class structure_motion : public motion<double> {
public:
    structure_motion(problem what, std::string method, points<double> const& T)
        : what_(std::move(what)), method_(std::move(method)), structure_(what_), energy_(hilger::energy(what_.lagrangian)),
          T_(hilger::uniform(T.start, T.step, T.steps)) {
        structure_.require_valid();
    }

    void walk(initial<double> const& from,
              std::function<bool(double const&, vector<double> const&, vector<double> const&)> const& keep) const override {
        if (from.is == second_datum::next_position) refuse("starts from q0 and v0 or p0, and not from two positions");
        with_history(what_.history, T_.steps(), [&](auto const& policy) {
            structure_.with_scheme(method_, policy, [&](auto const& scheme) {
                auto const q = taken_by<double>(scheme, from.q0), other = taken_by<double>(scheme, from.other);
                auto const p = from.is == second_datum::momentum ? other : scheme.momentum(T_.point(0), q, other);
                for (auto const& x : scheme.along(T_, q, p))
                    if (not keep(x.t, as_vector<double>(x.q), as_vector<double>(x.p))) return;
            });
        });
    }
    [[nodiscard]] std::vector<double> times() const override { return elements_of<double>(T_); }
    [[nodiscard]] joined<double> between(vector<double> const&, vector<double> const&, std::vector<vector<double>> const&,
                                         std::stop_token const&) const override {
        refuse("is solved from initial values");
    }
    [[nodiscard]] double residual(initial<double> const&, std::vector<vector<double>> const&, std::vector<vector<double>> const&,
                                  bool) const override {
        refuse("has no discrete Euler-Lagrange equation");
    }
    [[nodiscard]] std::string equation(bool latex_wanted) const override {
        std::string const scheme = method_ == "gl-newmark" ? "Newmark's scheme"
                                   : latex_wanted          ? R"(the $G^{\alpha}$-Newmark scheme)"
                                                           : "the G^alpha-Newmark scheme";
        if (latex_wanted)
            return (what_.material ? R"(M \ddot{q} + \tfrac{E_\infty}{E_0} K (q - q_a) = f, \quad q_a + \tau^{\alpha} D^{\alpha}[q_a] =)"
                                     R"( \left(1 - \tfrac{E_0}{E_\infty}\right) q)"
                                   : R"(M \ddot{q} + \rho D^{\alpha}[q] + K q = f)") +
                   (R"(\quad\text{by )" + scheme + "}");
        return (what_.material ? "M q̈ + (E∞/E₀) K (q − qₐ) = f,   qₐ + τᵅ Dᵅ[qₐ] = (1 − E₀/E∞) q" : "M q̈ + ρ Dᵅ[q] + K q = f") +
               ("   by " + scheme + "\n");
    }
    [[nodiscard]] double energy(state<double> const& x, vector<double> const&) const override {
        return energy_(hilger::state<double, vector<double>>{x.t, x.q, x.p});
    }
    [[nodiscard]] state<double> between_states(state<double> const&, state<double> const&, double const&) const override {
        refuse("has a memory, which is no part of a state: there is nothing between the points of T");
    }

private:
    [[noreturn]] void refuse(char const* why) const {
        hilger::error::raise<hilger::error::invalid_parameter>("the method ", method_, " ", why);
    }
    problem what_;
    std::string method_;
    structure_of_problem<double> structure_;
    decltype(hilger::energy(std::declval<hilger::text::stated_lagrangian const&>())) energy_;
    decltype(hilger::uniform(0.0, 1.0, 1)) T_;
};

} // namespace

made by_newmark(problem const& what, std::string const& method, points<double> const& T) {
    if (not is_newmark(method)) return nullptr;
    if (not T.is_uniform()) hilger::error::raise<hilger::error::invalid_parameter>("the method ", method, " is for uniform scales");
    return std::make_unique<structure_motion>(what, method, T);
}

} // namespace engine
