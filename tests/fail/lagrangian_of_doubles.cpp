// SPDX-License-Identifier: BSL-1.0
// expect 1: takes two states of any number type, as [](auto const& q, auto const& v) does
// expect 2: takes two states of any number type, as [](auto const& q, auto const& v) does
// expect 3: a force takes two states of any number type, as [](auto const& q, auto const& v) does
// Derivatives pass through a Lagrangian as numbers of another type.
#include "hilger/integrator/flow.hpp"

using namespace hilger;

int main() {
    auto const T = uniform(0.0, 0.1, 10);
    Eigen::VectorXd const one = Eigen::VectorXd::Ones(6);
    auto const L = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 - q.squaredNorm() / 2; };
#if MUST_NOT_COMPILE == 1
    auto const oscillator = [](double q, double v) { return v * v / 2 - q * q / 2; };
    [[maybe_unused]] auto const path = embed(oscillator, mid_point).along(T, 1.0, 0.0);
#elif MUST_NOT_COMPILE == 2
    auto const vectors = [](Eigen::VectorXd const& q, Eigen::VectorXd const& v) { return v.squaredNorm() / 2 - q.squaredNorm() / 2; };
    [[maybe_unused]] auto const path = embed(vectors, mid_point).along(T, one, one);
#elif MUST_NOT_COMPILE == 3
    auto const friction = [](Eigen::VectorXd const&, Eigen::VectorXd const& v) { return Eigen::VectorXd(-v); };
    [[maybe_unused]] auto const path = embed(with_force(L, friction), mid_point).along(T, one, one);
#else
    auto const friction = [](auto const&, auto const& v) { return -v; };
    [[maybe_unused]] auto const path = embed(with_force(L, friction), mid_point).along(T, one, one);
#endif
}
