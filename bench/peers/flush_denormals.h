// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <immintrin.h>

namespace boxwood::bench {

/// While it lives, this thread takes denormal numbers for zero, as Embree recommends.
class FlushDenormals {
public:
    FlushDenormals() : before_(_mm_getcsr()) { _mm_setcsr(before_ | 0x8040); }
    ~FlushDenormals() { _mm_setcsr(before_); }
    FlushDenormals(const FlushDenormals&) = delete;
    FlushDenormals& operator=(const FlushDenormals&) = delete;

private:
    unsigned before_;
};

}  // namespace boxwood::bench
