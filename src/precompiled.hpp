// SPDX-License-Identifier: BSL-1.0
// What the files of the program share, compiled once. They include what they use all the same.
#pragma once

#include "compiled_once.hpp"