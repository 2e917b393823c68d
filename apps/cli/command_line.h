// SPDX-License-Identifier: Apache-2.0
// The name of CLI11's class for a program or subcommand. Reading all of CLI11 takes seconds, and
// who only passes one on has no need to.
#pragma once

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11 chose it
class App;
}
