// SPDX-License-Identifier: Apache-2.0
// WebAssembly's SIMD: 16 characters. See core/simd_bytes.h for the vocabulary.
#pragma once

#include <wasm_simd128.h>

#include "boxwood/core/simd_bytes.h"

namespace boxwood {

struct WasmBytes : SixteenInWords {
    static constexpr int kWidth = 16;
    using Vector = v128_t;

    static BOXWOOD_KERNEL Vector load(const char* p) { return wasm_v128_load(p); }
    static BOXWOOD_KERNEL std::uint64_t less(Vector x, char c) {
        return bits(wasm_u8x16_lt(x, wasm_i8x16_splat(c)));
    }
    static BOXWOOD_KERNEL std::uint64_t equal(Vector x, char c) {
        return bits(wasm_i8x16_eq(x, wasm_i8x16_splat(c)));
    }
    static BOXWOOD_KERNEL std::uint64_t digits(Vector x) {
        return less(wasm_v128_xor(x, wasm_i8x16_splat('0')), 10);
    }

private:
    static BOXWOOD_KERNEL std::uint64_t bits(v128_t mask) { return wasm_i8x16_bitmask(mask); }
};

}  // namespace boxwood
