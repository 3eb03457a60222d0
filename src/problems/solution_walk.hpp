// SPDX-License-Identifier: BSL-1.0
// Solutions between two ends: computed at once, then traversed as a walk.
#pragma once

#include "stated_walk.hpp"

namespace program {

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
        for (auto const& f : observed_) text += ',' + digits_of(f.of.value(t_[k], q_[k], q_[k])); // the formulas read no velocity
        return text;
    }
    /// At the middle: the ends are given.
    [[nodiscard]] std::vector<hilger::float100> position() const override {
        auto const& middle = q_[q_.size() / 2];
        return {middle.begin(), middle.end()};
    }
    [[nodiscard]] std::vector<double> drift() const override { return {}; }

private:
    std::vector<double> t_;
    std::vector<engine::vector<double>> q_;
    std::vector<named_formula> observed_;
    hilger::index_type at_ = 0;
};

} // namespace program
