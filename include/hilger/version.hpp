// SPDX-License-Identifier: BSL-1.0
// The one place where the version is written; CMakeLists.txt reads it from here.
#pragma once

#define HILGER_VERSION_MAJOR 0
#define HILGER_VERSION_MINOR 2
#define HILGER_VERSION_PATCH 0
