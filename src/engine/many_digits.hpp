// SPDX-License-Identifier: BSL-1.0
// Methods in scalars of many digits. Loops over digits take most of the run time and of the compile time, so only a few instances are
// compiled.
#pragma once

#include "engine/methods.hpp"
#include "engine/methods/one_step.hpp"
#include "engine/transformed_time.hpp"

namespace engine {

/// @throws hilger::error::invalid_parameter
template <class S>
std::unique_ptr<motion<S>> motion_in_digits(problem const& what, std::string const& method, points<S> const& T) {
    if (what.time_transformation) return in_transformed_time(what, method, T);
    std::string const scalar =
        std::numeric_limits<S>::is_exact ? "rationals" : std::to_string(std::numeric_limits<S>::digits10) + " digits";
    if (what.has_memory() and what.besides.empty())
        hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is for numbers of the processor, and not for ", scalar);
    if (auto made = in_one_step(what, method, T)) return made;
    auto const by = [&](auto const& make) {
        return with_mechanics(what, [&](auto const& mechanics) { return motion_by(make(mechanics), T, method); });
    };
    if (method == "verlet") return by([](auto const& L) { return hilger::stoermer_verlet(L); });
    if constexpr (not std::numeric_limits<S>::is_exact) {
        if (method == "kahan-li-8")
            return by([](auto const& L) { return hilger::compose(hilger::kahan_li<8>, hilger::stoermer_verlet(L)); });
        if (method == "gauss-8") return by([](auto const& L) { return hilger::embed(L, hilger::galerkin<8, hilger::gauss>); });
        if (method == "gauss-16") return by([](auto const& L) { return hilger::embed(L, hilger::galerkin<16, hilger::gauss>); });
    }
    refuse_method(method, kind_of_scalar<S>, scalar);
}

} // namespace engine
