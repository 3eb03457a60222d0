// SPDX-License-Identifier: BSL-1.0
#include "engine/ensemble/lanes.hpp"

#include <algorithm>
#include <map>
#include <mutex>
#include <optional>

#include "engine/ensemble/lanes_of.hpp"
#include "engine/machine_code/c_library.hpp"
#include "engine/machine_code/machine_code.hpp"
#include "engine/methods/lambda.hpp"
#include "engine/motions.hpp"
#include "hilger/simd.hpp"

namespace engine {

namespace {

/// The number of doubles in a register, and the compiler's options for the processor.
struct registers {
    int width;
    std::vector<std::string> options;
};
registers registers_here() {
    using namespace hilger::detail::memory;
    switch (available_instructions()) {
    case instructions::avx512:
        return {8, {"-O3", "-w", "-mavx2", "-mavx512f", "-mavx512dq"}};
    case instructions::avx2:
        return {4, {"-O3", "-w", "-mavx2"}};
    default:
        return {2, {"-O3", "-w"}};
    }
}

/// The Lagrangian and a force as formulas, with the members' own parameters as m[0], m[1], ...
/// @throws hilger::error::no_formula when one of them has a comparison
hilger::detail::node_formulas formulas_of(problem const& what) {
    using hilger::detail::named_graph;
    int const d = what.lagrangian.formula().words().dimension();
    auto const in = std::make_shared<named_graph>(d);
    hilger::detail::tracing<double> const here(in->graph);
    auto const value_of = [&](hilger::text::stated const& f) {
        return f.value(
            named_graph::argument(2 * d),
            [&](int k) { return k < d ? named_graph::argument(k) : in->variable("m[" + std::to_string(k - d) + "]"); },
            [&](int k) { return named_graph::argument(d + k); });
    };
    std::vector<hilger::detail::formula_node> force;
    if (what.force)
        for (auto const& f : what.force->formulas()) force.push_back(value_of(f));
    return hilger::detail::differentiated(in, value_of(what.lagrangian.formula()), force);
}

std::optional<one_node_parts> parts_of(hilger::detail::named_graph& in, std::string const& method, std::optional<double> const& lambda) {
    using number = hilger::detail::formula_node;
    hilger::detail::tracing<double> const here(in.graph);
    number const h = in.variable("h"), one_over_h = number(1) / h;
    if (lambda) return one_node_parts{{{1, 2, {number(1 - *lambda), number(*lambda)}, {-one_over_h, one_over_h}, {h}, {}, {}}}, {{0, 1}}};
    if (method == "order-one") return one_node_parts{{tableau_of(hilger::order_one, h)}, {{0, 1}}};
    if (method == "order-one-left") return one_node_parts{{tableau_of(hilger::order_one_left, h)}, {{0, 1}}};
    if (method == "mid-point") return one_node_parts{{tableau_of(hilger::mid_point, h)}, {{0, 1}}};
    auto const verlet = [&](auto const& shares) {
        one_node_parts made{{tableau_of(hilger::order_one, h), tableau_of(hilger::order_one_left, h)}, {}};
        for (double const share : shares) made.parts.insert(made.parts.end(), {{0, share / 2}, {1, share / 2}});
        return made;
    };
    if (method == "verlet") return verlet(std::array{1.0});
    if (method == "kahan-li-8") return verlet(hilger::kahan_li<8>.template values<double>());
    return {};
}

/// Libraries by their texts, kept until the process ends.
std::shared_ptr<c_library const> compiled(std::string const& text, std::vector<std::string> const& options) {
    static std::mutex one_at_a_time;
    static std::map<std::string, std::shared_ptr<c_library>> all;
    std::lock_guard const lock(one_at_a_time);
    auto& library = all[text];
    if (not library) library = std::make_shared<c_library>(text, options);
    switch (library->look(true)) {
    case c_library::status::done:
        return library;
    case c_library::status::no_compiler:
        say_there_is_no_compiler();
        return nullptr;
    default:
        return nullptr;
    }
}

} // namespace

std::vector<double> times_of(points<double> const& T, hilger::index_type first, hilger::index_type last) {
    if (not T.is_uniform()) return {T.given.begin() + first, T.given.begin() + last + 1};
    std::vector<double> times;
    times.reserve(static_cast<std::size_t>(last - first + 1));
    auto const scale = hilger::uniform(T.start, T.step, T.steps);
    for (hilger::index_type i = first; i <= last; ++i) times.push_back(scale.element(i));
    return times;
}

int lanes::width_here() {
    int const most = registers_here().width;
    auto const said = environment_variable("HILGER_LANES");
    if (not said) return most;
    for (int width = 1; width <= most; width *= 2)
        if (*said == std::to_string(width)) return width;
    hilger::error::raise<hilger::error::invalid_parameter>("HILGER_LANES is 1, 2, 4 or 8 and no more than the ", most,
                                                           " numbers that a register of this processor has, and was '", *said, "'");
}

std::unique_ptr<lanes> lanes::of(problem const& what, std::string const& method, points<double> const& T, int width) {
    int const d = what.lagrangian.formula().words().dimension();
    if (what.time_transformation) return nullptr;
    if (what.has_memory() or not what.besides.empty() or d > most_coordinates or wanted_machine_code() == machine_code::off) return nullptr;
    std::size_t size = 0;
    int const brought = what.lagrangian.formula().words().brought();
    std::optional<double> lambda;
    try {
        if (not T.is_uniform() and has_lambda_of_step(what, method)) return nullptr;
        lambda = lambda_of<double>(what, method, T.equal_step());
    } catch (hilger::error::unreadable const&) {
        if (brought == 0) throw;
        return nullptr; // a factor depends on the members' parameters
    }
    std::string text;
    try {
        auto const formulas = formulas_of(what);
        auto const parts = parts_of(*formulas.in, method, lambda);
        if (not parts) return nullptr;
        size = size_in_lanes(d, *parts) + static_cast<std::size_t>(brought);
        text = lanes_of(formulas, *parts, brought, width);
    } catch (hilger::error::no_formula const&) { // a formula has a comparison
        return nullptr;
    }
    if (text.empty() or text.size() > (width == alone ? most_letters_for_one : most_letters)) return nullptr;
    auto const library = compiled(text, width == alone ? std::vector<std::string>{"-O3", "-w"} : registers_here().options);
    if (not library) return nullptr;
    std::unique_ptr<lanes> made(new lanes);
    made->begin_ = reinterpret_cast<decltype(made->begin_)>(library->find("begin"));
    made->walk_ = reinterpret_cast<decltype(made->walk_)>(library->find("walk"));
    if (made->begin_ == nullptr or made->walk_ == nullptr) return nullptr;
    made->width_ = std::max(width, 1);
    made->dimension_ = d;
    made->brought_ = brought;
    made->size_ = size;
    made->T_ = T;
    return made;
}

lanes::group::group(lanes const& code, std::vector<start> const& from)
    : code_(code), x_(code.size_ * static_cast<std::size_t>(code.width_)), lost_(static_cast<std::size_t>(code.width_)) {
    auto const d = code.dimension_, width = code.width_;
    auto const put = [&](int lane, int first, auto const& numbers) {
        for (double const x : numbers) x_[static_cast<std::size_t>(first++ * width + lane)] = x;
    };
    int const brought = static_cast<int>(code.size_) - code.brought_; // the place of the members' parameters
    for (int lane = 0; lane < width; ++lane) {
        auto const& at = from[static_cast<std::size_t>(lane)];
        put(lane, 0, at.q);
        for (int first = 2 * d; first < brought; first += d) put(lane, first, at.v);
        put(lane, brought, at.parameters);
    }
    code.begin_(times_of(code.T_, 0, 0).front(), x_.data(), lost_.data());
    for (int lane = 0; lane < width; ++lane)
        if (auto const& p = from[static_cast<std::size_t>(lane)].p; p.size() > 0) put(lane, d, p);
}

void lanes::group::walk(hilger::index_type steps, double* q, double* p) {
    code_.walk_(done_, steps, times_of(code_.T_, done_, done_ + steps).data(), code_.T_.equal_step().value_or(0), x_.data(), lost_.data(),
                q, p);
    done_ += steps;
}

} // namespace engine
