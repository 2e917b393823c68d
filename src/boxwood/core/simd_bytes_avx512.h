// SPDX-License-Identifier: Apache-2.0
// AVX-512: 32 characters, as with AVX2; 64 at once were no faster. A struct of its own, as code
// made from it is compiled for another machine. See core/simd_bytes.h for the vocabulary.
#pragma once

#include "boxwood/core/simd_bytes_avx2.h"

namespace boxwood {

struct Avx512Bytes : Avx2Bytes {};

}  // namespace boxwood
