// SPDX-License-Identifier: BSL-1.0
// Drives the product identity x scale x N for one kind of values: random data by RapidCheck, so that a failure shrinks, and a table
// of what was proved.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include <boost/hana/for_each.hpp>
#include <boost/hana/front.hpp>
#include <boost/hana/tuple.hpp>

#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"
#include "identities/registry.hpp"

namespace laws {

using hilger::index_type;

/// The numbers RapidCheck drew, handed out one after the other and then again.
class drawn {
public:
    explicit drawn(std::vector<std::pair<int, int>> numbers) : numbers_(std::move(numbers)) {}
    std::pair<int, int> operator()() {
        auto const [p, q] = numbers_[next_++ % numbers_.size()];
        return {p + static_cast<int>(next_ / numbers_.size()), q}; // not periodic
    }
    /// A positive step.
    template <class S>
    S step() {
        auto const [p, q] = (*this)();
        return S(1 + (p < 0 ? -p : p)) / S(4 * q);
    }

private:
    std::vector<std::pair<int, int>> numbers_;
    std::size_t next_ = 0;
};

/// One identity in one setting; run by RapidCheck `times` times, reported under name and source.
using experiment = std::function<hilger::verdict(drawn&)>;
void prove(std::string const& name, std::string const& source, std::string const& setting, bool exact, int times, experiment const& run);

/// Prints the table of what prove() proved since the last call and checks that it was something.
void report(char const* values);

// The scales. Each makes one with N steps from random numbers.
template <class S>
struct uniform_steps {
    static constexpr char const* name = "a + ih";
    auto operator()(index_type N, drawn& d) const { return hilger::uniform(S(d.step<S>() - S(3)), d.step<S>(), N); }
};
template <class S>
struct divided_interval {
    static constexpr char const* name = "[a, b] in N";
    auto operator()(index_type N, drawn& d) const {
        S const a = -d.step<S>();
        return hilger::uniform(hilger::interval<S>{a, a + d.step<S>()}, N);
    }
};
template <class S>
struct random_points {
    static constexpr char const* name = "random points";
    auto operator()(index_type N, drawn& d) const {
        std::vector<S> points{S(-d.step<S>())};
        for (index_type i = 0; i < N; ++i) points.push_back(points.back() + d.step<S>());
        return hilger::time_scale<S>(std::move(points));
    }
};
template <class S>
struct quantum {
    static constexpr char const* name = "q^Z";
    auto operator()(index_type N, drawn& d) const { return hilger::powers(S(S(1) + d.step<S>() / S(8)), index_type(-1), N - 1); }
};
template <class S>
struct harmonic {
    static constexpr char const* name = "harmonic numbers";
    auto operator()(index_type N, drawn&) const { return hilger::harmonic_numbers<S>(N); }
};
/// Two fine steps after every coarse one.
template <class S>
struct fine_and_coarse {
    static constexpr char const* name = "fine and coarse";
    auto operator()(index_type N, drawn& d) const {
        S const h = d.step<S>();
        std::vector<S> points{S(0)};
        for (index_type i = 0; i < N; ++i) points.push_back(points.back() + (i % 3 == 0 ? h : S(h / S(100))));
        return hilger::time_scale<S>(std::move(points));
    }
};
/// T_o of random points as a T of its own.
template <class S>
struct own_circ {
    static constexpr char const* name = "T_o as a T";
    auto operator()(index_type N, drawn& d) const { return hilger::time_scale<S>(hilger::circ(random_points<S>{}(N, d))); }
};

/// Equal steps given as points: the same set as uniform_steps, computed as any other.
template <class S>
struct equal_points {
    static constexpr char const* name = "equal steps, given";
    auto operator()(index_type N, drawn& d) const { return hilger::time_scale<S>(uniform_steps<S>{}(N, d)); }
};

template <class S>
inline constexpr auto uniform_scales = boost::hana::make_tuple(uniform_steps<S>{}, divided_interval<S>{});
template <class S>
inline constexpr auto given_scales = boost::hana::make_tuple(equal_points<S>{}, random_points<S>{}, quantum<S>{}, harmonic<S>{},
                                                             fine_and_coarse<S>{}, own_circ<S>{});

/// Where scales of one type come from; so that an identity is compiled once for all of them.
template <class Scale>
struct kind_of_scale {
    char const* name;
    std::function<Scale(index_type, drawn&)> make;
};
template <class Makers>
auto kinds_of(Makers const& makers) {
    std::vector<kind_of_scale<decltype(boost::hana::front(makers)(1, std::declval<drawn&>()))>> kinds;
    boost::hana::for_each(makers, [&](auto const& make) { kinds.push_back({make.name, make}); });
    return kinds;
}

template <class Identity, class Scale, class Value>
void try_on(Identity const& identity, std::vector<kind_of_scale<Scale>> const& kinds, Value const& zero, int times) {
    if constexpr (not Identity::uniform_only or Scale::is_uniform)
        for (auto const& kind : kinds)
            for (index_type const N : {1, 2, 3, 10})
                prove(identity.name, identity.source, std::string(kind.name) + ", N = " + std::to_string(N),
                      std::numeric_limits<typename Scale::scalar_type>::is_exact, times,
                      [&, N](drawn& d) { return hilger::check(identity, kind.make(N, d), zero, d); });
}

/// The laws of every operator. The adjoint of the adjoint is the operator by type; that is tried where it is exact.
template <bool Exact, class Try>
void for_each_operator_law(Try const& one) {
    boost::hana::for_each(hilger::identities::operators, [&](auto const& a) {
        using A = std::remove_cvref_t<decltype(a)>;
        one(hilger::identities::by_parts_of<A>{a});
        if constexpr (Exact) one(hilger::identities::adjoint_is_involution<A>{a});
    });
}

/// All identities with values like zero, on every scale of given points; on uniform scales those that are stated there only.
template <class S, class Value>
void prove_all(Value const& zero, int times) {
    namespace hana = boost::hana;
    namespace id = hilger::identities;
    auto const on_given = [&, kinds = kinds_of(given_scales<S>)](auto const& identity) { try_on(identity, kinds, zero, times); };
    hana::for_each(id::calculus, on_given);
    hana::for_each(id::formulae, on_given);
    for_each_operator_law<std::numeric_limits<S>::is_exact>(on_given);
    auto const on_uniform = [&, kinds = kinds_of(uniform_scales<S>)](auto const& identity) {
        if constexpr (std::remove_cvref_t<decltype(identity)>::uniform_only) try_on(identity, kinds, zero, times);
    };
    hana::for_each(id::calculus, on_uniform);
    hana::for_each(id::formulae, on_uniform);
}

/// What prove_all leaves out: every identity on scales whose type says that they are uniform.
template <class S>
void prove_all_on_uniform_scales(int times) {
    namespace hana = boost::hana;
    namespace id = hilger::identities;
    auto const one = [&, kinds = kinds_of(uniform_scales<S>)](auto const& identity) { try_on(identity, kinds, S(0), times); };
    hana::for_each(id::calculus, one);
    hana::for_each(id::formulae, one);
    for_each_operator_law<std::numeric_limits<S>::is_exact>(one);
}

} // namespace laws
