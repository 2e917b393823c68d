// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/stack.h"

#include <gtest/gtest.h>

#include <type_traits>

namespace boxwood {
namespace {

TEST(Stack, gives_back_in_reverse_as_many_as_fit) {
    Stack<int, 80> stack;
    EXPECT_TRUE(stack.is_empty());
    for (const int count : {1, 79, 80, 3}) {
        for (int i = 0; i < count; ++i) {
            EXPECT_FALSE(stack.is_full());
            stack.push(i);
        }
        EXPECT_EQ(stack.is_full(), count == 80);
        for (int i = count; i-- > 0;) ASSERT_EQ(stack.pop(), i) << count;
        EXPECT_TRUE(stack.is_empty());
    }
}

TEST(Stack, owns_no_memory_elsewhere) {
    EXPECT_TRUE((std::is_trivially_copyable_v<Stack<int, 80>>));
}

}  // namespace
}  // namespace boxwood
