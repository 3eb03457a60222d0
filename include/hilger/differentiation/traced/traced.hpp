// SPDX-License-Identifier: BSL-1.0
// A number that records its operations in a graph. A generic callable is called with these once; the graph gives its derivatives and what
// they depend on, for any number of variables.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include <Eigen/Core>

#include "hilger/differentiation/comparisons.hpp"
#include "hilger/differentiation/jet/jet.hpp"
#include "hilger/differentiation/traced/graph.hpp"

namespace hilger {

/// A number with its node in this thread's graph; a constant has none.
template <class S>
class traced : public detail::keeps_its_derivatives<S> {
public:
    using scalar_type = S;
    traced() = default;
    template <class C>
        requires std::constructible_from<S, C>
    explicit(false) traced(C const& constant) : value(constant) {}
    static traced at(int node, S const& value) {
        traced x(value);
        x.node = node;
        return x;
    }
    [[nodiscard]] bool is_constant() const { return node < 0; }
    [[nodiscard]] bool is(int constant) const { return node < 0 and value == S(constant); }
    /// Its node; a constant gets one.
    [[nodiscard]] int place() const { return node < 0 ? detail::formula_graph<S>::of_this_thread()->place_of(value) : node; }

    /// Whether this thread's graph has no values: a formula is written out, or derivatives are made.
    static bool is_written_out() {
        auto const* g = detail::formula_graph<S>::of_this_thread();
        return g != nullptr and not g->has_values;
    }

    S value{};
    int node = -1;

    // Overloads for two of them, before std::max and std::min of any type.
    friend traced max(traced const& x, traced const& y) { return detail::extremum<true>(x, y); }
    friend traced min(traced const& x, traced const& y) { return detail::extremum<false>(x, y); }

#define HILGER_ASSIGNMENT(operation)                                                                                                       \
    template <class Y>                                                                                                                     \
    traced& operator operation##=(Y const& y) {                                                                                            \
        return *this = *this operation y;                                                                                                  \
    }
    HILGER_ASSIGNMENT(+)
    HILGER_ASSIGNMENT(-)
    HILGER_ASSIGNMENT(*)
    HILGER_ASSIGNMENT(/)
#undef HILGER_ASSIGNMENT
};

/// Whether T is a traced number.
template <class T>
inline constexpr bool is_traced = false;
template <class S>
inline constexpr bool is_traced<traced<S>> = true;

namespace detail {

/// The graph's object for operation O, which has commutes, value(x, y) and pull_back(x, y, result, adjoint).
template <class O, class S>
void run_operation(S* x, int out, int count, int const* a, int const* b) {
    for (int i = 0; i < count; ++i) x[out + i] = O::value(x[a[i]], x[b[i]]);
}
template <class O, class S>
void run_in_a_row(S* __restrict out, int count, S const* __restrict a, bool all_a, S const* __restrict b, bool all_b) {
    if (all_a)
        for (int i = 0; i < count; ++i) out[i] = O::value(*a, b[i]);
    else if (all_b)
        for (int i = 0; i < count; ++i) out[i] = O::value(a[i], *b);
    else
        for (int i = 0; i < count; ++i) out[i] = O::value(a[i], b[i]);
}
template <class O, class S>
std::pair<traced<S>, traced<S>> pull_back_of(traced<S> const& x, traced<S> const& y, traced<S> const& result, traced<S> const& adjoint) {
    if constexpr (requires { O::pull_back(x, y, result, adjoint); })
        return O::pull_back(x, y, result, adjoint);
    else
        return {}; // of a choice (choices.hpp): see differentiator
}
template <class O, class S>
inline constexpr traced_operation<S> operation_object{O::name, O::commutes, &run_operation<O, S>, &run_in_a_row<O, S>, &pull_back_of<O, S>};

template <class O, class S>
traced<S> make_traced(traced<S> const& x, traced<S> const& y) {
    if (x.is_constant() and y.is_constant()) return traced<S>(O::value(x.value, y.value));
    auto& g = *formula_graph<S>::of_this_thread();
    int const a = x.place(), b = y.place(), made = g.make(operation_object<O, S>, a, b);
    return traced<S>::at(made, g.has_values ? O::value(x.value, y.value) : S(0));
}
/// An operation of one operand takes it twice.
template <class O, class S>
traced<S> make_traced(traced<S> const& x) {
    return make_traced<O>(x, x);
}

} // namespace detail

} // namespace hilger

namespace Eigen {

template <class S>
struct NumTraits<hilger::traced<S>> : NumTraits<S> {
    using Real = hilger::traced<S>;
    using NonInteger = Real;
    using Nested = Real;
    using Literal = typename NumTraits<S>::Literal;
    enum { IsComplex = 0, IsInteger = 0, IsSigned = 1, RequireInitialization = 1, ReadCost = 4, AddCost = 32, MulCost = 32 };
};

} // namespace Eigen
