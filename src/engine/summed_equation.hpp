// SPDX-License-Identifier: BSL-1.0
// The equation of a sum of actions of one type, in a number chosen at run time; action_sum of hilger/variational/sum_of_actions.hpp is for
// two.
#pragma once

#include <algorithm>
#include <vector>

#include "hilger/function/function.hpp"
#include "hilger/variational/variation.hpp"

namespace engine {

template <class Action>
struct action_list {
    using root_type = typename Action::root_type;
    using position_type = typename Action::position_type;
    std::vector<Action> parts;
};

/// The sum of functions on the same points; the first may have another type.
template <class First, class Other>
class function_list : public hilger::function_interface<function_list<First, Other>> {
public:
    using root_type = typename First::root_type;
    using domain_type = typename First::domain_type;
    function_list(First first, std::vector<Other> others) : first_(std::move(first)), others_(std::move(others)) {}
    [[nodiscard]] decltype(auto) root() const { return first_.root(); }
    [[nodiscard]] domain_type domain() const { return first_.domain(); }
    [[nodiscard]] auto get(hilger::index_type i) const {
        hilger::value_of<First> sum = first_.get(i);
        for (Other const& f : others_) sum += f.get(i);
        return sum;
    }

private:
    First first_;
    std::vector<Other> others_;
};

} // namespace engine

namespace hilger {

/// A force acts beside the first Lagrangian, at its nodes.
template <class Action, class P>
class euler_lagrange<engine::action_list<Action>, P> {
    std::vector<euler_lagrange<Action, P>> parts_;
    /// The values of `of` for each part after the first, with its number among those.
    template <class Of>
    [[nodiscard]] auto others(Of const& of) const {
        std::vector<decltype(of(parts_[0], std::size_t()))> all;
        for (std::size_t k = 1; k < parts_.size(); ++k) all.push_back(of(parts_[k], k - 1));
        return all;
    }

public:
    explicit euler_lagrange(engine::action_list<Action> const& sum) {
        for (Action const& part : sum.parts) parts_.emplace_back(part);
    }
    static constexpr reach reads = euler_lagrange<Action, P>::reads;

    template <discrete_function X, class Force = no_force>
    auto residual(X const& x, Force const& force = {}) const {
        return engine::function_list(parts_[0].residual(x, force), others([&](auto const& part, std::size_t) { return part.residual(x); }));
    }
    template <class Force = no_force>
    [[nodiscard]] auto derivatives(Force const& force = {}) const {
        return std::pair(parts_[0].derivatives(force), others([](auto const& part, std::size_t) { return part.derivatives(); }));
    }
    template <discrete_function X, class Kept>
    auto residual_slope(X const& x, index_type k, Kept const& kept) const {
        return engine::function_list(parts_[0].residual_slope(x, k, kept.first),
                                     others([&](auto const& part, std::size_t n) { return part.residual_slope(x, k, kept.second[n]); }));
    }
    template <discrete_function X, class Kept>
    auto residual_size(X const& x, index_type k, Kept const& kept) const {
        auto sum = parts_[0].residual_size(x, k, kept.first);
        for (std::size_t n = 1; n < parts_.size(); ++n) sum += parts_[n].residual_size(x, k, kept.second[n - 1]);
        return sum;
    }
};

} // namespace hilger
