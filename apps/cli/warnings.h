// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "boxwood/core/warnings.h"

namespace boxwood::cli {

/// Prints to stderr, a line each, the faults of each kind that the warnings show, and how many more
/// there are.
void print_warnings(const Warnings& warnings);

}  // namespace boxwood::cli
