// SPDX-License-Identifier: BSL-1.0
// Operators as text: in the words of the papers, and read back what they do to a function.
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"
#include "read_back.hpp"

namespace printed_operators_tests {

using namespace hilger;
using reading::printed;

namespace {

time_scale<Q> const T{Q(0), Q(1, 3), Q(1), Q(7, 5), Q(2), Q(9, 4), Q(3), Q(10, 3)};

/// What is printed, and in LaTeX, does the same to a random function on T.
template <class A>
void read_operator(A const& a) {
    auto const q = reading::random_function(T);
    auto r = reading::reader_on(T);
    r.names["f"] = r.names["q"];
    auto const made = a[q];
    auto const text = printed(a);
    CAPTURE(text);
    std::string rest = text + ",   ";
    std::string const formula = reading::cut(rest, ",   ");
    auto const read = r.read(formula);
    for (index_type i = made.first(); i <= made.last(); ++i) {
        REQUIRE(read.at.count(static_cast<int>(i)) == 1);
        CHECK(read.at.at(static_cast<int>(i)) == made[i]);
    }
    rest = reading::as_terminal(latex(a)) + ", \\quad ";
    CHECK(reading::cut(rest, ", \\quad ") == formula);
}

} // namespace

TEST_CASE("operators are written as the papers write them") {
    CHECK(printed(identity_T) == "f");
    CHECK(printed(Delta_plus) == "Δ₊[f]");
    CHECK(printed(Delta_plus * sigma) == "Δ₊[σ[f]]");
    CHECK(printed(Delta_minus[Delta_plus]) == "Δ₋[Δ₊[f]]");
    CHECK(printed(adjoint(Delta_plus)) == "−Δ₋[f]");
    CHECK(printed(rho * Delta_plus) == "Δ₋[f]"); // they are one operator
    CHECK(printed(sigma * rho) == "σ[ρ[f]]");    // the identity has more points
    CHECK(printed(mean_h_minus) == "[f]½,₋");
    CHECK(printed(mean_o) == "[f]∘");
    CHECK(printed(on_half * extend) == "f∘|T½");
    CHECK(printed(pi_inverse * Delta_plus) == "Δ∘,₊[f∘]|T½");
    CHECK(printed(fraction<-3, 2>{} * Delta_minus + sigma) == "−3/2 Δ₋[f] + σ[f]");
    CHECK(printed(2.5 * Delta_plus - 0.1 * rho) == "2.5 Δ₊[f] − 0.1 ρ[f]");
    CHECK(printed(Delta_plus * (-0.1 * sigma)) == "−0.1 Δ₊[σ[f]]");
    CHECK(printed(uniformly(adjoint(on_half * (0.9 * extend)))) == "0.9 π[[f]½,₋]");
    CHECK(printed(Delta_plus / 2.5 - rho / -4) == "0.4 Δ₊[f] + 1/4 ρ[f]");
    CHECK(printed(Delta_minus_alpha<1, 2> / -4) == "−1/4 Δ₋^(1/2)[f]"); // no field has its weights
    CHECK(printed((identity_T + sigma) / 2) == "1/2 f + 1/2 σ[f]");
    CHECK(printed(Delta_minus_alpha<1, 2>) == "Δ₋^(1/2)[f]");
    CHECK(printed(adjoint(Delta_minus_alpha<1, 2>)) == "Δ₊^(1/2)[f]");
    CHECK(printed(caputo_minus_alpha<1, 2>) == "Δ₋^(1/2)[f − f(a)]");
    CHECK(printed(Delta_minus(0.75) * sigma) == "Δ₋^(0.75)[σ[f]]");
    CHECK(printed(minus_alpha<bdf<2>, 1, 2>) == "BDF2₋^(1/2)[f]");
    CHECK(printed(antiderivative_h) == "∫ₐᵗ(f)Δ½");
    CHECK(printed(uniformly(adjoint(on_half * extend))) == "π[[f]½,₋]");
    CHECK(printed(adjoint(on_half * extend)) == "π[[f]μ],   [f]μ = (μ f + ν ρ½[f])/(μ + ν)");
    CHECK(latex(Delta_minus_alpha<1, 2> * sigma) == "\\Delta_{-}^{1/2}\\left[\\sigma\\left[f\\right]\\right]");
    CHECK(latex(fraction<1, 2>{} * Delta_h_minus) == "\\tfrac{1}{2}\\,\\Delta_{\\frac{1}{2},-}\\left[f\\right]");
    CHECK(latex(extend) == "f_{\\circ}");
}

TEST_CASE("whole factors of any size keep their digits") {
    constexpr auto most = std::numeric_limits<unsigned long long>::max();
    CHECK(printed(most * Delta_plus) == "18446744073709551615 Δ₊[f]");
    CHECK(printed(Delta_plus / most) == "1/18446744073709551615 Δ₊[f]");
    CHECK(printed(4'000'000'000'000LL * (5'000'000'000LL * Delta_plus)) == "5000000000 4000000000000 Δ₊[f]");
    CHECK(printed(Delta_plus / std::numeric_limits<long long>::min()) == "1/-9223372036854775808 Δ₊[f]");
    CHECK_FALSE(most * Delta_plus == -1 * Delta_plus);
    CHECK_FALSE(most * Delta_plus == 7 * Delta_plus);
    CHECK_FALSE((1LL << 30) * ((1LL << 31) * Delta_plus) == Delta_plus); // which they are modulo 2^61 - 1
}

TEST_CASE("read back") {
    read_operator(Delta_plus * sigma - fraction<2, 3>{} * rho);
    read_operator(adjoint(Delta_plus * Delta_plus));
    read_operator(Delta_minus * Delta_plus * sigma);
    read_operator(reweight<nodes, nabla_weight, mean_weight<fraction<1, 3>>>{});
    read_operator(extend);
    read_operator(rho_o * extend + Delta_o_minus * extend);
    read_operator(mean_o * extend * sigma);
    read_operator(adjoint(on_half * extend) * pi_inverse * sigma);
    read_operator(adjoint(extend) * extend);
    read_operator(mean_h_plus * on_half * extend + pi_inverse);
    read_operator(Delta_h_minus * on_half * extend);
    read_operator(minus_start + Delta_plus);
}

} // namespace printed_operators_tests
