// SPDX-License-Identifier: BSL-1.0
// The walk of a problem in a file: a cursor of the engine with observed quantities.
#pragma once

#include <iomanip>
#include <sstream>

#include "observation.hpp"
#include "scene.hpp"

namespace program {

template <class S>
std::string digits_of(S const& x) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<S>::max_digits10) << x;
    return out.str();
}

template <class S>
class stated_walk final : public walk {
public:
    stated_walk(std::shared_ptr<observation<S> const> seen, std::unique_ptr<engine::cursor<S>> at)
        : seen_(std::move(seen)), at_(std::move(at)), first_(at_->state()), first_velocity_(at_->velocity()) {}

    void advance(hilger::index_type steps) override { at_->advance(steps); }
    [[nodiscard]] hilger::index_type number() const override { return at_->number(); }
    [[nodiscard]] std::string row() const override {
        auto const& start = start_of_all();
        auto const x = at_->state();
        auto const near = at_->velocity();
        std::string text = digits_of(x.t);
        for (auto const* part : {&x.q, &x.p})
            for (S const& component : *part) text += ',' + digits_of(component);
        auto const now = seen_->constants(x, near);
        for (std::size_t k = 0; k < now.size(); ++k) {
            auto const change = static_cast<double>(S(now[k] - start[k]));
            largest_[k] = std::max(largest_[k], std::abs(change));
            text += ',' + digits_of(change);
        }
        for (S const& shown : seen_->shown(x, near)) text += ',' + digits_of(shown);
        return text;
    }
    [[nodiscard]] std::vector<hilger::float100> position() const override {
        auto const q = at_->state().q;
        return {q.begin(), q.end()};
    }
    [[nodiscard]] std::vector<double> drift() const override {
        (void)start_of_all();
        return largest_;
    }
    bool save(std::ostream& out) const override {
        (void)start_of_all();
        std::ostringstream rest;
        if (not at_->save(rest)) return false;
        for (double const x : largest_) out << std::hexfloat << x << '\n';
        out << rest.str();
        return true;
    }
    void load(std::istream& in, std::string const& source) override {
        (void)start_of_all();
        for (double& x : largest_) {
            std::string word;
            std::getline(in, word);
            char* end = nullptr;
            x = std::strtod(word.c_str(), &end);
            if (word.empty() or *end != '\0')
                hilger::error::raise<hilger::error::unreadable>(source, " is damaged: '", word, "' is no number");
        }
        at_->load(in, source);
    }

private:
    /// The observed values at the first point, computed on the first request for rows: that may take longer than the walk.
    std::vector<S> const& start_of_all() const {
        if (not start_) {
            start_ = seen_->constants(first_, first_velocity_);
            largest_.assign(start_->size(), 0);
        }
        return *start_;
    }
    std::shared_ptr<observation<S> const> seen_;
    std::unique_ptr<engine::cursor<S>> at_;
    engine::state<S> first_;
    engine::vector<S> first_velocity_;
    mutable std::optional<std::vector<S>> start_;
    mutable std::vector<double> largest_;
};

} // namespace program
