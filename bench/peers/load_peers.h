// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "peers/peer.h"

namespace boxwood::bench {

/// Boxwood first, then the peers that were built, each a module with names of its own: two versions
/// of one library have the same symbols. With names of libraries, only those and Boxwood.
/// Throws Error when a module can't be loaded or a library isn't there.
Peers load_peers(const std::vector<std::string>& libraries = {});

}  // namespace boxwood::bench
