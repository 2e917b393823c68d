// SPDX-License-Identifier: Apache-2.0
#include "boxwood/world/mtl.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace boxwood;
    try {
        parse_mtl(fuzz::source_of(data, size, "library.mtl"), fuzz::small_options());
    } catch (const Error&) {
    }
    return 0;
}
