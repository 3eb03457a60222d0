// SPDX-License-Identifier: BSL-1.0
#pragma once

#include <iosfwd>

namespace program {

/// Proves the identities behind the two embeddings on random rational functions and prints one line for each.
/// Returns whether all of them hold.
bool prove_identities(std::ostream& out);

} // namespace program
