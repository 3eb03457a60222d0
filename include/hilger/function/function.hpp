// SPDX-License-Identifier: BSL-1.0
// Discrete functions that a user makes: from a formula f(t), kept as the formula, or from a table with one value per point. Tables are
// shared and never change, so expressions own their operands, and copying one costs a pointer.
#pragma once

#include <memory>
#include <vector>

#include "hilger/function/concept.hpp"

namespace hilger {

/// A callable that takes the points of the scale.
template <class Formula, class Scale>
concept formula_on = std::invocable<Formula const&, typename Scale::root_type::scalar_type>;

/// f(t), evaluated at each access.
template <class Formula>
struct by_formula {
    [[no_unique_address]] Formula formula;
    template <class Root, class Domain>
    constexpr auto get(Root const& root, Domain const& domain, index_type i) const {
        using value = value_on<decltype(formula(domain.base.point(root, i))), typename Root::scalar_type>;
        return value(formula(domain.base.point(root, i)));
    }
};

/// One value per point of the domain, in order.
template <class Value>
struct by_table {
    std::shared_ptr<std::vector<Value> const> values;
    template <class Root, class Domain>
    Value const& get(Root const& root, Domain const& domain, index_type i) const {
        return (*values)[static_cast<std::size_t>(i - domain.first(root))];
    }
};

namespace detail {
template <class Domain>
constexpr void made_from_something_else() {
    does_not_compile<"a function on " + Domain::name() +
                     " is made from a formula that takes its points, or from a std::vector of its values">{};
}
template <class Domain>
struct no_formula {
    template <class Root>
    constexpr auto get(Root const&, Domain const&, index_type) const {
        return typename Root::scalar_type(0);
    }
};
} // namespace detail

/// A function on a scale by a formula or a table: function_on(T, [](auto const& t) { return ...; }), function_on(T, values).
template <class Root, class Domain, class Rule>
class function_on : public function_interface<function_on<Root, Domain, Rule>> {
public:
    using root_type = Root;
    using domain_type = Domain;

    constexpr function_on(Root root, Domain domain, Rule rule)
        : root_(std::move(root)), domain_(std::move(domain)), rule_(std::move(rule)) {}

    /// f(t) for t in the scale. The formula is evaluated at each access; tabulate() keeps its values.
    template <time_scale_like Scale, formula_on<Scale> Formula>
    constexpr function_on(Scale const& scale, Formula formula) : function_on(scale.root(), scale.domain(), Rule{std::move(formula)}) {}

    /// One value per point. @throws error::mismatch when their number is not the scale's, or vectors differ in length, error::not_finite
    /// on NaN or infinity.
    template <time_scale_like Scale, class Value>
    function_on(Scale const& scale, std::vector<Value> values)
        : function_on(scale.root(), scale.domain(), Rule{share<value_on<Value, typename Root::scalar_type>>(std::move(values))}) {
        if (static_cast<index_type>(rule_.values->size()) != scale.size())
            error::raise<error::mismatch>("a function on ", scale, " needs ", scale.size(), " values, and was given ",
                                          rule_.values->size());
        for (std::size_t i = 0; i < rule_.values->size(); ++i) {
            auto const& value = (*rule_.values)[i];
            auto const where = [&] { return scale.element(scale.first() + static_cast<index_type>(i)); };
            if (not is_finite(value))
                error::raise<error::not_finite>("the value at ", where(), " is NaN or infinite; a function on ", scale,
                                                " has finite values");
            if constexpr (requires { value.size(); })
                if (value.size() != rule_.values->front().size())
                    error::raise<error::mismatch>("the value at ", where(), " has ", value.size(), " components, and the first one has ",
                                                  rule_.values->front().size());
        }
    }

    /// Anything else is refused in one sentence.
    template <time_scale_like Scale, class Other>
        requires(not formula_on<Other, Scale>)
    constexpr function_on(Scale const& scale, Other const&) : function_on(scale.root(), scale.domain(), Rule{}) {
        detail::made_from_something_else<typename Scale::domain_type>();
    }

    [[nodiscard]] constexpr Root const& root() const { return root_; }
    [[nodiscard]] constexpr Domain const& domain() const { return domain_; }
    [[nodiscard]] constexpr decltype(auto) get(index_type i) const { return rule_.get(root_, domain_, i); }

private:
    template <class Stored, class Value>
    static auto share(std::vector<Value> values) {
        if constexpr (std::same_as<Stored, Value>)
            return std::make_shared<std::vector<Stored> const>(std::move(values));
        else
            return std::make_shared<std::vector<Stored> const>(values.begin(), values.end());
    }
    Root root_;
    [[no_unique_address]] Domain domain_;
    [[no_unique_address]] Rule rule_;
};

template <time_scale_like Scale, formula_on<Scale> Formula>
function_on(Scale const&, Formula) -> function_on<typename Scale::root_type, typename Scale::domain_type, by_formula<Formula>>;

template <time_scale_like Scale, class Other>
    requires(not formula_on<Other, Scale>)
function_on(Scale const&, Other const&)
->function_on<typename Scale::root_type, typename Scale::domain_type, detail::no_formula<typename Scale::domain_type>>;

template <time_scale_like Scale, class Value>
function_on(Scale const&, std::vector<Value>) -> function_on<typename Scale::root_type, typename Scale::domain_type,
                                                             by_table<value_on<Value, typename Scale::root_type::scalar_type>>>;

/// f as a table: its values, computed once.
template <discrete_function F>
auto tabulate(F const& f) {
    using R = typename F::root_type;
    using D = typename F::domain_type;
    std::vector<value_of<F>> values;
    values.reserve(static_cast<std::size_t>(f.size()));
    auto const use = [&values](auto const& value) { values.push_back(value); };
    if constexpr (requires { f.for_each_value(use); })
        f.for_each_value(use);
    else
        for (index_type i = f.first(); i <= f.last(); ++i) use(f.get(i));
    return function_on<R, D, by_table<value_of<F>>>(f.root(), f.domain(),
                                                    {std::make_shared<std::vector<value_of<F>> const>(std::move(values))});
}

} // namespace hilger
