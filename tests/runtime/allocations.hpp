// SPDX-License-Identifier: BSL-1.0
// Counts what is asked for on the heap, by operator new and, where the C library lets it, by malloc: Eigen's vectors of dynamic size come
// from there. With a sanitizer, which has a malloc of its own, operator new alone is counted.
#pragma once

/// How often memory was asked for until now.
long allocations_until_now();
/// Whether malloc is counted.
extern bool const counts_malloc;
