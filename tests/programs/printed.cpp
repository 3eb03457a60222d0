// SPDX-License-Identifier: BSL-1.0
// The printed equation evaluated on the result: a program is run in double, the text of its equation is read, and what the text says of
// the positions, as the rational numbers that they are, is as small as rounding leaves it, and what the residual is.
#include "hilger/variational/print.hpp"
#include "programs.hpp"
#include "runtime/printing/read_back.hpp"

namespace printed_tests {

using namespace hilger;
using namespace hilger::programs;

namespace {

/// The left-hand side of the printed equation at positions along a path, by its points: a list of components. A force stands beside dL/dq,
/// as in the principle of Lagrange and d'Alembert; the text says the same of each component.
template <class Path>
std::map<int, std::vector<Q>> as_printed(Path const& path) {
    using s = detail::shape<std::remove_cvref_t<decltype((*path.begin()).q)>>;
    using V = typename s::template with<Q>;
    using exact = detail::shape<V>;
    constexpr std::size_t d = s::size;
    auto const T = path.scale();
    auto const EL = equation_of(path.method(), T);
    auto const& [L, force] = path.method().mechanics();
    std::array<reading::reader, d> readers;
    for (std::size_t k = 0; k < d; ++k) {
        for (double const t : T) readers[k].t.emplace_back(t);
        reading::table q{{}, {}};
        for (auto const& x : path) q.at[static_cast<int>(q.at.size())] = Q(s::component(x.q, static_cast<int>(k)));
        readers[k].names["q"] = q;
        readers[k].integral = reading::family_of(path.method().embedding().position.image(domain<nodes>{}).base);
    }

    std::string rest = reading::printed(EL);
    CAPTURE(rest);
    std::string const left = reading::cut(rest, " = 0   on "), where = reading::cut(rest, ",   ⋆ = (");
    auto const [a, b] = reading::arguments(rest);
    std::array<reading::table, d> positions, velocities;
    for (std::size_t k = 0; k < d; ++k) {
        auto& r = readers[k];
        positions[k] = r.restricted(r.read(a), r.integral);
        velocities[k] = r.restricted(r.read(b), r.integral);
        r.names["∂L/∂q(⋆)"] = r.names["∂L/∂v(⋆)"] = {r.integral, {}};
    }
    for (auto const& [i, first] : positions[0].at) {
        if (velocities[0].at.count(i) == 0) continue;
        V x = exact::zero(d), v = x;
        for (std::size_t k = 0; k < d; ++k) {
            exact::component(x, static_cast<int>(k)) = positions[k].at.at(i);
            exact::component(v, static_cast<int>(k)) = velocities[k].at.at(i);
        }
        V f = gradient_first(L, x, v);
        V const p = gradient_second(L, x, v);
        if constexpr (not std::same_as<std::remove_cvref_t<decltype(force)>, no_force>) f = f + V(force(x, v));
        for (std::size_t k = 0; k < d; ++k) {
            readers[k].names["∂L/∂q(⋆)"].at[i] = exact::component(f, static_cast<int>(k));
            readers[k].names["∂L/∂v(⋆)"].at[i] = exact::component(p, static_cast<int>(k));
        }
    }
    auto const [first, last] = reading::numbers_of(where, readers[0]);
    std::map<int, std::vector<Q>> result;
    for (auto& r : readers) {
        auto const residual = r.read(left);
        for (int i = first; i <= last; ++i) result[i].push_back(residual.at.at(i));
    }
    return result;
}
template <class Path>
void says_what_it_did(Path const& path) {
    double worst = 0;
    auto const values = as_printed(path);
    for (auto const& [i, all] : values)
        for (Q const& x : all) worst = std::max(worst, std::abs(static_cast<double>(x)));
    CAPTURE(worst);
    CHECK(static_cast<index_type>(values.size()) == static_cast<index_type>(path.scale().size()) - 2);
    CHECK(worst <= rounding_along(path, 2));
    CHECK(std::abs(worst - largest_residual(path)) <= rounding_along(path, 2));
}
template <class How, class Scale>
void says_what_it_does(How const& how, Scale const& T) {
    says_what_it_did(embed(reading::L, how).along(T, 1.0, 0.5));
}

/// Neither separable nor quadratic, as cubic is; and a drag.
struct cubic_in_the_plane {
    template <class X, class V>
    auto operator()(X const& x, V const& v) const {
        return v.dot(v) / 2 + v(0) * x(1) / 3 - x(0) * x(0) * x(1) / 5 - x.dot(x) / 2 + v(1) * v(1) * x(0) / 7;
    }
};
struct drag_in_the_plane {
    template <class X, class V>
    auto operator()(X const& x, V const& v) const {
        return x / 20 - v / 5; // an expression
    }
};
struct drag_of_a_number {
    template <class X, class V>
    auto operator()(X const& x, V const& v) const {
        return -v / 5 + x * v / 10;
    }
};

auto const T = uniform(0.0, 0.0625, 24);
time_scale<double> const uneven{0, 0.0625, 0.125, 0.25, 0.28125, 0.375, 0.5, 0.5625, 0.625, 0.75, 0.875, 1.0};
constexpr auto ends = make_embedding<step_weight>(pi_inverse, pi_inverse* Delta_plus, "from the start, over T_half");

} // namespace

TEST_CASE("mid-point") {
    says_what_it_does(mid_point, T);
    says_what_it_does(mid_point, uneven);
}
TEST_CASE("order one") {
    says_what_it_does(order_one, T);
    says_what_it_does(order_one_left, uneven);
}
TEST_CASE("theta") {
    says_what_it_does(theta<1, 4>, T);
    says_what_it_does(theta<1, 4>, uneven);
}
TEST_CASE("an embedding of one's own") { says_what_it_does(ends, T); }
TEST_CASE("vectors, and forces that return expressions") {
    Eigen::Vector2d const q(1.0, 0.5), p(0.0, 0.25);
    says_what_it_did(embed(cubic_in_the_plane{}, mid_point).along(T, q, p));
    says_what_it_did(embed(with_force(cubic_in_the_plane{}, drag_in_the_plane{}), mid_point).along(uneven, q, p));
    says_what_it_did(embed(with_force(cubic_in_the_plane{}, drag_in_the_plane{}), order_one).along(T, q, p));
    says_what_it_did(embed(with_force(reading::L, drag_of_a_number{}), theta<1, 4>).along(T, 1.0, 0.5));
}

} // namespace printed_tests
