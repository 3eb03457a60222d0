// SPDX-License-Identifier: BSL-1.0
#include "../papers/bourdin_cresson_greff_inizan_2013/exact.hpp"
#include "path_walk.hpp"
#include "scenes.hpp"
#include "structures.hpp"

namespace program {

namespace {

/// The solution of a two-sided problem, computed at once and then walked along.
class solution_walk final : public walk {
public:
    explicit solution_walk(hilger::index_type steps) : q_(fractional_dirichlet_solution(steps).q) {}
    void advance(hilger::index_type steps) override { at_ = std::min(at_ + steps, q_.root().steps()); }
    [[nodiscard]] hilger::index_type number() const override { return at_; }
    [[nodiscard]] std::string row() const override { return digits_of(q_.root().element(at_)) + ',' + digits_of(q_[at_]); }
    /// In the middle: at the ends it is given.
    [[nodiscard]] std::vector<hilger::float100> position() const override { return {hilger::float100(q_[q_.root().steps() / 2])}; }
    [[nodiscard]] std::vector<double> drift() const override { return {}; }

private:
    decltype(fractional_dirichlet_solution(1).q) q_;
    hilger::index_type at_ = 0;
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
    s.picture = "set title 'Solution'; set xlabel 't'; plot <rows> using 1:2 with lines notitle\n"
                "set title 'Distance from the straight line'; plot <rows> using 1:($2-$1) with lines notitle\n";
    s.exact_source = "the closed form of (19) in the middle, in 100 digits";
    s.exact = [] {
        using R = hilger::float100;
        return std::vector<R>{hilger::papers::dirichlet_solution<R>(R(3) / 4, R(1) / 2)};
    };
    s.begin = [](configuration const& c) { return std::make_unique<solution_walk>(c.steps); };
    return s;
}

} // namespace program
