// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

namespace tbb {

template <class Iterator, class Compare>
void parallel_sort(Iterator begin, Iterator end, const Compare& compare) {
    std::sort(begin, end, compare);
}
template <class Container>
void parallel_sort(Container& container) {
    std::sort(container.begin(), container.end());
}
template <class Container, class Compare>
void parallel_sort(Container& container, const Compare& compare) {
    std::sort(container.begin(), container.end(), compare);
}

}  // namespace tbb
