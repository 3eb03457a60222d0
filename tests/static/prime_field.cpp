// SPDX-License-Identifier: BSL-1.0
// The field behind the equality of operators is a field: a wrong carry in it would make wrong theorems.
#include "hilger/adjoint/normal_form.hpp"

using namespace hilger;

namespace {

using F = prime_field;
constexpr std::uint64_t p = F::prime;
static_assert(p == 1'425'089'352'415'399'919ULL and scalar<F> and not ordered_scalar<F>);
constexpr auto number = [](std::uint64_t n) { return F::residue(n); };

// residues, from both sides of zero and from beyond the prime
static_assert(F(0) == F() and F(-1) == number(p - 1) and F(-1) + F(1) == F(0) and F(7) - F(9) == F(-2) and -F(0) == F(0) and
              -F(5) == F(-5));
static_assert(number(p) == F(0) and number(p + 5) == F(5) and number(2 * p) == F(0) and number(~std::uint64_t(0)) == F(~std::uint64_t(0)));
static_assert(F(static_cast<long long>(p)) == F(0) and F(-static_cast<long long>(p)) == F(0) and
              F(-static_cast<long long>(p) - 3) == F(-3));
static_assert(number(p - 1) + number(p - 1) == F(-2) and number(p - 1) - F(0) == F(-1) and F(0) - number(p - 1) == F(1));

// products, where every partial product carries: against doubling and adding, which cannot
constexpr F slow_product(F a, std::uint64_t b) {
    F sum(0);
    for (; b != 0; b >>= 1, a = a + a)
        if (b & 1) sum = sum + a;
    return sum;
}
static_assert(number(p - 1) * number(p - 1) == F(1) and number(p - 1) * number(p - 2) == F(2) and F(0) * number(p - 1) == F(0));
static_assert(number(1ULL << 60) * F(2) == number((1ULL << 61) - p) and
              number(1ULL << 60) * number(1ULL << 60) == slow_product(number(1ULL << 60), 1ULL << 60));
static_assert(number(0x1555555555555555ULL) * number(0x0aaaaaaaaaaaaaaaULL) ==
              slow_product(number(0x1555555555555555ULL), 0x0aaaaaaaaaaaaaaaULL));

constexpr bool products_agree() {
    std::uint64_t a = 1, b = p - 2;
    for (int k = 0; k < 60; ++k) {
        a = (a * 6364136223846793005ULL + 1442695040888963407ULL) % p;
        b = (b * 2862933555777941757ULL + 3037000493ULL) % p;
        if (number(a) * number(b) != slow_product(number(a), b)) return false;
    }
    return true;
}
static_assert(products_agree());

// quotients
static_assert(F(1) / F(1) == F(1) and F(1) / F(-1) == F(-1) and F(6) / F(3) == F(2) and F(1) / F(2) == number((p + 1) / 2));
constexpr bool is_a_field() {
    for (int i = 0; i < 20; ++i) {
        F const a = detail::random_element(static_cast<std::uint64_t>(i)), b = detail::random_element(static_cast<std::uint64_t>(i) + 77);
        F const c = detail::random_element(static_cast<std::uint64_t>(i) + 1000);
        bool const ring =
            a * (b + c) == a * b + a * c and a * b == b * a and (a * b) * c == a * (b * c) and a - b == -(b - a) and a + (b - a) == b;
        bool const field = (a / b) * b == a and (a / b) * (b / a) == F(1) and a != F(0) and a / b + c / b == (a + c) / b;
        if (not ring or not field) return false;
    }
    return true;
}
static_assert(is_a_field());

// The random elements the normal forms are made of are different from each other: steps, values, and steps from values.
constexpr bool all_different() {
    F seen[64];
    for (index_type i = 0; i < 32; ++i) {
        seen[2 * i] = detail::generic_scale<false, 40>::step(i);
        seen[2 * i + 1] = detail::generic_function<false, 40, nodes>::get(i);
    }
    for (int i = 0; i < 64; ++i)
        for (int j = 0; j < i; ++j)
            if (seen[i] == seen[j] or seen[i] == F(0)) return false;
    return true;
}
static_assert(all_different());
static_assert(detail::generic_scale<true, 9>::step(0) == detail::generic_scale<true, 9>::step(7));

} // namespace
