// SPDX-License-Identifier: BSL-1.0
// Fractional damping at Radau's nodes: first steps of 1e-12, coefficients next to the ends of double's range, orders next to 0, 1 and 2.
// The residual of the equation is measured, with the damping summed by whole rows of weights, in roundings of its terms. It has no sharp
// bound: a sum of some hundred terms, and a step solved to rounding.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;

constexpr double bound = 16;

/// T on [0, 1] with a first step of 1e-12, each one eight times as long as the one before.
time_scale<double> steep() {
    std::vector<double> points{0};
    for (double t = 1e-12; t < 1; t *= 8) points.push_back(t);
    points.push_back(1);
    return time_scale<double>(points);
}
template <int Stages>
row roundings(std::string what, time_scale<double> const& T, double rho, double order) {
    auto const flow = embed(with_fractional_damping(pendulum, rho, order, exponentials{}), galerkin<Stages, radau>);
    return kept(std::move(what), relative_residual(flow.along(T, 1.0, 0.5)), bound, "roundings");
}

} // namespace

rows stages(scope) {
    rows all;
    struct {
        double order;
        char const* name;
    } constexpr orders[]{{1e-9, "1e-9"},         {0.5, "1/2"}, {1 - 1e-9, "1 - 1e-9"},
                         {1 + 1e-9, "1 + 1e-9"}, {1.5, "3/2"}, {2 - 1e-9, "2 - 1e-9"}};
    for (auto const& [order, name] : orders)
        all.push_back(roundings<3>(std::string("damping at three stages, a first step of 1e-12, order ") + name, steep(), 0.5, order));
    auto const T = graded(0.0, 1.0, 12, 3.0);
    for (double const rho : {1e-300, 1e-12, 1e12})
        all.push_back(roundings<2>("damping at two stages, rho = " + few_digits(rho), T, rho, 0.5));
    all.push_back(roundings<1>("damping at one stage, a first step of 1e-12", steep(), 0.5, 0.5));
    all.push_back(refused<error::outside_domain>("a step shorter than a history of stages was made for", [] {
        stage_history<double> history(collocation<double, radau>(2), 0.5, 1e-12, 1.0, 0.1, 0.0);
        history.begin(0.01);
    }));
    return all;
}

} // namespace extremes
