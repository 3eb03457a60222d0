// SPDX-License-Identifier: BSL-1.0
// Parts of a file: positions and velocities at the ends of the interval, { q = 1, v = [0, "sqrt(2)/k"] }; observed quantities.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "from_file.hpp"
#include "hilger/multiprecision.hpp"
#include "toml_file.hpp"

namespace program {

/// Names with their lengths, 0 for one number.
using named_coordinates = std::vector<std::pair<std::string, int>>;

/// The values of names: digits, and the formulas among them.
struct wanted_values {
    named_coordinates const& names;
    std::vector<std::string>& to;
    std::vector<initial_formula>& formulas;
};
/// Reads the table `key`, with as many numbers as the names have components.
class values_in_file {
public:
    values_in_file(toml_file const& file, std::shared_ptr<hilger::text::vocabulary const> words) : file_(file), words_(std::move(words)) {}

    void read(std::string const& key, char const* as, std::vector<wanted_values> const& wanted) const {
        auto const& n = file_.required(key.c_str());
        auto const& given = file_.table_of(n, as);
        std::size_t used = 0;
        for (auto const& [names, to, formulas] : wanted)
            for (auto const& [name, size] : names) {
                auto const* values = given.get(name);
                if (values == nullptr) file_.refuse(&n, "the " + key + " values have no '" + name + "'");
                auto const count = static_cast<std::size_t>(std::max(size, 1));
                auto const* list = values->as_array();
                bool const for_all = is_formula(*values) or values->value<double>() == 0.0;
                std::size_t const here = list != nullptr ? list->size() : for_all ? count : 1;
                if (here != count)
                    file_.refuse(values, "'" + name + "' has " + std::to_string(count) + ' ' + key + " values, and here are " +
                                             std::to_string(here));
                for (std::size_t k = 0; k < count; ++k) {
                    auto const& one = list != nullptr ? *list->get(k) : *values;
                    if (is_formula(one)) {
                        formulas.push_back({to.size(), k, file_.formula(one, words_for_component(*words_, k), "an initial value")});
                        to.push_back(value(one, formulas.back().of, "an initial value"));
                    } else
                        to.push_back(file_.digits_of(one));
                }
                ++used;
            }
        if (used != given.size())
            file_.refuse(&n, "there are " + key + " values of what is no coordinate" + (wanted.size() > 1 ? " and no velocity" : ""));
    }
    /// A number, or a formula of numbers, as "2*pi".
    [[nodiscard]] std::string end_of_interval(toml::node const& n) const {
        if (not is_formula(n)) return file_.digits_of(n);
        try {
            return value(n, file_.formula(n, hilger::text::no_words(), "interval"), "an end of the interval");
        } catch (hilger::error::unreadable const&) {
            file_.refuse(&n, "an end of the interval is a number, as 1, \"1/3\" or \"2*pi\"");
        }
    }

private:
    [[nodiscard]] static bool is_formula(toml::node const& n) {
        auto const s = n.value_exact<std::string>();
        return s and not hilger::text::number_in<double>(*s);
    }
    /// The value of a formula of the parameters and of i, in a hundred digits.
    [[nodiscard]] std::string value(toml::node const& n, hilger::text::stated const& f, std::string const& what) const {
        using R = hilger::float100;
        if (f.reads_state()) file_.refuse(&n, what + " is a number, or a formula of the parameters and of i, which component it is");
        R const x = f.number<R>();
        if (not(abs(x) <= R(std::numeric_limits<double>::max()))) file_.refuse(&n, what + " is a finite number, and this one is not");
        return x.str(std::numeric_limits<R>::max_digits10, std::ios::scientific);
    }
    toml_file const& file_;
    std::shared_ptr<hilger::text::vocabulary const> words_;
};

/// Reads the observed quantities and the reference of a file: units, conserved, observed, pictures, reference, exact. Expects the columns
/// of t, positions and momenta.
void observe(toml_file const& file, std::shared_ptr<hilger::text::vocabulary const> const& words, stated_problem& what, scene& s);

} // namespace program
