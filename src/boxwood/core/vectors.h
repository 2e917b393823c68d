// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>

namespace boxwood {

// By an extension of GCC and Clang, which know the operators: no instruction set is named here.
using Double2 = double __attribute__((vector_size(16)));
using Float4 = float __attribute__((vector_size(16)));
using Int4 = std::int32_t __attribute__((vector_size(16)));

/// Whether all lanes of a mask, as comparisons give them, are set.
inline bool all_of(const Int4& mask) {
    std::int64_t halves[2];
    std::memcpy(halves, &mask, sizeof halves);
    return (halves[0] & halves[1]) == -1;
}

}  // namespace boxwood
