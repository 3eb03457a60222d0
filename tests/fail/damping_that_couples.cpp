// SPDX-License-Identifier: BSL-1.0
// expect: a fractional damping has one number for all components or one for each, as a column vector or diagonal()
#include <Eigen/Core>

#include "hilger/fractional/flow.hpp"

using namespace hilger;

int main() {
    constexpr auto L = [](auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) / 2; };
    Eigen::Matrix2d const rho = Eigen::Matrix2d::Identity();
#ifdef MUST_NOT_COMPILE
    [[maybe_unused]] auto const damped = with_fractional_damping(L, rho, 0.5);
#else
    [[maybe_unused]] auto const damped = with_fractional_damping(L, rho.diagonal(), 0.5);
#endif
}
