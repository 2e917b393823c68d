// SPDX-License-Identifier: Apache-2.0
// The instruction sets that ray kernels are compiled for, and which of them this machine has. Each
// has a header of its own, core/simd_NAME.h, with one struct of static functions: the vocabulary
// below, for vectors of kWidth lanes. A kernel is a template over that struct, so it is written
// once; a source file of its own compiles it with the flags of each set.
//
//   Float, Int                    vectors of kWidth floats, of kWidth 32-bit integers
//   load, store                   aligned to the size of the vector; store_unaligned: not
//   broadcast(x)                  x in every lane; broadcast_integer(x): integers
//   min(a, b), max(a, b)          lane by lane; b where a is NaN, one of them where b is; of 0 and
//   -0
//                                 either, here and below
//   sqrt(x)                       rounded once, as by the standard; NaN below 0
//   multiply_add(a, b, c)         a b + c, rounded once or twice as the machine likes
//   fused(a, b, c)                a b + c rounded once, the same on every machine; emulated unless
//                                 kFastFused
//   less, less_equal, equal       masks: bit i is lane i; equal for integers as well
//   compress(mask, x)             the lanes of the mask moved together to the front
//   order(packed, octant)         reads a permutation from a node, see query/wide_node.h
//   permute(x, order)             lane i becomes lane order[i]
//   load_records(p, field)        kWidth records of eight floats, as eight vectors of a field each
//   store_records(p, field)       the way back
//   as_float(x)                   the bits of integers as floats
//   select(mask, a, b)            lanes of a where the mask is set, else of b
//   store_masked(mask, p, x)      x into the lanes of the mask
//   greatest(x)                   the greatest lane
//   least(mask, x)                the least lane of the mask, which isn't empty; no NaN for both
//   Quad                          the struct for four lanes, for the coordinates of one ray; it has
//                                 abs(x), copy_sign(size, sign) for a size >= 0, signs(x) and
//                                 largest_of_three(x), in every lane, besides
//
// Floats also add, subtract and multiply by their operators.
#pragma once

#include <cstdint>
#include <span>

#include "boxwood/core/named.h"

// Kernels must not leave out-of-line copies of shared functions behind: the linker could pick one
// compiled for an instruction set that the machine lacks.
#define BOXWOOD_KERNEL inline __attribute__((always_inline))

namespace boxwood {

enum class InstructionSet { scalar, sse4, avx2, avx512, neon, wasm };

/// Those compiled in, from the plainest on, by name.
std::span<const Named<InstructionSet>> instruction_sets();

/// Whether this machine can run it.
bool is_supported(InstructionSet set);

/// What the environment variable BOXWOOD_ISA names (scalar, sse4, avx2, avx512, neon or wasm) if
/// the machine has it, else the best that it has. Decided once.
InstructionSet preferred_instruction_set();

/// Lanes of a float vector.
constexpr int lanes(InstructionSet set) {
    return set == InstructionSet::avx512 ? 16 : set == InstructionSet::avx2 ? 8 : 4;
}

}  // namespace boxwood
