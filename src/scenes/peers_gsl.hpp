// SPDX-License-Identifier: BSL-1.0
// The GNU Scientific Library's solvers of ordinary differential equations, if installed.
#pragma once

#include <cstddef>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <vector>

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

namespace program {

struct gsl_method {
    char const* name;
    gsl_odeiv2_step_type const* type;
};
/// The methods without a Jacobian matrix, of orders 4, 5, 8 and variable order.
inline std::vector<gsl_method> gsl_methods() {
    return {{"gsl-rkf45", gsl_odeiv2_step_rkf45},
            {"gsl-rkck", gsl_odeiv2_step_rkck},
            {"gsl-rk8pd", gsl_odeiv2_step_rk8pd},
            {"gsl-msadams", gsl_odeiv2_step_msadams}};
}

/// The solution x(t1) of x' = field(x) from x. @throws std::runtime_error when the tolerance cannot be kept
template <class Field, class Phase>
Phase by_gsl(gsl_method const& method, double tolerance, Field const& field, Phase x, double t1) {
    gsl_odeiv2_system const system{[](double, double const* y, double* rate, void* f) {
                                       (*static_cast<Field const*>(f))(y, rate);
                                       return static_cast<int>(GSL_SUCCESS);
                                   },
                                   nullptr, x.size(), const_cast<Field*>(&field)};
    gsl_set_error_handler_off(); // the default handler ends the program
    std::unique_ptr<gsl_odeiv2_driver, decltype(&gsl_odeiv2_driver_free)> const driver(
        gsl_odeiv2_driver_alloc_y_new(&system, method.type, t1 / 1000, tolerance, tolerance), gsl_odeiv2_driver_free);
    if (driver == nullptr) throw std::bad_alloc();
    gsl_odeiv2_driver_set_nmax(driver.get(), 1'000'000);
    double t = 0;
    int const status = gsl_odeiv2_driver_apply(driver.get(), &t, t1, x.data());
    if (status != GSL_SUCCESS) throw std::runtime_error(std::string(method.name) + ": " + gsl_strerror(status));
    return x;
}

} // namespace program
