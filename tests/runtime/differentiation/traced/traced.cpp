// SPDX-License-Identifier: BSL-1.0
// Traced formulas have the derivatives that jets have, evaluate only what is not zero, and hold where the comparisons come out as they did.
#include <random>

#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/variational/nodes/node.hpp"

namespace traced_tests {

using namespace hilger;

namespace {

constexpr int d = 3;
template <class S>
using vector = Eigen::Matrix<S, d, 1>;

/// All derivatives of f by jets and by its graph; what they differ by, in units of the largest.
template <class S, class F>
S difference(F const& f, vector<S> const& q, vector<S> const& v) {
    auto const x = expand(f, q, v);
    auto const y = detail::expand_traced(f, q, v);
    S most(0), size(0);
    auto const compare = [&](auto const& a, auto const& b) {
        most = std::max(most, S(magnitude(std::remove_cvref_t<decltype(a)>(a - b))));
        size = std::max(size, S(magnitude(a)));
    };
    compare(x.by_q, y.by_q);
    compare(x.by_v, y.by_v);
    compare(x.qq, y.qq);
    compare(x.qv, y.qv);
    compare(x.vv, y.vv);
    return most == S(0) ? most : S(most / size);
}

/// A formula of random operations: each one of q, v, small numbers and of those before it.
struct random_formula {
    struct operation {
        int what, a, b;
    };
    std::vector<operation> all;

    explicit random_formula(unsigned seed) {
        std::mt19937 random(seed);
        auto const below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
        for (int k = 0; k < 14; ++k) all.push_back({below(6), below(2 * d + 2 + k), below(2 * d + 2 + k)});
    }
    template <class X, class Y>
    auto operator()(X const& q, Y const& v) const {
        auto const one = plain_t<decltype(q(0) * v(0))>(1);
        using T = std::remove_cvref_t<decltype(one)>;
        std::vector<T> x;
        for (int k = 0; k < d; ++k) x.push_back(T(q(k)));
        for (int k = 0; k < d; ++k) x.push_back(T(v(k)));
        x.push_back(T(2));
        x.push_back(T(-1) / 3);
        for (auto const& o : all) {
            T const a = x[static_cast<std::size_t>(o.a)], b = x[static_cast<std::size_t>(o.b)];
            switch (o.what) {
            case 0:
                x.push_back(a + b);
                break;
            case 1:
                x.push_back(a - b);
                break;
            case 2:
                x.push_back(a * b);
                break;
            case 3:
                x.push_back(a / (b * b + 1));
                break;
            case 4:
                x.push_back(-a * 3);
                break;
            default:
                x.push_back(pow(b, 2) - a);
                break;
            }
            if (x.size() > 12) x.back() = x.back() / (x.back() * x.back() + 7); // or numbers grow beyond all bounds
        }
        return x.back() * x[x.size() - 2] + x[x.size() - 3];
    }
};

} // namespace

TEST_CASE("random rational formulas: the derivatives of jets, exactly") {
    for (unsigned seed = 0; seed < 60; ++seed) {
        CAPTURE(seed);
        random_formula const f(seed);
        vector<Q> const q(Q(1, 2), Q(-2, 3), Q(3, 5)), v(Q(-1, 4), Q(2), Q(5, 7));
        CHECK(difference<Q>(f, q, v) == 0);
    }
}

TEST_CASE("every function has the derivatives of jets") {
    auto const near = [](char const* name, auto const& f) {
        CAPTURE(name);
        vector<double> const q(0.4, -0.3, 0.7), v(0.2, 0.6, -0.5);
        CHECK(difference<double>(f, q, v) <= 64 * epsilon<double>());
        CHECK(difference<float50>(f, vector<float50>(q.cast<float50>()), vector<float50>(v.cast<float50>())) <= 64 * epsilon<float50>());
    };
    // inside each function something that depends on positions and velocities, and whose second derivatives are not zero
    auto const in = [](auto const& q, auto const& v) { return q(0) * v(1) * v(1) + q(2) * q(1) / 3 + 0.75; };
#define NEAR(formula)                                                                                                                      \
    near(#formula, [&](auto const& q, auto const& v) {                                                                                     \
        [[maybe_unused]] auto const u = in(q, v);                                                                                          \
        return formula;                                                                                                                    \
    })
    NEAR(sin(u) * v(0));
    NEAR(cos(u));
    NEAR(tan(u));
    NEAR(exp(u) - exp(-v(2)));
    NEAR(log(u));
    NEAR(sqrt(u));
    NEAR(sinh(u));
    NEAR(cosh(u));
    NEAR(tanh(u));
    NEAR(asin(u));
    NEAR(acos(u));
    NEAR(atan(u));
    NEAR(asinh(u));
    NEAR(acosh(1 + u));
    NEAR(atanh(u));
    NEAR(cbrt(u));
    NEAR(expm1(u));
    NEAR(log1p(u));
    NEAR(erf(u));
    NEAR(pow(u, 2.5));
    NEAR(pow(u, 3) + pow(u, -2) + pow(u, 0) + pow(u, 1));
    NEAR(pow(u, u));
    NEAR(pow(2.5, u) + pow(0.0, u));
    NEAR(hypot(u, v(0)) + hypot(q(1), 2.0));
    NEAR(atan2(u, v(0)) + atan2(0.5, u));
    NEAR(abs(u - 2) + fabs(q(1)) + copysign(u, q(1)));
    NEAR(max(u, 0.1) * min(q(0), v(0)) + fmax(q(1), q(2)) + fmin(v(1), 3.0));
    NEAR(q.squaredNorm() * v.norm() + (q - v).dot(q) / q.norm() + q.cwiseProduct(v).sum());
#undef NEAR
}

