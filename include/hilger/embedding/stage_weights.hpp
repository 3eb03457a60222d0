// SPDX-License-Identifier: BSL-1.0
// Rows and columns of D^alpha on any T, D the inverse of the integral I of a stiffly accurate method with s stages, Radau IIA or Lobatto
// IIIC (history/runge_kutta.hpp). Their s x s blocks, with the steps nu_n,
//   I_nn = nu_n A,   I_nj = nu_j 1 b^T for j < n;      D_nn = (nu_n A)^-1,   D_{n,n-1} = -(nu_n A)^-1 1 e_s^T
// With alpha = m + beta, m whole and 0 <= beta < 1, D is applied m times, or I -m times, and then D^beta,
//   (D^beta)_nn = (nu_n A)^-beta,
//   (D^beta)_nj = -(sin(pi beta)/pi) Int_0^inf x^{beta-1} (1 + x nu_n A)^{-1} 1 prod_{j<m<n} R(-x nu_m) x nu_j b^T (1 + x nu_j A)^{-1} dx,
// R the stability function (Lopez-Fernandez and Sauter 2013). All terms of all rows are computed, whatever histories keep of them.
#pragma once

#include <array>
#include <map>

#include "hilger/embedding/collocation.hpp"
#include "hilger/operator/power.hpp"

namespace hilger::detail {

/// The method whose stages are these nodes in numbers S.
template <class S, int Stages, class Quadrature>
class stage_numbers {
    using W = typename wider<S>::type;

public:
    using block = std::array<S, static_cast<std::size_t>(Stages)>;
    using matrix = std::array<block, static_cast<std::size_t>(Stages)>;

    static stage_numbers const& here() {
        static stage_numbers const numbers(stage_method<S, Quadrature>(Stages));
        return numbers;
    }
    /// A^-beta, 0 < beta < 1, kept.
    [[nodiscard]] matrix const& inverse_power(S const& beta) const {
        thread_local std::map<S, matrix> kept;
        auto const found = kept.find(beta);
        return found != kept.end() ? found->second : kept.emplace(beta, rounded(resolvent_.inverse_power(beta))).first->second;
    }

private:
    explicit stage_numbers(runge_kutta<W> const& method)
        : resolvent_(method.A), A(rounded(method.A)), inverse(rounded(resolvent_.inverse())), functions(resolvent_, method.b) {}
    static matrix rounded(memory::stage_matrix<W> const& a) {
        matrix m;
        for (std::size_t i = 0; i < Stages; ++i)
            for (std::size_t j = 0; j < Stages; ++j) m[i][j] = static_cast<S>(a[i][j]);
        return m;
    }
    memory::stage_resolvent<S, W> resolvent_;

public:
    matrix A, inverse;
    memory::stage_functions<S> functions;
};

/// Rows for the side minus, columns for the side plus. Block d belongs to the step that is d steps before the own one, or behind it.
template <class S, int Stages, side Side, class Quadrature = radau>
class stage_weights {
    using numbers = stage_numbers<S, Stages, Quadrature>;
    using block = typename numbers::block;
    using matrix = typename numbers::matrix;
    using blocks = std::vector<block>;
    static constexpr bool is_row = Side == side::minus;

public:
    /// The first `count` blocks of the row of stage k, or the column, for steps of length nu(d). @throws error::invalid_parameter in an
    /// exact scalar where a weight is not rational, or not known to be
    template <class Order, class Steps>
    static blocks of(Order const& order, index_type k, index_type count, Steps const& nu) {
        auto const [whole, rest] = whole_and_rest(order);
        S const part = rest.template as<S>();
        S const beta = part < S(0) ? S(part + S(1)) : part; // 1 if it is that to rounding
        int const m = part < S(0) and beta < S(1) ? whole - 1 : whole;
        block none;
        none.fill(S(0));
        blocks c(static_cast<std::size_t>(count), none);
        c[0][static_cast<std::size_t>(k)] = S(1);
        if (S(0) < beta and beta < S(1)) raise(c, beta, nu);
        for (int i = 0; i < m; ++i) differentiate(c, nu);
        for (int i = 0; i < -m; ++i) integrate(c, nu);
        return c;
    }

private:
    /// x M for a row, M x for a column.
    static block applied(matrix const& M, block const& x) {
        block y;
        for (std::size_t i = 0; i < Stages; ++i) {
            y[i] = S(0);
            for (std::size_t j = 0; j < Stages; ++j) y[i] = y[i] + x[j] * (is_row ? M[j][i] : M[i][j]);
        }
        return y;
    }
    static block times(block x, S const& y) {
        for (S& z : x) z = z * y;
        return x;
    }
    static block sum(block x, block const& y) {
        for (std::size_t i = 0; i < Stages; ++i) x[i] = x[i] + y[i];
        return x;
    }
    static S total(block const& x) {
        S y(0);
        for (S const& z : x) y = y + z;
        return y;
    }
    /// The contribution of block d - 1 to block d of c D, or D c.
    template <class Steps>
    static block beside(blocks const& c, std::size_t d, Steps const& nu) {
        auto const& inverse = numbers::here().inverse;
        block x;
        x.fill(is_row ? S(0) : S(-c[d - 1].back()));
        if constexpr (is_row) {
            x.back() = -total(applied(inverse, c[d - 1])) / nu(static_cast<index_type>(d) - 1);
            return x;
        } else
            return times(applied(inverse, x), S(S(1) / nu(static_cast<index_type>(d))));
    }
    template <class Steps>
    static void differentiate(blocks& c, Steps const& nu) {
        for (std::size_t d = c.size(); d-- > 0;) {
            block const own = times(applied(numbers::here().inverse, c[d]), S(S(1) / nu(static_cast<index_type>(d))));
            c[d] = d == 0 ? own : sum(own, beside(c, d, nu));
        }
    }
    template <class Steps>
    static void integrate(blocks& c, Steps const& nu) {
        auto const& A = numbers::here().A;
        S before(0);
        for (std::size_t d = 0; d < c.size(); ++d) {
            S const h = nu(static_cast<index_type>(d));
            block const own = times(applied(A, c[d]), h);
            S next = before + total(c[d]);
            block from_before = times(A.back(), S(before * h));
            if constexpr (not is_row) {
                next = before;
                for (std::size_t k = 0; k < Stages; ++k) next = next + h * A.back()[k] * c[d][k];
                from_before.fill(before);
            }
            c[d] = sum(own, from_before);
            before = next;
        }
    }
    template <class Steps>
    static void raise(blocks& c, S const& beta, Steps const& nu) {
        if constexpr (not std::numeric_limits<S>::is_exact) {
            using std::pow;
            S unit = nu(0); // the shortest step, so that x is no number beyond the scalar's range
            for (index_type d = 1; d < static_cast<index_type>(c.size()); ++d) unit = std::min(unit, S(nu(d)));
            raise_by_resolvents(c, beta, [&](index_type d) { return S(nu(d) / unit); });
            S const factor = pow(unit, S(-beta));
            for (block& x : c) x = times(x, factor);
        } else if constexpr (Stages == 1) {
            auto const [p, q] = quotient_of<S>(run_time<S>{beta});
            auto const row = exact_power_row<S>(p, q, static_cast<index_type>(c.size()), nu);
            for (std::size_t d = 0; d < c.size(); ++d) c[d][0] = is_row ? row[d] : S(row[d] * nu(0) / nu(static_cast<index_type>(d)));
        } else
            error::raise<error::invalid_parameter>("in an exact scalar a power of the difference quotient of a method with ", Stages,
                                                   " stages has a whole order: the others are irrational, and this one is ", beta,
                                                   " beyond a whole number");
    }
    /// For steps from 1 on: the part of the integral between the nodes 1/x, and what it has beyond the largest x, where only neighbours
    /// meet and terms are geometric.
    struct rule {
        std::vector<S> x, value;
        S beyond, factor;

