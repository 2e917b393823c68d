// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_avx512.h"
#include "core/vocabulary.h"

namespace boxwood {

const Vocabulary& avx512_vocabulary() {
    static constexpr Vocabulary kVocabulary = vocabulary_of<Avx512>();
    return kVocabulary;
}

}  // namespace boxwood
