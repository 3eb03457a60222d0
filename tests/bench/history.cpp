// SPDX-License-Identifier: BSL-1.0
// What a history costs: nanoseconds for past() and push() of one value, the time to make it, bytes, and the largest distance from the exact
// sums. The values come from a recurrence that waits for the history, as a scheme does.
#include "hilger/history/history.hpp"
#include "timing.hpp"

namespace bench {
namespace {

using clock = std::chrono::steady_clock;
using hilger::bdf;
using hilger::grunwald_letnikov;

double seconds_since(clock::time_point begin) { return std::chrono::duration<double>(clock::now() - begin).count(); }

/// sum_{n=0..k} w_n x_{k-n} of order 1/2 for all k.
template <class G>
std::vector<double> all_sums(std::vector<double> const& x) {
    return hilger::toeplitz_triangle<double>(hilger::first_weights<G>(0.5, static_cast<hilger::index_type>(x.size())))(x);
}

struct line {
    double seconds = std::numeric_limits<double>::infinity(), making = seconds, distance = 0;
    std::size_t bytes = 0;
};
template <class G, class Policy>
line measure(Policy const& policy, long steps, int rounds, std::vector<double> const& exact) {
    line result;
    for (int r = 0; r < rounds; ++r) {
        auto begin = clock::now();
        auto engine = hilger::make_history<G>(policy, 0.5, 0.0);
        result.making = std::min(result.making, seconds_since(begin));
        begin = clock::now();
        double x = 1;
        for (long m = 0; m < steps; ++m) {
            x = 1 - 0.1 * (x + engine.past());
            engine.push(x);
        }
        result.seconds = std::min(result.seconds, seconds_since(begin));
        result.bytes = engine.bytes();
    }
    auto engine = hilger::make_history<G>(policy, 0.5, 0.0);
    for (long m = 0; m < steps; ++m) {
        double const x = std::cos(static_cast<double>(m) / 100);
        result.distance = std::max(result.distance, std::abs(x + engine.past() - exact[static_cast<std::size_t>(m)]));
        engine.push(x);
    }
    return result;
}
void print(std::string const& name, long steps, line const& l) {
    std::cout << std::setw(9) << steps << "  " << std::left << std::setw(24) << name << std::right << std::fixed << std::setprecision(1)
              << std::setw(9) << l.seconds / static_cast<double>(steps) * 1e9 << " ns" << std::setprecision(3) << std::setw(10)
              << l.making * 1e3 << " ms" << std::setw(12) << l.bytes << std::scientific << std::setprecision(1) << std::setw(11)
              << l.distance << std::defaultfloat << '\n';
}
template <class G>
void table(std::string const& title) {
    std::cout << title << "\n    steps  history                 a value      making       bytes   distance\n";
    for (long const steps : {1L << 10, 1L << 14, 1L << 17, 1L << 20}) {
        std::vector<double> x;
        for (long m = 0; m < steps; ++m) x.push_back(std::cos(static_cast<double>(m) / 100));
        auto const exact = all_sums<G>(x); // tests/runtime holds it to the sum as it is written
        if (steps <= 1L << 17) print("direct", steps, measure<G>(hilger::direct{}, steps, steps > 1L << 14 ? 1 : 5, exact));
        print("blocks", steps, measure<G>(hilger::blocks{}, steps, 3, exact));
        print("exponentials", steps, measure<G>(hilger::exponentials{}, steps, 5, exact));
        print("exponentials{1e-8}", steps, measure<G>(hilger::exponentials{1e-8}, steps, 5, exact));
    }
    std::cout << '\n';
}

/// Steps of a scheme by hand, two Newton corrections of x + sin(x)/10 = 1/2 - s/10 each, with and without a history s.
template <bool Remembers>
double scheme(long steps) {
    auto engine = hilger::make_history<bdf<2>>(hilger::exponentials{}, 0.5, 0.0);
    double x = 1, sum = 0;
    for (long m = 0; m < steps; ++m) {
        double const right = 0.5 - 0.1 * (Remembers ? engine.past() : x);
        for (int i = 0; i < 2; ++i) x -= (x + 0.1 * std::sin(x) - right) / (1 + 0.1 * std::cos(x));
        if (Remembers) engine.push(x);
        sum += x;
    }
    return sum;
}

} // namespace

void histories() {
    std::cout << "Histories of order 1/2 in double: time for past() and push() of one value\n\n";
    table<grunwald_letnikov>("Gruenwald-Letnikov");
    table<bdf<2>>("G^alpha");
    race("Two Newton corrections a step, and G^alpha's history beside them", 1L << 20, 7,
         {{"without a history", scheme<false>, true}, {"exponentials", scheme<true>}});
    std::size_t const N = 1U << 20;
    std::vector<double> const x(N, 1.0);
    double all = std::numeric_limits<double>::infinity(), weights = all;
    for (int r = 0; r < 5; ++r) {
        auto begin = clock::now();
        auto const w = hilger::first_weights<grunwald_letnikov>(0.5, static_cast<hilger::index_type>(N));
        weights = std::min(weights, seconds_since(begin));
        begin = clock::now();
        auto const y = all_sums<grunwald_letnikov>(x);
        all = std::min(all, seconds_since(begin));
    }
    std::cout << std::setprecision(3) << "all sums of 2^20 values: " << all << " s, of which " << weights << " s are the weights\n";
}

} // namespace bench
