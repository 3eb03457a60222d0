// SPDX-License-Identifier: BSL-1.0
// expect: a force is a state like q, and this one has another number of components
// lines-clang: 60
// lines: 60
#include "hilger/hilger.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    constexpr unknown q;
    constexpr lagrangian L{[](auto const& x, auto const& v) { return v.dot(v) / 2 - x.dot(x) / 2; }};
    auto const EL = variation(integral(L(q, Delta_plus[q]), T));
    Eigen::Vector3d const x(1, 0, 0);
#ifdef MUST_NOT_COMPILE
    auto const weight = [](auto const&, auto const&) { return Eigen::Vector2d(0, -9.81); };
#else
    auto const weight = [](auto const&, auto const&) { return Eigen::Vector3d(0, 0, -9.81); };
#endif
    [[maybe_unused]] auto const y = solve(EL, T, initial_velocity{x, x}, weight);
}
