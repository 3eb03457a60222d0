// SPDX-License-Identifier: BSL-1.0
// Printed fractional equations, read back: of one action, and of the restricted principle with its two curves.
#include "hilger/scale/uniform.hpp"
#include "read_back.hpp"

namespace printed_fractional_tests {

using namespace hilger;
using namespace reading;

namespace {

constexpr unknown q;
constexpr unknown<"y"> y;
auto const T = uniform(Q(0), Q(1), 7); // so that powers of h are rational

/// Both lines of the restricted equations.
template <class Action>
void read_back_restricted(Action const& S) {
    auto const EL = variation(S);
    std::string text = printed(EL);
    CAPTURE(text);
    auto const at = random_function(T);
    auto const rx = EL.residual(at);
    auto const ry = EL.reversed_residual(at);
    reader r = reader_on(T);
    r.integral = family_of(S.conservative.position.image(domain<nodes>{}).base);
    r.names["y"] = r.names["q"];
    std::string rest = text;
    std::string const left = cut(rest, " = "), damping = cut(rest, "   on "), where = cut(rest, ",   ⋆ = (");
    auto const [a, b] = arguments(rest);
    (void)cut(rest, "\nthe same of y = ");
    std::string const reversed = cut(rest, ",   ρ = ");
    take_arguments(r, a, b);
    r.constants["ρ"] = Q(rest.substr(0, rest.size() - 1)); // a rational number, and the end of the line
    auto const numbers = numbers_of(where, r);
    auto const check = [&](std::string const& right, auto const& residual) {
        table const x = r.read(left), d = r.read(right);
        REQUIRE(x.on == d.on);
        table difference{x.on, {}};
        for (auto const& [i, value] : x.at)
            if (d.at.count(i) > 0) difference.at[i] = value - d.at.at(i);
        CHECK(same_as_residual(difference, numbers, residual, 1));
    };
    check(damping, rx);
    check(reversed, ry);
    std::string const formula = as_terminal(latex(EL));
    CAPTURE(formula);
    CHECK(formula.find(left + " &= " + damping) != std::string::npos);
    CHECK(formula.find("y &= " + reversed) != std::string::npos);
}

} // namespace

TEST_CASE("velocities and positions that are fractional differences") {
    read_back(nabla_integral(L(q, fraction<3, 2>{} * Delta_minus_alpha<1, 3>[q]), T));
    read_back(nabla_integral(L(Delta_minus_alpha<1, 2>[q], q), T));
    read_back(nabla_integral(L(q, caputo_minus_alpha<1, 2>[q]), T));
    read_back(nabla_integral(L(q, Delta_minus_alpha<2, 5>[q] - fraction<1, 4>{} * Delta_minus[q]), T));
    read_back(nabla_integral(L(q, Delta_minus(Q(1, 3))[q]), T));
}

TEST_CASE("orders that add up to a whole one") {
    auto const U = uniform(Q(1), Q(2, 3), 7);
    read_back(nabla_integral(L(q, Delta_minus_alpha<1, 2>[Delta_minus_alpha<1, 2>[q]]), U));
    read_back(nabla_integral(L(q, minus_alpha<bdf<2>, 1, 1>[q]), U));
}

TEST_CASE("the restricted principle") {
    constexpr auto q_o = extend[q];
    auto const damping = Delta_minus_alpha<1, 4>[q] * Delta_plus_alpha<1, 4>[y];
    read_back_restricted(integral(L(q_o, Delta_o_plus[q_o]), half(T)) - Q(3, 7) * integral(damping, T));
    read_back_restricted(integral(L(sigma[q], Delta_plus[q]), T) - Q(3, 7) * integral(damping, T));
    read_back_restricted(integral(L(fraction<2>{} * q_o, Delta_o_plus[q_o]), half(T)) -
                         Q(-1, 2) * integral(Delta_minus_alpha<1, 3>[q] * Delta_plus_alpha<1, 6>[y], T));
}

} // namespace printed_fractional_tests
