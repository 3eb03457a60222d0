// SPDX-License-Identifier: BSL-1.0
// The loops of a history in every instruction set that this processor has give what one number at a time gives.
#include <doctest/doctest.h>

#include <cmath>

#include "histories.hpp"

namespace history_loops_tests {

using namespace hilger;
using namespace hilger::testing;

namespace {
template <class S>
struct loops {
    std::string name;
    detail::memory::sums<S> sum;
};
/// What a user of an older processor runs is tested here as well.
template <class S>
std::vector<loops<S>> all_loops() {
    using sums = detail::memory::sums<S>;
    loops<S> baseline;
    baseline.name = "baseline";
    baseline.sum.product_sum = sums::for_product_sum::baseline;
    baseline.sum.relax = sums::for_relax::baseline;
    std::vector<loops<S>> all{baseline};
#ifdef HILGER_DETAIL_X86
    if (detail::memory::available_instructions() >= detail::memory::instructions::avx2) {
        loops<S> avx2;
        avx2.name = "AVX2";
        avx2.sum.product_sum = sums::for_product_sum::avx2;
        avx2.sum.relax = sums::for_relax::avx2;
        all.push_back(avx2);
    }
#endif
    return all;
}

template <class S>
void check_sums() {
    noise source;
    S const eps = epsilon<S>();
    for (auto const& loop : all_loops<S>()) {
        CAPTURE(loop.name);
        for (std::size_t n = 0; n <= 70; ++n) { // any address and length
            std::vector<S> x, y;
            for (std::size_t i = 0; i < n + 1; ++i) x.push_back(source.next<S>()), y.push_back(source.next<S>());
            S expected(0);
            for (std::size_t i = 1; i <= n; ++i) expected += x[i] * y[i];
            CHECK(std::abs(loop.sum.product_sum(x.data() + 1, y.data() + 1, n) - expected) <= S(20) * eps);
        }
        std::size_t const n = detail::memory::padded<S>(90);
        for (std::size_t const brief : {std::size_t(0), detail::memory::padding<S>, n - detail::memory::padding<S>, n}) {
            CAPTURE(brief);
            detail::memory::line_vector<S> rate(n, S(1)), coefficient(n, S(0)), state(n, S(0)), low(n - brief, S(0)), expected(n, S(0));
            for (std::size_t i = 0; i < 90; ++i) {
                rate[i] = std::abs(source.next<S>());
                coefficient[i] = source.next<S>() / S(90);
            }
            for (int step = 0; step < 100; ++step) {
                S const x = source.next<S>();
                S const sum = loop.sum.relax(rate.data(), coefficient.data(), state.data(), low.data(), brief, n, x);
                S expected_sum(0);
                for (std::size_t i = 0; i < n; ++i) {
                    expected[i] = (S(1) - rate[i]) * expected[i] + x;
                    expected_sum += coefficient[i] * expected[i];
                    REQUIRE(std::abs(state[i] - expected[i]) <= S(1000) * eps);
                }
                REQUIRE(std::abs(sum - expected_sum) <= S(1000) * eps);
            }
        }
        // Of a sum that grows for long nothing is lost.
        S const slow = S(1) / S(1 << 20);
        detail::memory::line_vector<S> rate(n, slow), coefficient(n, S(1)), state(n, S(0)), low(n, S(0));
        long double expected = 0;
        for (int step = 0; step < 10'000; ++step) {
            S const x = S(1) + source.next<S>();
            loop.sum.relax(rate.data(), coefficient.data(), state.data(), low.data(), 0, n, x);
            expected += static_cast<long double>(x) - static_cast<long double>(slow) * expected;
        }
        for (std::size_t i = 0; i < n; ++i) CHECK(std::abs(state[i] - expected) <= 2 * eps * expected);
    }
}
} // namespace

TEST_CASE_TEMPLATE("sums of products and exponentials", S, float, double) { check_sums<S>(); }

} // namespace history_loops_tests
