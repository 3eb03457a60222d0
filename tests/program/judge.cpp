// SPDX-License-Identifier: BSL-1.0
// judge <scene> <rows> <epsilon>: whether the rows that `hilger run` has written, one for each step, solve the discrete equation that the
// scene's method was derived from. It is evaluated in 50 digits, at numbers as they are written, without anything of what steps are made
// by; what rounding with this epsilon may leave of it is computed beside it. The exit status is 0 where they do.
#include <fstream>
#include <iostream>

#include "../../examples/beam.hpp"
#include "../../papers/bourdin_cresson_greff_inizan_2013/exact.hpp"
#include "hilger/integrator/residual.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/trajectory/checkpoint.hpp"
#include "outer_solar_system_data.hpp"

namespace {

using namespace hilger;
using S = float50;
using vector = Eigen::Matrix<S, Eigen::Dynamic, 1>;
using matrix = Eigen::Matrix<S, Eigen::Dynamic, Eigen::Dynamic>;

/// Times, positions and momenta.
struct rows {
    std::vector<S> t;
    std::vector<vector> q, p;

    rows(std::string const& file, int d, int momenta) {
        std::ifstream in(file);
        std::string line;
        std::getline(in, line);
        while (std::getline(in, line)) {
            std::istringstream cells(line);
            std::string cell;
            auto const next = [&] {
                if (not std::getline(cells, cell, ',')) error::raise<error::unreadable>("a row of '", file, "' is too short: ", line);
                return detail::number_from<S>(cell);
            };
            t.push_back(next());
            for (auto* x : {&q, &p}) {
                x->emplace_back(x == &q ? d : momenta);
                for (S& component : x->back()) component = next();
            }
        }
        if (t.size() < 10) error::raise<error::unreadable>("'", file, "' has ", t.size(), " rows only");
    }
    [[nodiscard]] index_type steps() const { return static_cast<index_type>(t.size()) - 1; }
    [[nodiscard]] auto scale() const { return uniform(interval<S>{t.front(), t.back()}, steps()); }
    /// The largest of a component; of all of them.
    static S largest(std::vector<vector> const& x, index_type k) {
        S worst(0);
        for (vector const& y : x) worst = std::max(worst, S(abs(y(k))));
        return worst;
    }
    static S largest(std::vector<vector> const& x) {
        S worst(0);
        for (vector const& y : x) worst = std::max(worst, S(magnitude(y)));
        return worst;
    }
};

/// What is left of an equation, and what may be.
struct judgement {
    S residual{0}, bound{0};
    void add(S const& r, S const& b) {
        if (bound == 0 or not(abs(r) * bound <= residual * b)) residual = abs(r), bound = b; // the worst in units of its bound
    }
};

/// Mid-point's equation. In each component numbers of the sizes p / h and m q / h^2 cancel, and a step is solved to epsilon of its largest
/// velocity; m is p / v.
template <class L>
judgement of_midpoint(L const& l, rows const& x, S const& epsilon) {
    auto const T = x.scale();
    S const h = T.h();
    auto const path = embed(l, mid_point);
    auto const residual = equation_of(path, T).residual(function_on(T, x.q));
    std::vector<vector> v;
    for (std::size_t i = 0; i + 1 < x.q.size(); ++i) v.push_back((x.q[i + 1] - x.q[i]) / h);
    S const fastest = rows::largest(v);
    vector bound(x.q[0].size());
    for (index_type k = 0; k < bound.size(); ++k) {
        S const p = rows::largest(x.p, k), m = p / rows::largest(v, k);
        bound(k) = 32 * epsilon / h * (p + m * (rows::largest(x.q, k) / h + fastest));
    }
    judgement all;
    for (auto const& r : residual)
        for (index_type k = 0; k < bound.size(); ++k) all.add(r(k), bound(k));
    return all;
}

/// The sums of a fractional difference of Caputo from rest, as they are written.
struct difference {
    std::vector<S> w;
    difference(S const& alpha, S const& h, index_type count) : w(first_weights<bdf<2>>(alpha, count)) {
        S const factor = leading_weight<bdf<2>>(alpha) * pow(h, S(-alpha));
        for (S& weight : w) weight *= factor;
    }
    /// From the value n - first on.
    [[nodiscard]] vector at(std::vector<vector> const& y, std::size_t n, std::size_t first = 0) const {
        vector sum = vector::Zero(y[0].size());
        for (std::size_t k = first; k <= n; ++k) sum += w[k] * y[n - k];
        return sum;
    }
};
/// Newmark's equation in positions, M (u_{n+1} - 2 u_n + u_{n-1}) / h^2 = (r_{n+1} + 2 r_n + r_{n-1}) / 4.
judgement of_newmark(matrix const& M, std::vector<vector> const& r, rows const& x, S const& stiffness, S const& epsilon) {
    S const h = x.scale().h();
    S const size = M.cwiseAbs().rowwise().sum().maxCoeff() / (h * h) + stiffness;
    judgement all;
    for (std::size_t n = 1; n + 1 < x.q.size(); ++n) {
        vector const left = M * (x.q[n + 1] - 2 * x.q[n] + x.q[n - 1]) / (h * h) - (r[n + 1] + 2 * r[n] + r[n - 1]) / 4;
        all.add(S(magnitude(left)), S(64 * epsilon * (size * rows::largest(x.q) + rows::largest(r))));
    }
    return all;
}
/// u'' + c D^alpha u + k u = f
struct oscillator {
    S alpha, c, k, f;
};
judgement of_oscillator(oscillator const& on, rows const& x, S const& epsilon) {
    difference const D(on.alpha, x.scale().h(), x.steps() + 1);
    std::vector<vector> r;
    for (std::size_t n = 0; n < x.q.size(); ++n) r.push_back(vector::Constant(1, on.f) - on.c * D.at(x.q, n) - on.k * x.q[n]);
    return of_newmark(matrix::Constant(1, 1, S(1)), r, x, S(on.k + on.c * D.w[0]), epsilon);
}
/// sigma = E_inf (eps - eps_a), eps_a + tau^alpha D^alpha eps_a = (E_inf - E_o) / E_inf eps, at every point and from rest: a cantilever of
/// 150 mm in five elements under a force at its tip that grows to 10 mN for 50 ms. Rows have all deflections first, then all slopes.
judgement of_beam(rows const& x, S const& epsilon) {
    constexpr int elements = 5;
    S const relaxed = 1'000'000, unrelaxed = 50'000'000, width = S(25) / 1000, thickness = S(5) / 1000, density = 1000;
    auto const beam =
        beams::cantilever(S(S(15) / 100), S(relaxed * width * pow(thickness, 3) / 12), S(density * width * thickness), elements);
    Eigen::PermutationMatrix<Eigen::Dynamic> order(2 * elements);
    for (int k = 0; k < elements; ++k) order.indices()(2 * k) = k, order.indices()(2 * k + 1) = elements + k;
    matrix const M = order * beam.mass * order.transpose(), K = order * beam.stiffness * order.transpose();
    auto const load = [](S const& t) -> vector { return vector::Unit(2 * elements, elements - 1) * (std::min(S(t * 20), S(1)) / 100); };
    S const ratio = unrelaxed / relaxed, tau = sqrt(S(S(1) / 1000));
    difference const D(S(1) / 2, x.scale().h(), x.steps() + 1);
    std::vector<vector> anelastic{vector::Zero(x.q[0].size())}, r;
    for (std::size_t n = 0; n < x.q.size(); ++n) {
        if (n > 0) {
            anelastic.push_back(anelastic[0]);
            anelastic[n] = (x.q[n] * ((ratio - 1) / ratio) - tau * D.at(anelastic, n, 1)) / (1 + tau * D.w[0]);
        }
        r.push_back(load(x.t[n]) - K * (x.q[n] - anelastic[n]) * ratio);
    }
    return of_newmark(M, r, x, S(ratio * K.cwiseAbs().rowwise().sum().maxCoeff()), epsilon);
}
/// The two-sided equation, whose differences are of the size h^{-2 alpha}.
judgement of_dirichlet(rows const& x, S const& epsilon) {
    std::vector<S> q;
    for (vector const& y : x.q) q.push_back(y(0));
    auto const T = x.scale();
    judgement all;
    for (auto const& r : papers::dirichlet_equation(S(3) / 4, T).residual(function_on(T, q)))
        all.add(r, S(32 * epsilon * pow(T.h(), S(-1.5))));
    return all;
}
/// What files state, once more in C++.
constexpr auto pendulum = [](auto const& q, auto const& v) { return v(0) * v(0) / 2 + cos(q(0)); };
constexpr auto kepler = [](auto const& q, auto const& v) { return v.squaredNorm() / 2 + 1 / q.norm(); };
constexpr auto henon_heiles = [](auto const& q, auto const& v) {
    return v.squaredNorm() / 2 - q.squaredNorm() / 2 - q(0) * q(0) * q(1) + q(1) * q(1) * q(1) / 3;
};
/// Six bodies, of all of them x, then y, then z.
auto const outer_solar_system = [] {
    std::istringstream data(outer_solar_system_csv);
    std::vector<S> mass;
    for (std::string line, cell; std::getline(data, line);) {
        std::istringstream cells(line);
        if (line[0] == '#' or line.starts_with("body") or not std::getline(cells, cell, ',')) continue;
        std::getline(cells, cell, ',');
        mass.push_back(detail::number_from<S>(cell));
    }
    return [mass](auto const& q, auto const& v) {
        S const G = detail::number_from<S>("2.95912208286e-4");
        int const n = static_cast<int>(mass.size());
        auto L = v(0) * S(0);
        for (int i = 0; i < n; ++i) {
            S const m = mass[static_cast<std::size_t>(i)];
            L = L + m / 2 * (v(i) * v(i) + v(n + i) * v(n + i) + v(2 * n + i) * v(2 * n + i));
            for (int j = 0; j < i; ++j) {
                auto const x = q(i) - q(j), y = q(n + i) - q(n + j), z = q(2 * n + i) - q(2 * n + j);
                L = L + G * m * mass[static_cast<std::size_t>(j)] / sqrt(x * x + y * y + z * z);
            }
        }
        return L;
    };
};

constexpr auto double_pendulum = [](auto const& q, auto const& v) {
    return v(0) * v(0) + v(1) * v(1) / 2 + v(0) * v(1) * cos(q(0) - q(1)) + 2 * cos(q(0)) + cos(q(1));
};
constexpr auto charged_particle = [](auto const& q, auto const& v) {
    auto const r = q.norm();
    return v.squaredNorm() / 2 + r * (q(0) * v(1) - q(1) * v(0)) / 3 - 1 / (100 * r);
};

judgement judged(std::string const& scene, std::string const& file, S const& epsilon) {
    auto const as = [&](auto const& l, int d) { return of_midpoint(l, rows(file, d, d), epsilon); };
    if (scene == "pendulum") return as(pendulum, 1);
    if (scene == "double-pendulum") return as(double_pendulum, 2);
    if (scene == "kepler") return as(kepler, 2);
    if (scene == "henon-heiles") return as(henon_heiles, 2);
    if (scene == "charged-particle") return as(charged_particle, 2);
    if (scene == "fermi-pasta-ulam")
        return as(mechanical(S(1), chain([](index_type, auto const& r) { return r * r / 2 + r * r * r / 12; })), 32);
    if (scene == "fractional-oscillator") return of_oscillator({S(1) / 2, 1, 1, 1}, rows(file, 1, 1), epsilon);
    if (scene == "bagley-torvik") return of_oscillator({S(3) / 2, S(1) / 2, S(1) / 2, 8}, rows(file, 1, 1), epsilon);
    if (scene == "viscoelastic-beam") return of_beam(rows(file, 10, 0), epsilon);
    if (scene == "fractional-dirichlet") return of_dirichlet(rows(file, 1, 0), epsilon);
    if (scene == "outer-solar-system") return as(outer_solar_system(), 18);
    error::raise<error::invalid_parameter>("there is no equation for the scene '", scene, "'");
}

} // namespace

int main(int count, char** arguments) {
    try {
        if (count != 4) error::raise<error::invalid_parameter>("judge <scene> <rows> <epsilon>");
        judgement const v = judged(arguments[1], arguments[2], detail::number_from<S>(arguments[3]));
        std::cout << arguments[1] << ": the largest residual is " << v.residual.str(3) << ", and rounding may leave " << v.bound.str(3)
                  << '\n';
        return v.residual <= v.bound ? 0 : 1;
    } catch (std::exception const& e) {
        std::cerr << e.what() << '\n';
        return 2;
    }
}
