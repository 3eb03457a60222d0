// SPDX-License-Identifier: BSL-1.0
// The printed equation evaluated on the result: a program is run in double, the text of its equation is read, and what the text says of
// the positions, as the rational numbers that they are, is as small as rounding leaves it, and what the residual is.
#include "hilger/mechanics/print.hpp"
#include "programs.hpp"
#include "runtime/read_back.hpp"

using namespace hilger;
using namespace hilger::testing;

namespace {

/// The left-hand side of the printed equation at positions along a path, by its points.
template <class Path>
std::map<int, Q> as_printed(Path const& path) {
    auto const T = path.scale();
    auto const EL = equation_of(path.method(), T);
    reading::reader r;
    for (double const t : T) r.t.emplace_back(t);
    reading::table q{{}, {}};
    for (auto const& x : path) q.at[static_cast<int>(q.at.size())] = Q(x.q);
    r.names["q"] = q;
    r.integral = reading::family_of(path.method().embedding().position.image(domain<nodes>{}).base);

    std::string rest = reading::printed(EL);
    CAPTURE(rest);
    std::string const left = reading::cut(rest, " = 0   on "), where = reading::cut(rest, ",   ⋆ = (");
    auto const [a, b] = reading::arguments(rest);
    reading::take_arguments(r, a, b);
    auto const residual = r.read(left);
    auto const [first, last] = reading::numbers_of(where, r);
    std::map<int, Q> result;
    for (int i = first; i <= last; ++i) result[i] = residual.at.at(i);
    return result;
}
template <class How, class Scale>
void says_what_it_does(How const& how, Scale const& T) {
    auto const path = embed(reading::L, how).along(T, 1.0, 0.5);
    double worst = 0;
    auto const values = as_printed(path);
    for (auto const& [i, x] : values) worst = std::max(worst, std::abs(static_cast<double>(x)));
    CAPTURE(worst);
    CHECK(static_cast<index_type>(values.size()) == static_cast<index_type>(T.size()) - 2);
    CHECK(worst <= rounding_along(path, 2));
    CHECK(std::abs(worst - largest_residual(path)) <= rounding_along(path, 2));
}

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
