// SPDX-License-Identifier: BSL-1.0
// Nearly singular mass matrices, and Lagrangians without a Legendre map.
#include "extremes/row.hpp"
#include "hilger/hilger.hpp"

namespace extremes {

namespace {

using namespace hilger;
using hilger::index_type;
using plane = Eigen::Vector2d;
using space = Eigen::Vector3d;

/// [[1, 1], [1, 1 + d]] has the condition 4 / d, and the velocity of (1, 0) is (1 + 1/d, -1/d).
Eigen::Matrix2d mass(double d) { return Eigen::Matrix2d{{1, 1}, {1, 1 + d}}; }
auto by_elements(Eigen::Matrix2d const& m) {
    return [m](auto const& q, auto const& v) {
        return m(0, 0) * v(0) * v(0) / 2 + m(0, 1) * v(0) * v(1) + m(1, 1) * v(1) * v(1) / 2 - q.dot(q) / 2;
    };
}
auto whole(Eigen::Matrix2d const& m) {
    return mechanical(m, [](auto const& q) { return q.dot(q) / 2; });
}
/// The position after one step of length 1 from 0 with momentum (1, 0), against the exact one, relative to its size, in epsilons.
template <class L>
double step_error(L const& l, double d) {
    auto const y = embed(l, order_one).step(state<double, plane>{0, plane(0, 0), plane(1, 0)}, 1.0);
    float50 const rest = float50(1 + d) - 1; // the rounded entry of the matrix
    float50 const x = 1 + 1 / rest;
    return std::max(in_epsilons(y.q(0), x), in_epsilons(y.q(1), float50(-1 / rest), x));
}
template <class L, class V>
void two_steps(L const& l, V const& q, V const& p) {
    walk(embed(l, order_one).along(uniform(0.0, 0.125, 2), q, p));
}
/// Rank two, up to rounding.
Eigen::Matrix3d rank_two() {
    space const u(1, 1.0 / 3, 0.7), w(0.1, 0.9, -0.3);
    return u * u.transpose() + w * w.transpose();
}

void mass_matrices(rows& all) {
    for (double const d : {1e-4, 1e-8, 4e-12, 1e-14}) {
        std::string const condition = "condition " + few_digits(4 / d);
        // Rounding the data by an epsilon costs the condition times it; but 1 + d is an exact input, and (1 + d) - 1 does not round.
        all.push_back(kept("mass matrix of " + condition + ", mechanical", step_error(whole(mass(d)), d), 4));
        all.push_back(kept("mass matrix of " + condition + ", any L", step_error(by_elements(mass(d)), d), 4));
    }
    double const last = 2 * epsilon<double>();
    plane const q(1, 0), p(0, 1);
    all.push_back(refused<error::singular>("mass matrix of condition 9e15, mechanical", [&] { two_steps(whole(mass(last)), q, p); }));
    all.push_back(
        refused<error::singular>("mass matrix of condition 1.8e16, any L", [&] { two_steps(by_elements(mass(last / 2)), q, p); }));
    all.push_back(refused<error::singular>("singular mass matrix, mechanical", [&] { two_steps(whole(mass(0)), q, p); }));
    all.push_back(refused<error::singular>("singular mass matrix, any L", [&] { two_steps(by_elements(mass(0)), q, p); }));
    auto const spatial = rank_two();
    auto const L = [spatial](auto const& x, auto const& v) { return v.dot(evaluated(spatial * v)) / 2 - x.dot(x) / 2; };
    auto const bodies = mechanical(spatial, [](auto const& x) { return x.dot(x) / 2; });
    all.push_back(refused<error::singular>("singular mass matrix in space, any L", [&] { two_steps(L, space(1, 0, 0), space(0, 1, 0)); }));
    all.push_back(
        refused<error::singular>("singular mass matrix in space, mechanical", [&] { two_steps(bodies, space(1, 0, 0), space(0, 1, 0)); }));
    // Masses as different as those of an electron and a star are not a singular matrix.
    auto const graded = mechanical(plane(1e-30, 1e30), [](auto const& x) { return x.dot(x) / 2; });
    auto const y = embed(graded, order_one).step(state<double, plane>{0, plane(0, 0), plane(1e-30, 1e30)}, 0.5);
    all.push_back(kept("masses 1e-30 and 1e30 side by side", (y.q - plane(0.5, 0.5)).cwiseAbs().maxCoeff() / epsilon<double>(), 1));
    auto const together = mechanical(Eigen::Matrix2d{{1e-30, 0}, {0, 1e30}}, [](auto const& x) { return x.dot(x) / 2; });
    auto const z = embed(together, order_one).step(state<double, plane>{0, plane(0, 0), plane(1e-30, 1e30)}, 0.5);
    all.push_back(kept("the same as a matrix", (z.q - plane(0.5, 0.5)).cwiseAbs().maxCoeff() / epsilon<double>(), 2));
    all.push_back(
        refused<error::singular>("a mass of 0", [] { (void)mechanical(0.0, chain([](index_type, auto const& r) { return r * r; })); }));
    all.push_back(refused<error::singular>("a negative mass",
                                           [] { (void)mechanical(plane(1, -1), chain([](index_type, auto const& r) { return r * r; })); }));
    fractional_structure const frame{Eigen::MatrixXd(mass(0)), Eigen::MatrixXd(Eigen::Matrix2d::Zero()), Eigen::MatrixXd(mass(0)), 1.0,
                                     fraction<1, 2>{}};
    all.push_back(refused<error::singular>("singular mass and stiffness of a structure", [&] {
        auto const scheme = newmark<bdf<2>>(frame, [](double) { return Eigen::VectorXd(Eigen::VectorXd::Zero(2)); });
        Eigen::VectorXd const ones = Eigen::VectorXd::Ones(2);
        walk(scheme.along(uniform(0.0, 0.1, 2), ones, ones));
    }));
    // q'' = q by mid-point: 1 - h^2 / 4 = 0 at h = 2
    auto const hill = [](auto const& q_, auto const& v) { return v * v / 2 + q_ * q_ / 2; };
    all.push_back(refused<error::singular>(
        "a step whose equation is singular: q'' = q, mid-point, h = 2",
        [&] { walk(embed(hill, mid_point).along(uniform(0.0, 2.0, 2), 1.0, 0.0)); }, "the step from t = 0"));
}

void legendre_maps(rows& all) {
    auto const degenerate = [](auto const& q, auto const& v) { return q * v - q * q / 2; };
    all.push_back(
        refused<error::singular>("Legendre map of L = q v, p = q: every v would do", [&] { (void)velocity_of(degenerate, 1.0, 1.0); }));
    all.push_back(refused<error::singular>("Legendre map of L = q v, p != q: none does", [&] { (void)velocity_of(degenerate, 1.0, 2.0); }));
    auto const homogeneous = [](auto const&, auto const& v) { return sqrt(v.dot(v)); };
    all.push_back(refused<error::singular>("Legendre map of L = |v|",
                                           [&] { (void)velocity_of(homogeneous, plane(1, 1), plane(0.5, 0), plane(0.5, 0)); }));
    auto const H = lagrangian_of([](auto const& p, auto const& q) { return p * p * p * p / 4 + q * q / 2; });
    all.push_back(refused<error::singular>("Legendre map of H = p^4 / 4 at p = 0", [&] { (void)H.momentum(0.0, 0.0); }));
    // sqrt(1 + v^2) has p = v / sqrt(1 + v^2) in ]-1, 1[; Newton's method diverges from |v| > 1
    auto const bounded = [](auto const&, auto const& v) { return sqrt(1 + v * v); };
    all.push_back(kept("Legendre map of sqrt(1 + v^2) at p = 0.999, condition 1.0e3",
                       in_epsilons(velocity_of(bounded, 0.0, 0.999), float50(float50(0.999) / sqrt(1 - float50(0.999) * 0.999))), 1.0e3));
    all.push_back(kept("    from a guess from which whole corrections run away",
                       in_epsilons(velocity_of(bounded, 0.0, 0.3, 3.0), float50(float50(0.3) / sqrt(1 - float50(0.3) * 0.3))), 1));
    all.push_back(refused<error::exception>("    at p = 2, where there is no v", [&] { (void)velocity_of(bounded, 0.0, 2.0); }));
    // From v = 3 the corrections grow: an iterate of 1e30 is no root.
    auto const tanh_of = [](auto const&, auto const& v) { return log(cosh(v)); };
    all.push_back(kept("Legendre map of log cosh from a guess far out",
                       in_epsilons(velocity_of(tanh_of, 0.0, 0.25, 3.0), float50(atanh(float50(0.25)))), 4)); // sinh, cosh, their ratio, v
    all.push_back(refused<error::exception>("    at p = 2, where there is no v", [&] { (void)velocity_of(tanh_of, 0.0, 2.0, 3.0); }));
    auto const tiny = [](auto const&, auto const& v) { return 0x1p-120 * log(cosh(0x1p60 * v)); };
    all.push_back(kept("Legendre map in units of 2^-60, as in those of 1",
                       std::abs(velocity_of(tiny, 0.0, 0.25 * 0x1p-60) * 0x1p60 - velocity_of(tanh_of, 0.0, 0.25)) / epsilon<double>(), 0));
}

} // namespace

rows masses(scope) {
    rows all;
    mass_matrices(all);
    legendre_maps(all);
    return all;
}

} // namespace extremes
