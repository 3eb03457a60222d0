// SPDX-License-Identifier: BSL-1.0
#include "prove.hpp"

#include <iomanip>
#include <ostream>

#include "hilger/embedding/embedding.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "identities/by_parts.hpp"
#include "identities/calculus.hpp"

namespace program {

namespace {

using hilger::Q;

// Proved by the compiler.
static_assert(hilger::mid_point.velocity == hilger::on_half * hilger::Delta_o_plus * hilger::extend);
static_assert(adjoint(hilger::Delta_plus) == -hilger::Delta_minus);
static_assert(hilger::uniformly(adjoint(hilger::on_half * hilger::extend)) == hilger::pi_half * hilger::mean_h_minus);

template <class Identity>
bool prove(std::ostream& out, Identity const& identity, char const* name) {
    constexpr std::uint64_t seed = 1988;
    hilger::random_fractions source(seed);
    long cases = 0, comparisons = 0;
    bool holds = true;
    std::string failure;
    auto const on = [&](auto const& T) {
        auto const v = hilger::check(identity, T, Q(0), source);
        ++cases;
        comparisons += v.comparisons;
        if (holds and not v.holds) failure = v.first_failure;
        holds = holds and v.holds;
    };
    for (hilger::index_type N = 1; N <= 12; ++N) {
        on(hilger::uniform(Q(-1, 3), Q(2, 7), N));
        if constexpr (not Identity::uniform_only) {
            on(hilger::harmonic_numbers<Q>(N));
            on(hilger::powers(Q(3, 2), 0, N));
        }
    }
    out << "  " << std::left << std::setw(42) << name << std::setw(34) << identity.source << std::right << std::setw(4) << cases
        << " cases, " << std::setw(6) << comparisons << (holds ? " equalities, all exact\n" : " equalities, FAILED\n");
    if (not holds) out << "    " << failure << '\n';
    return holds;
}

} // namespace

bool prove_identities(std::ostream& out) {
    namespace id = hilger::identities;
    using hilger::fraction, hilger::nodes;
    auto const by_parts_of = []<class A>(A const& a) { return id::by_parts_of<A>{a}; };
    bool all = true;
    auto const named = [&](char const* name, auto const& identity) { all = prove(out, identity, name) and all; };
    auto const one = [&](auto const& identity) { named(identity.name, identity); };
    one(id::fundamental_theorem<nodes>{});
    one(id::by_parts_order_one<nodes>{});
    one(id::lemma_1<fraction<1, 2>>{});
    one(id::lemma_2{});
    one(id::lemma_3{});
    one(id::lemma_4{});
    named("by parts, velocity of the mid-point", by_parts_of(hilger::mid_point.velocity));
    named("by parts, position of the mid-point", by_parts_of(hilger::mid_point.position));
    return all;
}

} // namespace program
