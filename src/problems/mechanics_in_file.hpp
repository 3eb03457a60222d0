// SPDX-License-Identifier: BSL-1.0
// The mechanics in a file: Lagrangians, their embeddings, forces, damping, a material.
#pragma once

#include <array>

#include "from_file.hpp"
#include "toml_file.hpp"

namespace program {

class mechanics_in_file {
public:
    mechanics_in_file(toml_file const& file, std::shared_ptr<hilger::text::vocabulary const> words)
        : file_(file), words_(std::move(words)) {}

    [[nodiscard]] stated_problem read() const {
        stated_problem what = lagrangian(file_.required("lagrangian"));
        if (auto const* f = file_.get("force")) what.of.force = force(*f);
        if (auto const* d = file_.get("damping")) what.of.damping = damping(*d);
        if (auto const* m = file_.get("material")) what.of.material = material(*m, what.of);
        return what;
    }
    /// g of dt = g(q) dtau.
    void transform_time(stated_problem& what, std::vector<hilger::text::coordinate> const& coordinates) const {
        auto const* given = file_.get("time_transformation");
        if (given == nullptr) return;
        auto const g = hilger::text::read(file_.text_of(*given, "time_transformation"), file_.path(), toml_file::begin_of_text(*given));
        file_.saying_where(given, [&] {
            engine::require_constant_energy(what.of);
            what.of.time_transformation.emplace(g, what.of.lagrangian.formula(), coordinates, file_.path());
            return 0;
        });
    }
    /// A list has one embedding for each part of the Lagrangian.
    [[nodiscard]] std::string embedding(toml::node const& n, stated_problem const& what) const {
        auto const* list = n.as_array();
        if (list == nullptr) return on_one_line(file_.text_of(n, "embedding"));
        std::string all;
        for (auto const& one : *list) all += (all.empty() ? "" : " + ") + on_one_line(file_.text_of(one, "embedding"));
        if (what.parts.size() != list->size() or not file_.saying_where(&n, [&] { return is_for_parts(what, all); }))
            file_.refuse(&n, "a list of embeddings has one for each Lagrangian of a list, and here are " + std::to_string(list->size()) +
                                 " for " + std::to_string(std::max<std::size_t>(what.parts.size(), 1)));
        return all;
    }

private:
    /// One formula, or a list of them.
    [[nodiscard]] std::vector<hilger::text::stated> formulas(toml::node const& n, char const* key) const {
        std::vector<hilger::text::stated> all;
        if (auto const* list = n.as_array())
            for (auto const& f : *list) all.push_back(file_.formula(f, words_, key));
        else
            all.push_back(file_.formula(n, words_, key));
        return all;
    }
    [[nodiscard]] stated_problem lagrangian(toml::node const& n) const {
        auto const all = formulas(n, "lagrangian");
        if (all.empty()) file_.refuse(&n, "a Lagrangian is a formula, or a list of formulas that add up, and this list is empty");
        hilger::text::expression sum = all[0].formula();
        for (std::size_t k = 1; k < all.size(); ++k) sum = sum + all[k].formula();
        stated_problem what(hilger::text::stated_lagrangian(hilger::text::stated(sum, words_, file_.path())));
        if (all.size() > 1)
            for (auto const& one : all) what.parts.emplace_back(one);
        return what;
    }
    [[nodiscard]] hilger::text::stated_force force(toml::node const& n) const {
        std::vector<hilger::text::stated> const all = formulas(n, "force");
        if (all.empty()) file_.refuse(&n, "a force has one formula for each coordinate, and this list is empty");
        return file_.saying_where(&n, [&] { return hilger::text::stated_force(all); });
    }
    [[nodiscard]] std::vector<engine::problem::damping_term> damping(toml::node const& n) const {
        auto const* list = n.as_array();
        if (list == nullptr or list->empty()) file_.refuse(&n, "damping is a list, as [ { rho = 0.2, alpha = 0.5 } ]");
        std::vector<engine::problem::damping_term> terms;
        for (auto const& term : *list) {
            auto const* t = term.as_table();
            if (t == nullptr or t->size() != 2 or not t->contains("rho") or not t->contains("alpha"))
                file_.refuse(&term, "a term of the damping is { rho = 0.2, alpha = 0.5 }");
            terms.push_back({exactly(*t->get("rho")), exactly(*t->get("alpha"))});
            if (not(terms.back().alpha > 0 and terms.back().alpha < 2)) file_.refuse(t->get("alpha"), "alpha lies between 0 and 2");
        }
        return terms;
    }
    [[nodiscard]] engine::problem::zener_material material(toml::node const& n, engine::problem const& of) const {
        auto const& t =
            file_.table_of(n, "a material is { relaxed_modulus = 1e6, unrelaxed_modulus = 5e7, relaxation_time = 1e-3, alpha = 0.5 }");
        constexpr std::array<std::string_view, 4> known{"relaxed_modulus", "unrelaxed_modulus", "relaxation_time", "alpha"};
        file_.require_known(t, known);
        for (auto const& key : known)
            if (not t.contains(key)) file_.refuse(&n, "a material has " + std::string(key) + ", and this one has not");
        if (not of.damping.empty()) file_.refuse(&n, "there is a material or damping, and here are both");
        engine::problem one = of;
        one.material = {exactly(*t.get("relaxed_modulus")), exactly(*t.get("unrelaxed_modulus")), exactly(*t.get("relaxation_time")),
                        exactly(*t.get("alpha"))};
        file_.saying_where(&n, [&] {
            require_structure(one);
            return 0;
        });
        return *one.material;
    }
    /// The exact value of the digits in a file.
    [[nodiscard]] hilger::float100 exactly(toml::node const& n) const {
        return *hilger::text::number_in<hilger::float100>(file_.digits_of(n));
    }
    toml_file const& file_;
    std::shared_ptr<hilger::text::vocabulary const> words_;
};

} // namespace program
