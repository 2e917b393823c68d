// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/file_content.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace boxwood;
    try {
        unpack_gzip({reinterpret_cast<const char*>(data), size}, "mesh.off.gz", 1 << 20);
    } catch (const Error&) {
    }
    return 0;
}
