// SPDX-License-Identifier: BSL-1.0
// Members of an ensemble that step together, in the lanes of the processor's registers: the C of lanes_of.hpp, compiled and loaded.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "engine/engine.hpp"

namespace engine {

/// Points `first` to `last` of T.
std::vector<double> times_of(points<double> const& T, hilger::index_type first, hilger::index_type last);

class lanes {
public:
    static constexpr int most_coordinates = 6; ///< a larger state does not fit into registers
    /// Limits in characters of C: a longer text takes the compiler seconds to minutes, and one member is faster in the engine.
    static constexpr std::size_t most_letters = 64'000, most_letters_for_one = 32'000;
    /// Compiles and waits. Nothing for a part of the step with more than one node, a memory, branches, more than a few coordinates or
    /// thousands of operations, and when machine code is off or there is no compiler.
    /// States are the same to the last bit at every width: 1, 2, 4 or 8, wider vectors in several registers. One member `alone` has plain
    /// numbers and functions of the C library.
    static std::unique_ptr<lanes> of(problem const& what, std::string const& method, points<double> const& T, int width = width_here());
    static constexpr int alone = 0;
    /// The number of doubles in a register, or HILGER_LANES of the environment.
    /// @throws hilger::error::invalid_parameter when that is not 1, 2, 4 or 8, or exceeds the width of a register
    static int width_here();

    [[nodiscard]] int width() const { return width_; }

    /// The start of a member. An empty p means p = dL/dv; otherwise v is the guess of the velocity.
    struct start {
        vector<double> q, v, p;
        std::vector<double> parameters; ///< the member's own
    };
    /// As many members as lanes.
    class group {
    public:
        group(lanes const& code, std::vector<start> const& from);
        /// Makes so many steps. Of one member, q and p after each step up to a failing one are written to q and p, unless these are null.
        void walk(hilger::index_type steps, double* q = nullptr, double* p = nullptr);
        /// Whether all steps of the member have succeeded; false from the beginning when d2L/dv2 is singular there: the equation of a step
        /// may be regular without a mass.
        [[nodiscard]] bool is_well(int lane) const { return lost_[static_cast<std::size_t>(lane)] == 0; }
        [[nodiscard]] double q(int lane, int k) const { return at(lane, k); }
        [[nodiscard]] double p(int lane, int k) const { return at(lane, code_.dimension_ + k); }

    private:
        [[nodiscard]] double at(int lane, int number) const { return x_[static_cast<std::size_t>(number * code_.width_ + lane)]; }
        lanes const& code_;
        std::vector<double> x_;
        std::vector<long long> lost_;
        hilger::index_type done_ = 0;
    };

private:
    lanes() = default;
    int width_ = 0, dimension_ = 0, brought_ = 0;
    std::size_t size_ = 0; ///< numbers in the state of a member
    points<double> T_;
    void (*begin_)(double, double*, long long*) = nullptr;
    void (*walk_)(long, long, double const*, double, double*, long long*, double*, double*) = nullptr;
};

} // namespace engine
