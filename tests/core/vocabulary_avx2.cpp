// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_avx2.h"
#include "core/vocabulary.h"

namespace boxwood {

const Vocabulary& avx2_vocabulary() {
    static constexpr Vocabulary kVocabulary = vocabulary_of<Avx2>();
    return kVocabulary;
}

}  // namespace boxwood
