// SPDX-License-Identifier: BSL-1.0
// Solutions between two ends: computed at once, and then walked along.
#include <iostream>

#include "engine/methods/lambda.hpp"
#include "engine/motions.hpp"
#include "from_file.hpp"
#include "hilger/text/embedding.hpp"
#include "path_walk.hpp"

namespace program {

namespace {

class solution_walk final : public walk {
public:
    solution_walk(std::vector<double> t, std::vector<engine::vector<double>> q, std::vector<named_formula> observed)
        : t_(std::move(t)), q_(std::move(q)), observed_(std::move(observed)) {}
    void advance(hilger::index_type steps) override { at_ = std::min(at_ + steps, static_cast<hilger::index_type>(q_.size()) - 1); }
    [[nodiscard]] hilger::index_type number() const override { return at_; }
    [[nodiscard]] std::string row() const override {
        auto const k = static_cast<std::size_t>(at_);
        std::string text = digits_of(t_[k]);
        for (double const x : q_[k]) text += ',' + digits_of(x);
        for (auto const& f : observed_) text += ',' + digits_of(f.of.value(t_[k], q_[k], q_[k])); // no velocity is read
        return text;
    }
    /// In the middle: at the ends it is given.
    [[nodiscard]] std::vector<hilger::float100> position() const override {
        auto const& middle = q_[q_.size() / 2];
        return {middle.begin(), middle.end()};
    }
    [[nodiscard]] engine::state<double> state() const override {
        auto const k = static_cast<std::size_t>(at_);
        return {t_[k], q_[k], {}};
    }
    [[nodiscard]] std::vector<double> drift() const override { return {}; }

private:
    std::vector<double> t_;
    std::vector<engine::vector<double>> q_;
    std::vector<named_formula> observed_;
    hilger::index_type at_ = 0;
};

using vector = engine::vector<double>;

/// By the embeddings that a scene between two ends can have.
template <class Scale>
std::vector<vector> embedded_between(engine::problem const& what, std::string const& method, Scale const& T,
                                     hilger::boundary_values<vector> const& ends) {
    std::vector<vector> q;
    engine::with_mechanics(what, [&](auto const& mechanics) {
        auto const by = [&](auto const& how) {
            hilger::ends_report<double> report;
            auto const x = solve(equation_of(hilger::embed(mechanics, how), T), T, ends, mechanics.force, hilger::detail::straight_line{},
                                 {}, &report);
            if (not report.warning.empty()) std::cerr << "warning: " << report.warning << '\n';
            for (hilger::index_type i = x.first(); i <= x.last(); ++i) q.push_back(x[i]);
        };
        if (method == "order-one") by(hilger::order_one);
        if (method == "mid-point") by(hilger::mid_point);
        if (auto const lambda = engine::lambda_of<double>(what, method, T.h())) by(hilger::text::embedding_at(*lambda));
    });
    return q;
}

} // namespace

std::unique_ptr<walk> begin_between(stated_problem const& what, configuration const& c) {
    hilger::boundary_values<vector> const ends{numbers_of(what.q), numbers_of(what.last)};
    auto const points = points_of(what, c.steps);
    auto const T = hilger::uniform(points.start, points.step, points.steps);
    std::vector<vector> q;
    if (auto const two_sided = engine::between_two_ends(what.of, c.embedding, points))
        q = two_sided->between(ends.q0, ends.qN).q;
    else
        q = embedded_between(what.of, c.embedding, T, ends);
    if (q.empty()) return nullptr;
    return std::make_unique<solution_walk>(engine::elements_of<double>(T), std::move(q), what.observed);
}

} // namespace program
