// SPDX-License-Identifier: BSL-1.0
// Steps from 1e-12 to beyond the limit of stability: the oscillator against its linear map in 100 digits, in the stable and in the growing
// range, and equations without a solution.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;

/// A linear map of (q, p) in 100 digits, and its powers.
struct map {
    float100 a, b, c, d;
    friend map operator*(map const& x, map const& y) {
        return {x.a * y.a + x.b * y.c, x.a * y.b + x.b * y.d, x.c * y.a + x.d * y.c, x.c * y.b + x.d * y.d};
    }
};
/// 1, M, ..., M^n.
std::vector<map> powers(map const& M, index_type n) {
    std::vector<map> all{{1, 0, 0, 1}};
    while (static_cast<index_type>(all.size()) <= n) all.push_back(M * all.back());
    return all;
}
map order_one_map(float100 const& h) { return {1 - h * h, h, -h, 1}; }
map verlet_map(float100 const& h) { return {1 - h * h / 2, h, -h * (1 - h * h / 4), 1 - h * h / 2}; }
map midpoint_map(float100 const& h) {
    float100 const s = 1 + h * h / 4;
    return {(1 - h * h / 4) / s, h / s, -h / s, (1 - h * h / 4) / s};
}

/// The state after N steps against the power of the map, in epsilons of the largest component, times h when h > 1.
template <class Flow>
double against(Flow const& flow, map (*one_step)(float100 const&), double h, index_type N) {
    auto const end = last_of(flow.along(uniform(0.0, h, N), 1.0, 0.0));
    map const m = powers(one_step(float100(h)), N).back();
    // A step longer than the period adds h dL/dq to p, which rounds as q does.
    float100 const size = std::max(float100(abs(m.a)), float100(abs(m.c))) * std::max(1.0, h);
    return std::max(in_epsilons(end.q, m.a, size), in_epsilons(end.p, m.c, size));
}
template <class Flow>
void each_step(rows& all, std::string const& name, Flow const& flow, map (*one_step)(float100 const&),
               std::vector<std::pair<double, double>> const& lengths_with_bounds) {
    for (auto const& [h, bound] : lengths_with_bounds)
        all.push_back(kept("oscillator, " + name + ", 1000 steps of h = " + few_digits(h), against(flow, one_step, h, 1000), bound));
}
template <class Flow>
void overflow(rows& all, std::string const& name, Flow const& flow, double h) {
    bool finite = true;
    all.push_back(refused<error::not_finite>(
        name + " beyond its limit, h = " + few_digits(h) + ": grows until it overflows",
        [&] {
            for (auto const& x : flow.along(uniform(0.0, h, 100'000), 1.0, 0.0)) finite = finite and is_finite(x.q) and is_finite(x.p);
        },
        "the step from t = "));
    all.push_back(holds("    and no state with NaN or infinity was delivered", "none", finite));
}

} // namespace

rows steps(scope) {
    rows all;
    auto const euler = embed(oscillator, order_one);
    auto const verlet = stoermer_verlet(oscillator);
    auto const mid = embed(oscillator, mid_point);
    // For h = 1 and 2 explicit steps yield small multiples of 1/4. Long implicit steps round h dL/dq, with a bias.
    each_step(all, "order one", euler, order_one_map, {{1e-12, 4}, {1e-6, 20}, {1, 0}, {1.99, 500}, {2, 0}});
    each_step(all, "Stoermer-Verlet", verlet, verlet_map, {{1e-12, 4}, {1, 0}, {1.99, 300}});
    each_step(all, "mid-point", mid, midpoint_map, {{1e-12, 4}, {1e-6, 20}, {1, 100}, {2.5, 2000}, {1e3, 2e4}, {1e6, 4e4}});
    each_step(all, "Galerkin, order 8", embed(oscillator, galerkin<4, gauss>),
              [](float100 const& h) {
                  // The diagonal Pade approximation of exp of the generator
                  float100 const x = h * h, even = 1 - x * 3 / 28 + x * x / 1680, odd = h / 2 - h * x / 84, s = even * even + odd * odd;
                  return map{(even * even - odd * odd) / s, 2 * even * odd / s, -2 * even * odd / s, (even * even - odd * odd) / s};
              },
              {{1e-12, 4}, {1, 2000}, {100, 4e4}});
    // The rounding of the first steps grows as the solution does, and dominates.
    all.push_back(kept("growth beyond the limit, order one, 300 steps of h = 2.5", against(euler, order_one_map, 2.5, 300), 4));
    overflow(all, "order one", euler, 2.5);
    overflow(all, "order one, left", embed(oscillator, order_one_left), 2.5);
    overflow(all, "Stoermer-Verlet", verlet, 2.5);

    auto const cubic = [](auto const& x, auto const& v) { return v * v / 2 + 10 * x * x * x / 3; };
    all.push_back(refused<error::no_convergence>(
        "mid-point where a step has no solution", [&] { walk(embed(cubic, mid_point).along(uniform(0.0, 1.0, 3), 1.0, 0.0)); },
        "the step from t = 0"));
    all.push_back(refused<error::no_convergence>(
        "Galerkin where a step has no solution", [&] { walk(embed(cubic, galerkin<2, gauss>).along(uniform(0.0, 1.0, 3), 1.0, 0.0)); },
        "the step from t = 0"));
    // A large step of a pendulum either solves its equation or fails with an error.
    double worst = 0;
    int solved = 0, said = 0;
    for (double h = 0.5; h < 200; h *= 1.25) {
        try {
            auto const y = embed(pendulum, mid_point).step(state<double, double>{0, 1.0, 0.5}, h);
            float50 const v = (float50(y.q) - 1) / h, middle = (float50(y.q) + 1) / 2;
            float50 const force = -sin(middle) * h;
            worst = std::max({worst, in_epsilons(0.0, float50(v - 0.5 - force / 2), float50(abs(v) + h)),
                              in_epsilons(y.p, float50(0.5 + force), float50(1 + h))});
            ++solved;
        } catch (error::no_convergence const&) {
            ++said;
        }
    }
    // q, p and the sine round; h |q| / 2 is the sensitivity of the sine to the rounding of q.
    all.push_back(kept("pendulum, mid-point, h from 1/2 to 200: " + std::to_string(solved) + " solve their equation", worst, 100));
    all.push_back(holds("    and the others say that they do not", "27 steps in all", solved + said == 27, std::to_string(said) + " do"));
    return all;
}

} // namespace extremes
