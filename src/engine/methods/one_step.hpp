// SPDX-License-Identifier: BSL-1.0
// Embeddings in one step. A consistent one reads the position as a mean of the ends, (1 - lambda) q_i + lambda q_{i+1}, and the velocity as
// their difference: order-one, order-one-left, mid-point, theta:0.3 and embeddings in text differ in this lambda, which may depend on the
// length of the step. A sum of actions has one for each Lagrangian. All of them are one flow type, compiled once for each scalar.
#pragma once

#include "engine/methods/lambda.hpp"
#include "engine/methods/summed_lagrangian.hpp"
#include "engine/summed_equation.hpp"

namespace engine {

/// The position of a step, as a mean of its ends.
template <class S>
class mean_of_ends {
public:
    explicit mean_of_ends(S lambda) : lambda_(std::move(lambda)) {}
    /// For an embedding whose lambda depends on the length of the step.
    explicit mean_of_ends(hilger::text::embedding_formula of)
        : lambda_(0), of_(std::make_shared<hilger::text::embedding_formula const>(std::move(of))) {}
    [[nodiscard]] S lambda(S const& h) const { return of_ ? hilger::text::lambda_of_step<S>(*of_, h) : lambda_; }

private:
    S lambda_;
    std::shared_ptr<hilger::text::embedding_formula const> of_;
};

/// f -> (1 - lambda) f + lambda f^sigma, or its adjoint between Delta sums, g -> (1 - lambda) g + (nu / mu) lambda^rho g^rho.
template <class S, hilger::side Side = hilger::side::plus>
struct mean_operator : hilger::linear_operator<mean_operator<S, Side>> {
    using from = hilger::nodes;
    using to = hilger::nodes;
    using from_weight = hilger::delta_weight;
    using to_weight = hilger::delta_weight;
    static constexpr bool is_plus = Side == hilger::side::plus;
    static constexpr hilger::reach reads = hilger::reach::local(is_plus ? 0 : 1, is_plus ? 1 : 0).template at<hilger::nodes>();
    static constexpr auto name() { return hilger::fixed_text("the mean of the ends"); }
    mean_of_ends<S> of;
    explicit mean_operator(mean_of_ends<S> mean) : of(std::move(mean)) {}

    template <int F, int B>
    constexpr auto image(hilger::domain<hilger::nodes, F, B> const&) const {
        return hilger::domain<hilger::nodes, F + not is_plus, B + is_plus>{};
    }
    template <class F>
    auto evaluate(F const& f, hilger::index_type i) const {
        auto const step = [&](hilger::index_type k) { return S(f.domain().base.step(f.root(), k)); };
        S const h = step(i), lambda = of.lambda(h);
        if constexpr (is_plus)
            return hilger::evaluated(f.get(i) * S(S(1) - lambda) + f.get(i + 1) * lambda);
        else {
            S const before = step(i - 1);
            return hilger::evaluated(f.get(i) * S(S(1) - lambda) + f.get(i - 1) * S(of.lambda(before) * before / h));
        }
    }
    [[nodiscard]] auto adjoint() const { return mean_operator<S, hilger::opposite<Side>>(of); }
};

/// The embedding of each Lagrangian.
template <class S>
struct embedding_list {
    std::vector<mean_of_ends<S>> parts;
    static constexpr char const* name = "the embeddings of a sum of actions";
};
/// The nodes of all parts.
template <class S>
hilger::tableau<S> tableau_of(embedding_list<S> const& how, S const& h) {
    auto const of = [&](mean_of_ends<S> const& mean) { return hilger::tableau_of(hilger::text::embedding_at(mean.lambda(h)), h); };
    auto all = of(how.parts.front());
    for (std::size_t k = 1; k < how.parts.size(); ++k) hilger::detail::append_nodes(all, of(how.parts[k]));
    return all;
}
/// The embedding in the equation of one part.
template <class S>
auto embedding_by(mean_of_ends<S> const& mean) {
    using position = mean_operator<S>;
    using velocity = std::remove_const_t<decltype(hilger::Delta_plus)>;
    return hilger::embedding<position, velocity, hilger::delta_weight, false>{position(mean), velocity{}, "the embedding"};
}

template <class S, class Force, hilger::sums Sums>
using one_step_flow = hilger::flow<summed_lagrangian, Force, embedding_list<S>, Sums>;
/// one_step_motion handles two positions itself, part by part.
template <class Force, class S, hilger::sums Sums>
inline constexpr bool starts_from_two_positions<one_step_flow<S, Force, Sums>> = false;

template <class S, class Force, hilger::sums Sums>
class one_step_motion final : public motion_of<S, one_step_flow<S, Force, Sums>, any_scale<S>> {
    using flow_type = one_step_flow<S, Force, Sums>;
    using base = motion_of<S, flow_type, any_scale<S>>;

public:
    using base::base;

