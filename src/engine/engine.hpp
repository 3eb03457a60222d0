// SPDX-License-Identifier: BSL-1.0
// Problems known at run time only, solved by code that is compiled once: a Lagrangian in text, forces and fractional damping, one of a list
// of methods (methods.hpp), any scale, one of a few scalars. It is a thin layer over flows of stated_lagrangian in the library, common to
// files, the command line and Python.
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

#include "hilger/accuracy/solution.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/scale/uniform.hpp"
#include "hilger/text/lagrangian.hpp"
#include "hilger/trajectory/initial_data.hpp"

namespace engine {

/// The mechanics. Damping is -rho D^alpha q of every coordinate, as a mean over each step by mid-point and at the nodes by radau-3, ...
struct problem {
    hilger::text::stated_lagrangian lagrangian;
    std::optional<hilger::text::stated_force> force;
    struct damping_term {
        hilger::float100 rho, alpha;
    };
    std::vector<damping_term> damping;
    std::string history = "direct"; ///< direct, blocks, exponentials, exponentials:1e-8
    /// The fractional Zener material of a structure (hilger/fractional/zener.hpp); the Lagrangian has the relaxed modulus.
    struct zener_material {
        hilger::float100 relaxed_modulus, unrelaxed_modulus, relaxation_time, alpha;
    };
    std::optional<zener_material> material{};
    /// Other Lagrangians of the same action, each with its own method. A force acts beside the first Lagrangian.
    struct summand {
        hilger::text::stated_lagrangian lagrangian;
        std::string method;
    };
    std::vector<summand> besides{};
    /// g(q) of dt = g(q) dtau: T is then in tau, and the times of states are part of the solution (transformed_time.hpp).
    std::optional<hilger::text::stated_rate> time_transformation{};
    [[nodiscard]] bool has_memory() const { return not damping.empty() or material; }
};

/// @throws hilger::error::invalid_parameter unless the problem is one Lagrangian L(q, v), of constant energy, as a transformed time wants
void require_constant_energy(problem const& what);

/// T: {start + i step}, or any increasing points.
template <class S>
struct points {
    S start{}, step{};
    hilger::index_type steps = 0;
    std::vector<S> given;
    std::optional<S> last{};    ///< of equal steps, if known exactly
    bool may_be_graded = false; ///< equal steps, with as many others, by a method whose order asks for it
    [[nodiscard]] bool is_uniform() const { return given.empty(); }
    /// The step of a uniform scale; nothing for other points.
    [[nodiscard]] std::optional<S> equal_step() const { return is_uniform() ? std::optional(step) : std::nullopt; }
};

template <class S>
using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
/// A state of any kind, numbers too, as a vector.
template <class S, class V>
vector<S> as_vector(V const& x) {
    if constexpr (std::is_convertible_v<V, S>)
        return vector<S>::Constant(1, S(x));
    else
        return x;
}
/// The same, into a vector of that length.
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

/// int g(q) over step i, which goes from x to y; for the steps of one walk.
template <class S>
using step_integral = std::function<S(hilger::index_type i, state<S> const& x, state<S> const& y)>;

/// The solution between two ends, at the points of T; no momenta when the equation has none. A warning is a sentence, or empty.
template <class S>
struct joined {
    std::vector<vector<S>> q, p;
    std::string warning{};
};

/// Receives the states of a walk, one at a time; false ends it.
template <class S>
using keeper = std::function<bool(S const& t, vector<S> const& q, vector<S> const& p)>;

/// A position on a trajectory along T.
template <class S>
class cursor {
public:
    cursor() = default;
    cursor(cursor const&) = delete;
    cursor& operator=(cursor const&) = delete;
    virtual ~cursor() = default;
    /// Advances by so many steps, or to the last point. `keep`, if set, gets each new state.
    /// @throws the errors of steps; the cursor is then at its last good state
    virtual void advance(hilger::index_type steps, keeper<S> const& keep) = 0;
    void advance(hilger::index_type steps) { advance(steps, nullptr); }
    /// The number of the point, from 0.
    [[nodiscard]] virtual hilger::index_type number() const = 0;
    [[nodiscard]] virtual engine::state<S> state() const = 0;
    /// A velocity near that of the state.
    [[nodiscard]] virtual vector<S> velocity() const = 0;
    /// Writes everything that the rest of the walk depends on. @returns false, and writes nothing, when there is a memory
    virtual bool save(std::ostream& out) const = 0;
    /// Continues from the output of save. @throws hilger::error::unreadable, hilger::error::mismatch
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
    /// A cursor at the first point of T, independent of the motion's lifetime. @throws the errors of the first step
    [[nodiscard]] virtual std::unique_ptr<cursor<S>> begin(initial<S> const& from) const = 0;
    /// The states at the points of T, one at a time, until `keep` returns false. @throws the errors of steps
    void walk(initial<S> const& from, keeper<S> const& keep) const {
        auto const at = begin(from);
        auto const [t, q, p] = at->state();
        if (keep(t, q, p)) at->advance(std::numeric_limits<hilger::index_type>::max(), keep);
    }
    /// The points of T.
    [[nodiscard]] virtual std::vector<S> times() const = 0;
    /// The positions that join two ends, near `guess` (one for each point of T; by default the straight line), and their momenta. Throws
    /// hilger::error::no_convergence when a stop is requested.
    /// @throws hilger::error::invalid_parameter when the method has no equation in positions, or a memory
    [[nodiscard]] virtual joined<S> between(vector<S> const& first, vector<S> const& last, std::vector<vector<S>> const& guess = {},
                                            std::stop_token const& stop = {}) const = 0;
    /// The residual of the method's equation at the positions on T, in roundings of the terms of a row or absolute; points inside steps
    /// follow from the momenta. For compositions, the residual of their parts at positions and momenta; with a memory, that of the
    /// trajectory from `from`.
    /// @throws hilger::error::invalid_parameter when there is no such equation
    [[nodiscard]] virtual S residual(initial<S> const& from, std::vector<vector<S>> const& positions, std::vector<vector<S>> const& momenta,
                                     bool absolute) const = 0;
    /// H(p, q) = p v - L at a state, with the velocity near the given one when several have its momentum.
    [[nodiscard]] virtual S energy(state<S> const& x, vector<S> const& near) const = 0;
    /// The state at t between two neighbouring ones: a step of the method from the first, with a velocity near their mean one.
    /// @throws hilger::error::invalid_parameter with a memory, which a state does not contain
    [[nodiscard]] virtual state<S> between_states(state<S> const& x, state<S> const& y, S const& t) const = 0;
    /// The integral of g over steps, by the nodes of the method.
    /// @throws hilger::error::invalid_parameter when the method has no nodes in a step
    [[nodiscard]] virtual step_integral<S> integral_of(std::function<S(vector<S> const&)> g) const {
        (void)g;
        hilger::error::raise<hilger::error::invalid_parameter>(
            "the times of a transformed motion are sums over the nodes of steps, and this method has none");
    }
};

/// @throws hilger::error::invalid_parameter when there is no such method for this problem, or in this scalar
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

/// The discrete Euler-Lagrange equation and Hamiltonian system of a method, without forces, on equal steps or on any; otherwise the
/// method's name. @throws hilger::error::invalid_parameter, hilger::error::unreadable
std::string equation_of_method(problem const& what, std::string const& method, bool uniform, bool latex);

/// A motion over an interval to a wanted accuracy, at the points of the scale that was found.
struct accurate {
    std::vector<double> t;
    std::vector<vector<double>> q, p;
    std::string method;
    double error;
};
/// From initial values (hilger/accuracy/from_start.hpp) or between two ends (hilger/accuracy/between_ends.hpp).
/// @throws hilger::error::invalid_parameter with a memory or a transformed time; and what the solvers throw
accurate solve_accurately(problem const& what, hilger::interval<double> const& I, hilger::initial_velocity<vector<double>> const& from,
                          hilger::accuracy const& goal);
accurate solve_accurately(problem const& what, hilger::interval<double> const& I, hilger::boundary_values<vector<double>> const& ends,
                          hilger::accuracy const& goal);

/// The position at the end of a walk, to an absolute tolerance.
using adapted_walk = std::function<vector<double>(double tolerance)>;
/// Walks over [a, b] from q0 and v0 by gauss-6 or gauss-8, in steps that adapt to the tolerance; one at a time. They throw the errors of
/// steps.
/// @throws hilger::error::invalid_parameter for another method, and with a memory, a transformed time or several Lagrangians
adapted_walk walk_in_adapted_steps(problem const& what, std::string const& method, double a, double b, vector<double> const& q0,
                                   vector<double> const& v0);

/// One step as standalone C99 (hilger/text/c_code.hpp). @throws hilger::error::invalid_parameter, hilger::error::no_formula
std::string c_code_of(problem const& what, std::string const& method, std::string const& name);

} // namespace engine
