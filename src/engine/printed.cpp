// SPDX-License-Identifier: BSL-1.0
// The equations of methods in print, each by its own operators. The flow may use other operators with the same steps.
#include <sstream>

#include "engine/methods/lambda.hpp"
#include "engine/methods/newmark.hpp"
#include "engine/methods/two_sided.hpp"

namespace engine {

namespace {

/// Calls use(embedding), if the method is one. @throws hilger::error::unreadable, hilger::error::invalid_parameter
template <class Use>
void with_written(problem const& what, std::string const& method, bool uniform, Use const& use) {
    using namespace hilger;
    if (method == "order-one") return use(order_one);
    if (method == "order-one-left") return use(order_one_left);
    if (method == "mid-point" or method == "mid-point+") return use(mid_point);
    if (method == "gauss-2") return use(galerkin<2, gauss>);
    if (method == "gauss-4") return use(galerkin<4, gauss>);
    if (method == "gauss-6") return use(galerkin<6, gauss>);
    if (method == "gauss-8") return use(galerkin<8, gauss>);
    if (method == "gauss-16") return use(galerkin<16, gauss>);
    if (method == "lobatto-3") return use(galerkin<3, lobatto>);
    if (is_embedding_in_text(method)) return text::with_embedding<double>(own_embedding(what, method), uniform, use);
    if (auto const lambda = lambda_of<double>(what, method)) use(theta_at(*lambda));
}
/// The method as operators in text, for equations of sums.
std::string in_operators(problem const& what, std::string const& method) {
    if (method == "order-one") return "integral(L(q, Delta_plus[q]))";
    if (method == "order-one-left") return "nabla_integral(L(q, Delta_minus[q]))";
    if (method == "mid-point") return "integral(L((q + sigma[q])/2, Delta_plus[q]))";
    if (is_embedding_in_text(method) or not lambda_of<double>(what, method)) return method;
    std::string const lambda = '(' + method.substr(6) + ')';
    return "integral(L((1 - " + lambda + ")*q + " + lambda + "*sigma[q], Delta_plus[q]))";
}

std::string structure_equation(problem const& what, std::string const& method, bool latex_wanted) {
    structure_of_problem<double>(what).require_valid();
    std::string const scheme = method == "gl-newmark" ? "Newmark's scheme"
                               : latex_wanted         ? R"(the $G^{\alpha}$-Newmark scheme)"
                                                      : "the G^alpha-Newmark scheme";
    if (latex_wanted)
        return (what.material ? R"(M \ddot{q} + \tfrac{E_\infty}{E_0} K (q - q_a) = f, \quad q_a + \tau^{\alpha} D^{\alpha}[q_a] =)"
                                R"( \left(1 - \tfrac{E_0}{E_\infty}\right) q)"
                              : R"(M \ddot{q} + \rho D^{\alpha}[q] + K q = f)") +
               (R"(\quad\text{by )" + scheme + "}");
    return (what.material ? "M q̈ + (E∞/E₀) K (q − qₐ) = f,   qₐ + τᵅ Dᵅ[qₐ] = (1 − E₀/E∞) q" : "M q̈ + ρ Dᵅ[q] + K q = f") +
           ("   by " + scheme + "\n");
}

template <class Scale>
std::string written_on(Scale const& T, problem const& what, std::string const& method, bool latex_wanted) {
    if (not what.besides.empty()) {
        hilger::detail::sum_writer all{latex_wanted ? hilger::print_style::latex : hilger::print_style::terminal};
        auto const add = [&](problem const& one, std::string const& its) {
            hilger::text::with_embedding<double>(own_embedding(one, in_operators(one, its)), Scale::is_uniform, [&](auto const& how) {
                all.add(variation(hilger::detail::action_on(one.lagrangian, how, T)));
                return 0;
            });
        };
        add(what, method);
        for (auto const& part : what.besides) add(alone(part), part.method);
        return all.written();
    }
    std::ostringstream out;
    with_written(what, method, Scale::is_uniform, [&](auto const& how) {
        auto const EL = variation(hilger::detail::action_on(what.lagrangian, how, T));
        if (latex_wanted)
            out << latex(EL);
        else
            out << EL << hamiltonian_form(EL);
    });
    return out.str().empty() ? method : out.str();
}

} // namespace

std::string equation_of_method(problem const& what, std::string const& method, bool uniform, bool latex_wanted) {
    if (what.time_transformation) return method; // E is that of the initial values
    if (is_newmark(method)) return structure_equation(what, method, latex_wanted);
    auto const equal = hilger::uniform(0.0, 1.0, 2);
    if (is_two_sided(method)) {
        std::ostringstream out;
        auto const EL = two_sided_equation(what.lagrangian, order_of_two_sides(method), equal);
        if (latex_wanted)
            out << latex(EL);
        else
            out << EL;
        return out.str();
    }
    if (uniform) return written_on(equal, what, method, latex_wanted);
    return written_on(hilger::time_scale<double>{0, 1, 3}, what, method, latex_wanted);
}

} // namespace engine
