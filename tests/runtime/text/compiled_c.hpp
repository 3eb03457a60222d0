// SPDX-License-Identifier: BSL-1.0
// Generated C, compiled by cc with every warning an error, loaded, and walked beside the flow it is generated from.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <dlfcn.h>
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/text/c_code.hpp"
#include "support/there.hpp"

namespace hilger::testing {

using vector = Eigen::Vector2d;

/// C compiled into a shared object in a folder that goes away with it.
class compiled {
public:
    explicit compiled(std::string const& code) {
        std::string name = (std::filesystem::temp_directory_path() / "hilger_c_code_XXXXXX").string();
        if (mkdtemp(name.data()) == nullptr) return;
        folder_ = name;
        std::ofstream(folder_ / "generated.c") << code;
        std::string const command = "${CC:-cc} -std=c99 -Wall -Wextra -Werror -pedantic -shared -fPIC -o '" +
                                    (folder_ / "generated.so").string() + "' '" + (folder_ / "generated.c").string() + "' -lm";
        if (std::system(command.c_str()) == 0) object_ = dlopen((folder_ / "generated.so").c_str(), RTLD_NOW);
    }
    compiled(compiled const&) = delete;
    compiled& operator=(compiled const&) = delete;
    ~compiled() {
        if (object_ != nullptr) dlclose(object_);
        if (not folder_.empty()) std::filesystem::remove_all(folder_);
    }
    template <class Function>
    Function* get(std::string const& name) const {
        void* const found = object_ == nullptr ? nullptr : dlsym(object_, name.c_str());
        REQUIRE_MESSAGE(found != nullptr, "the generated C has a function " << name);
        return reinterpret_cast<Function*>(found);
    }

private:
    std::filesystem::path folder_;
    void* object_ = nullptr;
};
using lagrangian_in_c = double(double const*, double const*);
using momentum_of_ = void(double const*, double const*, double*);
using residual_of = void(double, double const*, double const*, double const*, double*);
using step_of = int(double, double*, double*, double*);

inline double* data(double& x) { return &x; }
inline double* data(vector& x) { return x.data(); }
inline double extent(double x) { return std::abs(x); }
template <class Expression>
double extent(Eigen::MatrixBase<Expression> const& x) {
    return x.cwiseAbs().maxCoeff();
}

template <class V>
struct point {
    V q, p;
};
template <class V, class Flow>
std::vector<point<V>> path_of(Flow const& flow, V const& q0, V const& p0, double h, int steps) {
    std::vector<point<V>> path;
    for (auto const& at : flow.along(uniform(0.0, h, steps), q0, p0)) path.push_back({at.q, at.p});
    return path;
}

/// 1000 steps of the C and of the flow. Both solve each step to an epsilon or so of the state; these errors add up as a random walk does,
/// to sqrt(1000) of them, and each is carried on as a small change of the initial state is. How much the largest of those grows is measured
/// here too: 16 for the double pendulum, 2200 for Kepler's ellipse, where a change of the period adds up.
/// @return the largest distance, in epsilons of the state's size times that growth
template <class V, class Flow>
double distance_after_1000_steps(compiled const& code, std::string const& name, Flow const& flow, V q, V p, double h) {
    using s = detail::shape<V>;
    constexpr int steps = 1000;
    auto* const step = code.get<step_of>(name + "_step");
    auto const path = path_of(flow, q, p, h, steps);
    double growth = 1, largest = 0;
    for (int k = 0; k < 2 * s::size; ++k) {
        double const change = 1e-8;
        V a = q, b = p;
        s::component(k < s::size ? a : b, k % s::size) += change;
        auto const other = path_of(flow, a, b, h, steps);
        for (std::size_t i = 0; i < path.size(); ++i) {
            growth = std::max(growth, std::max(extent(other[i].q - path[i].q), extent(other[i].p - path[i].p)) / change);
            largest = std::max(largest, std::max(extent(path[i].q), extent(path[i].p)));
        }
    }
    V v = velocity_of(detail::at_time{flow.mechanics().lagrangian, 0.0}, q, p);
    double worst = 0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        if (step(h, data(q), data(p), data(v)) != 0) return std::numeric_limits<double>::infinity();
        worst = std::max(worst, std::max(extent(q - path[i].q), extent(p - path[i].p)));
    }
    REQUIRE(path.size() == steps + 1);
    return worst / (epsilon<double>() * growth * largest);
}

} // namespace hilger::testing
