// SPDX-License-Identifier: BSL-1.0
// Replaces the interpretation of frequent evaluations by machine code: a program with a compiler at hand installs a translator, which is
// asked for it, and answers when it has some, or never.
#pragma once

#include <array>
#include <atomic>

namespace hilger::detail {

template <class S>
class evaluation;
template <class S>
class translation;

/// Makes functions of evaluations. Called from any thread.
template <class S>
class translator {
public:
    /// Sets the functions of `to` if there are any yet; is asked again if not.
    virtual void translate(evaluation<S> const& what, translation<S>& to) = 0;
    /// The installed one, or null. It lives as long as the program.
    static std::atomic<translator*>& installed() {
        static std::atomic<translator*> one = nullptr;
        return one;
    }
    /// Changes with the translator or its settings: earlier translations are then not used any more.
    static std::atomic<int>& generation() {
        static std::atomic<int> number = 0;
        return number;
    }

protected:
    ~translator() = default;
};

/// The parts of an evaluation as functions of its values: the same operations on the same places, so that every bit is the same.
template <class S>
class translation {
public:
    using function = void (*)(S* values);
    static constexpr int functions = 5, often = 1024; ///< a function for each part, and one for all of them

    /// Null as long as there is none.
    [[nodiscard]] function of(int part) const { return functions_[static_cast<std::size_t>(part)].load(std::memory_order_acquire); }
    void set(std::array<function, functions> const& made) {
        for (std::size_t k = 0; k < made.size(); ++k) functions_[k].store(made[k], std::memory_order_release);
    }
    /// Counts a part that was interpreted. Two threads may count as one.
    void count(evaluation<S> const& what) {
        int const n = count_.load(std::memory_order_relaxed) + 1;
        count_.store(n % often, std::memory_order_relaxed);
        if (n < often) return;
        if (auto* const by = translator<S>::installed().load(std::memory_order_acquire)) by->translate(what, *this);
    }

private:
    std::array<std::atomic<function>, functions> functions_{};
    std::atomic<int> count_ = 0;
};

} // namespace hilger::detail
