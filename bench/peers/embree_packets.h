// SPDX-License-Identifier: Apache-2.0
// Plain rays to Embree's packets and back. A packet is written in registers as wide as those Embree
// reads it with: narrower stores would stall its loads.
#pragma once

#include <algorithm>
#include <cstring>

#include "embree_calls.h"
#include "peer.h"
#include "transpose.h"

namespace boxwood::bench {

template <int kWidth>
struct EmbreePacket;
template <>
struct EmbreePacket<8> {
    using Rays = RTCRay8;
    using RayHits = RTCRayHit8;
};
template <>
struct EmbreePacket<16> {
    using Rays = RTCRay16;
    using RayHits = RTCRayHit16;
};

/// What doesn't change from one packet to the next.
template <class Rays>
void set_constants(Rays& rays) {
    std::memset(rays.time, 0, sizeof rays.time);
    std::memset(rays.mask, 0xff, sizeof rays.mask);
    std::memset(rays.id, 0, sizeof rays.id);
    std::memset(rays.flags, 0, sizeof rays.flags);
}

inline void load8(const PlainRay* rays, __m256 (&coordinates)[8]) {
    for (int i = 0; i < 8; ++i) coordinates[i] = _mm256_loadu_ps(&rays[i].ox);
    transpose8(coordinates);
}

inline void set_rays(const PlainRay* from, RTCRay8& to) {
    __m256 low[8];
    load8(from, low);
    float* const places[8] = {to.org_x, to.org_y, to.org_z, to.tnear,
                              to.dir_x, to.dir_y, to.dir_z, to.tfar};
    for (int i = 0; i < 8; ++i) _mm256_store_ps(places[i], low[i]);
}

inline void set_rays(const PlainRay* from, RTCRay16& to) {
    __m256 low[8], high[8];
    load8(from, low);
    load8(from + 8, high);
    float* const places[8] = {to.org_x, to.org_y, to.org_z, to.tnear,
                              to.dir_x, to.dir_y, to.dir_z, to.tfar};
    for (int i = 0; i < 8; ++i) {
#ifdef __AVX512DQ__
        _mm512_store_ps(places[i], _mm512_insertf32x8(_mm512_castps256_ps512(low[i]), high[i], 1));
#else
        _mm256_store_ps(places[i], low[i]);
        _mm256_store_ps(places[i] + 8, high[i]);
#endif
    }
}

/// The hits of eight lanes from the given one on.
template <class RayHits>
void get_hits(const RayHits& from, int lane, PlainHit* to) {
    const auto load = [&](const auto* place) {
        return _mm256_load_ps(reinterpret_cast<const float*>(place) + lane);
    };
    // The only geometry is number 0, and nothing hit is -1: one "or" puts it into the triangle.
    __m256 rows[8] = {
        load(from.ray.tfar), load(from.hit.u),
        load(from.hit.v),    _mm256_or_ps(load(from.hit.primID), load(from.hit.geomID)),
        load(from.hit.Ng_x), load(from.hit.Ng_y),
        load(from.hit.Ng_z), _mm256_setzero_ps()};
    transpose8(rows);
    for (int i = 0; i < 8; ++i) _mm256_storeu_ps(&to[i].t, rows[i]);
}

/// Calls body(rays, lanes, first) for each packet of rays; the last one is padded with rays that
/// its lanes switch off.
template <int kWidth, class Body>
void for_each_packet(std::span<const PlainRay> rays, const Body& body) {
    alignas(64) int lanes[kWidth];
    std::fill(lanes, lanes + kWidth, -1);
    std::size_t first = 0;
    for (; first + kWidth <= rays.size(); first += kWidth) body(rays.data() + first, lanes, first);
    if (first == rays.size()) return;
    PlainRay padded[kWidth] = {};
    std::copy(rays.begin() + static_cast<std::ptrdiff_t>(first), rays.end(), padded);
    std::fill(lanes + (rays.size() - first), lanes + kWidth, 0);
    body(padded, lanes, first);
}

template <int kWidth>
void closest_hits_in_packets(EmbreeCalls& calls, std::span<const PlainRay> rays, PlainHit* hits) {
    alignas(64) typename EmbreePacket<kWidth>::RayHits packet = {};
    set_constants(packet.ray);
    for_each_packet<kWidth>(rays, [&](const PlainRay* from, const int* lanes, std::size_t first) {
        set_rays(from, packet.ray);
        std::memset(packet.hit.geomID, 0xff, sizeof packet.hit.geomID);
        calls.closest(lanes, packet);
        if (first + kWidth <= rays.size()) {
            for (int lane = 0; lane < kWidth; lane += 8)
                get_hits(packet, lane, hits + first + lane);
            return;
        }
        PlainHit padded[kWidth];
        for (int lane = 0; lane < kWidth; lane += 8) get_hits(packet, lane, padded + lane);
        std::copy(padded, padded + (rays.size() - first), hits + first);
    });
}

template <int kWidth>
void any_hits_in_packets(EmbreeCalls& calls, std::span<const PlainRay> rays, std::uint8_t* hits) {
    alignas(64) typename EmbreePacket<kWidth>::Rays packet = {};
    set_constants(packet);
    for_each_packet<kWidth>(rays, [&](const PlainRay* from, const int* lanes, std::size_t first) {
        set_rays(from, packet);
        calls.any(lanes, packet);
        const std::size_t count = std::min<std::size_t>(kWidth, rays.size() - first);
        for (std::size_t i = 0; i < count; ++i) hits[first + i] = packet.tfar[i] < 0;
    });
}

}  // namespace boxwood::bench
