// SPDX-License-Identifier: Apache-2.0
// The two versions of Embree differ in how a query is told what it may assume of its rays. Here
// they look the same; the rest of the peer is one source, compiled once a version.
#pragma once

#if BOXWOOD_EMBREE == 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace boxwood::bench {

#if BOXWOOD_EMBREE == 4

class EmbreeCalls {
public:
    EmbreeCalls(RTCScene scene, bool coherent) : scene_(scene) {
        rtcInitIntersectArguments(&closest_);
        rtcInitOccludedArguments(&any_);
        closest_.flags = any_.flags =
            coherent ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
    }
    void closest(RTCRayHit& ray) { rtcIntersect1(scene_, &ray, &closest_); }
    void closest(const int* lanes, RTCRayHit8& r) { rtcIntersect8(lanes, scene_, &r, &closest_); }
    void closest(const int* lanes, RTCRayHit16& r) { rtcIntersect16(lanes, scene_, &r, &closest_); }
    void any(RTCRay& ray) { rtcOccluded1(scene_, &ray, &any_); }
    void any(const int* lanes, RTCRay8& rays) { rtcOccluded8(lanes, scene_, &rays, &any_); }
    void any(const int* lanes, RTCRay16& rays) { rtcOccluded16(lanes, scene_, &rays, &any_); }

private:
    RTCScene scene_;
    RTCIntersectArguments closest_;
    RTCOccludedArguments any_;
};

#else

class EmbreeCalls {
public:
    EmbreeCalls(RTCScene scene, bool coherent) : scene_(scene) {
        rtcInitIntersectContext(&context_);
        context_.flags =
            coherent ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
    }
    void closest(RTCRayHit& ray) { rtcIntersect1(scene_, &context_, &ray); }
    void closest(const int* lanes, RTCRayHit8& r) { rtcIntersect8(lanes, scene_, &context_, &r); }
    void closest(const int* lanes, RTCRayHit16& r) { rtcIntersect16(lanes, scene_, &context_, &r); }
    void any(RTCRay& ray) { rtcOccluded1(scene_, &context_, &ray); }
    void any(const int* lanes, RTCRay8& rays) { rtcOccluded8(lanes, scene_, &context_, &rays); }
    void any(const int* lanes, RTCRay16& rays) { rtcOccluded16(lanes, scene_, &context_, &rays); }

private:
    RTCScene scene_;
    RTCIntersectContext context_;
};

#endif

}  // namespace boxwood::bench
