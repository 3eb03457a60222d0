// SPDX-License-Identifier: BSL-1.0
// What rounding does to the energy of the mid-point pendulum. Each step in double is compared with the same step, from the same state, in
// long double; the energy that its rounding error makes is added up to D. If those errors are independent of each other D is a random walk,
// and the root mean square of D(n + m) - D(n) grows like m^(1/2) (Brouwer's law); a bias makes it grow like m. The truncation error, which
// is a thousand million times larger and periodic, is in neither.
#include <cstdlib>

#include "hilger/hilger.hpp"
#include "timing.hpp"

namespace bench {
namespace {

constexpr auto pendulum = [](auto const& q, auto const& v) { return v * v / 2 - (1 - cos(q)); };

/// What the sums have cut off so far, position first; nothing for plain sums.
struct rests {
    long double rest[2] = {0, 0};
    int n = 0;
    void operator()(char const* label, double& x) {
        if (label[0] == 'c') rest[n++] = x;
    }
    template <class Other>
    void operator()(char const*, Other&) {}
};

template <class Flow>
void walk(std::string const& name, Flow const& flow, long steps) {
    constexpr long every = 1000;
    double const h = 0.0625;
    auto const wide_flow = hilger::embed(pendulum, hilger::mid_point);
    using wide = hilger::state<long double, long double>;
    hilger::state<double, double> x{0.0, 1.5, 0.0};
    typename Flow::template memory<double, double> memory(flow, h, x.q);
    typename decltype(wide_flow)::template memory<long double, long double> wide_memory(wide_flow, h, 0.0L);
    rests before;
    std::vector<double> D{0};
    long double drift = 0;
    for (long n = 1; n <= steps; ++n) {
        wide y{0, x.q + before.rest[0], x.p + before.rest[1]};
        memory.advance(flow, x, h);
        wide_memory.advance(wide_flow, y, h);
        rests after;
        memory.visit(flow, after);
        long double const dq = x.q + after.rest[0] - y.q, dp = x.p + after.rest[1] - y.p;
        drift += std::sin(y.q) * dq + y.p * dp;
        before = after;
        if (n % every == 0) D.push_back(static_cast<double>(drift));
    }
    std::cout << name << ", " << steps << " steps\n    apart (steps)   rms energy error\n";
    double sx = 0, sy = 0, sxx = 0, sxy = 0, count = 0;
    for (std::size_t lag = 1; lag * 8 <= D.size(); lag *= 2) {
        double square = 0;
        for (std::size_t k = 0; k + lag < D.size(); ++k) square += (D[k + lag] - D[k]) * (D[k + lag] - D[k]);
        double const rms = std::sqrt(square / static_cast<double>(D.size() - lag));
        std::cout << std::setw(17) << lag * every << std::scientific << std::setprecision(3) << std::setw(19) << rms << std::defaultfloat
                  << '\n';
        double const u = std::log(static_cast<double>(lag)), v = std::log(rms);
        sx += u, sy += v, sxx += u * u, sxy += u * v, ++count;
    }
    std::cout << "    exponent " << std::setprecision(3) << (count * sxy - sx * sy) / (count * sxx - sx * sx)
              << ", energy error at the end " << D.back() << "\n\n";
}

} // namespace

void rounding(double log10_of_steps) {
    long const steps = std::lround(std::pow(10, log10_of_steps));
    walk("mid-point, compensated sums", hilger::embed(pendulum, hilger::mid_point, hilger::compensated), steps);
    walk("mid-point, plain sums", hilger::embed(pendulum, hilger::mid_point), steps);
}

} // namespace bench
