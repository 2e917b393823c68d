// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_wasm.h"
#include "core/vocabulary.h"

namespace boxwood {

const Vocabulary& wasm_vocabulary() {
    static constexpr Vocabulary kVocabulary = vocabulary_of<Wasm>();
    return kVocabulary;
}

}  // namespace boxwood
