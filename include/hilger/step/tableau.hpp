// SPDX-License-Identifier: BSL-1.0
// An embedding on one step, in numbers. The control values U_0 = q_i, ..., U_d = q_{i+1}, at the ends of the step and at points inside,
// give the position and the velocity at each node of the integral, A_k = sum_j position[k][j] U_j and B_k = sum_j velocity[k][j] U_j, and
// L_h = sum_k weight[k] L(A_k, B_k) (Cresson-Safi (47), (48) for mid-point). The operators applied to unit functions give the numbers.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "hilger/embedding/embedding.hpp"
#include "hilger/embedding/one_step.hpp"
#include "hilger/embedding/polynomial.hpp"

namespace hilger {

/// The coefficients of an embedding for steps of one length h.
template <class S>
struct tableau {
    int nodes = 1, controls = 2;
    std::vector<S> position, velocity; ///< nodes x controls, row by row; velocities carry 1/h
    std::vector<S> weight;             ///< carry h
    std::vector<S> inside;             ///< with points inside the step, the time of each node since its beginning
    std::vector<int> part;             ///< in a sum of actions, the number of each node's Lagrangian
    /// Velocities are slopes of the polynomial through values at equal distances, integrated exactly by the weights: uniform motion has its
    /// velocity, and its momentum, at every node.
    bool integrates_slopes = false;
    /// Coefficients of U_j in the position and in the velocity at node k, its weight, and the number of its Lagrangian.
    [[nodiscard]] S const& a(int k, int j) const { return position[static_cast<std::size_t>(controls * k + j)]; }
    [[nodiscard]] S const& b(int k, int j) const { return velocity[static_cast<std::size_t>(controls * k + j)]; }
    [[nodiscard]] S const& w(int k) const { return weight[static_cast<std::size_t>(k)]; }
    [[nodiscard]] int part_of(int k) const { return part.empty() ? 0 : part[static_cast<std::size_t>(k)]; }
    /// Position or velocity of the constant 1 at node k: of_constant(k, &tableau::a).
    [[nodiscard]] S of_constant(int k, S const& (tableau::*of)(int, int) const) const {
        S sum(0);
        for (int m = 0; m < controls; ++m) sum = sum + (this->*of)(k, m);
        return sum;
    }
    /// Whether constants have position 1 and velocity 0, to rounding.
    [[nodiscard]] bool reproduces_constants() const {
        S const rounding = S(64) * epsilon<S>();
        for (int k = 0; k < nodes; ++k) {
            S size_b(0);
            for (int m = 0; m < controls; ++m) size_b = size_b + magnitude(b(k, m));
            if (not(magnitude(S(of_constant(k, &tableau::a) - S(1))) <= rounding) or
                not(magnitude(of_constant(k, &tableau::b)) <= rounding * size_b))
                return false;
        }
        return true;
    }
    /// The time of node k in a step from t to t + h: the position operator on the function t -> t.
    [[nodiscard]] S time(int k, S const& t, S const& h) const {
        return inside.empty() ? S(t + a(k, 1) * h) : S(t + inside[static_cast<std::size_t>(k)]);
    }
    /// The tableau of a step of `share` times the length.
    [[nodiscard]] tableau shortened_to(S const& share) const {
        tableau t = *this;
        for (S& x : t.weight) x = x * share;
        for (S& x : t.inside) x = x * share;
        for (S& x : t.velocity) x = x / share;
        return t;
    }
};

namespace detail {
/// Makes c + f = w exact for numbers that satisfy it to rounding: else the one-node step is not symplectic. w less the larger one is exact.
template <class S>
void add_up_to(S const& w, S& c, S& f) {
    if (magnitude(c) < magnitude(f))
        c = w - f;
    else
        f = w - c;
}
/// Shortens the equation of a step to a share of its length, for steps that grow when no guess converges (newton/newton.hpp); the
/// destructor restores the whole step. The tableau is copied when first shortened: most searches do not need it.
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
} // namespace detail

/// Properties of an embedding's type, computed by its operators over a finite field with exact equality.
struct embedding_facts {
    bool one_node = false; ///< one node; position of 1 is 1, its velocity 0; weight times velocity of q_{i+1} is 1
    bool at_start = false; ///< and the position is q_i
    bool at_end = false;   ///< and the position is q_{i+1}
};
namespace detail {
template <class E>
inline constexpr embedding_facts facts_ = {};
template <linear_map A, linear_map B, class W, bool Checked>
    requires(not has_numbers<A, B> and reads_one_step<A, B>)
inline constexpr embedding_facts facts_<embedding<A, B, W, Checked>> = [] {
    using F = prime_field;
    using step = on_one_step<A, B, W, F>;
    if (step::nodes_ != 1 or step::controls != 2) return embedding_facts{};
    F const h = some_step, one(1), zero(0);
    auto const constant = step::constant(one), start = step::unit(0), end = step::unit(step::controls - 1);
    bool const plain = step::value(A{}, h, constant, 0) == one and step::value(B{}, h, constant, 0) == zero and
                       step::value(B{}, h, end, 0) * step::weight(A{}, B{}, h, 0) == one;
    return embedding_facts{plain, plain and step::value(A{}, h, end, 0) == zero, plain and step::value(A{}, h, start, 0) == zero};
}();
/// Numbers known at run time: consistency, checked then, leaves no other velocity than (q_{i+1} - q_i) / h.
template <linear_map A, linear_map B, class W>
    requires(has_numbers<A, B>and reads_one_step<A, B>)
inline constexpr embedding_facts facts_<embedding<A, B, W, true>> = [] {
    using step = on_one_step<A, B, W, prime_field>;
    return embedding_facts{step::nodes_ == 1 and step::controls == 2, false, false};
}();
} // namespace detail
/// The properties of embedding E.
template <class E>
inline constexpr embedding_facts facts_of = detail::facts_<std::remove_cvref_t<E>>;

/// Number of control values of a step, known by the type.
template <class E>
inline constexpr int controls_of = 2;
template <linear_map A, linear_map B, class W, bool Checked>
inline constexpr int controls_of<embedding<A, B, W, Checked>> = static_cast<int>(A::from::last(1)) + 1;

namespace detail {
/// Whether each value depends on few points; whether these are the ends of one step.
template <class E>
inline constexpr bool is_local = true;
template <linear_map A, linear_map B, class W, bool Checked>
inline constexpr bool is_local<embedding<A, B, W, Checked>> = reads_few_points<A, B>;
template <class E>
inline constexpr bool is_on_one_step = true;
template <linear_map A, linear_map B, class W, bool Checked>
inline constexpr bool is_on_one_step<embedding<A, B, W, Checked>> = reads_one_step<A, B>;

/// @throws error::invalid_parameter if the numbers of an embedding are not consistent to rounding
template <class W, class S, linear_map A, linear_map B>
void require_consistent(A const& a, B const& b, S const& h, char const* name) {
    auto const near = [](S const& x, S const& y) { return magnitude(S(x - y)) <= S(16) * epsilon<S>(); };
    auto const refuse = [&](auto const&... what) {
        error::raise<error::invalid_parameter>(
            "the ", what..., ", and of the embedding \"", name,
            "\" not, so that it integrates another "
            "system; if that is meant, say make_embedding<Weight>(position, velocity, name, inconsistent)");
    };
    switch (examine<W>(a, b, h, near)) {
    case consistency::holds:
        return;
    case consistency::weights:
        refuse("weights of an embedding add up to the step h");
        break;
    case consistency::position_of_one:
        refuse("position operator of an embedding makes 1 of the constant 1");
        break;
    case consistency::velocity_of_one:
        refuse("velocity operator of an embedding makes 0 of the constant 1");
        break;
    case consistency::velocity_of_time:
        refuse("velocity operator of an embedding makes 1 of the function t");
        break;
    case consistency::values_inside:
        refuse("velocities at the nodes of an embedding determine the values inside the step");
        break;
    }
}
} // namespace detail

namespace detail {
template <class Velocity>
inline constexpr bool integrates_slopes = false;
template <int Degree, known_quadrature Quadrature, int Count>
inline constexpr bool integrates_slopes<polynomial_reading<Degree, Quadrature, Count, true>> = 1 < Degree and Degree - 1 <=
                                                                                               Quadrature::exact_up_to(Count);
} // namespace detail

/// The tableau of e for steps of length h. @throws error::invalid_parameter if numbers known at run time only are not consistent
template <class S, linear_map A, linear_map B, class W, bool Checked>
tableau<S> tableau_of(embedding<A, B, W, Checked> const& e, S const& h) {
    if constexpr (Checked and detail::has_numbers<A, B> and std::numeric_limits<S>::is_specialized) // formulas cannot be compared
        detail::require_consistent<W>(e.position, e.velocity, h, e.name);
    using step = detail::on_one_step<A, B, W, S>;
    tableau<S> t;
    t.nodes = step::nodes_;
    t.controls = step::controls;
    for (int k = 0; k < t.nodes; ++k) {
        t.weight.push_back(step::weight(e.position, e.velocity, h, k));
        if constexpr (step::controls > 2) t.inside.push_back(step::value(e.position, h, step::time(h), k));
        for (int j = 0; j < t.controls; ++j) {
            t.position.push_back(step::value(e.position, h, step::unit(j), k));
            t.velocity.push_back(step::value(e.velocity, h, step::unit(j), k));
        }
    }
    t.integrates_slopes = detail::integrates_slopes<B>;
    return t;
}

} // namespace hilger
