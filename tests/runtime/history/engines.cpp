// SPDX-License-Identifier: BSL-1.0
// Every engine against the sum as it is written, at every point.
#include <doctest/doctest.h>

#include <cmath>

#include "histories.hpp"

namespace history_engines_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
/// Random numbers between -1 and 1 and their sums as they are written.
template <class G, class V>
struct data {
    using S = scalar_of<V>;
    S alpha;
    std::vector<V> x, sums;
    data(S const& order, hilger::index_type N) : alpha(order), x(random_values<V>(N)), sums(sums_as_written<G>(alpha, x)) {}

    /// The engine of a policy is nowhere further than so many epsilon from the sums, and once more after reset().
    template <class Policy>
    void compare(Policy const& policy, double bound) const {
        auto engine = make_history<G>(policy, alpha, x[0]);
        for (int run = 0; run < (x.size() <= 100 ? 2 : 1); ++run) {
            CHECK(magnitude(engine.past()) == S(0));
            double worst = 0;
            std::size_t where = 0;
            for (std::size_t k = 0; k < x.size(); ++k) {
                engine.push(x[k]);
                double const distance = static_cast<double>(magnitude(V(engine.past() - sums[k])) / epsilon<S>());
                if (not(distance <= worst)) worst = distance, where = k;
            }
            CAPTURE(x.size());
            CAPTURE(where);
            CAPTURE(static_cast<double>(alpha));
            CHECK(worst <= bound);
            CHECK(engine.count() == static_cast<hilger::index_type>(x.size()));
            engine.reset();
            CHECK(engine.count() == 0);
        }
    }
};

/// With |x| <= 1 the sums are below sum |w_n| <= 2 (3 for G^alpha); a few roundings of that, and the tolerance times it.
template <class V>
void compare_all(hilger::index_type longest) {
    for (hilger::index_type const N :
         {hilger::index_type(1), hilger::index_type(2), hilger::index_type(3), hilger::index_type(100), longest})
        for (int const tenths : {1, 5, 9, 10, 14}) {
            scalar_of<V> const alpha = scalar_of<V>(tenths) / scalar_of<V>(10);
            data<grunwald_letnikov, V> const gl(alpha, N);
            gl.compare(direct{}, 10);
            gl.compare(blocks{}, 10);
            gl.compare(exponentials{}, 10 + 2 * 64);
            data<bdf<2>, V> const g_alpha(alpha, N);
            g_alpha.compare(blocks{}, 15);
            g_alpha.compare(exponentials{}, 15 + 3 * 64);
        }
}
} // namespace

TEST_CASE("double") { compare_all<double>(5000); }
TEST_CASE("float") { compare_all<float>(5000); }
TEST_CASE("vectors of three doubles") { compare_all<Eigen::Vector3d>(3000); }
TEST_CASE("vectors whose size is known at run time") { compare_all<Eigen::VectorXd>(200); }
TEST_CASE("float to 50 digits") {
    for (hilger::index_type const N : {1, 2, 3, 100, 300}) {
        data<bdf<2>, float50> const g_alpha(float50(7) / 10, N);
        g_alpha.compare(direct{}, 30);
        g_alpha.compare(blocks{}, 30);
    }
    data<grunwald_letnikov, float50>(float50(1) / 2, 300).compare(exponentials{0, 1000}, 2100); // 1024 epsilon is the tolerance
    data<bdf<2>, float50>(float50(9) / 10, 300).compare(exponentials{0, 1000}, 3100);
}
TEST_CASE("every BDF, and a generating function that only direct and blocks know") {
    data<bdf<1>, double>(0.4, 1500).compare(exponentials{}, 140);
    data<bdf<3>, double>(0.4, 1500).compare(exponentials{}, 200);
    data<bdf<4>, double>(0.7, 1500).compare(exponentials{}, 300);
    data<bdf<5>, double>(0.5, 1500).compare(exponentials{}, 300);
    data<bdf<6>, Eigen::Vector3d> const last(0.5, 1500);
    last.compare(exponentials{}, 500);
    last.compare(blocks{}, 40);
    data<trapezoid, double> const oscillating(0.4, 1500); // sum |w_n| grows
    oscillating.compare(blocks{}, 100);
    oscillating.compare(direct{}, 100);
}

TEST_CASE("weights in reversed order beyond n = 64: an impulse shows every engine's weights one by one") {
    auto const check = [](auto engine) {
        weight_sequence<grunwald_letnikov, double> w(0.4);
        w.next();
        for (int n = 1; n <= 700; ++n) {
            engine.push(n == 1 ? 1 : 0);
            REQUIRE(engine.past() == doctest::Approx(w.next()).epsilon(1e-11));
        }
    };
    check(make_history<grunwald_letnikov>(direct{}, 0.4, 0.0));
    check(make_history<grunwald_letnikov>(blocks{}, 0.4, 0.0));
    check(make_history<grunwald_letnikov>(exponentials{}, 0.4, 0.0));
}

TEST_CASE("memory sums that are overwritten instead of added: of constant values the sum is the product formula") {
    // w_0 + ... + w_m = (1 - alpha)(1 - alpha/2)...(1 - alpha/m)
    auto const check = [](auto engine) {
        double product = 1;
        for (int m = 1; m <= 20'000; ++m) {
            engine.push(1);
            product *= 1 - 0.3 / m;
            REQUIRE(std::abs(1 + engine.past() - product) <= 1e-13);
        }
    };
    check(make_history<grunwald_letnikov>(blocks{}, 0.3, 0.0));
    check(make_history<grunwald_letnikov>(exponentials{}, 0.3, 0.0));
}

} // namespace history_engines_tests