    [[nodiscard]] std::unique_ptr<cursor<S>> begin(initial<S> const& from) const override {
        if (from.is != second_datum::next_position) return base::begin(from);
        for (vector<S> const* x : {&from.q0, &from.other}) this->require_coordinates(*x);
        S const h = this->T_.step(0);
        vector<S> momentum = vector<S>::Zero(from.q0.size());
        for_each_part([&](auto const& flow) { momentum += flow.momentum_between(this->T_.min(), from.q0, from.other, h); });
        return base::begin({from.q0, second_datum::momentum, momentum});
    }
    [[nodiscard]] joined<S> between(vector<S> const& first, vector<S> const& last, std::vector<vector<S>> const& guess,
                                    std::stop_token const& stop) const override {
        for (vector<S> const* x : {&first, &last}) this->require_coordinates(*x);
        hilger::ends_report<S> report;
        hilger::boundary_values<vector<S>> const ends{first, last};
        auto const& T = this->T_;
        using hilger::detail::solve_between;
        auto const x =
            hilger::function_on(T, guess.empty() ? solve_between(this->flow_, T, ends, hilger::detail::straight_line{}, stop, &report)
                                                 : solve_between(this->flow_, T, ends, hilger::function_on(T, guess), stop, &report));
        std::vector<vector<S>> p(static_cast<std::size_t>(x.size()), vector<S>::Zero(first.size()));
        for_each_part([&](auto const& flow) {
            auto const of_part = momenta_of(flow, x);
            for (std::size_t i = 0; i < p.size(); ++i) p[i] += of_part[static_cast<hilger::index_type>(i)];
        });
        return {this->values_on_T(x), std::move(p), report.warning};
    }
    [[nodiscard]] S residual(initial<S> const&, std::vector<vector<S>> const& positions, std::vector<vector<S>> const&,
                             bool absolute) const override {
        for (vector<S> const& x : positions) this->require_coordinates(x);
        auto const x = hilger::function_on(this->T_, positions);
        auto const& force = this->flow_.mechanics().force;
        return absolute ? largest_residual(equation(), x, force) : relative_residual(equation(), x, force);
    }

private:
    template <class Use>
    void for_each_part(Use const& use) const {
        auto const& how = this->flow_.embedding().parts;
        auto const& what = this->flow_.mechanics();
        use(hilger::embed(what.first, embedding_by(how.front())));
        for (std::size_t k = 1; k < how.size(); ++k) use(hilger::embed(what.lagrangian.parts()[k], embedding_by(how[k])));
    }
    [[nodiscard]] auto equation() const {
        auto const& how = this->flow_.embedding().parts;
        auto const& parts = this->flow_.mechanics().lagrangian.parts();
        action_list<decltype(hilger::detail::action_on(parts[0].lagrangian, embedding_by(how[0]), this->T_))> sum;
        for (std::size_t k = 0; k < parts.size(); ++k)
            sum.parts.push_back(hilger::detail::action_on(parts[k].lagrangian, embedding_by(how[k]), this->T_));
        return hilger::euler_lagrange<decltype(sum)>(sum);
    }
};

/// The embedding of each Lagrangian on T, of the first one by `method`; nothing when that is no embedding in one step.
/// @throws hilger::error::invalid_parameter, hilger::error::unreadable; hilger::error::mismatch for parts with other coordinates
template <class S>
std::optional<embedding_list<S>> embeddings_in_one_step(problem const& what, std::string const& method, points<S> const& T) {
    if (what.besides.empty()) {
        if (not T.is_uniform() and has_lambda_of_step(what, method))
            return embedding_list<S>{{mean_of_ends<S>(own_embedding(what, method))}};
        auto const lambda = lambda_in_one_step<S>(what, method, T.equal_step());
        if (not lambda) return {};
        return embedding_list<S>{{mean_of_ends<S>(*lambda)}};
    }
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is beside one Lagrangian, and here are ",
                                                               what.besides.size() + 1);
    embedding_list<S> how;
    auto const add = [&](problem const& one, std::string const& its) {
        auto const lambda = lambda_in_one_step<S>(one, its, T.equal_step());
        if (not lambda)
            hilger::error::raise<hilger::error::invalid_parameter>(
                "what adds up is read in one step, by order-one, order-one-left, mid-point, theta:0.3 or an embedding, as "
                "integral(L(q, Delta_plus[q])), and not by '",
                its, "'");
        how.parts.emplace_back(*lambda);
    };
    add(what, method);
    int const d = what.lagrangian.formula().words().dimension();
    for (auto const& part : what.besides) {
        if (int const other = part.lagrangian.formula().words().dimension(); other != d)
            hilger::error::raise<hilger::error::mismatch>("Lagrangians add up of the same coordinates, and here are ones of ", d,
                                                          " and of ", other);
        add(alone(part), part.method);
    }
    return how;
}

/// The motion of states of dynamic size. @throws as embeddings_in_one_step does
template <class S, hilger::sums Sums = hilger::sums::plain>
std::unique_ptr<motion<S>> in_one_step(problem const& what, std::string const& method, points<S> const& T, beginning_by<S> faster = {}) {
    auto const how = embeddings_in_one_step<S>(what, method, T);
    if (not how) return nullptr;
    std::string names = method;
    for (auto const& part : what.besides) names += " + " + part.method;
    auto const with = [&]<class Force>(Force const& force) -> std::unique_ptr<motion<S>> {
        one_step_flow<S, Force, Sums> const flow(summed_lagrangian(what), force, *how);
        return std::make_unique<one_step_motion<S, Force, Sums>>(flow, any_scale<S>(T), names, std::move(faster));
    };
    if (what.force) return with(*what.force);
    return with(hilger::no_force{});
}

} // namespace engine
