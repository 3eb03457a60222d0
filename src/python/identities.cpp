// SPDX-License-Identifier: BSL-1.0
#include <boost/hana/for_each.hpp>

#include "bindings.hpp"
#include "hilger/hilger.hpp"
#include "hilger/multiprecision.hpp"
#include "hilger/text/vocabulary.hpp"
#include "identities/registry.hpp"

namespace bindings {

void add_identities(py::module_& m) {
    m.def("identities", [](std::vector<std::string> const& points) {
        using hilger::Q;
        std::vector<Q> all;
        for (auto const& digits : points) {
            auto const x = hilger::text::number_in<Q>(digits);
            if (not x)
                hilger::error::raise<hilger::error::invalid_parameter>("a rational number was expected, as 1/3, and here is '", digits,
                                                                       "'");
            all.push_back(*x);
        }
        hilger::time_scale<Q> const T(std::move(all));
        hilger::random_fractions source(1988);
        py::list proved;
        auto const on = [&](auto const& identity) {
            using identity_type = std::remove_cvref_t<decltype(identity)>;
            if constexpr (not identity_type::uniform_only) {
                if (PyErr_CheckSignals() != 0) throw py::error_already_set();
                auto const v = hilger::check(identity, T, Q(0), source);
                proved.append(
                    py::make_tuple(std::string(identity.name), std::string(identity.source), v.comparisons, v.holds, v.first_failure));
            }
        };
        namespace id = hilger::identities;
        boost::hana::for_each(id::calculus, on);
        boost::hana::for_each(id::formulae, on);
        return proved;
    });
}

} // namespace bindings
