// SPDX-License-Identifier: Apache-2.0
// Many rays, a few dozen of them at a time. One ray alone keeps a core waiting: for a box before it
// knows which child is next, for the memory that holds it, for a branch that nobody could predict.
// So kRaysInFlight rays each take one step in turn, a node or a block, and which of these it is
// decides on which list a ray stands next, without a branch. A ray that is done makes room for the
// next. Explained in docs/algorithms/wavefront.md.
// Sources: Wald et al., "Wavefront path tracing" of Laine, Karras and Aila, "Megakernels Considered
// Harmful", HPG 2013; Barringer and Akenine-Moeller, "Dynamic Ray Stream Traversal", 2014.
#pragma once

#include "boxwood/query/kernels/fetch_trial.h"
#include "boxwood/query/kernels/node_ray.h"
#include "boxwood/query/kernels/tree_blocks.h"
#include "boxwood/query/kernels/wide_walk.h"

namespace boxwood {

constexpr int kRaysInFlight = 32;

/// What is below everything else on the stack of a ray: nothing is left to visit.
constexpr WideReference kDone = 0xffffffffu;

template <class S, class State>
struct WavefrontRay {
    static constexpr int N = S::kWidth;

    RaySetup setup;
    WideReference current;
    int size;  ///< of the stack; its first N places hold kDone
    std::size_t index;
    State state;
    alignas(64) std::uint32_t references[kWavefrontStack + 2 * kStackSlack];
    alignas(64) float distances[kWavefrontStack + 2 * kStackSlack];
};

/// The query is what is asked of `count` rays. It has
/// - State: what is known of a ray's answer so far; what lies beyond state.t is of no interest;
/// - kNearestFirst: whether children are visited in the order of their distance;
/// - start(i, setup, state): takes up ray i; false when that is answered already;
/// - visit(block, reference, setup, state): looks at a leaf; true when that settles the answer;
/// - finish(i, state): answers ray i.
template <class S, class Query>
class Wavefront {
public:
    static constexpr int N = S::kWidth;
    using State = typename Query::State;

    BOXWOOD_KERNEL Wavefront(const WideTreeView& tree, const Query& query, std::size_t count)
        : tree_(tree), query_(query), count_(count) {}

    BOXWOOD_KERNEL void run() {
        Lists lists;
        for (int i = 0; i < kRaysInFlight && next_ < count_; ++i) {
            for (int k = 0; k < N; ++k) {
                slots_[i].references[k] = kDone;
                slots_[i].distances[k] = -__builtin_inff();
            }
            lists.node[0][lists.nodes] = static_cast<std::uint16_t>(i);
            lists.nodes += start_next(slots_[i]);
        }
        bool fetches_ahead = false;
        if (tree_.bytes > kLargeTree) {
            FetchTrial trial;
            run(
                lists, [&](WideReference reference) { trial.watch(reference); },
                [&] { return trial.is_over(); });
            fetches_ahead = trial.favors_fetching();
        }
        const auto to_the_end = [] { return false; };
        if (fetches_ahead) {
            // The root, where there is nothing left.
            run(
                lists,
                [&](WideReference reference) {
                    prefetch<N>(tree_, reference == kDone ? 0 : reference);
                },
                to_the_end);
        } else {
            run(
                lists, [](WideReference) {}, to_the_end);
        }
    }

private:
    using Float = typename S::Float;
    using Slot = WavefrontRay<S, State>;

    /// Which slots stand at a node and which at a block: the lists of this round and of the next.
    struct Lists {
        std::uint16_t node[2][kRaysInFlight + 1], block[2][kRaysInFlight + 1];
        int round = 0;
        int nodes = 0, blocks = 0;
    };

