// SPDX-License-Identifier: BSL-1.0
// The history that suits a number of steps, a tolerance and a scalar.
#pragma once

#include <variant>

#include "hilger/history/blocks.hpp"
#include "hilger/history/exponentials.hpp"

namespace hilger {

/// `steps` values; without a tolerance as accurate as the direct sum. Exact scalars and few steps: direct. Many steps: exponentials where
/// there are some for the generating function and the order that reach the tolerance, else blocks.
struct automatic {
    index_type steps;
    double tolerance = 0;
    static constexpr index_type few = 128; ///< up to here the direct sum is the fastest
};

/// One of three engines; name() says which.
template <class... Engines>
class one_of_histories {
public:
    template <class Engine>
    explicit one_of_histories(Engine engine) : engine_(std::move(engine)) {}

    /// As the engine's; the same holds for the others.
    auto const& past() {
        return std::visit(
            [](auto& e) -> auto const& { return e.past(); }, engine_);
    }
    template <class V>
    void push(V const& x) {
        std::visit([&](auto& e) { e.push(x); }, engine_);
    }
    /// Everything that later sums depend on, for checkpoints.
    template <class Visit>
    void visit(Visit& each) {
        std::visit([&](auto& e) { e.visit(each); }, engine_);
    }
    index_type count() const {
        return std::visit([](auto const& e) { return e.count(); }, engine_);
    }
    void reset() {
        std::visit([](auto& e) { e.reset(); }, engine_);
    }
    std::size_t bytes() const {
        return std::visit([](auto const& e) { return e.bytes(); }, engine_);
    }
    std::string name() const {
        return std::visit([](auto const& e) { return e.name(); }, engine_);
    }

private:
    std::variant<Engines...> engine_;
};

/// @throws error::invalid_parameter for less than one step.
template <generating_function G, class S, class V>
auto make_history(automatic const& policy, S const& alpha, V const& like) {
    using value = plain_t<V>;
    if (policy.steps < 1) error::raise<error::invalid_parameter>("a history has one step or more, not ", policy.steps);
    if constexpr (not detail::memory::same_scalar<S, V>)
        return detail::memory::scalars_differ<S, V>();
    else if constexpr (std::numeric_limits<S>::is_exact)
        return direct_history<G, value>(alpha, like);
    else if constexpr (strongly_damped<G>) {
        using engine = one_of_histories<direct_history<G, value>, blocks_history<G, value>, exponentials_history<G, value>>;
        if (policy.steps <= automatic::few) return engine(direct_history<G, value>(alpha, like));
        using weights = detail::memory::exponential_weights<G, S>;
        if (weights::has(alpha) and weights::holds(policy.tolerance)) {
            try {
                return engine(exponentials_history<G, value>(exponentials{policy.tolerance, policy.steps}, alpha, like));
            } catch (error::invalid_parameter const&) { // they looked at themselves, and do not reach the tolerance
            }
        }
        return engine(blocks_history<G, value>(alpha, like));
    } else {
        using engine = one_of_histories<direct_history<G, value>, blocks_history<G, value>>;
        if (policy.steps <= automatic::few) return engine(direct_history<G, value>(alpha, like));
        return engine(blocks_history<G, value>(alpha, like));
    }
}

} // namespace hilger
