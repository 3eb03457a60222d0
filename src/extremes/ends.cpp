// SPDX-License-Identifier: BSL-1.0
// lambda next to 0 and to 1: there the theta embedding is order one and its mirror image, and T_lambda is T^+ and T^-.
#include "extremes/apart.hpp"
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;

constexpr int steps_made = 500;

template <class Flow, class Other>
double apart(Flow const& flow, Other const& other) {
    return extremes::apart(flow, other, uniform(0.0, 0.0625, steps_made), 1.0, 0.25);
}

} // namespace

rows ends(scope) {
    rows all;
    auto const right = embed(pendulum, order_one);
    auto const left = embed(pendulum, order_one_left);
    // A step with lambda = 1e-15 differs from one with 0 by h lambda dL/dq, a quarter of an epsilon; both round. Two of these schemes form
    // the same sums and agree exactly, unless a compiler contracts only one of them.
    double const bound = 400;
    all.push_back(kept("theta at lambda = 1e-300 is order one", apart(embed(pendulum, theta_at(1e-300)), right), bound));
    all.push_back(kept("theta at lambda = 1e-15 is order one", apart(embed(pendulum, theta_at(1e-15)), right), bound));
    all.push_back(kept("theta at lambda = 1 - 1e-15 is order one, left", apart(embed(pendulum, theta_at(1 - 1e-15)), left), bound));
    double const last = 1 - epsilon<double>() / 2;
    all.push_back(kept("theta at the last lambda below 1 is order one, left", apart(embed(pendulum, theta_at(last)), left), bound));
    all.push_back(
        kept("theta at lambda = 1/2 at run time is mid-point", apart(embed(pendulum, theta_at(0.5)), embed(pendulum, mid_point)), bound));
    all.push_back(refused<error::invalid_parameter>("theta at lambda = 0", [] { (void)theta_at(0.0); }));
    all.push_back(refused<error::invalid_parameter>("theta at lambda = 1", [] { (void)theta_at(1.0); }));
    all.push_back(refused<error::invalid_parameter>("theta at lambda = NaN", [] { (void)theta_at(std::nan("")); }));

    auto const T = uniform(0.0, 0.0625, 64);
    auto const exponential_of = [](double t) { return std::exp(t); };
    double const at_left = integral(function_on(T, exponential_of), T), at_right = nabla_integral(function_on(T, exponential_of), T);
    auto const integral_at = [&](double lambda) {
        auto const scale = at_lambda(T, lambda);
        return integral(function_on(scale, exponential_of), scale);
    };
    // Points, values and the sum round; e^t is at most t times as sensitive.
    all.push_back(kept("integral over T_lambda, lambda = 0", in_epsilons(integral_at(0), float50(at_left)), 0));
    all.push_back(kept("integral over T_lambda, lambda = 1e-15", in_epsilons(integral_at(1e-15), float50(at_left)), 4));
    all.push_back(
        kept("integral over T_lambda, lambda = 1 - 1e-15: the nabla integral", in_epsilons(integral_at(1 - 1e-15), float50(at_right)), 4));
    all.push_back(refused<error::invalid_parameter>("T_lambda, lambda = 1", [&] { (void)at_lambda(T, 1.0); }));
    all.push_back(refused<error::invalid_scale>("T_{o,lambda}, lambda = 1e-15: two points would be one",
                                                [&] { (void)circ(uniform(1.0, 0.0625, 64), 1e-15); }));
    all.push_back(refused<error::invalid_scale>("T_{o,lambda}, lambda = 1 - 1e-16", [&] { (void)circ(T, last); }));
    time_scale<double> const given{1.0, 2.0, 2.0 + 1e-15, 3.0};
    all.push_back(
        refused<error::invalid_scale>("T_{o,lambda} of points 1e-15 apart, lambda = 1/1024", [&] { (void)circ(given, 1.0 / 1024); }));
    auto const O = circ(T, 1e-12);
    bool ordered = true;
    for (index_type i = O.first(); i < O.last(); ++i)
        ordered = ordered and O.element(i) < O.element(i + 1) and O.sigma(O.element(i)) == O.element(i + 1);
    all.push_back(
        holds("T_{o,lambda}, lambda = 1e-12: sigma goes from each point to the next", "129 points in order", ordered and O.size() == 129));
    return all;
}

} // namespace extremes
