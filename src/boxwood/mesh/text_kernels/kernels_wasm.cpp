// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_bytes_wasm.h"
#include "boxwood/mesh/text_kernels/kernel_table.h"

namespace boxwood {

const TextKernels& wasm_text_kernels() {
    static constexpr TextKernels kKernels = text_kernels_of<WasmBytes>();
    return kKernels;
}

}  // namespace boxwood
