// SPDX-License-Identifier: BSL-1.0
// A type-erased reference to a callable: a function that takes one is compiled once for all callables. It does not own the callable, and is
// for parameters only.
#pragma once

#include <type_traits>
#include <utility>

namespace hilger::detail {

template <class Signature>
class function_view;
/// std::function also copies and destroys its callable, which is most of its compile time.
template <class R, class... X>
class function_view<R(X...)> {
    void const* callable_;
    R (*call_)(void const*, X...);

    template <class F>
    static R call_as(void const* callable, X... x) {
        return (*static_cast<F const*>(callable))(std::forward<X>(x)...);
    }

public:
    template <class F>
        requires(not std::is_same_v<F, function_view> and std::is_invocable_r_v<R, F const&, X...>)
    constexpr explicit(false) function_view(F const& f) : callable_(&f), call_(call_as<F>) {}
    R operator()(X... x) const { return call_(callable_, std::forward<X>(x)...); }
};

} // namespace hilger::detail
