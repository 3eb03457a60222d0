// SPDX-License-Identifier: BSL-1.0
// One step in every scalar against 120 digits: the error is a few of the scalar's own epsilons.
#include "extremes/row.hpp"
#if HILGER_HAS_FLOAT128
#include "hilger/float128.hpp"
#endif
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;

using wide = mp::number<mp::cpp_bin_float<120>, mp::et_off>;
/// From (1, 1/4), which every scalar holds exactly.
template <class S>
state<S, S> step_of(S const& h) {
    return embed(pendulum, mid_point).step(state<S, S>{S(0), S(1), S(S(1) / 4)}, h);
}
template <class S>
row one(std::string const& name, state<wide, wide> const& exact) {
    auto const x = step_of<S>(S(S(1) / 16));
    // q and p round by half an epsilon each; so do v, the sine and its product with h.
    return kept("mid-point step of the pendulum in " + name, std::max(in_epsilons(x.q, exact.q), in_epsilons(x.p, exact.p)), 4);
}
template <class S>
row weights_of(std::string const& name) {
    auto const w = first_weights<bdf<2>>(S(S(3) / 8), 200);
    auto const exact = first_weights<bdf<2>>(wide(wide(3) / 8), 200);
    double worst = 0;
    for (std::size_t n = 0; n < w.size(); ++n) worst = std::max(worst, in_epsilons(w[n], exact[n]));
    // Without double-double numbers the recurrence rounds three times in each step.
    return kept("200 weights of bdf<2>, order 3/8, in " + name, worst, std::is_floating_point_v<S> ? 1 : 600);
}
template <class S>
void scalar_rows(rows& all, std::string const& name, state<wide, wide> const& exact) {
    all.push_back(one<S>(name, exact));
    all.push_back(weights_of<S>(name));
}

} // namespace

rows scalars(scope) {
    rows all;
    auto const exact = step_of<wide>(wide(1) / 16);
    scalar_rows<float>(all, "float", exact);
    scalar_rows<double>(all, "double", exact);
    scalar_rows<long double>(all, "long double", exact);
#if HILGER_HAS_FLOAT128
    scalar_rows<float128>(all, "float128", exact);
#endif
    scalar_rows<float50>(all, "50 digits", exact);
    scalar_rows<float100>(all, "100 digits", exact);
    return all;
}

} // namespace extremes
