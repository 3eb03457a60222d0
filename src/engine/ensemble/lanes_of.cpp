// SPDX-License-Identifier: BSL-1.0
#include "engine/ensemble/lanes_of.hpp"

#include <algorithm>
#include <string_view>

#include "engine/ensemble/lane_language.hpp"
#include "engine/ensemble/lane_part.hpp"
#include "hilger/text/c_code.hpp"

namespace engine {

namespace {

using node_list = std::vector<hilger::detail::formula_node>;

/// The guess of a velocity is the polynomial through those of up to so many earlier equal steps, or through two of unequal ones. At an end
/// of the step it is the last velocity, as in hilger/step/small/one_node.hpp: a polynomial may lie near another root.
constexpr int guesses = 7;

bool is_everywhere_smooth(hilger::detail::node_formulas const& what) {
    constexpr std::string_view others[] = {"log",   "slope_of_log", "log1p", "asin", "acos", "acosh",     "atanh",
                                           "atan2", "max",          "min",   "abs",  "sign", "elsewhere", "where"};
    node_list all{what.L};
    for (auto const* list : {&what.g, &what.p, &what.gq, &what.gv, &what.pq, &what.pv}) all.insert(all.end(), list->begin(), list->end());
    auto const& g = what.in->graph;
    auto const nodes = hilger::detail::nodes_below(g, all);
    return std::none_of(nodes.begin(), nodes.end(), [&](int k) {
        return g[k].what != nullptr and std::find(std::begin(others), std::end(others), g[k].what->name) != std::end(others);
    });
}

// The numbers of a state in their order; m comes last. Velocities are stored twice, so that the last ones are contiguous.
constexpr char const* state_in = R"(    lanes q[$n], p[$n], v[parts][2][guesses][$n], m[brought + 1];
    (void)v;
    memcpy(q, x, sizeof q);
    memcpy(p, x + width * $n, sizeof p);
    for (int part = 0; part < parts; ++part)
        for (int copy = 0; copy < 2; ++copy) memcpy(v[part][copy], x + width * $n * (2 + part * guesses), sizeof v[part][copy]);
    memcpy(m, x + width * (2 + parts * guesses) * $n, sizeof(lanes) * brought);
)";
constexpr char const* beginning = R"(
void begin(double time, double *x, long long *lost_lanes)
{
$state    const lanes t = all(time), *y = v[0][0][0];
    (void)t;
    (void)y;
$momenta    memcpy(x + width * $n, p, sizeof p);
    lanes K[$n][$n];
$masses    for (int lane = 0; lane < width; ++lane) {
        double mass[$n][$n], nothing[$n] = {0.0};
        for (int j = 0; j < $n; ++j)
            for (int k = 0; k < $n; ++k) mass[j][k] = lane_of(K[j][k], lane);
        lost_lanes[lane] = mass_solve(mass, nothing) ? 0 : -1;
    }
}
)";
constexpr char const* walking = R"(
void walk(long begin, long n, const double *times, double step, double *x, long long *lost_lanes, double *kept_q, double *kept_p)
{
    (void)kept_q;
    (void)kept_p;
$state    const long most = step > 0.0 ? guesses : 2;
    long now = begin % guesses;
    mask lost;
    memcpy(&lost, lost_lanes, sizeof lost);
    for (long i = begin; i < begin + n && !are_all(lost); ++i) {
        const double h = step > 0.0 ? step : times[i + 1 - begin] - times[i - begin];
        const double *of = through[i + 1 < most ? i : most - 1];
        double t = times[i - begin];
        (void)of;
$parts$keeping        now = now + 1 == guesses ? 0 : now + 1;
    }
    memcpy(x, q, sizeof q);
    memcpy(x + width * $n, p, sizeof p);
    for (int part = 0; part < parts; ++part) memcpy(x + width * $n * (2 + part * guesses), v[part][0], sizeof v[part][0]);
    memcpy(lost_lanes, &lost, sizeof lost);
}
)";
constexpr char const* one_part = R"(        {
            const double share = $share * h;
            lanes y[$n] = {{0}}, (*newest)[$n] = v[$part][0] + now + guesses - 1;
            (void)newest;
