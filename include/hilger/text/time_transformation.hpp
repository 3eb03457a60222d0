// SPDX-License-Identifier: BSL-1.0
// The transformation of time dt = g(q) dtau (variational/time_transformation.hpp) in text. g is a formula of the positions, with names as
// in C++ (variational/rates_of_time.hpp):
//   "1 + q^2"
//   "sundman(1.5)"               |q|^1.5, of all coordinates together
//   "sundman(1, hypot(x, y))"    another distance
//   "inverse_potential"          1 / L(q, 0)
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hilger/error.hpp"
#include "hilger/text/stated.hpp"

namespace hilger::text {

/// g(q) of a Lagrangian in text.
class stated_rate {
public:
    /// @throws error::unreadable for unknown names, error::invalid_parameter if g reads the time or a velocity
    stated_rate(expression const& g, stated const& lagrangian, std::vector<coordinate> const& coordinates, std::string source)
        : is_inverse_(g.root().what == kind::name and g.root().name == "inverse_potential"),
          of_(is_inverse_ ? lagrangian
                          : stated(written_out(g, coordinates), std::make_shared<vocabulary>(lagrangian.words()), std::move(source))) {
        if (not is_inverse_ and (of_.reads(meaning::role::time) or of_.reads(meaning::role::velocity)))
            error::raise<error::invalid_parameter>("the g of dt = g(q) dtau is a formula of the positions alone");
    }
    template <class T, class Q>
    T value(T const& t, Q const& q) const {
        T const x = of_.value(t, q, [](int) { return T(0); });
        return is_inverse_ ? T(T(1) / x) : x;
    }

private:
    /// sundman(gamma) and sundman(gamma, r) as powers.
    static expression written_out(expression const& g, std::vector<coordinate> const& coordinates) {
        node const& n = g.root();
        if (n.what != kind::call or n.name != "sundman" or n.parts.empty() or n.parts.size() > 2) return g;
        expression const gamma(n.parts[0]);
        return pow(n.parts.size() == 2 ? expression(n.parts[1]) : distance(coordinates), gamma);
    }
    static expression distance(std::vector<coordinate> const& coordinates) {
        expression sum;
        for (std::size_t k = 0; k < coordinates.size(); ++k) {
            auto const q = expression::variable(coordinates[k].position);
            expression const square = coordinates[k].size == 0 ? q * q : expression::call("dot", {q, q});
            sum = k == 0 ? square : sum + square;
        }
        return expression::call("sqrt", {sum});
    }
    bool is_inverse_;
    stated of_;
};

/// g(q) (L(q, q'/g(q)) + E)
struct formula_in_time {
    stated lagrangian;
    stated_rate rate;
    stated energy; ///< a number
    template <class T, class Q, class V>
    T value(T const& t, Q const& q, V const& v) const {
        T const g = rate.value(t, q);
        return T(g * (lagrangian.value(t, q, [&](int k) { return T(T(v(k)) / g); }) + energy.value(t, q, v)));
    }
};

} // namespace hilger::text
