// SPDX-License-Identifier: Apache-2.0
// How many random cases a test tries. Under a sanitizer each costs ten times as much, and memory
// errors show in few of them: there a part will do. Answers are judged without sanitizers.
#pragma once

#include <algorithm>

namespace boxwood {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kIsSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kIsSanitized = true;
#else
inline constexpr bool kIsSanitized = false;
#endif
#else
inline constexpr bool kIsSanitized = false;
#endif

/// Of so many cases one is tried. A prime, so that every 13th item of a list where kinds take turns
/// has some of each.
inline constexpr int kThinning = kIsSanitized ? 13 : 1;

/// All of them, or a 13th under a sanitizer, but ten at least.
template <class Integer>
constexpr Integer cases(Integer all) {
    const Integer tried = all / static_cast<Integer>(kThinning);
    return std::min(all, std::max(tried, static_cast<Integer>(10)));
}

}  // namespace boxwood
