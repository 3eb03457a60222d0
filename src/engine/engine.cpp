// SPDX-License-Identifier: BSL-1.0
#include "engine/machine_code/machine_code.hpp"
#include "engine/methods.hpp"
#include "engine/motions.hpp"
#include "engine/transformed_time.hpp"

namespace engine {

void require_constant_energy(problem const& what) {
    char const* const why = what.has_memory()              ? "fractional damping remembers the past in t"
                            : what.force                   ? "a force changes the energy"
                            : what.lagrangian.reads_time() ? "the energy changes where a Lagrangian contains the time"
                            : not what.besides.empty()     ? "a sum of actions has several embeddings"
                                                           : nullptr;
    if (why != nullptr)
        hilger::error::raise<hilger::error::invalid_parameter>(why,
                                                               ", and a transformed time dt = g(q) dtau is for one Lagrangian L(q, v)");
}

template <>
std::unique_ptr<motion<double>> make_motion(problem const& what, std::string const& method, points<double> const& T) {
    if (what.time_transformation) return in_transformed_time(what, method, T);
    prepare_machine_code();
    if (what.besides.empty())
        if (auto made = by_newmark(what, method, T)) return made;
    if (what.has_memory() and what.besides.empty()) {
        if (what.material)
            hilger::error::raise<hilger::error::invalid_parameter>(
                "with a Zener material the method is g-alpha-newmark or gl-newmark, and not '", method, "'");
        if (auto made = damped(what, method, T)) return made;
        hilger::error::raise<hilger::error::invalid_parameter>(
            "with fractional damping the method is mid-point, radau-3, radau-4 or radau-5, or g-alpha-newmark or gl-newmark of linear "
            "structures, and not '",
            method, "'");
    }
    if (auto made = embedded_in_one_step(what, method, T)) return made;
    if (auto made = embedded_with_inner_points(what, method, T)) return made;
    if (auto made = composed(what, method, T)) return made;
    if (auto made = between_two_ends(what, method, T)) return made;
    if (method.starts_with("radau-"))
        hilger::error::raise<hilger::error::invalid_parameter>("the method ", method, " is for fractional damping");
    refuse_method(method, scalar_kind::machine, "double");
}

} // namespace engine
