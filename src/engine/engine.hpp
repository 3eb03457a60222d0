// SPDX-License-Identifier: BSL-1.0
// Problems that are known at run time only, solved by what is compiled once: a Lagrangian in text, forces and fractional damping beside it,
// one of a list of methods (methods.hpp), any scale, one of a few scalars. It is the library's engine and nothing else: flows of
// stated_lagrangian. Files, the command line and Python have it in common.
#pragma once

#include <functional>
#include <iosfwd>
#include <limits>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "hilger/multiprecision.hpp"
#include "hilger/text/lagrangian.hpp"

namespace engine {

/// What moves. Damping is -rho D^alpha q of every coordinate, as a mean over each step where the method is an embedding.
struct problem {
    hilger::text::stated_lagrangian lagrangian;
    std::optional<hilger::text::stated_force> force;
    struct damping_term {
        hilger::float100 rho, alpha;
    };
    std::vector<damping_term> damping;
    std::string history = "direct"; ///< direct, blocks, exponentials, exponentials:1e-8
    /// The fractional Zener material that a structure is made of (hilger/fractional/zener.hpp); the Lagrangian has the relaxed modulus.
    struct zener_material {
        hilger::float100 relaxed_modulus, unrelaxed_modulus, relaxation_time, alpha;
    };
    std::optional<zener_material> material{};
    /// Other Lagrangians of the same action, each read by a method of its own. A force is beside the first one.
    struct summand {
        hilger::text::stated_lagrangian lagrangian;
        std::string method;
    };
    std::vector<summand> besides{};
    [[nodiscard]] bool has_memory() const { return not damping.empty() or material; }
};

/// T: {start + i step}, or any increasing points.
template <class S>
struct points {
    S start{}, step{};
    hilger::index_type steps = 0;
    std::vector<S> given;
    std::optional<S> last{}; ///< of equal steps, where it is known exactly
    [[nodiscard]] bool is_uniform() const { return given.empty(); }
    /// That of a uniform scale.
    [[nodiscard]] std::optional<S> equal_step() const { return is_uniform() ? std::optional(step) : std::nullopt; }
};

template <class S>
using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
/// A state of any kind, numbers too.
template <class S, class V>
vector<S> as_vector(V const& x) {
    if constexpr (std::is_convertible_v<V, S>)
        return vector<S>::Constant(1, S(x));
    else
        return x;
}
/// The same into a vector of that length.
template <class S, class V>
void put_into(vector<S>& to, V const& x) {
    if constexpr (std::is_convertible_v<V, S>)
        to(0) = x;
    else
        to = x;
}
enum class second_datum { velocity, momentum, next_position };
/// q0, and v0, p0 or q1.
template <class S>
struct initial {
    vector<S> q0;
    second_datum is;
    vector<S> other;
};
template <class S>
struct state {
    S t;
    vector<S> q, p;
};

/// What joins two ends, at the points of T; without momenta where the equation has none. A warning is a sentence, or nothing.
template <class S>
struct joined {
    std::vector<vector<S>> q, p;
    std::string warning{};
};

/// What gets the states of a walk, one at a time; false ends it.
template <class S>
using keeper = std::function<bool(S const& t, vector<S> const& q, vector<S> const& p)>;

/// A trajectory on its way along T.
template <class S>
class cursor {
public:
    cursor() = default;
    cursor(cursor const&) = delete;
    cursor& operator=(cursor const&) = delete;
    virtual ~cursor() = default;
    /// Advances by so many steps, or to the last point. `keep`, where there is one, gets each state that is reached.
    /// @throws what steps throw; the cursor is then at its last good state
    virtual void advance(hilger::index_type steps, keeper<S> const& keep) = 0;
    void advance(hilger::index_type steps) { advance(steps, nullptr); }
    /// The number of the point, from 0.
    [[nodiscard]] virtual hilger::index_type number() const = 0;
    [[nodiscard]] virtual engine::state<S> state() const = 0;
    /// A velocity near that of the state.
    [[nodiscard]] virtual vector<S> velocity() const = 0;
    /// Writes everything that the rest of the walk depends on. @returns false where nothing is written, because there is a memory
    virtual bool save(std::ostream& out) const = 0;
    /// Continues from what save has written. @throws hilger::error::unreadable, hilger::error::mismatch
    virtual void load(std::istream& in, std::string const& source) = 0;
};

/// A problem with its method on its scale.
template <class S>
class motion {
public:
    motion() = default;
    motion(motion const&) = delete;
    motion& operator=(motion const&) = delete;
    virtual ~motion() = default;
    /// A cursor at the first point of T. It does not depend on the motion any more. @throws what the first step throws
    [[nodiscard]] virtual std::unique_ptr<cursor<S>> begin(initial<S> const& from) const = 0;
    /// The states at the points of T, one at a time, until `keep` returns false. @throws what steps throw
    void walk(initial<S> const& from, keeper<S> const& keep) const {
        auto const at = begin(from);
        auto const [t, q, p] = at->state();
        if (keep(t, q, p)) at->advance(std::numeric_limits<hilger::index_type>::max(), keep);
    }
    /// The points of T.
    [[nodiscard]] virtual std::vector<S> times() const = 0;
    /// The positions that join two ends, near `guess`, one for each point of T, and their momenta; without a guess the straight line is
    /// it. A request to stop ends it with hilger::error::no_convergence.
    /// @throws hilger::error::invalid_parameter where the method has no equation in positions, or a memory
    [[nodiscard]] virtual joined<S> between(vector<S> const& first, vector<S> const& last, std::vector<vector<S>> const& guess = {},
                                            std::stop_token const& stop = {}) const = 0;
    /// What the positions at the points of T leave, in roundings of the terms of a row or as an absolute number, of the equation that the
    /// method comes from, at the points inside steps that the momenta lead to, where there are any; of compositions, what they and the
    /// momenta leave of those of their parts; with a memory, what those that `from` leads to leave of it.
    /// @throws hilger::error::invalid_parameter where it has none
    [[nodiscard]] virtual S residual(initial<S> const& from, std::vector<vector<S>> const& positions, std::vector<vector<S>> const& momenta,
                                     bool absolute) const = 0;
    /// H(p, q) = p v - L at a state, with the velocity near the given one where several have its momentum.
    [[nodiscard]] virtual S energy(state<S> const& x, vector<S> const& near) const = 0;
    /// The state at t between two neighbouring ones, of order 4. @throws hilger::error::invalid_parameter with a memory, which is no part
    /// of a state
    [[nodiscard]] virtual state<S> between_states(state<S> const& x, state<S> const& y, S const& t) const = 0;
};

/// @throws hilger::error::invalid_parameter when there is no such method, for this problem or in this scalar
template <class S>
std::unique_ptr<motion<S>> make_motion(problem const& what, std::string const& method, points<S> const& T);
template <>
std::unique_ptr<motion<double>> make_motion(problem const&, std::string const&, points<double> const&);
template <>
std::unique_ptr<motion<hilger::Q>> make_motion(problem const&, std::string const&, points<hilger::Q> const&);
template <>
std::unique_ptr<motion<hilger::float50>> make_motion(problem const&, std::string const&, points<hilger::float50> const&);

template <>
std::unique_ptr<motion<hilger::float100>> make_motion(problem const&, std::string const&, points<hilger::float100> const&);

/// The discrete Euler-Lagrange equation and Hamiltonian system of a method, without forces, on equal steps or on any; or what the method is
/// called. @throws hilger::error::invalid_parameter, hilger::error::unreadable
std::string equation_of_method(problem const& what, std::string const& method, bool uniform, bool latex);

/// A motion over [a, b] to a wanted accuracy.
struct accurate {
    std::vector<double> t;
    std::vector<vector<double>> q, p;
    std::string method;
    double error;
};
accurate solve_accurately(problem const& what, double a, double b, vector<double> const& q0, vector<double> const& v0, double wanted,
                          double longest_step, std::stop_token const& stop);

/// One step as C99 that stands alone (hilger/text/c_code.hpp). @throws hilger::error::invalid_parameter, hilger::error::no_formula
std::string c_code_of(problem const& what, std::string const& method, std::string const& name);

} // namespace engine
