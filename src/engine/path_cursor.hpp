// SPDX-License-Identifier: BSL-1.0
// A cursor along any trajectory of the library.
#pragma once

#include <optional>
#include <sstream>

#include "engine/engine.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"

// Checkpoints take long to compile, and the Python package does not use them.
#ifndef ENGINE_KEEPS_CHECKPOINTS
#define ENGINE_KEEPS_CHECKPOINTS true
#endif

namespace engine {

template <class S, class Path>
class path_cursor final : public cursor<S> {
    using iterator = typename Path::iterator;
    using state_type = typename iterator::value_type;
    using V = std::remove_cvref_t<decltype(std::declval<state_type>().q)>;
    // Walks in rationals are short and are repeated instead.
    static constexpr bool keeps = ENGINE_KEEPS_CHECKPOINTS and not std::numeric_limits<S>::is_exact and
                                  requires(Path const& p, typename Path::checkpoint_type c, std::ostringstream out) {
        c.memory.visit(p.method(), out);
    };

public:
    explicit path_cursor(Path path)
        : path_(std::move(path)), at_(std::as_const(path_).begin()),
          velocity_(path_.starting_velocity().value_or(hilger::zero_like(at_->q))) {}

    void advance(hilger::index_type steps, keeper<S> const& keep) override {
        hilger::index_type const last = steps < path_.scale().last() - at_.number() ? at_.number() + steps : path_.scale().last();
        iterator at = at_; // a local copy, which the optimiser may keep in registers
        std::optional<state_type> before_last;
        vector<S> q = as_vector<S>(at->q), p = q;
        try {
            for (hilger::index_type end = last - 1; at.number() < last; end = last) { // the inlined step is long, so it appears once
                if (end == last) before_last.emplace(*at);
                while (at.number() < end) {
                    ++at;
                    if (not keep) continue;
                    put_into(q, at->q);
                    put_into(p, at->p);
                    if (not keep(at->t, q, p)) {
                        at_ = at;
                        return;
                    }
                }
            }
        } catch (...) {
            at_ = at;
            throw;
        }
        if (before_last) velocity_ = hilger::detail::mean_velocity(*before_last, *at);
        at_ = at;
    }
    [[nodiscard]] hilger::index_type number() const override { return at_.number() - path_.scale().first(); }
    [[nodiscard]] engine::state<S> state() const override { return {at_->t, as_vector<S>(at_->q), as_vector<S>(at_->p)}; }
    [[nodiscard]] vector<S> velocity() const override { return as_vector<S>(velocity_); }
    bool save(std::ostream& out) const override {
        if constexpr (keeps) hilger::write_checkpoint(out, path_, at_.checkpoint());
        return keeps;
    }
    void load(std::istream& in, std::string const& source) override {
        if constexpr (keeps) {
            resumed_.emplace(path_.resume(hilger::read_checkpoint(in, path_, source)));
            at_ = std::as_const(*resumed_).begin();
        }
    }

private:
    Path path_;
    std::optional<hilger::resumed<Path>> resumed_;
    iterator at_;
    V velocity_; ///< the mean velocity of the last step
};
template <class S, class Path>
std::unique_ptr<cursor<S>> cursor_along(Path path) {
    return std::make_unique<path_cursor<S, Path>>(std::move(path));
}

} // namespace engine