TEST_CASE("a formula is looked at once, and again where a comparison comes out differently") {
    long long calls = 0;
    auto const spring = [&calls](auto const& q, auto const& v) {
        ++calls;
        plain_t<decltype(q(0))> const r = q(4) - q(0);
        return v.dot(v) / 2 - q.dot(q) / 2 - (r > 0 ? 1 : 3) * r * r / 2;
    };
    using V = Eigen::Matrix<double, 5, 1>;
    problem<decltype(spring)> const what{spring, {}};
    detail::given<problem<decltype(spring)>, V> const asked(what);
    detail::traced_node<V> at;
    V q = V::Zero(), v = V::Ones();
    q(4) = 1;
    auto const slope = [&](double far, detail::wanted which) {
        q(4) = far;
        (void)at.evaluate(asked, 0.0, q, v, which);
        return at.by_q(4);
    };
    using parts = detail::wanted;
    for (int pass = 0; pass < 3; ++pass) {
        CHECK(slope(1, parts::first_order) == -2);
        CHECK(slope(-1, parts::with_seconds) == 4);
        CHECK(slope(2, parts::forces_only) == -4);
        CHECK(calls == 2);
    }
    // whoever watches sees the branches, as with jets
    detail::branch_watch const watch;
    (void)slope(1, parts::first_order);
    auto const right = watch.path();
    detail::branch_watch const again;
    (void)slope(3, parts::first_order);
    CHECK(again.path() == right);
    detail::branch_watch const left;
    (void)slope(-3, parts::first_order);
    CHECK(not(left.path() == right));
}

TEST_CASE("powers have the slopes of powers, however they are multiplied") {
    using V = Eigen::Matrix<Q, d, 1>;
    V const q(Q(2, 3), Q(-5, 7), Q(3)), v(Q(1, 2), Q(4), Q(-3, 5));
    auto const raised = [](auto const& x, int n) {
        plain_t<decltype(x * x)> y(1);
        for (int k = 0; k < n; ++k) y = y * x;
        return y;
    };
    for (int n = 2; n <= 9; ++n) {
        CAPTURE(n);
        auto const halves = [n](auto const& x) { return plain_t<decltype(x * x)>(pow(x, n / 2) * pow(x, n - n / 2)); };
        for (bool const in_a_row : {true, false}) {
            auto const f = [&](auto const& x, auto const& y) {
                plain_t<decltype(x(0) * y(0))> const u = x(0) - x(1) * y(2); // a base that is no argument
                return (in_a_row ? raised(u, n) : halves(u)) * y(1) + (in_a_row ? raised(y(1), n) : halves(y(1))) / 3 + u;
            };
            CHECK(difference<Q>(f, q, v) == 0);
        }
        auto const y = detail::expand_traced([&](auto const& x, auto const&) { return raised(x(2), n); }, q, v);
        CHECK(y.by_q(2) == n * raised(q(2), n - 1));
        CHECK(y.qq(2, 2) == n * (n - 1) * raised(q(2), n - 2));
    }
}

TEST_CASE("equal operations are one node, however many there are") {
    detail::formula_graph<double> g(1);
    detail::tracing<double> const here(g);
    auto const size_after = [&](int terms) {
        auto const q = traced<double>::at(0, 0.5), v = traced<double>::at(1, 2.0);
        auto sum = q * v;
        for (int k = 2; k < 2 + terms; ++k) sum = sum + q * k;
        return g.size();
    };
    int const size = size_after(2000);
    CHECK(size == g.arguments(1) + 1 + 3 * 2000); // the product, and a number, a product and a sum for each term
    CHECK(size_after(2000) == size);
    CHECK(size_after(2001) == size + 3);
}

TEST_CASE("the slope of a spring is no more work than by hand") {
    // r^2/2 + r^4/4 has the slope r + r^3, whose r^2 and r^3 are there
    auto const spring = [](auto const& q, auto const& v) { return v(0) * v(0) / 2 + q(0) * q(0) / 2 + q(0) * q(0) * q(0) * q(0) / 4; };
    Eigen::VectorXd const x = Eigen::VectorXd::Constant(1, 0.5);
    auto const formula = detail::trace<double>(0.0, x, x, detail::on_position | detail::on_velocity,
                                               [&](auto const&, auto const& q, auto const& v, auto&) { return spring(q, v); });
    auto const operations = [&](detail::evaluation<double>::part which) {
        int sum = 0;
        formula.how.for_each_round(which, [&](auto const& round) { sum += round.count; });
        return sum;
    };
    CHECK(operations(detail::evaluation<double>::shared) == 0);
    CHECK(operations(detail::evaluation<double>::momenta) == 0);
    CHECK(operations(detail::evaluation<double>::forces) == 3);  // r r, r r r, the sum
    CHECK(operations(detail::evaluation<double>::seconds) == 2); // 3 r r + 1
}

