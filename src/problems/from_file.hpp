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

/// What is looked at along the way, by the name of its column.
struct named_formula {
    std::string name;
    hilger::text::stated of;
};
/// An initial value that a formula of the parameters gives.
struct initial_formula {
    std::size_t at; ///< of all coordinates
    std::size_t i;  ///< of its own
    hilger::text::stated of;
};
/// The words of initial values: i is which component it is, where that is not the name of something else.
inline std::shared_ptr<hilger::text::vocabulary const> words_for_component(hilger::text::vocabulary const& words, std::size_t i) {
    auto known = std::make_shared<hilger::text::vocabulary>(words);
    if (known->find("i") == nullptr) known->set("i", std::to_string(i));
    return known;
}
/// A problem in text with its data, digits in the place of numbers.
struct stated_problem {
    explicit stated_problem(engine::problem what) : of(std::move(what)) {}
    explicit stated_problem(hilger::text::stated_lagrangian L) : of{std::move(L), {}, {}, "", {}} {}
    engine::problem of;
    std::vector<hilger::text::stated_lagrangian> parts;               ///< whose sum is the Lagrangian, where there are several
    std::vector<std::string> q, v;                                    ///< initial, one for each coordinate
    std::vector<std::string> last;                                    ///< instead of v, where q is given at both ends
    std::vector<initial_formula> q_formulas, v_formulas;              ///< where members of an ensemble have other parameters
    std::string start, end;                                           ///< of T
    std::vector<named_formula> conserved, observed;                   ///< beside the energy
    mutable std::map<std::type_index, std::shared_ptr<void>> known{}; ///< what one walk leaves for the next one
    /// Whether the energy is constant.
    [[nodiscard]] bool conserves_energy() const {
        return not of.force and not of.has_memory() and not of.lagrangian.formula().reads(hilger::text::meaning::role::time);
    }
};

/// The scene that a file in TOML states; its name is that of the file.
/// @throws hilger::error::unreadable with file, line and column, what stands there and what is accepted
scene scene_from_file(std::string const& path);
/// The same of what stands in a file of this name.
scene scene_from_text(std::string_view content, std::string const& path);
/// The methods and the scalars that a stated problem can be run with.
std::vector<std::string> embeddings_of(stated_problem const& what);
std::vector<std::string> scalars_of(stated_problem const& what, std::vector<std::string> const& embeddings);
/// Whether there is the method of c in its scalar.
bool has_method(stated_problem const& what, configuration const& c);
/// Whether a method that is no name is one of numbers or operators, theta:0.3 or integral(L(q, Delta_plus[q])), that the problem has.
/// @throws hilger::error::unreadable, hilger::error::invalid_parameter where something in it is wrong
bool has_embedding(stated_problem const& what, std::string const& method);
/// @throws hilger::error::invalid_parameter that says why it is no linear structure with one fractional term or material
void require_structure(engine::problem const& of);
/// Its way along T. @throws what methods and steps throw
std::unique_ptr<walk> begin_stated(stated_problem const& what, configuration const& c);
/// Whether a method is one for each of several parts of the Lagrangian, "mid-point + order-one".
/// @throws hilger::error::invalid_parameter where one of them is no embedding in one step, or there are not as many as parts
bool is_for_parts(stated_problem const& what, std::string const& method);
/// What digits of a number spell, rounded to what S has. @throws hilger::error::invalid_parameter beyond its largest number
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
/// How a member of an ensemble, which may have other parameters, is walked alone, from velocities.
engine::walker walker_of_member(stated_problem const& what, engine::problem const& one, configuration const& c);

} // namespace program
