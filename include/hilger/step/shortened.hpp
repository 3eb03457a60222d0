// SPDX-License-Identifier: BSL-1.0
// The equation of a step, of a share of its length for a while: what a step that no guess leads to grows from (newton/newton.hpp).
#pragma once

#include <optional>
#include <type_traits>
#include <utility>

#include "hilger/step/tableau.hpp"

namespace hilger::detail {

/// The equation is that of the whole step again when this ends. Its numbers are copied where it is shortened, not before: most steps that
/// are searched for are not.
template <class Equation>
class shortened_step {
    using S = std::remove_cvref_t<decltype(std::declval<Equation&>().h())>;
    Equation& equation_;
    S const h_ = equation_.h();
    std::optional<tableau<S>> whole_{};
    S share_{1};

public:
    explicit shortened_step(Equation& equation) : equation_(equation) {}
    shortened_step(shortened_step const&) = delete;
    shortened_step& operator=(shortened_step const&) = delete;
    ~shortened_step() { shorten_to(S(1)); }
    [[nodiscard]] S const& share() const { return share_; }
    void shorten_to(S const& share) {
        if (share == share_) return;
        if (not whole_) whole_ = equation_.table();
        share_ = share;
        if (share == S(1))
            equation_.prepare(*whole_, h_);
        else
            equation_.prepare(whole_->shortened_to(share), S(share * h_));
    }
};

} // namespace hilger::detail
