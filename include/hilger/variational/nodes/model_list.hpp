// SPDX-License-Identifier: BSL-1.0
// The derivatives of a model L = v.Mv / 2 - U(q) (models/mechanical.hpp) as a list of values: dL/dq, dL/dv, room for a gradient, and the
// second derivatives that its potential and its mass have, term by term.
#pragma once

#include <memory>
#include <vector>

#include "hilger/differentiation/traced/trace.hpp"
#include "hilger/models/mechanical.hpp"

namespace hilger::detail {

/// The values at (q, v), those of second order where `seconds` asks for them; and where they are, the first time. `room` is as long as q.
template <class L, class V, class S = scalar_of<V>>
void list_model(L const& of, V const& q, V const& v, bool seconds, V& room, std::vector<S>& values,
                std::shared_ptr<derivative_places const>& places) {
    index_type const d = q.size();
    derivative_places made;
    bool const is_first = not places;
    if (is_first) values.assign(static_cast<std::size_t>(3 * d + 1), S(0));
    std::size_t place = static_cast<std::size_t>(3 * d + 1);
    auto const add_to = [&](block_number block, int sign) {
        return [&, block, sign](index_type j, index_type k, S const& x) {
            if (is_first) {
                auto& entries = made.entries[static_cast<std::size_t>(block)];
                int const row = static_cast<int>(j), column = static_cast<int>(k), here = static_cast<int>(place);
                entries.push_back({row, column, here});
                if (j != k) entries.push_back({column, row, here});
                values.push_back(S(0));
            }
            values[place++] = sign < 0 ? S(-x) : x;
        };
    };
    if (is_first or seconds) of.potential().hessian(q, add_to(block_qq, -1));
    if (is_first) {
        of.template put_mass<S>(d, add_to(block_vv, 1));
        made.constant = {false, true, true, true};
        for (int k = 0; k < static_cast<int>(d); ++k) {
            made.by_q.push_back(k);
            made.by_v.push_back(static_cast<int>(d) + k);
        }
        made.find_stretches();
        places = std::make_shared<derivative_places const>(std::move(made));
    }
    using part = Eigen::Map<Eigen::Matrix<S, Eigen::Dynamic, 1>>;
    part tensions(values.data() + 2 * d, d + 1);
    of.potential().gradient(q, room, tensions);
    part(values.data(), d) = -room;
    of.put_momentum(v, part(values.data() + d, d));
}

} // namespace hilger::detail
