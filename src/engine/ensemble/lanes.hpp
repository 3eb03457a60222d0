// SPDX-License-Identifier: BSL-1.0
// Members of an ensemble that step together, in the lanes of the processor's registers: what lanes_of.hpp writes, compiled and loaded.
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
    static constexpr int most_coordinates = 6; ///< more are not kept in registers
    /// Letters of C: more take the compiler seconds, then minutes, and one member is faster in the engine.
    static constexpr std::size_t most_letters = 64'000, most_letters_for_one = 32'000;
    /// Compiles and waits for it. Nothing where the method has more than one node in a part of its step, the problem a memory, a formula
    /// branches, more than a few coordinates or thousands of operations, or where machine code is off or there is no compiler.
    /// States are the same to the last bit at every width: 1, 2, 4 or 8, and those of several registers where one is not as wide. One
    /// member `alone` has plain numbers, and its functions are those of the C library.
    static std::unique_ptr<lanes> of(problem const& what, std::string const& method, points<double> const& T, int width = width_here());
    static constexpr int alone = 0;
    /// As many doubles as a register has, or HILGER_LANES of the environment.
    /// @throws hilger::error::invalid_parameter where that is not 1, 2, 4 or 8, or more than a register has
    static int width_here();

    [[nodiscard]] int width() const { return width_; }

    /// Where a member begins: without p, from p = dL/dv. Without that, v is what its velocity is guessed to be.
    struct start {
        vector<double> q, v, p;
        std::vector<double> parameters; ///< those that states bring
    };
    /// As many members as there are lanes.
    class group {
    public:
        group(lanes const& code, std::vector<start> const& from);
        /// Goes on by so many steps. Of one member q and p behind each of them, up to one that fails, go to these places, if there are any.
        void walk(hilger::index_type steps, double* q = nullptr, double* p = nullptr);
        /// Whether the member's steps have succeeded until here; not from the beginning where d2L/dv2 is singular there, for the equation
        /// of a step may be regular without a mass.
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
    std::size_t size_ = 0; ///< of a member's state, in numbers
    points<double> T_;
    void (*begin_)(double, double*, long long*) = nullptr;
    void (*walk_)(long, long, double const*, double, double*, long long*, double*, double*) = nullptr;
};

} // namespace engine