TEST_CASE("a time that a formula is told is the time that it has") {
    auto const driven = [](double t, auto const& q, auto const& v) { return v.dot(v) / 2 - q.dot(q) * std::cos(t); };
    using V = Eigen::Matrix<double, 5, 1>;
    problem<decltype(driven)> const what{driven, {}};
    detail::given<problem<decltype(driven)>, V> const asked(what);
    detail::traced_node<V> at;
    for (double const t : {0.0, 1.0, 0.5, 1.0}) {
        (void)at.evaluate(asked, t, V::Ones(), V::Zero(), detail::wanted::first_order);
        CHECK(at.by_q(2) == -2 * std::cos(t));
    }
}

TEST_CASE("of a chain only the neighbours are there") {
    int const n = 40;
    auto const chain = [](auto const& q, auto const& v) {
        auto sum = v.dot(v) / 2 - q(0) * q(0) / 2;
        for (int k = 1; k < q.size(); ++k) sum = sum - pow(q(k) - q(k - 1), 4) / 4;
        return sum;
    };
    problem<decltype(chain)> const what{chain, {}};
    detail::given<problem<decltype(chain)>, Eigen::VectorXd> const asked(what);
    detail::traced_node<Eigen::VectorXd> at;
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(n, 0, 1), v = q;
    (void)at.evaluate(asked, 0.0, q, v, detail::wanted::with_seconds);
    auto const& places = at.places();
    CHECK(places.entries[detail::block_qq].size() == 3 * n - 2);
    CHECK(places.entries[detail::block_vv].size() == n);
    CHECK(places.entries[detail::block_qv].empty());
    CHECK(places.entries[detail::block_vq].empty());
    CHECK(places.constant[detail::block_vv]);
    CHECK(not places.constant[detail::block_qq]);
    for (auto const& e : places.entries[detail::block_vv]) {
        CHECK(e.row == e.column);
        CHECK(at.value(e.place) == 1);
    }
}

TEST_CASE("what a chain has many of is computed in rows, the same value by several numbers too") {
    auto const chain = [](auto const& q, auto const& v) {
        auto sum = v.dot(v) / 2 + 0 * q(0);
        for (int k = 1; k < q.size(); ++k) {
            auto const r = q(k) - q(k - 1);
            sum = sum - (r * r / 2 + r * r * r * r / 4);
        }
        return sum;
    };
    problem<decltype(chain)> const what{chain, {}};
    detail::given<problem<decltype(chain)>, Eigen::VectorXd> const asked(what);
    detail::traced_node<Eigen::VectorXd> at;
    Eigen::VectorXd const q = Eigen::VectorXd::LinSpaced(100, 0, 1), v = q;
    (void)at.evaluate(asked, 0.0, q, v, detail::wanted::with_seconds);
    using evaluation = detail::evaluation<double>;
    int operations = 0, alone = 0;
    for (int part = 0; part < evaluation::parts; ++part)
        at.how().for_each_round(static_cast<evaluation::part>(part), [&](auto const& r) { (r.in_a_row ? operations : alone) += r.count; });
    CHECK(operations > 500);
    CHECK(alone < 10); // at the ends
}

TEST_CASE("norms in all their forms have no slope at 0, as jets have none") {
    auto const check = [](auto const& L) {
        using V = Eigen::Vector3d;
        for (V const& q : {V(0, 0, 0), V(0.5, 0, 0), V(1, -2, 0.5)}) {
            V const v(0.25, 0, -1);
            auto const e = expand(L, q, v);
            auto const t = detail::expand_traced(L, q, v);
            CHECK(magnitude(V(e.by_q - t.by_q)) <= 1e-13);
            CHECK(magnitude(V(e.by_v - t.by_v)) <= 1e-13);
            CHECK((e.qq - t.qq).cwiseAbs().maxCoeff() <= 1e-12);
        }
    };
    check([](auto const& q, auto const& v) { return v.squaredNorm() / 2 - sqrt(2.0 * q(0) * q(0) + 3.0 * q(1) * q(1) + q(2) * q(2)); });
    check([](auto const& q, auto const& v) { return v.squaredNorm() / 2 - sqrt(q.squaredNorm() / 4.0); });
    check([](auto const& q, auto const& v) { return v.squaredNorm() / 2 - sqrt(q.squaredNorm() * q.squaredNorm() * q.squaredNorm()); });
    check([](auto const& q, auto const& v) { return v.squaredNorm() / 2 - pow(q.squaredNorm(), 0.5) * q.squaredNorm(); });
    check([](auto const& q, auto const& v) { return v.squaredNorm() / 2 - pow(q.squaredNorm(), 1.5) + 0.5 * q.norm(); });
}

} // namespace traced_tests
