// SPDX-License-Identifier: BSL-1.0
// A walk along any trajectory of hilger's, and the scene that a system makes with the methods. A system has, for each scalar S,
//   lagrangian<S>()            any Lagrangian L(q, v)
//   start<S>()                 initial position and velocity
//   invariants(L, x)           what should be constant, a vector of numbers, at a state x
#pragma once

#include <iomanip>
#include <optional>
#include <sstream>

#include "methods.hpp"
#include "scene.hpp"

namespace program {

template <class S>
std::string digits_of(S const& x) {
    std::ostringstream out;
    out << std::setprecision(std::numeric_limits<S>::max_digits10) << x;
    return out.str();
}

/// Observe gives the numbers that should be constant at a state, and may give others, shown(x), that are looked at.
template <class Path, class Observe>
class path_walk final : public walk {
    using iterator = typename Path::iterator;
    using S = std::remove_cvref_t<decltype((*std::declval<iterator const&>()).t)>;
    using V = std::remove_cvref_t<decltype((*std::declval<iterator const&>()).q)>;
    using s = hilger::detail::shape<V>;
    static constexpr bool keeps = requires(Path const& p, typename Path::checkpoint_type c, std::ostringstream out) {
        c.memory.visit(p.method(), out);
    };

public:
    path_walk(Path path, Observe observe)
        : path_(std::move(path)), observe_(std::move(observe)), at_(std::as_const(path_).begin()), start_(observe_(*at_)),
          largest_(start_.size(), 0) {}

    void advance(hilger::index_type steps) override {
        hilger::index_type const last = std::min(path_.scale().last(), at_.number() + steps);
        iterator at = at_; // where nobody else can see it, the optimiser may keep it in registers
        try {
            while (at.number() < last) ++at;
        } catch (...) {
            at_ = at;
            throw;
        }
        at_ = at;
    }
    [[nodiscard]] hilger::index_type number() const override { return at_.number() - path_.scale().first(); }
    [[nodiscard]] std::string row() const override {
        auto const& x = *at_;
        std::string text = digits_of(x.t);
        for (int k = 0; k < s::dimension(x.q); ++k) text += ',' + digits_of(S(s::component(x.q, k)));
        for (int k = 0; k < s::dimension(x.p); ++k) text += ',' + digits_of(S(s::component(x.p, k)));
        auto const now = observe_(x);
        for (std::size_t k = 0; k < now.size(); ++k) {
            auto const change = static_cast<double>(S(now[k] - start_[k]));
            largest_[k] = std::max(largest_[k], std::abs(change));
            text += ',' + digits_of(change);
        }
        if constexpr (requires { observe_.shown(x); })
            for (S const& value : observe_.shown(x)) text += ',' + digits_of(value);
        return text;
    }
    [[nodiscard]] std::vector<hilger::float100> position() const override {
        std::vector<hilger::float100> x;
        for (int k = 0; k < s::dimension(at_->q); ++k) x.emplace_back(s::component(at_->q, k));
        return x;
    }
    [[nodiscard]] std::vector<double> drift() const override { return largest_; }
    bool save(std::ostream& out) const override {
        if constexpr (keeps) {
            for (double const x : largest_) out << std::hexfloat << x << '\n';
            hilger::write_checkpoint(out, path_, at_.checkpoint());
        }
        return keeps;
    }
    void load(std::istream& in, std::string const& source) override {
        if constexpr (keeps) {
            for (double& x : largest_) {
                std::string word;
                std::getline(in, word);
                x = std::strtod(word.c_str(), nullptr);
            }
            resumed_.emplace(path_.resume(hilger::read_checkpoint(in, path_, source)));
            at_ = std::as_const(*resumed_).begin();
        }
    }

private:
    Path path_;
    Observe observe_;
    std::optional<hilger::resumed<Path>> resumed_;
    iterator at_;
    decltype(std::declval<Observe const&>()(*std::declval<iterator const&>())) start_;
    mutable std::vector<double> largest_;
};
template <class Path, class Observe>
std::unique_ptr<walk> walk_along(Path path, Observe observe) {
    return std::make_unique<path_walk<Path, Observe>>(std::move(path), std::move(observe));
}

/// The walk of a system by c.embedding in numbers S; nothing where there is no such method.
template <class S, class System>
std::unique_ptr<walk> begin_in(System const& system, configuration const& c, double t0, double t1) {
    std::unique_ptr<walk> result;
    auto const L = system.template lagrangian<S>();
    auto const start = system.template start<S>();
    auto const T = hilger::uniform(hilger::interval<S>{S(t0), S(t1)}, c.steps);
    with_method<S, in_many_digits::gauss>(c.embedding, L, [&](auto const& flow) {
        result = walk_along(flow.along(T, start.q0, hilger::momentum_of(L, start.q0, start.v0)),
                            [system, L](auto const& x) { return system.invariants(L, x); });
    });
    return result;
}

/// In 50 and 100 digits, which src/program.cmake has compiled for each system by itself.
#define PROGRAM_MANY_DIGITS(keyword, System)                                                                                               \
    keyword template std::unique_ptr<walk> begin_in<hilger::float50>(System const&, configuration const&, double, double);                 \
    keyword template std::unique_ptr<walk> begin_in<hilger::float100>(System const&, configuration const&, double, double);

/// The scene that a system makes with all methods, T being [t0, t1] in equal steps.
template <class System>
scene scene_of(System const& system, scene made) {
    made.embeddings.assign(method_names.begin(), method_names.end());
    made.scalars = {"double", "float", "50-digits", "100-digits"};
    made.begin = [system, name = made.name, t0 = made.t0, t1 = made.t1](configuration const& c) {
        std::unique_ptr<walk> result = c.scalar == "double"      ? begin_in<double>(system, c, t0, t1)
                                       : c.scalar == "float"     ? begin_in<float>(system, c, t0, t1)
                                       : c.scalar == "50-digits" ? begin_in<hilger::float50>(system, c, t0, t1)
                                                                 : begin_in<hilger::float100>(system, c, t0, t1);
        if (not result)
            hilger::error::raise<hilger::error::invalid_parameter>("the scene ", name, " has no ", c.embedding, " in ", c.scalar);
        return result;
    };
    return made;
}

} // namespace program
