// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <vector>

namespace boxwood {

/// Sets of the numbers below a count, each alone at first. The lowest number of a set stands for
/// it. Nearly O(1) a call.
class UnionFind {
public:
    explicit UnionFind(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::uint32_t{0});
    }

    std::uint32_t find(std::uint32_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }

    void join(std::uint32_t a, std::uint32_t b) {
        a = find(a);
        b = find(b);
        (a < b ? parents_[b] : parents_[a]) = a < b ? a : b;
    }

private:
    std::vector<std::uint32_t> parents_;
};

}  // namespace boxwood
