// SPDX-License-Identifier: BSL-1.0
#include "outer_solar_system_data.hpp"
#include "path_walk.hpp"
#include "scenes.hpp"
#include "solar_system.hpp"
#include "systems.hpp"

namespace program {

namespace {

/// The system of solar_system.hpp in any scalar.
struct outer_solar_system_in {
    solar_system data;
    static constexpr in_many_digits wide = in_many_digits::gauss;
    template <class S>
    [[nodiscard]] auto lagrangian() const {
        auto const list = hilger::all_pairs(bodies);
        std::vector<S> strength;
        for (auto const& [a, b] : list) strength.push_back(S(solar_system::gravity) * S(data.mass(3 * a)) * S(data.mass(3 * b)));
        return hilger::mechanical(column<S, dimension>(data.mass.cast<S>()),
                                  hilger::pairs<3>(list, [strength](hilger::index k, auto const& r) {
                                      return -strength[static_cast<std::size_t>(k)] / r.norm();
                                  }));
    }
    template <class S>
    [[nodiscard]] auto start() const {
        return hilger::initial_velocity<column<S, dimension>>{data.q.cast<S>(), data.v.cast<S>()};
    }
    /// Energy and the three components of the angular momentum.
    template <class L, class State>
    [[nodiscard]] auto invariants(L const& l, State const& x) const {
        using S = scalar_of_state<State>;
        std::vector<S> all{S(x.p.dot(x.p.cwiseQuotient(l.mass())) / S(2) + l.potential()(x.q)), S(0), S(0), S(0)};
        for (int i = 0; i < dimension; i += 3)
            for (int c = 0; c < 3; ++c) {
                int const a = (c + 1) % 3, b = (c + 2) % 3;
                all[static_cast<std::size_t>(c) + 1] += x.q(i + a) * x.p(i + b) - x.q(i + b) * x.p(i + a);
            }
        return all;
    }
};

} // namespace

scene outer_solar_system() {
    std::istringstream built_in(outer_solar_system_csv);
    outer_solar_system_in const system{read_solar_system(built_in, "the built-in data")};
    scene s;
    s.name = "outer-solar-system";
    s.title = "Sun, Jupiter, Saturn, Uranus, Neptune, Pluto from 5 September 1994";
    s.units = "days";
    s.dimension = dimension;
    s.t1 = 20'000;
    s.usual = {"mid-point", "double", "", 400};
    s.columns = {"t"};
    for (char const* x : {"", "p_"})
        for (auto const& name : system.data.names)
            for (char const* c : {"x", "y", "z"}) s.columns.push_back(name + ' ' + x + c);
    s.invariants = {"energy", "angular momentum x", "angular momentum y", "angular momentum z"};
    for (auto const& name : s.invariants) s.columns.push_back(name + " error");
    s.picture =
        "set title 'Orbits'; set size ratio -1; set xlabel 'x / au'; set ylabel 'y / au'\n"
        "plot for [k=0:5] DATA using (column(2+3*k)):(column(3+3*k)) with lines notitle\n"
        "set size noratio; set title 'Energy error'; set xlabel 't / days'; set ylabel ''; plot DATA using 1:38 with lines notitle\n";
    s.reference = {"gauss-16", "100-digits", "", 300};
    return scene_of(system, s);
}

} // namespace program
