// SPDX-License-Identifier: Apache-2.0
#if defined(__wasm__)  // linters come by on other machines too
#include "boxwood/core/simd_wasm.h"
#include "boxwood/query/kernels/kernel_table.h"

namespace boxwood {

const RayKernels& wasm_kernels() {
    static constexpr RayKernels kKernels = kernels_of<Wasm>();
    return kKernels;
}

}  // namespace boxwood
#endif
