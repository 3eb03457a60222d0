// SPDX-License-Identifier: BSL-1.0
// Conversions of numbers and initial values from and to Python: numpy arrays of double; text for rationals and 50 digits.
#pragma once

#include <algorithm>

#include "bindings.hpp"
#include "engine/engine.hpp"

namespace bindings {

/// Conversions of one scalar type.
template <class S>
struct crossing {
    using word_type = std::string; ///< of one number
    using given = std::vector<std::string>;
    static engine::vector<S> vector_of(given const& digits) {
        engine::vector<S> x(static_cast<Eigen::Index>(digits.size()));
        for (std::size_t k = 0; k < digits.size(); ++k) x(static_cast<Eigen::Index>(k)) = number(digits[k]);
        return x;
    }
    static S number(std::string const& digits) {
        if (auto const x = hilger::text::number_in<S>(digits)) return *x;
        hilger::error::raise<hilger::error::invalid_parameter>("a number was expected, as 0.1 or 1/3, and here is '", digits, "'");
    }
    static py::object array(std::vector<S>&& numbers, int columns) {
        py::list rows;
        for (S const& x : numbers) rows.append(word(x));
        return py::make_tuple(rows, columns);
    }
    static py::object word(S const& x) {
        if constexpr (std::numeric_limits<S>::is_exact)
            return py::str(x.str());
        else
            return py::str(x.str(std::numeric_limits<S>::max_digits10, std::ios::scientific));
    }
};
template <>
struct crossing<double> {
    using word_type = double;
    using given = py::array_t<double, py::array::c_style | py::array::forcecast>;
    static engine::vector<double> vector_of(given const& x) { return Eigen::Map<engine::vector<double> const>(x.data(), x.size()); }
    static double number(double x) { return x; }
    /// An array that takes ownership of the numbers without a copy.
    static py::object array(std::vector<double>&& numbers, int columns) {
        auto* const kept = new std::vector<double>(std::move(numbers));
        py::capsule const owner(kept, [](void* p) { delete static_cast<std::vector<double>*>(p); });
        auto const rows = static_cast<py::ssize_t>(kept->size()) / std::max(columns, 1);
        if (columns == 0) return py::array_t<double>({rows}, kept->data(), owner);
        return py::array_t<double>({rows, static_cast<py::ssize_t>(columns)}, kept->data(), owner);
    }
    static py::object word(double x) { return py::float_(x); }
};

/// The points of T from (start, step, steps), or from (points,).
template <class S>
engine::points<S> points_from(py::tuple const& T) {
    using with = crossing<S>;
    auto const number = [&](std::size_t k) { return with::number(T[k].cast<typename with::word_type>()); };
    if (T.size() == 3) return {number(0), number(1), T[2].cast<hilger::index_type>(), {}};
    auto const all = with::vector_of(T[0].cast<typename with::given>());
    return {S(0), S(0), all.size() - 1, std::vector<S>(all.begin(), all.end())};
}

inline engine::second_datum datum_named(std::string const& what) {
    using engine::second_datum;
    return what == "v0" ? second_datum::velocity : what == "p0" ? second_datum::momentum : second_datum::next_position;
}
template <class S>
engine::initial<S> initial_of(typename crossing<S>::given const& q0, std::string const& what, typename crossing<S>::given const& other) {
    return {crossing<S>::vector_of(q0), datum_named(what), crossing<S>::vector_of(other)};
}

} // namespace bindings
