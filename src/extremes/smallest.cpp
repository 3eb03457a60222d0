// SPDX-License-Identifier: BSL-1.0
// The smallest scales, of one step and of two, in exact rationals: operators and their integration by parts, integrals, flows and two-sided
// problems; and scales without a step, which are refused.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"
#include "identities/by_parts.hpp"
#include "identities/calculus.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;

/// Checks identities in random fractions and counts them.
class proofs {
public:
    template <class Identity, class Scale>
    void add(Identity const& identity, Scale const& T) {
        auto const v = check(identity, T, Q(0), source_);
        comparisons_ += v.comparisons;
        if (not v.holds and failure_.empty()) failure_ = std::string(identity.name) + ": " + v.first_failure;
    }
    row result(std::string what) const {
        return holds(std::move(what), "equal in the rationals", failure_.empty() and comparisons_ > 0,
                     failure_.empty() ? std::to_string(comparisons_) + " equalities" : failure_);
    }

private:
    random_fractions source_{1988};
    long comparisons_ = 0;
    std::string failure_;
};

template <class Scale>
row identities_on(std::string what, Scale const& T) {
    namespace id = identities;
    proofs all;
    all.add(id::fundamental_theorem<nodes>{}, T);
    all.add(id::by_parts_order_one<nodes>{}, T);
    all.add(id::by_parts_order_one<joined<fraction<1, 2>>>{}, T);
    all.add(id::lemma_1<fraction<1, 2>>{}, T);
    all.add(id::lemma_2{}, T);
    return all.result(std::move(what));
}
/// <A f, g> = <f, A* g> + end terms, whatever A is.
template <class Operator, class Scale>
bool by_parts_holds(Operator const& A, Scale const& T) {
    auto const f = function_on(T, [](Q const& t) { return Q(t * t + 2); });
    auto const g = function_on(T, [](Q const& t) { return Q(3 - t); });
    auto const parts = by_parts(A, f, g);
    return parts.left == parts.interior + parts.boundary;
}
template <class Scale>
row operators_on(std::string what, Scale const& T) {
    int good = 0, all = 0;
    auto const one = [&](bool ok) {
        good += ok;
        ++all;
    };
    one(by_parts_holds(Delta_plus, T));
    one(by_parts_holds(Delta_minus, T));
    one(by_parts_holds(sigma, T));
    one(by_parts_holds(rho, T));
    one(by_parts_holds(fraction<2, 3>{} * Delta_plus + sigma, T));
    auto const f = function_on(T, [](Q const& t) { return Q(t * t + 2); });
    one(integral(Delta_plus[f], T) == boundary(f));
    one(nabla_integral(Delta_minus[f], T) == boundary(f));
    one(integral(Delta_o_plus[extend[f]], half(T)) == boundary(f));
    one(integral(f, T.min(), T.max()) == -integral(f, T.max(), T.min()));
    one(antiderivative[restrict_to(f, without_last(T))][T.last()] == integral(f, T));
    return holds(std::move(what), "equal in the rationals", good == all, std::to_string(good) + " of " + std::to_string(all));
}

/// The states of a run of N steps are those of N single steps.
template <class E>
bool steps_as_flow(E const& how, index_type N) {
    auto const flow = embed([](auto const& q, auto const& v) { return v * v / 2 - q * q / 2; }, how);
    Q const h(1, 4);
    state<Q, Q> x{Q(0), Q(1), Q(1, 3)};
    index_type count = 0;
    bool same = true;
    for (auto const& y : flow.along(uniform(Q(0), h, N), x.q, x.p)) {
        same = same and y == x;
        x = flow.step(x, h);
        ++count;
    }
    return same and count == N + 1;
}
bool boundary_problem(index_type N) {
    auto const L = [](auto const& q, auto const& v) { return v * v / 2 + q * q / 2; };
    constexpr unknown q;
    auto const T = uniform(Q(0), Q(1), N);
    auto const EL = variation(nabla_integral(lagrangian{L}(q, Delta_minus_alpha<1, 1>[q]), T));
    auto const s = solve(EL, T, {.q0 = 0, .qN = 6}, boundary_options{});
    // x_1 of x_2 - 2 x_1 + x_0 = x_1
    return s.q[0] == 0 and s.q[N] == 6 and (N == 1 or s.q[1] == 2) and s.residual == 0;
}

} // namespace

rows smallest(scope) {
    rows all;
    for (index_type const N : {1, 2}) {
        std::string const n = "N = " + std::to_string(N) + ": ";
        auto const T = uniform(Q(-1, 3), Q(2, 7), N);
        all.push_back(identities_on(n + "identities on a uniform scale", T));
        all.push_back(identities_on(n + "identities on harmonic numbers", harmonic_numbers<Q>(N)));
        all.push_back(operators_on(n + "operators, their adjoints and integrals", T));
        all.push_back(operators_on(n + "the same on given points", powers(Q(3, 2), 0, N)));
        bool const flows = steps_as_flow(order_one, N) and steps_as_flow(order_one_left, N) and steps_as_flow(mid_point, N) and
                           steps_as_flow(galerkin<2, lobatto>, N);
        all.push_back(holds(n + "flows: order one, left, mid-point, Galerkin", "as single steps", flows));
        all.push_back(holds(n + "two-sided problem", "solved exactly", boundary_problem(N)));
        auto const U = uniform(Q(0), Q(1), N);
        auto const f = function_on(U, [](Q const& t) { return Q(t + 1); });
        auto const d = Delta_minus_alpha<1, 2>[f];
        all.push_back(holds(n + "fractional difference", "1, 3/2, ...", d[0] == 1 and d[1] == Q(3, 2) and (N == 1 or d[2] == Q(15, 8))));
    }
    all.push_back(refused<error::invalid_scale>("N = 0, uniform", [] { (void)uniform(0.0, 0.5, 0); }));
    all.push_back(refused<error::invalid_scale>("N = 0, an interval", [] { (void)uniform(interval{0.0, 1.0}, 0); }));
    all.push_back(refused<error::invalid_scale>("N = 0, one given point", [] { (void)time_scale<double>{1.0}; }));
    all.push_back(refused<error::invalid_scale>("N = 0, no given point", [] { (void)time_scale<double>(std::vector<double>{}); }));
    all.push_back(refused<error::invalid_scale>("N = 0, harmonic numbers", [] { (void)harmonic_numbers<Q>(0); }));
    all.push_back(refused<error::invalid_scale>("N = -1, uniform in rationals", [] { (void)uniform(Q(0), Q(1), -1); }));
    all.push_back(refused<error::invalid_parameter>("a history of no step", [] {
        (void)make_history<bdf<2>>(exponentials{0, 0}, 0.5, 0.0);
    }));
    return all;
}

} // namespace extremes
