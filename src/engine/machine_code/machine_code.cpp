// SPDX-License-Identifier: BSL-1.0
#include "engine/machine_code/machine_code.hpp"

#include <array>
#include <atomic>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <utility>

#include "engine/machine_code/c_library.hpp"
#include "hilger/simd.hpp"

namespace engine {

namespace {

using evaluation = hilger::detail::evaluation<double>;
using translation = hilger::detail::translation<double>;
using functions = std::array<translation::function, translation::functions>;

/// Nothing is folded, and sin and cos are not merged into one call: that would round differently.
std::vector<std::string> const options{"-O2", "-ftree-vectorize", "-fno-builtin-sin", "-fno-builtin-cos"};

/// Loops over nodes are vectorised. Two components of one node are not, because they were stored one by one: a vector load would stall.
std::vector<std::string> node_options() {
    using namespace hilger::detail::memory;
    std::vector<std::string> all{"-O3",
                                 "-fno-tree-slp-vectorize",
                                 "-fno-math-errno",
                                 "-fno-trapping-math",
                                 "-fno-builtin-sin",
                                 "-fno-builtin-cos",
                                 "-fno-builtin-sinf",
                                 "-fno-builtin-cosf"};
    if (available_instructions() >= instructions::avx2) all.emplace_back("-mavx2");
    return all;
}

class compiler final : public hilger::detail::translator<double> {
public:
    void translate(evaluation const& what, translation& to) override {
        if (how_.load() == machine_code::off) return;
        std::string text = c_of(what);
        if (text.empty()) return;
        if (auto const* made = library(std::move(text), options)) use(*made, to);
    }
    c_library const* library(std::string text, std::vector<std::string> const& how_to_compile) {
        auto const how = how_.load();
        if (how == machine_code::off) return nullptr;
        std::unique_lock lock(busy_, std::defer_lock);
        if (how == machine_code::at_once)
            lock.lock();
        else if (not lock.try_lock())
            return nullptr;
        auto const [found, is_new] = jobs_.try_emplace(text, nullptr);
        if (is_new) found->second = std::make_unique<c_library>(std::move(text), how_to_compile);
        switch (found->second->look(how == machine_code::at_once)) {
        case c_library::status::done:
            ++translated_;
            return found->second.get();
        case c_library::status::no_compiler:
            say_once();
            return nullptr;
        default:
            return nullptr;
        }
    }
    /// Also forgets the earlier texts.
    void set(machine_code how) {
        std::lock_guard const lock(busy_);
        jobs_.clear();
        how_ = how;
    }
    [[nodiscard]] int translated() const { return translated_; }
    [[nodiscard]] machine_code wanted() const { return how_; }
    void say_once() {
        if (has_said_.exchange(true)) return;
        std::cerr << "hilger: there is no C compiler (cc, or what CC names), and formulas go on interpreted; HILGER_MACHINE_CODE=off says "
                     "nothing\n";
    }

private:
    void use(c_library const& library, translation& to) {
        functions made;
        for (std::size_t k = 0; k < made.size(); ++k) {
            made[k] = reinterpret_cast<translation::function>(library.find("part_" + std::to_string(k)));
            if (made[k] == nullptr) return;
        }
        to.set(made);
    }
    std::atomic<machine_code> how_ = machine_code::off;
    std::atomic<int> translated_ = 0;
    std::mutex busy_;
    std::map<std::string, std::unique_ptr<c_library>> jobs_;
    std::atomic<bool> has_said_ = false;
};

compiler& the_compiler() {
    static compiler one;
    return one;
}

} // namespace

void set_machine_code(machine_code how) {
    auto& one = the_compiler();
    one.set(how);
    hilger::detail::translator<double>::installed() = &one;
    ++hilger::detail::translator<double>::generation();
}
void prepare_machine_code() {
    static bool const once = [] {
        if (hilger::detail::translator<double>::installed().load() == nullptr)
            set_machine_code(environment_variable("HILGER_MACHINE_CODE") == "off" ? machine_code::off : machine_code::on);
        return true;
    }();
    (void)once;
}
c_library const* machine_code_of(std::string text) {
    prepare_machine_code();
    return the_compiler().library(std::move(text), node_options());
}
machine_code wanted_machine_code() {
    prepare_machine_code();
    return the_compiler().wanted();
}
void say_there_is_no_compiler() { the_compiler().say_once(); }
int formulas_in_machine_code() { return the_compiler().translated(); }

} // namespace engine
