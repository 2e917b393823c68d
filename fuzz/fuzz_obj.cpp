// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/obj.h"
#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    return boxwood::fuzz::try_mesh(data, size, "mesh.obj", boxwood::parse_obj);
}
