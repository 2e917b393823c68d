// SPDX-License-Identifier: Apache-2.0
#if defined(__aarch64__)  // linters come by on other machines too
#include "boxwood/core/simd_neon.h"
#include "boxwood/query/kernels/kernel_table.h"

namespace boxwood {

const RayKernels& neon_kernels() {
    static constexpr RayKernels kKernels = kernels_of<Neon>();
    return kKernels;
}

}  // namespace boxwood
#endif
