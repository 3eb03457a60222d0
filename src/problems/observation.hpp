// SPDX-License-Identifier: BSL-1.0
// Quantities observed along a walk: invariants, and others.
#pragma once

#include "from_file.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

namespace program {

template <class S>
class observation {
    using vector = engine::vector<S>;
    using state = engine::state<S>;

public:
    explicit observation(stated_problem const& what)
        : conserves_energy_(what.conserves_energy()), conserved_(what.conserved), observed_(what.observed),
          derivatives_({what.of.lagrangian, {}}), energy_(hilger::energy(what.of.lagrangian)) {}
    /// `near` is a velocity near that of x.
    [[nodiscard]] std::vector<S> constants(state const& x, vector const& near) const {
        std::vector<S> all;
        if (conserves_energy_) all.push_back(energy_(hilger::state<S, vector>{x.t, x.q, x.p}, near));
        evaluate(conserved_, x, near, all);
        return all;
    }
    [[nodiscard]] std::vector<S> shown(state const& x, vector const& near) const {
        std::vector<S> all;
        evaluate(observed_, x, near, all);
        return all;
    }

private:
    void evaluate(std::vector<named_formula> const& formulas, state const& x, vector const& near, std::vector<S>& to) const {
        if (formulas.empty()) return;
        auto const v = hilger::detail::velocity_by(derivatives_, x.t, x.q, x.p, near);
        for (auto const& f : formulas) to.push_back(f.of.value(x.t, x.q, v));
    }
    bool conserves_energy_;
    std::vector<named_formula> conserved_, observed_;
    hilger::detail::kept_derivatives<hilger::problem<hilger::text::stated_lagrangian>> derivatives_;
    decltype(hilger::energy(std::declval<hilger::text::stated_lagrangian const&>())) energy_;
};

} // namespace program
