// SPDX-License-Identifier: BSL-1.0
// Sums of actions (hilger/variational/sum_of_actions.hpp) of which there are as many as a problem has at run time: each Lagrangian is read
// in one step by a method of its own, and the equation of the sum is the sum of their equations.
#pragma once

#include <algorithm>

#include "engine/methods/own.hpp"
#include "engine/summed_equation.hpp"

namespace engine {

/// As a function it is the sum of the Lagrangians: what the momentum, the energy and the slopes are of.
class summed_lagrangian {
public:
    static constexpr bool is_generic_in_time = true;
    explicit summed_lagrangian(problem const& what) : parts_{{what.lagrangian, {}}} {
        for (auto const& part : what.besides) parts_.push_back({part.lagrangian, {}});
    }
    template <class T, class Q, class V>
        requires requires(Q const& q) { q(0); }
    auto operator()(T const& t, Q const& q, V const& v) const {
        auto sum = parts_.front().lagrangian(t, q, v);
        for (std::size_t k = 1; k < parts_.size(); ++k) sum = sum + parts_[k].lagrangian(t, q, v);
        return sum;
    }
    [[nodiscard]] bool reads_time() const {
        return std::any_of(parts_.begin(), parts_.end(), [](auto const& part) { return part.lagrangian.reads_time(); });
    }
    [[nodiscard]] hilger::text::stated const& formula() const { return parts_.front().lagrangian.formula(); }
    [[nodiscard]] std::vector<free_problem> const& parts() const { return parts_; }

private:
    std::vector<free_problem> parts_;
};

/// How each of them is read.
template <class S>
struct embedding_list {
    std::vector<decltype(hilger::text::embedding_at(std::declval<S const&>()))> parts;
    static constexpr char const* name = "the embeddings of a sum of actions";
};
/// The nodes of all.
template <class S>
hilger::tableau<S> tableau_of(embedding_list<S> const& how, S const& h) {
    auto all = hilger::tableau_of(how.parts.front(), h);
    for (std::size_t k = 1; k < how.parts.size(); ++k) hilger::detail::append_nodes(all, hilger::tableau_of(how.parts[k], h));
    return all;
}

} // namespace engine

namespace hilger {

/// The force is beside the first Lagrangian, and read where that is.
template <class Force>
struct problem<engine::summed_lagrangian, Force> {
    engine::summed_lagrangian lagrangian;
    [[no_unique_address]] Force force;
    problem<text::stated_lagrangian, Force> first;
    problem(engine::summed_lagrangian L, Force f)
        : lagrangian(std::move(L)), force(std::move(f)), first{lagrangian.parts().front().lagrangian, force} {}
};

namespace detail {

/// The nodes ask for one Lagrangian each, and who asks for the whole for their sum.
template <class Force, class V, bool Traces>
class given<problem<engine::summed_lagrangian, Force>, V, Traces> final
    : public given_whole<problem<engine::summed_lagrangian, Force>, V, Traces> {
    using what_type = problem<engine::summed_lagrangian, Force>;

public:
    explicit given(what_type const& what) : given_whole<what_type, V, Traces>(what), first_(what.first) {
        auto const& parts = what.lagrangian.parts();
        others_.reserve(parts.size() - 1);
        for (std::size_t k = 1; k < parts.size(); ++k) others_.emplace_back(parts[k]);
    }
    [[nodiscard]] given_problem<V> const& part(int k) const override {
        if (k == 0) return first_;
        return others_[static_cast<std::size_t>(k) - 1];
    }

private:
    given<problem<text::stated_lagrangian, Force>, V> first_;
    std::vector<given<engine::free_problem, V>> others_;
};

} // namespace detail
} // namespace hilger

namespace engine {

template <class S, class Force>
using summed_flow = hilger::flow<summed_lagrangian, Force, embedding_list<S>, hilger::sums::plain>;
/// The parts say what two positions determine.
template <class Force, class S>
inline constexpr bool starts_from_two_positions<hilger::flow<summed_lagrangian, Force, embedding_list<S>, hilger::sums::plain>> = false;

template <class S, class Force, class Scale>
class summed_motion final : public motion_of<S, summed_flow<S, Force>, Scale> {
    using base = motion_of<S, summed_flow<S, Force>, Scale>;
    using seen = std::function<bool(S const&, vector<S> const&, vector<S> const&)>;

public:
    summed_motion(summed_flow<S, Force> flow, Scale T, problem what, std::string const& method, bool uniform)
        : base(std::move(flow), std::move(T), names_of(what, method)), what_(std::move(what)), method_(method), uniform_(uniform) {}

