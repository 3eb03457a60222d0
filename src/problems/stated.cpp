// SPDX-License-Identifier: BSL-1.0
#include "engine/machine_code/machine_code.hpp"
#include "engine/methods/newmark.hpp"
#include "engine/motions.hpp"
#include "stated_walk.hpp"

namespace program {

namespace {

bool has_structure(engine::problem const& of) {
    try {
        require_structure(of);
        return true;
    } catch (hilger::error::invalid_parameter const&) {
        return false;
    }
}

} // namespace

void require_structure(engine::problem const& of) { engine::structure_of_problem<double>(of).require_valid(); }

std::vector<std::string> embeddings_of(stated_problem const& what) {
    if (not what.last.empty()) return {"order-one", "mid-point"};
    if (what.of.material) return {"g-alpha-newmark", "gl-newmark"};
    if (what.of.has_memory())
        return has_structure(what.of) ? std::vector<std::string>{"mid-point", "g-alpha-newmark", "gl-newmark"}
                                      : std::vector<std::string>{"mid-point"};
    if (what.of.force) return {"order-one", "mid-point", "gauss-4"};
    return {method_names.begin(), method_names.end()};
}
std::vector<std::string> scalars_of(stated_problem const& what, std::vector<std::string> const& embeddings) {
    if (not what.last.empty()) return {"double"};
    if (what.of.has_memory() and std::none_of(embeddings.begin(), embeddings.end(), engine::is_newmark)) return {"double"};
    if (what.of.has_memory() or what.of.force) return {"double", "50-digits"};
    return {"double", "float", "50-digits", "100-digits"};
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

engine::points<double> points_of(stated_problem const& what, hilger::index_type steps) {
    auto const T = hilger::uniform(hilger::interval<double>{number_of(what.start), number_of(what.end)}, steps);
    return {T.min(), T.h(), steps, {}};
}

engine::walker walker_of_member(stated_problem const& what, engine::problem const& one, configuration const& c) {
    stated_problem its(one);
    its.start = what.start;
    its.end = what.end;
    auto const words = std::make_shared<hilger::text::vocabulary const>(one.lagrangian.formula().words());
    for (auto const& part : what.parts)
        its.parts.emplace_back(hilger::text::stated(part.formula().formula(), words, part.formula().source()));
    return [its, c](engine::initial<double> const& from, auto const& keep) {
        stated_problem mine = its;
        mine.known[typeid(beginning<double>)] = std::make_shared<beginning<double>>(beginning_from<double>(mine, from.q0, from.other));
        auto const path = begin_stated(mine, c);
        if (not path) hilger::error::raise<hilger::error::invalid_parameter>("there is no ", c.embedding, " for the members");
        for (hilger::index_type i = 0;; ++i) {
            auto const x = path->state();
            if (not keep(x.t, x.q, x.p) or i == c.steps) return;
            path->advance(1);
        }
    };
}

std::unique_ptr<walk> begin_stated(stated_problem const& what, configuration const& c) {
    engine::prepare_machine_code();
    if (not what.last.empty()) return begin_between(what, c);
    if (names_parts(what, c.embedding)) return begin_summed(what, c);
    bool const in_50_digits = c.scalar == "50-digits";
    if (engine::is_newmark(c.embedding))
        return in_50_digits ? begin_with_memory<hilger::float50>(what, c) : begin_with_memory<double>(what, c);
    if (what.of.has_memory()) return begin_damped(what, c);
    if (what.of.force) return in_50_digits ? begin_with_force<hilger::float50>(what, c) : begin_with_force<double>(what, c);
    if (in_50_digits) return begin_in_numbers<hilger::float50>(what, c);
    if (c.scalar == "100-digits") return begin_in_numbers<hilger::float100>(what, c);
    bool const has_inner_points = c.embedding.starts_with("gauss-");
    auto const in = [&]<class S>(S) {
        return engine::with_small_size(what.of.lagrangian.formula().words().dimension(), [&]<int D>(std::integral_constant<int, D>) {
            if constexpr (D > 0) {
                if (not has_inner_points) return begin_small<S, D, method_kind::without_inner_points>(what, c);
                if constexpr (std::same_as<S, double>) return begin_small<S, D, method_kind::with_inner_points>(what, c);
            }
            return begin_in_numbers<S>(what, c); // Galerkin in float too, which nobody takes for its speed
        });
    };
    return c.scalar == "float" ? in(float()) : in(double());
}

} // namespace program