$guess            part_$kind(all(t), all(share), m, q, p, y, &lost$before);
$remember            t += share;
        }
)";
constexpr char const* keeping = R"(        if (kept_q) {
            for (int k = 0; k < $n; ++k) kept_q[k] = q[k], kept_p[k] = p[k];
            kept_q += $n;
            kept_p += $n;
        }
)";
// From the newest velocity back. Most steps are equal, and for them the number of terms is a constant.
constexpr char const* guess = R"(            if (most == guesses)
                for (int j = 0; j < guesses; ++j)
                    for (int k = 0; k < $n; ++k) y[k] += of[j] * newest[-j][k];
            else
                for (int j = 0; j < 2; ++j)
                    for (int k = 0; k < $n; ++k) y[k] += of[j] * newest[-j][k];
)";
constexpr char const* last = R"(            memcpy(y, newest[0], sizeof y);
)";
constexpr char const* remember = R"(            memcpy(v[$part][0][now], y, sizeof y);
            memcpy(v[$part][1][now], y, sizeof y);
)";

/// The coefficients of the extrapolating polynomials.
std::string polynomials() {
    std::string text = "static const double through[guesses][guesses] = {";
    for (int k = 1; k <= guesses; ++k) {
        text += k == 1 ? "{" : ", {";
        for (int j = 0; j < k; ++j) text += (j == 0 ? "" : ", ") + std::to_string(hilger::detail::extrapolation(k, j));
        text += "}";
    }
    return text + "};\n";
}

} // namespace

std::size_t size_in_lanes(int dimension, one_node_parts const& of) {
    return static_cast<std::size_t>(dimension) * (2 + guesses * of.parts.size());
}

std::string lanes_of(hilger::detail::node_formulas const& what, one_node_parts const& of, int brought, int width) {
    bool const one = width == 0;
    if (not is_everywhere_smooth(what)) return {};
    auto& in = *what.in;
    int const N = in.dimension;
    std::string const n = std::to_string(N);
    std::string text = language_of(width);
    struct solved {
        bool is_linear, is_inside;
    };
    std::vector<solved> kinds;
    for (std::size_t k = 0; k < of.kinds.size(); ++k) {
        lane_part part(what, of.kinds[k], "part_" + std::to_string(k), one);
        text += '\n' + part.text(of.parts.size() <= 2);
        kinds.push_back({part.is_linear(), part.is_inside()});
    }
    text += "\nenum { parts = " + std::to_string(of.parts.size()) + ", guesses = " + std::to_string(guesses) +
            ", brought = " + std::to_string(brought) + " };\n" + polynomials();
    for (int k = 0; k < N; ++k) in.names[static_cast<std::size_t>(k)] = {element("q", k)};
    in.names[2 * static_cast<std::size_t>(N)] = {"t"};
    hilger::detail::c_statements momenta(in, "    ", "u", "lanes"), masses(in, "    ", "of_mass", "lanes");
    for (int k = 0; k < N; ++k) momenta.add(element("p", k) + " =", what.p[static_cast<std::size_t>(k)]);
    for (int j = 0; j < N; ++j)
        for (int k = 0; k < N; ++k) masses.add(element("K", j, k) + " =", what.pv[static_cast<std::size_t>(j * N + k)]);
    text += '\n' + hilger::detail::c_solve("mass", N) +
            filled(beginning, {{"$state", state_in}, {"$momenta", momenta.text()}, {"$masses", masses.text()}, {"$n", n}});
    std::string parts;
    for (std::size_t k = 0; k < of.parts.size(); ++k) {
        auto const [is_linear, is_inside] = kinds[of.parts[k].kind];
        parts += filled(one_part, {{"$guess", is_linear   ? ""
                                              : is_inside ? guess
                                                          : last},
                                   {"$remember", is_linear ? "" : remember},
                                   {"$before", is_linear ? "" : ", newest, step > 0.0 ? i + 1 : 0"},
                                   {"$share", c_number(of.parts[k].share)},
                                   {"$part", std::to_string(k)},
                                   {"$kind", std::to_string(of.parts[k].kind)}});
    }
    return text + filled(walking, {{"$state", state_in}, {"$parts", parts}, {"$keeping", one ? keeping : ""}, {"$n", n}});
}

} // namespace engine
