// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <typeindex>

#include "engine/ensemble/ensemble.hpp"
#include "scene.hpp"

namespace program {

/// A formula observed along the walk, with the name of its column.
struct named_formula {
    std::string name;
    hilger::text::stated of;
};
/// An initial value given by a formula of the parameters.
struct initial_formula {
    std::size_t at; ///< among all coordinates
    std::size_t i;  ///< within its own name
    hilger::text::stated of;
};
/// The vocabulary of initial values, in which i is the index of the component, unless that name is taken.
inline std::shared_ptr<hilger::text::vocabulary const> words_for_component(hilger::text::vocabulary const& words, std::size_t i) {
    auto known = std::make_shared<hilger::text::vocabulary>(words);
    if (known->find("i") == nullptr) known->set("i", std::to_string(i));
    return known;
}
/// A problem in text with its data; numbers are kept as digits.
struct stated_problem {
    explicit stated_problem(engine::problem what) : of(std::move(what)) {}
    explicit stated_problem(hilger::text::stated_lagrangian L) : of{std::move(L), {}, {}, "", {}} {}
    engine::problem of;
    std::vector<hilger::text::stated_lagrangian> parts;               ///< its sum is the Lagrangian, if there are several parts
    std::vector<std::string> q, v;                                    ///< initial, one for each coordinate
    std::vector<std::string> last;                                    ///< instead of v, for problems between two ends
    std::vector<initial_formula> q_formulas, v_formulas;              ///< for members of an ensemble with other parameters
    std::string start, end;                                           ///< of T
    std::vector<named_formula> conserved, observed;                   ///< beside the energy
    mutable std::map<std::type_index, std::shared_ptr<void>> known{}; ///< data that one walk leaves for the next one
    /// Whether the energy is constant.
    [[nodiscard]] bool conserves_energy() const {
        return not of.force and not of.has_memory() and not of.lagrangian.formula().reads(hilger::text::meaning::role::time);
    }
};

/// The scene in a TOML file, named after the file.
/// @throws hilger::error::unreadable with file, line and column, the text found there and the accepted ones
scene scene_from_file(std::string const& path);
/// The same, of the content of a file of this name.
scene scene_from_text(std::string_view content, std::string const& path);
/// The methods and the scalars available to a problem.
std::vector<std::string> embeddings_of(stated_problem const& what);
std::vector<std::string> scalars_of(stated_problem const& what, std::vector<std::string> const& embeddings);
/// Whether the method of c is available in its scalar.
bool has_method(stated_problem const& what, configuration const& c);
/// Whether a method with a number or with operators, theta:0.3 or integral(L(q, Delta_plus[q])), is available to the problem.
/// @throws hilger::error::unreadable, hilger::error::invalid_parameter for an error in it
bool has_embedding(stated_problem const& what, std::string const& method);
/// @throws hilger::error::invalid_parameter with the reason, unless it is a linear structure with one fractional term or material
void require_structure(engine::problem const& of);
/// Starts its walk along T. @throws the errors of methods and steps
std::unique_ptr<walk> begin_stated(stated_problem const& what, configuration const& c);
/// Whether a method names one for each of several parts of the Lagrangian, "mid-point + order-one".
/// @throws hilger::error::invalid_parameter when one of them is no embedding in one step, or their number is not that of the parts
bool is_for_parts(stated_problem const& what, std::string const& method);
/// The value of digits, rounded to S. @throws hilger::error::invalid_parameter beyond the largest number of S
template <class S = double>
S number_of(std::string const& digits) {
    if (auto const x = hilger::text::number_in<S>(digits)) return *x;
    auto const x = static_cast<S>(*hilger::text::number_in<hilger::float100>(digits));
    if (not hilger::is_finite(x))
        hilger::error::raise<hilger::error::invalid_parameter>("the number ", digits, " is beyond the largest one of the scalar");
    return x;
}
template <class S = double>
engine::vector<S> numbers_of(std::vector<std::string> const& digits) {
    engine::vector<S> x(static_cast<Eigen::Index>(digits.size()));
    for (std::size_t k = 0; k < digits.size(); ++k) x(static_cast<Eigen::Index>(k)) = number_of<S>(digits[k]);
    return x;
}
/// T with so many steps.
engine::points<double> points_of(stated_problem const& what, hilger::index_type steps);
/// The walk of a single member of an ensemble, possibly with other parameters, from velocities.
engine::walker walker_of_member(stated_problem const& what, engine::problem const& one, configuration const& c);

} // namespace program
