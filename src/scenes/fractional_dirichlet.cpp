// SPDX-License-Identifier: BSL-1.0
#include "hilger/integrator/boundary.hpp"
#include "path_walk.hpp"
#include "scenes.hpp"

namespace program {

namespace {

/// The solution of a two-sided problem, computed at once and then walked along.
class solution_walk final : public walk {
public:
    explicit solution_walk(hilger::index steps)
        : T_(hilger::uniform(hilger::interval{0.0, 1.0}, steps)),
          q_(hilger::solve_boundary(
                 hilger::fractional_problem([](auto const&, auto const& v) { return v * v / 2; }, hilger::fraction<3, 4>{}), T_, 0.0, 1.0)
                 .q) {}
    void advance(hilger::index steps) override { at_ = std::min(at_ + steps, T_.steps()); }
    [[nodiscard]] hilger::index number() const override { return at_; }
    [[nodiscard]] hilger::index steps() const override { return T_.steps(); }
    [[nodiscard]] std::string row() const override { return digits_of(T_.element(at_)) + ',' + digits_of(q_[at_]); }
    /// In the middle: at the ends it is given.
    [[nodiscard]] std::vector<hilger::float100> position() const override { return {hilger::float100(q_[T_.steps() / 2])}; }
    [[nodiscard]] std::vector<double> drift() const override { return {}; }

private:
    decltype(hilger::uniform(hilger::interval{0.0, 1.0}, hilger::index{1})) T_;
    decltype(hilger::function(T_, std::vector<double>{})) q_;
    hilger::index at_ = 0;
};

} // namespace

scene fractional_dirichlet() {
    scene s;
    s.name = "fractional-dirichlet";
    s.title = "D_+^alpha D_-^alpha q = 0, q(0) = 0, q(1) = 1, alpha = 3/4 (Bourdin, Cresson, Greff, Inizan (18))";
    s.usual = {"two-sided", "double", "", 1'000};
    s.embeddings = {"two-sided"};
    s.scalars = {"double"};
    s.columns = {"t", "q"};
    s.picture = "set title 'Solution'; set xlabel 't'; plot DATA using 1:2 with lines notitle\n"
                "set title 'Distance from the straight line'; plot DATA using 1:($2-$1) with lines notitle\n";
    s.exact_source = "the closed form of (19) in the middle, in 100 digits";
    s.exact = [] { // (2 alpha - 1)/alpha t^alpha 2F1(1 - alpha, 1; 1 + alpha; t)
        using R = hilger::float100;
        R const alpha = R(3) / 4, t = R(1) / 2;
        R sum = 0, term = 1;
        for (int n = 0; n < 400; ++n) {
            sum += term;
            term *= (1 - alpha + n) / (1 + alpha + n) * t;
        }
        return std::vector<R>{(2 * alpha - 1) / alpha * pow(t, alpha) * sum};
    };
    s.begin = [](configuration const& c) { return std::make_unique<solution_walk>(c.steps); };
    return s;
}

} // namespace program
