// SPDX-License-Identifier: BSL-1.0
// One trial of an identity: a scale, random functions on it, and the comparison of two sides. In an exact scalar the sides must be equal;
// in a floating one they may differ by 4 epsilons times the size of the data, which the identity states.
//
// An identity is a type derived from stated<...> with operator()(trial), which draws functions and calls trial.equal(left, right, size).
#pragma once

#include <cstdint>
#include <random>
#include <sstream>
#include <string>

#include "hilger/function/function.hpp"
#include "hilger/function/pointwise.hpp"

namespace hilger {

namespace identities {
/// The name of an identity, its equation (S = Cresson-Safi, B = Bourdin and co-workers), and whether it holds on uniform scales only.
template <text_argument Name, text_argument Source, bool UniformOnly = false>
struct stated {
    static constexpr char const* name = Name.characters;
    static constexpr char const* source = Source.characters;
    static constexpr bool uniform_only = UniformOnly;
};
} // namespace identities

/// A source of random numbers for trials: small fractions p/q, so that exact arithmetic stays short.
class random_fractions {
public:
    explicit random_fractions(std::uint64_t seed) : engine_(seed) {}
    std::pair<int, int> operator()() {
        auto const bits = engine_();
        return {static_cast<int>(bits % 199) - 99, static_cast<int>((bits >> 32) % 19) + 1};
    }

private:
    std::mt19937_64 engine_;
};

/// The outcome of a trial.
struct verdict {
    bool holds = true;
    long comparisons = 0;
    double worst = 0;          ///< the largest |left - right| in units of epsilon times size; zero for exact scalars
    std::string first_failure; ///< both sides of the first comparison that failed
};

/// Value is the type of the functions' values: the scale's scalar, or an Eigen vector of it.
template <class Value, class Scale, class Source>
class trial {
public:
    using scalar = typename Scale::root_type::scalar_type;
    using value = Value;
    static constexpr bool uniform = Scale::root_type::is_uniform;

    /// zero has the shape of the values; source() gives numerators and denominators.
    trial(Scale scale, Value zero, Source& source) : T(std::move(scale)), zero_(std::move(zero)), source_(&source) {}

    Scale T;

    [[nodiscard]] scalar number() {
        auto const [p, q] = (*source_)();
        return scalar(p) / scalar(q);
    }
    [[nodiscard]] Value random_value() {
        if constexpr (requires { zero_.size(); }) {
            Value v = zero_;
            for (index_type k = 0; k < v.size(); ++k) v(k) = number();
            return v;
        } else
            return number();
    }
    /// A random function with this trial's kind of values, or with scalar values.
    template <class S>
    [[nodiscard]] auto function_on(S const& scale) {
        std::vector<Value> values;
        for (index_type i = 0; i < scale.size(); ++i) values.push_back(random_value());
        return hilger::function_on(scale, std::move(values));
    }
    template <class S>
    [[nodiscard]] auto scalar_function_on(S const& scale) {
        std::vector<scalar> values;
        for (index_type i = 0; i < scale.size(); ++i) values.push_back(number());
        return hilger::function_on(scale, std::move(values));
    }
    [[nodiscard]] Value zero() const { return zero_; }

    /// The largest |f(t)|.
    template <discrete_function F>
    [[nodiscard]] static scalar size_of(F const& f) {
        scalar most(0);
        for (auto const& x : f) most = std::max(most, scalar(magnitude(x)));
        return most;
    }
    /// 1 / (shortest step): the factor by which a difference quotient magnifies values.
    [[nodiscard]] scalar steepness() const {
        scalar least = T.root().step(0);
        for (index_type i = 1; i < T.root().steps(); ++i) least = std::min(least, scalar(T.root().step(i)));
        return scalar(1) / least;
    }
    /// b - a, plus the size of the points: the factor by which an integral magnifies values.
    [[nodiscard]] scalar length() const {
        return scalar(T.root().element(T.root().steps()) - T.root().element(0)) + magnitude(T.root().element(0));
    }
    [[nodiscard]] scalar count() const { return scalar(static_cast<long long>(T.root().steps() + 1)); }

    /// left and right are values; size bounds the terms that are added on either side.
    template <class L, class R>
    void equal(L const& left, R const& right, scalar const& size) {
        ++result.comparisons;
        bool good;
        if constexpr (std::numeric_limits<scalar>::is_exact)
            good = left == right;
        else {
            scalar const unit = epsilon<scalar>() * size;
            scalar const apart = magnitude(evaluated(left - right));
            good = apart <= scalar(4) * unit;
            if (unit > scalar(0)) result.worst = std::max(result.worst, static_cast<double>(apart / unit));
        }
        if (not good and result.holds) {
            result.holds = false;
            std::ostringstream sides;
            sides << "left = " << left << ", right = " << right << " on " << T;
            result.first_failure = sides.str();
        }
    }
    /// f and g have the same domain and the same values.
    template <discrete_function F, discrete_function G>
    void equal_everywhere(F const& f, G const& g, scalar const& size) {
        static_assert(std::same_as<typename F::domain_type, typename G::domain_type>, "the two sides of an identity live on one domain");
        for (index_type i = f.first(); i <= f.last(); ++i) equal(f.element(i), g.element(i), size);
    }
    void require(bool condition, char const* what) {
        ++result.comparisons;
        if (not condition and result.holds) {
            result.holds = false;
            std::ostringstream where;
            where << what << " on " << T;
            result.first_failure = where.str();
        }
    }

    verdict result;

private:
    Value zero_;
    Source* source_;
};

/// Tries an identity once: random functions with values like `zero` on T.
template <class Identity, time_scale_like Scale, class Value, class Source>
verdict check(Identity const& identity, Scale const& T, Value const& zero, Source& source) {
    trial<Value, Scale, Source> t(T, zero, source);
    identity(t);
    return t.result;
}

} // namespace hilger
