// SPDX-License-Identifier: BSL-1.0
// Printed equations of actions over T that are not the library's: what is printed is what runs.
#include "hilger/scale/uniform.hpp"
#include "read_back.hpp"

namespace printed_on_T_tests {

using namespace hilger;
using reading::L;
using reading::read_back;

namespace {

constexpr unknown q;
constexpr fraction<1, 2> half_of{};
constexpr fraction<3, 2> three_halves{};

auto const T = uniform(Q(1, 3), Q(2, 5), 9);

} // namespace

TEST_CASE("shifts, swapped and scaled operators") {
    read_back(integral(L(sigma[q], Delta_plus[q]), T));
    read_back(integral(L(Delta_plus[q], q), T));
    read_back(integral(L(q, fraction<2>{} * Delta_plus[q]), T));
    read_back(integral(L(three_halves * q, Delta_plus[q]), T));
    read_back(integral(L(sigma[q], fraction<-1>{} * Delta_plus[q]), T));
    read_back(integral(L(q, Delta_plus[sigma[q]]), T));
}

TEST_CASE("sums") {
    read_back(integral(L(half_of * (q + sigma[q]), Delta_plus[q]), T));
    read_back(integral(L(q, fraction<2>{} * Delta_plus[q] - Delta_minus[q]), T));
    read_back(integral(L(sigma[sigma[q]] - q, Delta_plus[Delta_plus[q]]), T));
    read_back(integral(L(q - fraction<1, 3>{} * sigma[q], Delta_plus[q] + fraction<5, 7>{} * q), T));
}

} // namespace printed_on_T_tests
