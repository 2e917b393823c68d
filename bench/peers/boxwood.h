// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "peers/peer.h"

namespace boxwood::bench {

/// This library, through its public interface and with the flags that users build it with.
std::unique_ptr<Peer> make_boxwood();

}  // namespace boxwood::bench
