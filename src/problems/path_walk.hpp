// SPDX-License-Identifier: BSL-1.0
// A walk along any trajectory of hilger's.
#pragma once

#include <iomanip>
#include <optional>
#include <sstream>

#include "hilger/hilger.hpp"
#include "scene.hpp"

namespace program {

template <class S>
std::string digits_of(S const& x) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<S>::max_digits10) << x;
    return out.str();
}

/// What does not depend on the kind of trajectory: rows, and what was observed so far.
template <class S>
class recorded_walk : public walk {
protected:
    std::string row_of(S const& t, std::vector<S> const& state, std::vector<S> const& now, std::vector<S> const& shown) const {
        std::string text = digits_of(t);
        for (S const& x : state) text += ',' + digits_of(x);
        for (std::size_t k = 0; k < now.size(); ++k) {
            auto const change = static_cast<double>(S(now[k] - (*start_)[k]));
            largest_[k] = std::max(largest_[k], std::abs(change));
            text += ',' + digits_of(change);
        }
        for (S const& x : shown) text += ',' + digits_of(x);
        return text;
    }
    void write_largest(std::ostream& out) const {
        for (double const x : largest_) out << std::hexfloat << x << '\n';
    }
    void read_largest(std::istream& in, std::string const& source) {
        for (double& x : largest_) {
            std::string word;
            std::getline(in, word);
            char* end = nullptr;
            x = std::strtod(word.c_str(), &end);
            if (word.empty() or *end != '\0')
                hilger::error::raise<hilger::error::unreadable>(source, " is damaged: '", word, "' is no number");
        }
    }
    /// What is observed at the first point. It is looked at when somebody asks for rows: that may take longer than to walk.
    mutable std::optional<std::vector<S>> start_;
    mutable std::vector<double> largest_;
};

/// Observe gives the numbers that should be constant at a state, and may give others, shown(x, v), that are looked at; v is a velocity near
/// that of x, where several have its momentum.
template <class Path, class Observe>
class path_walk final : public recorded_walk<std::remove_cvref_t<decltype((*std::declval<typename Path::iterator const&>()).t)>> {
    using iterator = typename Path::iterator;
    using S = std::remove_cvref_t<decltype((*std::declval<iterator const&>()).t)>;
    using V = std::remove_cvref_t<decltype((*std::declval<iterator const&>()).q)>;
    using s = hilger::detail::shape<V>;
    static constexpr bool keeps = requires(Path const& p, typename Path::checkpoint_type c, std::ostringstream out) {
        c.memory.visit(p.method(), out);
    };

public:
    path_walk(Path path, Observe observe)
        : path_(std::move(path)), observe_(std::move(observe)), at_(std::as_const(path_).begin()), first_(*at_),
          first_velocity_(path_.starting_velocity().value_or(hilger::zero_like(first_.q))), mean_(first_velocity_) {}

    void advance(hilger::index_type steps) override {
        hilger::index_type const last = std::min(path_.scale().last(), at_.number() + steps);
        iterator at = at_; // where nobody else can see it, the optimiser may keep it in registers
        std::optional<std::remove_cvref_t<decltype(*at)>> before_last;
        try {
            for (hilger::index_type end = last - 1; at.number() < last; end = last) { // a step stands here once: it is long
                if (end == last) before_last.emplace(*at);
                while (at.number() < end) ++at;
            }
        } catch (...) {
            at_ = at;
            throw;
        }
        if (before_last) mean_ = hilger::detail::mean_velocity(*before_last, *at);
        at_ = at;
    }
    [[nodiscard]] hilger::index_type number() const override { return at_.number() - path_.scale().first(); }
    [[nodiscard]] std::string row() const override {
        start_of_all();
        auto const& x = *at_;
        std::vector<S> state, shown;
        for (int k = 0; k < s::dimension(x.q); ++k) state.emplace_back(s::component(x.q, k));
        for (int k = 0; k < s::dimension(x.p); ++k) state.emplace_back(s::component(x.p, k));
        if constexpr (requires { observe_.shown(x, mean_); }) shown = observe_.shown(x, mean_);
        return this->row_of(x.t, state, observed(x, mean_), shown);
    }
    [[nodiscard]] std::vector<hilger::float100> position() const override {
        std::vector<hilger::float100> x;
        for (int k = 0; k < s::dimension(at_->q); ++k) x.emplace_back(s::component(at_->q, k));
        return x;
    }
    [[nodiscard]] engine::state<double> state() const override {
        auto const in_double = [](V const& x) { return engine::as_vector<S>(x).template cast<double>().eval(); };
        return {static_cast<double>(at_->t), in_double(at_->q), in_double(at_->p)};
    }
    [[nodiscard]] std::vector<double> drift() const override {
        start_of_all();
        return this->largest_;
    }
    bool save(std::ostream& out) const override {
        if constexpr (keeps) {
            start_of_all();
            this->write_largest(out);
            hilger::write_checkpoint(out, path_, at_.checkpoint());
        }
        return keeps;
    }
    void load(std::istream& in, std::string const& source) override {
        if constexpr (keeps) {
            start_of_all();
            this->read_largest(in, source);
            resumed_.emplace(path_.resume(hilger::read_checkpoint(in, path_, source)));
            at_ = std::as_const(*resumed_).begin();
        }
    }

private:
    void start_of_all() const {
        if (this->start_) return;
        this->start_.emplace(observed(first_, first_velocity_));
        this->largest_.assign(this->start_->size(), 0);
    }
    auto observed(typename iterator::value_type const& x, V const& near) const {
        if constexpr (requires { observe_(x, near); })
            return observe_(x, near);
        else
            return observe_(x);
    }
    Path path_;
    Observe observe_;
    std::optional<hilger::resumed<Path>> resumed_;
    iterator at_;
    std::remove_cvref_t<decltype(*std::declval<iterator const&>())> first_;
    V first_velocity_, mean_; ///< the mean one of the last step
};
template <class Path, class Observe>
std::unique_ptr<walk> walk_along(Path path, Observe observe) {
    return std::make_unique<path_walk<Path, Observe>>(std::move(path), std::move(observe));
}

} // namespace program
