// SPDX-License-Identifier: BSL-1.0
// Radau's nodes: the last one is the end of the step, and polynomials up to degree 2n - 2 are integrated exactly.
#include <doctest/doctest.h>

#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "runtime/embedding/radau.hpp"

namespace radau_nodes_tests {

using namespace hilger;

namespace {
/// The largest |sum_k w_k c_k^m - 1/(m + 1)| for m <= degree, in float50.
template <class S>
float50 worst_moment(int n, int degree) {
    auto const q = radau::on_unit_interval<S>(n);
    float50 worst(0);
    for (int m = 0; m <= degree; ++m) {
        float50 sum(0);
        for (std::size_t k = 0; k < q.node.size(); ++k) sum += float50(S(q.weight[k])) * pow(float50(S(q.node[k])), m);
        worst = std::max(worst, float50(abs(sum - 1 / float50(m + 1))));
    }
    return worst;
}
} // namespace

TEST_CASE("n nodes increase up to 1 and are exact up to degree 2n - 2, and no further") {
    for (int n = 1; n <= 12; ++n) {
        CAPTURE(n);
        auto const q = radau::on_unit_interval<float50>(n);
        REQUIRE(q.node.size() == static_cast<std::size_t>(n));
        CHECK(q.node.back() == 1);
        CHECK(abs(float50(q.weight.back() * (n * n) - 1)) <= 64 * epsilon<float50>());
        for (std::size_t k = 0; k < q.node.size(); ++k) CHECK((k == 0 ? float50(0) : q.node[k - 1]) < q.node[k]);
        // m roundings in a power of degree m, and weights that add up to 1
        CHECK(worst_moment<float50>(n, 2 * n - 2) <= (4 * n + 64) * epsilon<float50>());
        CHECK(worst_moment<float50>(n, 2 * n - 1) > pow(float50(1) / 16, n) / (8 * n)); // ((n-1)!/(2n-1)!)^2 n (2n-1)!/2 or so
        CHECK(worst_moment<double>(n, 2 * n - 2) <= 2 * n * epsilon<double>());
        CHECK(worst_moment<float>(n, 2 * n - 2) <= 2 * n * epsilon<float>());
    }
}

TEST_CASE("one node and two are rational, as numbers and as residues, and three are not") {
    auto const one = radau::on_unit_interval<Q>(1), two = radau::on_unit_interval<Q>(2);
    CHECK((one.node == std::vector<Q>{1} and one.weight == std::vector<Q>{1}));
    CHECK((two.node == std::vector<Q>{Q(1, 3), 1} and two.weight == std::vector<Q>{Q(3, 4), Q(1, 4)}));
    CHECK_THROWS_WITH_AS(static_cast<void>(radau::on_unit_interval<Q>(3)), "these nodes are irrational: take a scalar that is not exact",
                         error::invalid_parameter const&);
    constexpr auto single = detail::residues_of_quadrature<radau, 1>();
    constexpr auto pair = detail::residues_of_quadrature<radau, 2>();
    static_assert(single.node[0] == prime_field(1) and single.weight[0] == prime_field(1));
    static_assert(pair.node[0] * prime_field(3) == prime_field(1) and pair.node[1] == prime_field(1));
    static_assert(pair.weight[0] * prime_field(4) == prime_field(3) and pair.weight[1] * prime_field(4) == prime_field(1));
}

TEST_CASE("as embeddings: one node is the difference at the end of the step, two are as a quadrature of one's own has them") {
    auto const one = tableau_of(galerkin<1, radau>, Q(1, 5)), end = tableau_of(order_one_left, Q(1, 5));
    CHECK((one.position == end.position and one.velocity == end.velocity and one.weight == end.weight));
    static_assert(facts_of<decltype(galerkin<1, radau>)>.at_end);
    auto const two = tableau_of(galerkin<2, radau>, Q(1, 5)), own = tableau_of(testing::radau_galerkin, Q(1, 5));
    CHECK((two.position == own.position and two.velocity == own.velocity and two.weight == own.weight and two.inside == own.inside));
}

} // namespace radau_nodes_tests
