// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_neon.h"
#include "core/vocabulary.h"

namespace boxwood {

const Vocabulary& neon_vocabulary() {
    static constexpr Vocabulary kVocabulary = vocabulary_of<Neon>();
    return kVocabulary;
}

}  // namespace boxwood
