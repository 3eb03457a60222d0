// SPDX-License-Identifier: BSL-1.0
// What all walks of one problem begin with, whatever the method and the kind of its states, in each kind of numbers compiled once.
#pragma once

#include <optional>

#include "compiled_once.hpp"
#include "from_file.hpp"

namespace program {

/// How far what is constant is from what it was, and what else is looked at.
template <class S>
class observation {
public:
    using state = hilger::state<S, engine::vector<S>>;
    observation() = default;
    observation(observation const&) = delete;
    observation& operator=(observation const&) = delete;
    virtual ~observation() = default;
    /// `near` is a velocity near that of x.
    [[nodiscard]] virtual std::vector<S> constants(state const& x, engine::vector<S> const& near) const = 0;
    [[nodiscard]] virtual std::vector<S> shown(state const& x, engine::vector<S> const& near) const = 0;
};
/// The same of states of any kind.
template <class S>
class observed {
public:
    explicit observed(std::shared_ptr<observation<S> const> by) : by_(std::move(by)) {}
    template <class State, class V>
    std::vector<S> operator()(State const& x, V const& near) const {
        return by_->constants(of_any_size(x), engine::as_vector<S>(near));
    }
    template <class State, class V>
    std::vector<S> shown(State const& x, V const& near) const {
        return by_->shown(of_any_size(x), engine::as_vector<S>(near));
    }

private:
    template <class State>
    static typename observation<S>::state of_any_size(State const& x) {
        return {x.t, engine::as_vector<S>(x.q), engine::as_vector<S>(x.p)};
    }
    std::shared_ptr<observation<S> const> by_;
};

/// What all walks in numbers S begin with.
template <class S>
struct beginning {
    S start, end;
    engine::vector<S> q, v, p;
    observed<S> seen;
    /// In states V.
    template <class V = engine::vector<S>>
    [[nodiscard]] hilger::initial_velocity<V> from() const {
        return {V(q), V(v)};
    }
    [[nodiscard]] auto scale(hilger::index_type steps) const { return hilger::uniform(hilger::interval<S>{start, end}, steps); }
    [[nodiscard]] std::optional<S> step(hilger::index_type steps) const { return scale(steps).h(); }
};
/// From q and v, compiled once for each S (in_numbers.hpp).
template <class S>
beginning<S> beginning_from(stated_problem const& what, engine::vector<S> const& q, engine::vector<S> const& v);
extern template beginning<double> beginning_from(stated_problem const&, engine::vector<double> const&, engine::vector<double> const&);
extern template beginning<float> beginning_from(stated_problem const&, engine::vector<float> const&, engine::vector<float> const&);
extern template beginning<hilger::float50> beginning_from(stated_problem const&, engine::vector<hilger::float50> const&,
                                                          engine::vector<hilger::float50> const&);
extern template beginning<hilger::float100> beginning_from(stated_problem const&, engine::vector<hilger::float100> const&,
                                                           engine::vector<hilger::float100> const&);

/// What make() makes for the first walk, for all of them.
template <class T, class Make>
T const& known_to(stated_problem const& what, Make const& make) {
    auto& kept = what.known[typeid(T)];
    if (not kept) kept = std::make_shared<T>(make());
    return *static_cast<T const*>(kept.get());
}
template <class S>
beginning<S> const& beginning_of(stated_problem const& what) {
    return known_to<beginning<S>>(what, [&] { return beginning_from<S>(what, numbers_of<S>(what.q), numbers_of<S>(what.v)); });
}

} // namespace program

/// What compiled_once.hpp has not, for few programs need it.
#define PROGRAM_ENGINES_IN_FLOAT(how)                                                                                                      \
    namespace hilger::detail {                                                                                                             \
    HILGER_ENGINES(how, float)                                                                                                             \
    }
PROGRAM_ENGINES_IN_FLOAT(extern)