    void walk(initial<S> const& from, seen const& keep) const override {
        if (from.is != second_datum::next_position) return base::walk(from, keep);
        for (vector<S> const* x : {&from.q0, &from.other}) this->require_coordinates(*x);
        S const h = this->T_.domain().base.step(this->T_.root(), this->T_.first());
        vector<S> momentum = vector<S>::Zero(from.q0.size());
        for_each_part([&](auto const& flow) { momentum += flow.momentum_between(this->T_.min(), from.q0, from.other, h); });
        base::walk({from.q0, second_datum::momentum, momentum}, keep);
    }
    [[nodiscard]] joined<S> between(vector<S> const& first, vector<S> const& last, std::vector<vector<S>> const& guess,
                                    std::stop_token const& stop) const override {
        for (vector<S> const* x : {&first, &last}) this->require_coordinates(*x);
        hilger::ends_report<S> report;
        auto const x = this->solved_between(summed_equation(), first, last, guess, stop, report);
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
        return absolute ? largest_residual(summed_equation(), x, force) : relative_residual(summed_equation(), x, force);
    }
    [[nodiscard]] std::string equation(bool latex_wanted) const override;

private:
    static std::string names_of(problem const& what, std::string names) {
        for (auto const& part : what.besides) names += " + " + part.method;
        return names;
    }
    template <class Use>
    void for_each_part(Use const& use) const {
        auto const& how = this->flow_.embedding().parts;
        auto const& what = this->flow_.mechanics();
        use(hilger::embed(what.first, how.front()));
        for (std::size_t k = 1; k < how.size(); ++k) use(hilger::embed(what.lagrangian.parts()[k], how[k]));
    }
    [[nodiscard]] auto summed_equation() const {
        auto const& how = this->flow_.embedding().parts;
        auto const& parts = this->flow_.mechanics().lagrangian.parts();
        action_list<decltype(hilger::detail::action_on(parts[0].lagrangian, how[0], this->T_))> sum;
        for (std::size_t k = 0; k < parts.size(); ++k)
            sum.parts.push_back(hilger::detail::action_on(parts[k].lagrangian, how[k], this->T_));
        return hilger::euler_lagrange<decltype(sum)>(sum);
    }
    problem what_;
    std::string method_;
    bool uniform_;
};

/// The problem of one Lagrangian of a sum alone.
inline problem alone(problem::summand const& part) { return {part.lagrangian, {}, {}}; }

template <class S>
S lambda_of_part(problem const& one, std::string const& method, std::optional<S> const& h) {
    std::string const operators = in_operators<S>(one, method);
    if (not is_embedding_in_text(operators))
        hilger::error::raise<hilger::error::invalid_parameter>(
            "what adds up is read in one step, by order-one, order-one-left, mid-point, theta:0.3 or an embedding, as "
            "integral(L(q, Delta_plus[q])), and not by '",
            method, "'");
    return hilger::text::lambda_of_step<S>(own_embedding(one, operators), h);
}

template <class S, class Force, class Scale>
std::string summed_motion<S, Force, Scale>::equation(bool latex_wanted) const {
    if constexpr (std::same_as<S, double>) {
        hilger::detail::sum_writer all{latex_wanted ? hilger::print_style::latex : hilger::print_style::terminal};
        auto const add = [&](problem const& one, std::string const& method) {
            with_own_embedding<double>(one, in_operators<double>(one, method), uniform_, [&](auto const& how) {
                all.add(variation(hilger::detail::action_on(one.lagrangian, how, this->T_)));
                return 0;
            });
        };
        add(what_, method_);
        for (auto const& part : what_.besides) add(alone(part), part.method);
        return all.written();
    } else
        return equation_in_double(what_, method_, uniform_, latex_wanted);
}

/// How each Lagrangian of a sum is read, in steps of length h or of any. @throws hilger::error::invalid_parameter, hilger::error::mismatch
template <class S>
embedding_list<S> embeddings_of_sum(problem const& what, std::string const& method, std::optional<S> const& h) {
    if (what.has_memory())
        hilger::error::raise<hilger::error::invalid_parameter>("fractional damping is beside one Lagrangian, and here are ",
                                                               what.besides.size() + 1);
    embedding_list<S> how{{hilger::text::embedding_at(lambda_of_part<S>(what, method, h))}};
    int const d = what.lagrangian.formula().words().dimension();
    for (auto const& part : what.besides) {
        if (int const other = part.lagrangian.formula().words().dimension(); other != d)
            hilger::error::raise<hilger::error::mismatch>("Lagrangians add up of the same coordinates, and here are ones of ", d,
                                                          " and of ", other);
        how.parts.push_back(hilger::text::embedding_at(lambda_of_part<S>(alone(part), part.method, h)));
    }
    return how;
}

/// The motion of a sum of actions, each in one step. @throws hilger::error::invalid_parameter, hilger::error::mismatch
template <class S>
std::unique_ptr<motion<S>> summed(problem const& what, std::string const& method, points<S> const& T) {
    embedding_list<S> const how = embeddings_of_sum<S>(what, method, T.equal_step());
    summed_lagrangian const sum(what);
    auto const on = [&]<class Scale>(auto const& flow, Scale const& scale) -> std::unique_ptr<motion<S>> {
        using force = std::remove_cvref_t<decltype(flow.mechanics().force)>;
        return std::make_unique<summed_motion<S, force, Scale>>(flow, scale, what, method, T.is_uniform());
    };
    auto const made = [&](auto const& force) -> std::unique_ptr<motion<S>> {
        using flow_type = summed_flow<S, std::remove_cvref_t<decltype(force)>>;
        flow_type const flow(sum, force, how);
        return with_scale(T, [&](auto const& scale) { return on(flow, scale); });
    };
    if (what.force) return made(*what.force);
    return made(hilger::no_force{});
}

extern template std::unique_ptr<motion<double>> summed(problem const&, std::string const&, points<double> const&);

} // namespace engine
