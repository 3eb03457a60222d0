// SPDX-License-Identifier: BSL-1.0
// Problems from files, as motions of the engine.
#include <iostream>

#include "engine/machine_code/machine_code.hpp"
#include "engine/methods.hpp"
#include "engine/methods/newmark.hpp"
#include "engine/methods/one_step.hpp"
#include "engine/methods/two_sided.hpp"
#include "parts.hpp"
#include "solution_walk.hpp"

namespace program {

namespace {

using hilger::float100;
using hilger::float50;

bool has_structure(engine::problem const& of) {
    try {
        require_structure(of);
        return true;
    } catch (hilger::error::invalid_parameter const&) {
        return false;
    }
}
engine::scalar_kind kind_of(std::string const& scalar) {
    return scalar == "double" ? engine::scalar_kind::machine : engine::scalar_kind::digits;
}
bool contains(std::vector<std::string> const& names, std::string const& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}
std::vector<std::string> methods_in(stated_problem const& what, engine::scalar_kind numbers) {
    auto names = engine::method_names(what.of, numbers, not what.last.empty());
    if (what.of.has_memory() and not what.of.material and not has_structure(what.of)) std::erase_if(names, engine::is_newmark);
    return names;
}

template <class S>
engine::points<S> points_in(stated_problem const& what, hilger::index_type steps) {
    hilger::interval<S> const ends{number_of<S>(what.start), number_of<S>(what.end)};
    return {ends.a, hilger::uniform(ends, steps).h(), steps, {}, ends.b, true};
}
template <class S>
std::unique_ptr<engine::motion<S>> motion_in(stated_problem const& what, configuration const& c) {
    auto [of, method] = read_by(what, c.embedding);
    of.history = c.history;
    auto const T = points_in<S>(what, c.steps);
    if constexpr (std::same_as<S, float50>)
        if (auto made = engine::by_newmark(of, method, T)) return made;
    return engine::make_motion<S>(of, method, T);
}

/// Data that one walk leaves for the next one.
template <class S>
struct walked_before {
    configuration by;
    std::unique_ptr<engine::motion<S>> motion;
    std::shared_ptr<observation<S> const> seen;
};
template <class S>
std::unique_ptr<walk> begin_in(stated_problem const& what, configuration const& c) {
    auto& kept = what.known[typeid(S)];
    if (not kept) kept = std::make_shared<walked_before<S>>();
    auto& known = *static_cast<walked_before<S>*>(kept.get());
    if (not known.motion or not(known.by == c)) {
        known.motion = motion_in<S>(what, c);
        known.by = c;
    }
    if constexpr (std::same_as<S, double>)
        if (not what.last.empty()) {
            auto made = known.motion->between(numbers_of(what.q), numbers_of(what.last));
            if (not made.warning.empty()) std::cerr << "warning: " << made.warning << '\n';
            return std::make_unique<solution_walk>(known.motion->times(), std::move(made.q), what.observed);
        }
    if (not known.seen) known.seen = std::make_shared<observation<S> const>(what);
    auto at = known.motion->begin({numbers_of<S>(what.q), engine::second_datum::velocity, numbers_of<S>(what.v)});
    return std::make_unique<stated_walk<S>>(known.seen, std::move(at));
}

} // namespace

void require_structure(engine::problem const& of) { engine::structure_of_problem<double>(of).require_valid(); }

std::vector<std::string> embeddings_of(stated_problem const& what) {
    auto names = methods_in(what, engine::scalar_kind::machine);
    if (contains(scalars_of(what, names), "50-digits"))
        for (std::string const& name : methods_in(what, engine::scalar_kind::digits))
            if (not contains(names, name)) names.push_back(name);
    return names;
}
std::vector<std::string> scalars_of(stated_problem const& what, std::vector<std::string> const& embeddings) {
    if (not what.last.empty()) return {"double"};
    if (not what.of.has_memory()) return {"double", "50-digits", "100-digits"};
    if (std::none_of(embeddings.begin(), embeddings.end(), engine::is_newmark)) return {"double"};
    return {"double", "50-digits"};
}

bool is_for_parts(stated_problem const& what, std::string const& method) {
    if (not names_parts(what, method)) return false;
    auto const [sum, first] = read_by(what, method);
    (void)engine::embeddings_in_one_step<double>(sum, first, {0, 1, 1, {}});
    return true;
}
bool has_embedding(stated_problem const& what, std::string const& method) {
    if (engine::is_newmark(method) and what.last.empty() and what.of.has_memory()) {
        require_structure(what.of);
        return true;
    }
    if (not what.last.empty() and engine::between_two_ends(what.of, method, points_of(what, 2))) return true;
    if (is_for_parts(what, method)) {
        if (not what.last.empty())
            hilger::error::raise<hilger::error::invalid_parameter>("between two ends all parts of a Lagrangian are read by one embedding");
        return true;
    }
    return not what.of.has_memory() and engine::lambda_of<double>(what.of, method, 1.0).has_value();
}
bool has_method(stated_problem const& what, configuration const& c) {
    return contains(methods_in(what, kind_of(c.scalar)), c.embedding) or has_embedding(what, c.embedding);
}

engine::points<double> points_of(stated_problem const& what, hilger::index_type steps) { return points_in<double>(what, steps); }

engine::walker walker_of_member(stated_problem const& what, engine::problem const& one, configuration const& c) {
    stated_problem its(one);
    its.start = what.start;
    its.end = what.end;
    auto const words = std::make_shared<hilger::text::vocabulary const>(one.lagrangian.formula().words());
    for (auto const& part : what.parts)
        its.parts.emplace_back(hilger::text::stated(part.formula().formula(), words, part.formula().source()));
    return engine::walker_of(motion_in<double>(its, c));
}

std::unique_ptr<walk> begin_stated(stated_problem const& what, configuration const& c) {
    if (c.scalar == "50-digits") return begin_in<float50>(what, c);
    if (c.scalar == "100-digits") return begin_in<float100>(what, c);
    return begin_in<double>(what, c);
}

} // namespace program
