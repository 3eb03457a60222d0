// SPDX-License-Identifier: BSL-1.0
// The derivatives of a problem of few coordinates: the same bits interpreted and from machine code, at one node or at several, in double
// and in float, and what jets of the same formula say.
#include <doctest/doctest.h>

#include "engine/small_lagrangian.hpp"
#include "stated.hpp"

namespace small_lagrangian_tests {

using namespace hilger;
using engine::machine_code;
using engine::set_machine_code;
using engine::small_lagrangian;
using testing::kept_here;
using testing::stated;

namespace {

template <class S, int D>
auto position(int k) {
    Eigen::Matrix<S, D, 1> x;
    for (int c = 0; c < D; ++c) x(c) = S(0.75) + S(std::sin(3.0 * k + c)) / S(2);
    return x;
}
/// All that is said at 40 nodes, each of them asked for so often that it is machine code where that is wanted.
template <class S, int D>
std::vector<S> said(text::stated_lagrangian const& L, int often) {
    small_lagrangian<S, D> const of(L);
    using V = Eigen::Matrix<S, D, 1>;
    V a, b;
    for (int k = 0; k < often; ++k) (void)of.gradients(S(0), position<S, D>(0), position<S, D>(1), a, b);
    std::vector<S> all;
    auto const put = [&](auto const& x) { all.insert(all.end(), x.data(), x.data() + x.size()); };
    std::array<V, 5> q, f;
    for (int k = 0; k < 40; ++k) {
        V const x = position<S, D>(k), v = position<S, D>(k + 100);
        S const t = S(k) / S(8);
        auto const e = of.expand(t, x, v);
        for (auto const* block : {&e.qq, &e.qv, &e.vv}) put(*block);
        put(e.by_q);
        put(e.by_v);
        (void)of.gradients(t, x, v, a, b);
        put(a);
        put(b);
        for (int i = 0; i < 5; ++i) q[static_cast<std::size_t>(i)] = position<S, D>(k + i);
        for (std::size_t n : {std::size_t(1), std::size_t(5)}) {
            (void)of.forces(t, q.data(), f.data(), n);
            for (std::size_t i = 0; i < n; ++i) put(f[i]);
        }
    }
    return all;
}
template <class S, int D>
void same_bits(std::string const& formula) {
    if (not testing::there_is_a_c_compiler()) return;
    CAPTURE(formula);
    auto const L = stated(formula, D).lagrangian;
    set_machine_code(machine_code::off);
    auto const interpreted = said<S, D>(L, 0);
    set_machine_code(machine_code::at_once);
    int const before = engine::formulas_in_machine_code();
    CHECK(interpreted == said<S, D>(L, 2000));
    CHECK(engine::formulas_in_machine_code() > before);
    set_machine_code(machine_code::on);
}

} // namespace

TEST_CASE("machine code of a node has the bits of the formula, at one position and at several, in double and in float") {
    kept_here const here;
    same_bits<double, 1>("v[0]^2/2 + cos(q[0])*exp(-q[0]) - log(q[0])/3 + q[0]^(5/2)");
    same_bits<float, 1>("v[0]^2/2 + cos(q[0])*exp(-q[0]) - log(q[0])/3 + q[0]^(5/2)");
    same_bits<double, 2>("dot(v, v)/2 + 1/norm(q) + t*q[0]*v[1]^3");
    same_bits<float, 2>("dot(v, v)/2 + 1/norm(q)");
    same_bits<double, 3>("(1 + q[0]^2)*v[0]^2 + v[1]*v[2] + v[2]^2 + tanh(q[1])*sin(q[2]) - hypot(q[0], q[1]) + v[0]*q[2]");
    same_bits<float, 3>("dot(v, v) + q[0]*q[1]*q[2] - sqrt(q[0] + q[1])");
}
// Derivatives of the same formula by jets differ by rounding only: a few operations of numbers below 8.
TEST_CASE("what a formula says is what jets of it say") {
    set_machine_code(machine_code::off);
    auto const L = stated("(1 + q[0]^2)*v[0]^2/2 + v[1]^2/2 + q[0]*v[1] - q[0]^2*q[1] + t*q[1]", 2).lagrangian;
    small_lagrangian<double, 2> const of(L);
    using V = Eigen::Vector2d;
    V const q(0.5, -0.75), v(1.25, 0.5);
    auto const e = of.expand(2.0, q, v);
    auto const typed = [](auto const& x, auto const& y) {
        return (1 + x(0) * x(0)) * y(0) * y(0) / 2 + y(1) * y(1) / 2 + x(0) * y(1) - x(0) * x(0) * x(1) + 2 * x(1);
    };
    auto const j = hilger::expand(typed, q, v);
    double const rounding = 32 * epsilon<double>();
    CHECK((e.by_q - j.by_q).cwiseAbs().maxCoeff() <= rounding);
    CHECK((e.by_v - j.by_v).cwiseAbs().maxCoeff() <= rounding);
    CHECK((e.qq - j.qq).cwiseAbs().maxCoeff() <= rounding);
    CHECK((e.qv - j.qv).cwiseAbs().maxCoeff() <= rounding);
    CHECK((e.vv - j.vv).cwiseAbs().maxCoeff() <= rounding);
    CHECK(of.reads_time());
    CHECK(e.on.coupled);
    CHECK_FALSE(small_lagrangian<double, 1>(stated("v[0]^2 - q[0]^2", 1).lagrangian).reads_time());
}
TEST_CASE("a formula with branches is told of on each of them, and never machine code") {
    kept_here const here;
    set_machine_code(machine_code::at_once);
    small_lagrangian<double, 1> const of(stated("v[0]^2/2 - abs(q[0])*q[0]^2", 1).lagrangian);
    using V = Eigen::Matrix<double, 1, 1>;
    V a, b;
    detail::branch_watch const watch;
    for (int k = 0; k < 3000; ++k) {
        double const x = k % 2 == 0 ? 0.5 : -0.5;
        (void)of.gradients(0.0, V(x), V(1.0), a, b);
        REQUIRE(a(0) == -3 * std::abs(x) * x);
        REQUIRE(b(0) == 1.0);
    }
    CHECK(watch.saw_any());
}
TEST_CASE("a formula that is too long to be functions of numbers goes on as it is") {
    kept_here const here;
    std::string L = "v[0]^2/2";
    for (int k = 1; k < 400; ++k) L += " - cos(q[0]*" + std::to_string(k) + ")/" + std::to_string(k);
    auto const of = stated(L, 1).lagrangian;
    set_machine_code(machine_code::off);
    auto const interpreted = said<double, 1>(of, 0);
    set_machine_code(machine_code::at_once);
    CHECK(interpreted == said<double, 1>(of, 2000));
}
TEST_CASE("a formula in text is traced once for all that copies of it are asked") {
    auto const L = stated("v[0]^2/2 + cos(q[0])", 1).lagrangian;
    int traced = 0;
    auto const trace = [&] {
        ++traced;
        Eigen::VectorXd const x = Eigen::VectorXd::Ones(1);
        return detail::trace_problem(problem<text::stated_lagrangian, no_force>{L, {}}, 0.0, x, x);
    };
    auto const first = L.kept().of<double>(trace);
    auto const copy = L;
    CHECK(copy.kept().of<double>(trace) == first);
    CHECK(traced == 1);
    set_machine_code(machine_code::off); // and again where what was translated of it is not wanted any more
    CHECK(copy.kept().of<double>(trace) != first);
    CHECK(traced == 2);
    auto const branched = stated("v[0]^2/2 - abs(q[0])", 1).lagrangian;
    auto const trace_branch = [&] {
        Eigen::VectorXd const x = Eigen::VectorXd::Ones(1);
        return detail::trace_problem(problem<text::stated_lagrangian, no_force>{branched, {}}, 0.0, x, x);
    };
    auto const one = branched.kept().of<double>(trace_branch);
    CHECK(one != branched.kept().of<double>(trace_branch)); // other arguments may take another branch
}

} // namespace small_lagrangian_tests
