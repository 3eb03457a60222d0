// SPDX-License-Identifier: BSL-1.0
// The two-sided fractional equation dL/dq + Delta_plus^alpha[dL/dv] = 0, with v = Delta_minus^alpha[q] (Bourdin et al. (EL_h^alpha)),
// solved as a boundary value problem.
#include "engine/methods/two_sided.hpp"
#include "engine/motions.hpp"
#include "hilger/boundary/residual.hpp"
#include "hilger/boundary/solve.hpp"

namespace engine {

namespace {

class two_sided : public motion<double> {
    [[nodiscard]] auto derived() const { return two_sided_equation(L_, alpha_, T_); }

public:
    two_sided(hilger::text::stated_lagrangian L, double alpha, points<double> const& T)
        : L_(std::move(L)), alpha_(alpha), T_(uniform_scale_of(T)) {}

    [[nodiscard]] std::unique_ptr<cursor<double>> begin(initial<double> const&) const override {
        refuse("it looks to both ends, and initial values do not determine its solution: give q0 and qN");
    }
    [[nodiscard]] std::vector<double> times() const override { return elements_of<double>(T_); }
    [[nodiscard]] joined<double> between(vector<double> const& first, vector<double> const& last, std::vector<vector<double>> const& guess,
                                         std::stop_token const& stop) const override {
        if (not guess.empty()) refuse("it is solved from the solution for L = v.v / 2 on, and no other first guess is taken");
        auto const x = solve(derived(), T_, hilger::boundary_values<vector<double>>{first, last}, hilger::boundary_options{.stop = stop}).q;
        std::vector<vector<double>> positions;
        for (hilger::index_type i = x.first(); i <= x.last(); ++i) positions.push_back(x[i]);
        return {std::move(positions), {}};
    }
    [[nodiscard]] double residual(initial<double> const&, std::vector<vector<double>> const& positions, std::vector<vector<double>> const&,
                                  bool absolute) const override {
        auto const x = hilger::function_on(T_, positions);
        return absolute ? largest_residual(derived(), x) : relative_residual(derived(), x);
    }
    [[nodiscard]] double energy(state<double> const&, vector<double> const&) const override { refuse("it has no energy at a point"); }
    [[nodiscard]] state<double> between_states(state<double> const&, state<double> const&, double const&) const override {
        refuse("there is nothing between the points of T");
    }

private:
    [[noreturn]] static void refuse(char const* why) {
        hilger::error::raise<hilger::error::invalid_parameter>("the two-sided fractional equation is another kind: ", why);
    }
    hilger::text::stated_lagrangian L_;
    double alpha_;
    hilger::uniform_scale<double> T_;
};

} // namespace

made between_two_ends(problem const& what, std::string const& method, points<double> const& T) {
    if (not is_two_sided(method)) return nullptr;
    if (not T.is_uniform() or what.force)
        hilger::error::raise<hilger::error::invalid_parameter>("the two-sided fractional equation is for uniform scales, without forces");
    return std::make_unique<two_sided>(what.lagrangian, order_of_two_sides(method), T);
}

} // namespace engine
