// SPDX-License-Identifier: BSL-1.0
// Systems in text, along the trajectories that all others have.
#include "engine/machine_code/machine_code.hpp"
#include "from_file.hpp"
#include "histories.hpp"
#include "path_walk.hpp"

namespace program {

namespace {

using vector = Eigen::VectorXd;
using forced = hilger::problem<hilger::text::stated_lagrangian, hilger::text::stated_force>;

/// Where the energy is constant, how far it is from what it was.
struct observed {
    hilger::text::stated_lagrangian L;
    bool energy;
    template <class State>
    std::vector<double> operator()(State const& x) const {
        if (not energy) return {};
        return {hilger::energy(L)(x)};
    }
};
/// What is damped or driven may be both.
forced with_any_force(engine::problem const& of) {
    if (of.force) return {of.lagrangian, *of.force};
    auto const words = std::make_shared<hilger::text::vocabulary>(of.lagrangian.formula().words());
    std::vector<hilger::text::stated> const none(static_cast<std::size_t>(words->dimension()),
                                                 hilger::text::stated(hilger::text::expression(), words, "the force"));
    return {of.lagrangian, hilger::text::stated_force(none)};
}

/// Calls use(flow) with the one that is chosen.
template <class Use>
void with_flow(engine::problem const& of, configuration const& c, Use const& use) {
    std::vector<hilger::fractional_term<double>> terms;
    for (auto const& [rho, alpha] : of.damping) terms.push_back({rho, alpha});
    if (not terms.empty())
        with_history(c.history, c.steps, [&]<class Policy>(Policy const& policy) {
            if constexpr (not std::same_as<Policy, hilger::window>)
                use(hilger::embed(hilger::with_fractional_damping(with_any_force(of), terms, policy), hilger::mid_point));
        });
    else if (of.force) {
        forced const mechanics{of.lagrangian, *of.force};
        if (c.embedding == "order-one") use(hilger::embed(mechanics, hilger::order_one));
        if (c.embedding == "mid-point") use(hilger::embed(mechanics, hilger::mid_point));
        if (c.embedding == "gauss-4") use(hilger::embed(mechanics, hilger::galerkin<4, hilger::gauss>));
    } else {
        auto const& L = of.lagrangian;
        if (c.embedding == "order-one") use(hilger::embed(L, hilger::order_one));
        if (c.embedding == "mid-point") use(hilger::embed(L, hilger::mid_point));
        if (c.embedding == "verlet") use(hilger::stoermer_verlet(L));
        if (c.embedding == "gauss-4") use(hilger::embed(L, hilger::galerkin<4, hilger::gauss>));
        if (c.embedding == "gauss-8") use(hilger::embed(L, hilger::galerkin<8, hilger::gauss>));
    }
}

} // namespace

engine::vector<double> numbers_of(std::vector<std::string> const& digits) {
    vector x(static_cast<Eigen::Index>(digits.size()));
    for (std::size_t k = 0; k < digits.size(); ++k) x(static_cast<Eigen::Index>(k)) = *hilger::text::number_in<double>(digits[k]);
    return x;
}

std::vector<std::string> embeddings_of(stated_problem const& what) {
    if (not what.of.damping.empty()) return {"mid-point"};
    if (what.of.force) return {"order-one", "mid-point", "gauss-4"};
    return {"order-one", "mid-point", "verlet", "gauss-4", "gauss-8"};
}

engine::points<double> points_of(stated_problem const& what, hilger::index_type steps) {
    auto const number = [](std::string const& digits) { return *hilger::text::number_in<double>(digits); };
    auto const T = hilger::uniform(hilger::interval<double>{number(what.start), number(what.end)}, steps);
    return {T.min(), T.h(), steps, {}};
}

std::unique_ptr<walk> begin_stated(stated_problem const& what, configuration const& c) {
    engine::prepare_machine_code();
    auto const points = points_of(what, c.steps);
    std::unique_ptr<walk> made;
    with_flow(what.of, c, [&](auto const& flow) {
        hilger::initial_velocity<vector> const from{numbers_of(what.q), numbers_of(what.v)};
        made = walk_along(flow.along(hilger::uniform(points.start, points.step, points.steps), from),
                          observed{what.of.lagrangian, what.conserves_energy()});
    });
    return made;
}

engine::walker walker_of_member(engine::problem const& one, configuration const& c, engine::points<double> const& T) {
    return [one, c, T](engine::initial<double> const& from, auto const& keep) {
        with_flow(one, c, [&](auto const& flow) {
            hilger::initial_velocity<vector> const start{from.q0, from.other};
            for (auto const& x : flow.along(hilger::uniform(T.start, T.step, T.steps), start))
                if (not keep(x.t, x.q, x.p)) return;
        });
    };
}

} // namespace program
