// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_sse4.h"
#include "core/vocabulary.h"

namespace boxwood {

const Vocabulary& sse4_vocabulary() {
    static constexpr Vocabulary kVocabulary = vocabulary_of<Sse4>();
    return kVocabulary;
}

}  // namespace boxwood
