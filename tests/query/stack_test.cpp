// SPDX-License-Identifier: Apache-2.0
#include "boxwood/query/stack.h"

#include <gtest/gtest.h>

namespace boxwood {
namespace {

TEST(Stack, gives_back_in_reverse_however_many_there_are) {
    Stack<int> stack;
    EXPECT_TRUE(stack.is_empty());
    for (const int count : {1, 79, 80, 81, 82, 1000, 3}) {
        for (int i = 0; i < count; ++i) stack.push(i);
        for (int i = count; i-- > 0;) ASSERT_EQ(stack.pop(), i) << count;
        EXPECT_TRUE(stack.is_empty());
    }
}

TEST(Stack, goes_to_and_fro_over_the_places_at_hand) {
    Stack<int> stack;
    for (int i = 0; i < 78; ++i) stack.push(i);
    for (int round = 0; round < 10; ++round) {
        for (int i = 78; i < 90; ++i) stack.push(i + round);
        for (int i = 90; i-- > 78;) ASSERT_EQ(stack.pop(), i + round);
    }
    ASSERT_EQ(stack.pop(), 77);
}

}  // namespace
}  // namespace boxwood
