// SPDX-License-Identifier: BSL-1.0
// The calculus alone: scales, functions, operators and their adjoints. It needs neither Eigen nor Boost.
#pragma once

// Scalars and exceptions
#include "hilger/error.hpp"
#include "hilger/scalar.hpp"

// Time scales: T, T^+, T^-, T_half, T_o, T_lambda, any points
#include "hilger/scale/derived.hpp"
#include "hilger/scale/time_scale.hpp"
#include "hilger/scale/uniform.hpp"

// Functions on them
#include "hilger/function/exponential.hpp"
#include "hilger/function/function.hpp"
#include "hilger/function/pointwise.hpp"
#include "hilger/function/unknown.hpp"

// Operators between them: sigma, rho, Delta, extension, means, integrals
#include "hilger/operator/antiderivative.hpp"
#include "hilger/operator/fractional.hpp"
#include "hilger/operator/integral.hpp"
#include "hilger/operator/linear_expression.hpp"
#include "hilger/operator/local.hpp"
#include "hilger/operator/transfer.hpp"

// Adjoints, equality of operators, integration by parts
#include "hilger/adjoint/adjoint.hpp"
#include "hilger/adjoint/normal_form.hpp"

// Operators as text: std::cout << Delta_plus, latex(adjoint(extend))
#include "hilger/printing/notation.hpp"