        template <class Steps>
        rule(S const& beta, index_type count, Steps const& nu) {
            using std::atan, std::exp, std::expm1, std::log, std::sin;
            S whole(0);
            for (index_type d = 0; d < count; ++d) whole = whole + nu(d);
            S const digits = -log(epsilon<S>()), rest = S(1) - beta, pi = S(4) * atan(S(1));
            S const above = whole * exp(S((digits + S(1)) / (S(1) + beta)));
            S const first = std::min(above, S((std::numeric_limits<S>::max)() * epsilon<S>()));
            S const last = exp(S(-(digits + S(6)) / (S(2) - beta))) / S(2 * Stages * Stages);
            auto& nodes = power_nodes<S>::of(beta);
            for (auto const& node : nodes.covering(last, first))
                if (not(node.at < last or first < node.at)) {
                    x.push_back(S(1) / node.at);
                    value.push_back(node.value);
                }
            beyond = value.back() / x.back() / expm1(S(rest * nodes.step()));
            factor = sin(S(pi * std::min(beta, rest))) / pi;
        }
    };
    template <class Steps>
    static void raise_by_resolvents(blocks& c, S const& beta, Steps const& nu) {
        using std::pow;
        auto const& A = numbers::here();
        rule const by(beta, static_cast<index_type>(c.size()), nu);
        std::size_t const n = by.x.size();
        std::vector<S> answer, gain, before(n, S(0)); // (1 + x nu A)^{-1} 1 and x nu b^T (1 + x nu A)^{-1}
        blocks result = c;
        for (std::size_t d = 0; d < c.size(); ++d) {
            S const h = nu(static_cast<index_type>(d));
            A.functions.evaluate(by.x, h, answer, gain);
            auto const &from = is_row ? answer : gain, &to = is_row ? gain : answer;
            result[d] = times(applied(A.inverse_power(beta), c[d]), S(pow(h, S(-beta))));
            if (d > 0) result[d] = sum(result[d], times(beside(c, d, nu), S(by.factor * by.beyond)));
            for (std::size_t k = 0; k < Stages; ++k) {
                S all(0);
                for (std::size_t j = 0; j < n; ++j) all = all + before[j] * to[k * n + j];
                result[d][k] = result[d][k] - by.factor * all;
            }
            for (std::size_t j = 0; j < n; ++j) {
                S own(0);
                for (std::size_t k = 0; k < Stages; ++k) own = own + c[d][k] * from[k * n + j];
                before[j] = before[j] * answer[(Stages - 1) * n + j] + by.value[j] * own;
            }
        }
        c = std::move(result);
    }
};

} // namespace hilger::detail
