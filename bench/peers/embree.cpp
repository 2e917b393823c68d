// SPDX-License-Identifier: Apache-2.0
// Intel's ray tracing kernels, the fastest there were; BOXWOOD_EMBREE says which version.
#include <atomic>
#include <cstdlib>
#include <stdexcept>
#include <string_view>

#include "embree_packets.h"
#include "flush_denormals.h"

namespace boxwood::bench {

namespace {

class EmbreeTree : public Accelerator {
public:
    EmbreeTree(const std::string& isa, int threads) {
        const std::string config = "isa=" + isa + ",threads=" + std::to_string(threads);
        device_ = rtcNewDevice(config.c_str());
        if (!device_) throw std::runtime_error("Embree gives no device for " + config);
        rtcSetDeviceMemoryMonitorFunction(device_, count_bytes, this);
    }
    ~EmbreeTree() override {
        if (scene_) rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }
    EmbreeTree(const EmbreeTree&) = delete;
    EmbreeTree& operator=(const EmbreeTree&) = delete;

    void build(const PlainMesh& mesh, Quality quality) override {
        const FlushDenormals flush;
        const RTCBuildQuality qualities[] = {RTC_BUILD_QUALITY_LOW, RTC_BUILD_QUALITY_MEDIUM,
                                             RTC_BUILD_QUALITY_HIGH};
        const RTCBuildQuality of_embree = qualities[static_cast<int>(quality)];
        scene_ = rtcNewScene(device_);
        rtcSetSceneBuildQuality(scene_, of_embree);
        RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
        rtcSetGeometryBuildQuality(geometry, of_embree);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                   mesh.vertices.data(), 0, 3 * sizeof(float), mesh.vertex_count());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                   mesh.faces.data(), 0, 3 * sizeof(std::uint32_t),
                                   mesh.face_count());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_, geometry);
        rtcReleaseGeometry(geometry);
        rtcCommitScene(scene_);
    }

    std::size_t bytes() const override { return static_cast<std::size_t>(bytes_.load()); }

    void closest_hits(Mode mode, std::span<const PlainRay> rays, PlainHit* hits) const override {
        const FlushDenormals flush;
        EmbreeCalls calls(scene_, mode == Mode::coherent16);
        if (mode == Mode::packet8) return closest_hits_in_packets<8>(calls, rays, hits);
        if (mode != Mode::single) return closest_hits_in_packets<16>(calls, rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRayHit query;
            query.ray = as_embree(rays[i]);
            query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            query.hit.primID = kNoTriangle;
            calls.closest(query);
            hits[i] = {query.ray.tfar, query.hit.u,    query.hit.v,    query.hit.primID,
                       query.hit.Ng_x, query.hit.Ng_y, query.hit.Ng_z, 0};
        }
    }

    void any_hits(Mode mode, std::span<const PlainRay> rays, std::uint8_t* hits) const override {
        const FlushDenormals flush;
        EmbreeCalls calls(scene_, mode == Mode::coherent16);
        if (mode == Mode::packet8) return any_hits_in_packets<8>(calls, rays, hits);
        if (mode != Mode::single) return any_hits_in_packets<16>(calls, rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            RTCRay ray = as_embree(rays[i]);
            calls.any(ray);
            hits[i] = ray.tfar < 0;
        }
    }

private:
    static bool count_bytes(void* tree, ssize_t bytes, bool) {
        static_cast<EmbreeTree*>(tree)->bytes_ += bytes;
        return true;
    }

    static RTCRay as_embree(const PlainRay& ray) {
        RTCRay result;
        _mm_store_ps(&result.org_x, _mm_loadu_ps(&ray.ox));
        // The fourth is the time, of which only moving geometry makes use.
        _mm_store_ps(&result.dir_x, _mm_blend_ps(_mm_loadu_ps(&ray.dx), _mm_setzero_ps(), 8));
        result.tfar = ray.t_max;
        result.mask = ~0u;
        result.id = 0;
        result.flags = 0;
        return result;
    }

    RTCDevice device_;
    RTCScene scene_ = nullptr;
    std::atomic<ssize_t> bytes_ = 0;
};

class Embree : public Peer {
public:
    explicit Embree(std::string isa) : isa_(std::move(isa)) {}

    std::string library() const override { return "embree" + std::to_string(BOXWOOD_EMBREE); }
    std::string name() const override { return library() + " " + isa_; }
    std::vector<Mode> modes() const override {
        return {Mode::single, Mode::packet8, Mode::packet16, Mode::coherent16};
    }
    std::unique_ptr<Accelerator> make(int threads) const override {
        return std::make_unique<EmbreeTree>(isa_, threads);
    }

private:
    std::string isa_;
};

}  // namespace

}  // namespace boxwood::bench

/// One peer an instruction set that the machine has and the environment allows.
extern "C" void boxwood_bench_add_peers(boxwood::bench::Peers& peers) {
    const char* forced = std::getenv("BOXWOOD_ISA");
    const auto allows = [&](std::string_view isa) { return !forced || forced == isa; };
    if (__builtin_cpu_supports("avx512dq") && allows("avx512"))
        peers.push_back(std::make_unique<boxwood::bench::Embree>("avx512"));
    if (__builtin_cpu_supports("avx2") && allows("avx2"))
        peers.push_back(std::make_unique<boxwood::bench::Embree>("avx2"));
}
