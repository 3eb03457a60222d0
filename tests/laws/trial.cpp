// SPDX-License-Identifier: BSL-1.0
// What proves identities must refuse those that are false: in exact scalars by any difference, in floating ones by more than 4 epsilons of
// the size that the identity states, and whatever is NaN.
#include <doctest/doctest.h>

#include "hilger/calculus.hpp"
#include "hilger/multiprecision.hpp"
#include "identities/by_parts.hpp"

namespace identities_tests {

using namespace hilger;

namespace {

/// 1/1, 2/1, 3/1, ...
struct counting {
    int n = 0;
    std::pair<int, int> operator()() { return {++n, 1}; }
};
/// Whatever is written in it, tried on three points with functions f = 1, 2, 3.
template <class S, class Statement>
verdict tried(Statement const& statement) {
    counting numbers;
    return check(statement, uniform(S(0), S(1), 2), S(0), numbers);
}
template <class S>
verdict off_by(S const& distance, S const& size) {
    return tried<S>([&](auto& trial) { trial.equal(S(S(1) + distance), S(1), size); });
}

/// (40) of lemma 3 as Cresson and Safi print it: the end terms with the factor h.
struct lemma_3_as_printed {
    template <class Trial>
    void operator()(Trial& trial) const {
        auto const f = trial.function_on(half(trial.T));
        auto const v = trial.function_on(trial.T);
        auto const ends = f[f.last()] * v[v.last()] + f[0] * v[0];
        auto const inner = weighted_sum<delta_weight>(pi_half[mean_h_minus[f]] * v);
        trial.equal(integral(f * (on_half * extend)[v], half(trial.T)), inner + trial.T.h() * ends, trial.size_of(f) * trial.size_of(v));
    }
};

/// (9): the integral on the right is the nabla integral.
struct by_parts_as_printed {
    template <class Trial>
    void operator()(Trial& trial) const {
        auto const f = trial.function_on(trial.T);
        auto const g = trial.function_on(trial.T);
        auto const right = boundary(f * g) - weighted_sum<delta_weight>(Delta_minus[f] * g);
        trial.equal(integral(f * Delta_plus[g], trial.T), right, trial.size_of(f) * trial.size_of(g));
    }
};

} // namespace

TEST_CASE("what is printed falsely is refused, and what corrects it is not") {
    // f = 1, 2 and v = 3, 4, 5: the left-hand side is 7/2 + 9, the inner sum 3/2 4, the ends 3 + 10
    auto const printed = tried<Q>(lemma_3_as_printed{});
    CHECK(not printed.holds);
    CHECK(printed.comparisons == 1);
    CHECK(printed.first_failure.find("left = 25/2, right = 19") == 0);
    auto const corrected = tried<Q>(identities::lemma_3{});
    CHECK(corrected.holds);
    CHECK(corrected.comparisons == 2);
    CHECK(corrected.first_failure.empty());
    CHECK(not tried<double>(lemma_3_as_printed{}).holds);
    CHECK(tried<double>(identities::lemma_3{}).holds);
    CHECK(not tried<Q>(by_parts_as_printed{}).holds);
    CHECK(tried<Q>(identities::by_parts_order_one<nodes>{}).holds);
}

TEST_CASE("no difference is small in the rationals; in floating scalars 4 epsilons of the size are") {
    CHECK(off_by(Q(0), Q(1)).holds);
    CHECK(not off_by(Q(Q(1) / Q(1'000'000'000) / Q(1'000'000'000)), Q(1'000'000)).holds);
    double const e = epsilon<double>();
    CHECK(off_by(4 * e, 1.0).holds);
    CHECK(not off_by(5 * e, 1.0).holds);
    CHECK(not off_by(-5 * e, 1.0).holds);
    CHECK(off_by(40 * e, 10.0).holds);
    CHECK(not off_by(e, 0.0).holds);
    CHECK(off_by(3 * e, 2.0).worst == 1.5);
    CHECK(not off_by(std::numeric_limits<double>::quiet_NaN(), 1.0).holds);
    CHECK(not off_by(std::numeric_limits<double>::infinity(), 1.0).holds);
}

TEST_CASE("every point is compared, and the first failure is kept") {
    for (int const wrong : {0, 1, 2}) {
        CAPTURE(wrong);
        auto const found = tried<Q>([wrong](auto& trial) {
            auto const f = trial.function_on(trial.T);
            trial.equal_everywhere(f, function_on(trial.T, [wrong](Q t) { return t == Q(wrong) ? Q(0) : Q(t + 1); }), Q(1));
            trial.equal(Q(7), Q(8), Q(1));
        });
        CHECK(not found.holds);
        CHECK(found.comparisons == 4);
        CHECK(found.first_failure.find("left = " + std::to_string(wrong + 1) + ", right = 0 on T") == 0);
    }
}

TEST_CASE("a condition that is not met is a failure, and said") {
    auto const found = tried<Q>([](auto& trial) {
        trial.require(true, "one is one");
        trial.require(false, "one is two");
    });
    CHECK(not found.holds);
    CHECK(found.comparisons == 2);
    CHECK(found.first_failure.find("one is two on T = {0, 1, 2} (3 points)") == 0);
}

} // namespace identities_tests
