// SPDX-License-Identifier: Apache-2.0
#include "boxwood/core/simd_scalar.h"
#include "core/vocabulary.h"

namespace boxwood {

const Vocabulary& scalar_vocabulary() {
    static constexpr Vocabulary kVocabulary = vocabulary_of<Scalar>();
    return kVocabulary;
}

}  // namespace boxwood
