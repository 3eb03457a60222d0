// SPDX-License-Identifier: BSL-1.0
#pragma once

namespace hilger {

/// How the second derivatives of a potential are stored and solved with.
enum class hessian_pattern { dense, tridiagonal, sparse };

} // namespace hilger