    /// Takes steps until all rays are done, or enough of them. Looks ahead to where a ray goes
    /// next.
    template <class LookAhead, class IsOver>
    BOXWOOD_KERNEL void run(Lists& lists, const LookAhead& look_ahead, const IsOver& is_over) {
        std::uint16_t done[kRaysInFlight + 1];
        // The sizes are apart from the lists so that they stay in registers.
        int nodes = lists.nodes, blocks = lists.blocks, round = lists.round;
        for (; nodes + blocks > 0 && !is_over(); round ^= 1) {
            const std::uint16_t *node_list = lists.node[round], *block_list = lists.block[round];
            std::uint16_t *next_node_list = lists.node[round ^ 1],
                          *next_block_list = lists.block[round ^ 1];
            int next_nodes = 0, next_blocks = 0, finished = 0;
            // All three places are written; the one that counts is kept.
            const auto file = [&](std::uint16_t i, WideReference reference) {
                look_ahead(reference);
                slots_[i].current = reference;
                next_node_list[next_nodes] = next_block_list[next_blocks] = done[finished] = i;
                const int leaf = reference >> 31, last = reference == kDone;
                next_nodes += leaf ^ 1;
                next_blocks += leaf ^ last;
                finished += last;
            };
            for (int k = 0; k < nodes; ++k) file(node_list[k], visit_node(slots_[node_list[k]]));
            for (int k = 0; k < blocks; ++k)
                file(block_list[k], visit_block(slots_[block_list[k]]));
            for (int k = 0; k < finished; ++k) {
                query_.finish(slots_[done[k]].index, slots_[done[k]].state);
                next_node_list[next_nodes] = done[k];
                next_nodes += start_next(slots_[done[k]]);
            }
            nodes = next_nodes;
            blocks = next_blocks;
        }
        lists.nodes = nodes;
        lists.blocks = blocks;
        lists.round = round;
    }

    /// Puts the next ray that has to look at all into the slot.
    BOXWOOD_KERNEL bool start_next(Slot& slot) {
        while (next_ < count_) {
            const std::size_t i = next_++;
            if (!query_.start(i, slot.setup, slot.state)) continue;
            slot.current = 0;
            slot.size = N;
            slot.index = i;
            return true;
        }
        return false;
    }

    /// Drops what lies behind the closest hit from the top of the stack.
    BOXWOOD_KERNEL int drop_hidden(const Slot& slot) {
        int size = slot.size;
        for (;;) {
            const unsigned kept = S::less_equal(S::load_unaligned(slot.distances + size - N),
                                                S::broadcast(slot.state.t));
            if (__builtin_expect(kept != 0, 1)) return size - N + 32 - __builtin_clz(kept);
            size -= N;
        }
    }

    BOXWOOD_KERNEL WideReference visit_node(Slot& slot) {
        int size = Query::kNearestFirst ? drop_hidden(slot) : slot.size;
        const WideNode<N>& node = tree_.template node<N>(slot.current);
        Float enter, leave;
        NodeRay<S>(slot.setup).intersect(node, S::broadcast(slot.state.t), enter, leave);
        auto child = S::load(node.child);
        if constexpr (Query::kNearestFirst) {
            const auto order = S::order(node.order, static_cast<int>(slot.setup.octant));
            enter = S::permute(enter, order);
            leave = S::permute(leave, order);
            child = S::permute(child, order);
        }
        const unsigned hit = S::less_equal(enter, leave);
        S::store_unaligned(slot.references + size, S::compress(hit, child));
        if constexpr (Query::kNearestFirst)
            S::store_unaligned(slot.distances + size, S::compress(hit, enter));
        size += __builtin_popcount(hit) - 1;
        slot.size = size;
        return slot.references[size];
    }

    BOXWOOD_KERNEL WideReference visit_block(Slot& slot) {
        const TriangleBlock<N>& block = block_at<N>(tree_, slot.current, room_);
        if (query_.visit(block, slot.current, slot.setup, slot.state)) return kDone;
        if constexpr (Query::kNearestFirst) slot.size = drop_hidden(slot);
        return slot.references[--slot.size];
    }

    const WideTreeView& tree_;
    Query query_;
    std::size_t count_;
    std::size_t next_ = 0;
    Slot slots_[kRaysInFlight];
    TriangleBlock<N> room_;
};

}  // namespace boxwood
