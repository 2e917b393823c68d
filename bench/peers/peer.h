// SPDX-License-Identifier: Apache-2.0
// What a benchmark knows of each library it compares: build over plain arrays, trace plain rays.
// Turning the plain arrays into what the library wants, and its answers back, is part of the time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace boxwood::bench {

/// The points (ox, oy, oz) + t (dx, dy, dz) with t_min <= t <= t_max.
struct PlainRay {
    float ox, oy, oz, t_min;
    float dx, dy, dz, t_max;
};

/// The closest hit, at (1 - u - v) a + u b + v c; (nx, ny, nz) is normal to the triangle, of any
/// length and to either side. When nothing is hit the triangle is kNoTriangle and the rest is void.
struct PlainHit {
    float t, u, v;
    std::uint32_t triangle;
    float nx, ny, nz, unused;
};

static_assert(sizeof(PlainRay) == 32 && sizeof(PlainHit) == 32);

/// A point that the nearest one of a mesh is asked for.
struct PlainPoint {
    double x, y, z;
};

/// The nearest point, and how far it is: with signs, negative inside the mesh.
struct PlainNearest {
    PlainPoint point;
    double distance;
    std::uint32_t triangle;
};

inline constexpr std::uint32_t kNoTriangle = std::numeric_limits<std::uint32_t>::max();

/// Three floats a vertex, three indices a face. Sixteen bytes after the last vertex may be read.
struct PlainMesh {
    std::span<const float> vertices;
    std::span<const std::uint32_t> faces;

    std::size_t vertex_count() const { return vertices.size() / 3; }
    std::size_t face_count() const { return faces.size() / 3; }
};

/// What a peer spends on a tree: Embree's LOW, MEDIUM and HIGH; our fast, balanced and best.
enum class Quality { low, medium, high };

/// How many rays a library is asked at a time.
enum class Mode {
    single,      ///< one
    packet8,     ///< packets of eight
    packet16,    ///< packets of sixteen
    coherent16,  ///< packets of sixteen, told that the rays are alike
    batch        ///< all of them
};

/// A tree over one mesh, first empty. Rays may be traced from several threads at once.
class Accelerator {
public:
    virtual ~Accelerator() = default;

    /// Precondition: the arrays outlive the accelerator.
    virtual void build(const PlainMesh& mesh, Quality quality) = 0;

    /// What the tree holds on to, the mesh's own arrays left out; 0 when the peer doesn't tell.
    virtual std::size_t bytes() const { return 0; }

    virtual void closest_hits(Mode mode, std::span<const PlainRay> rays, PlainHit* hits) const = 0;
    /// Writes 1 for a ray that hits anything, else 0.
    virtual void any_hits(Mode mode, std::span<const PlainRay> rays, std::uint8_t* hits) const = 0;

    /// Whether it tells distances; else what follows isn't called.
    virtual bool tells_distances() const { return false; }
    /// With signs, distances are negative inside: the first call for them may prepare that.
    virtual void nearest(Mode, bool /*signs*/, std::span<const PlainPoint>, PlainNearest*) {}
};

/// A library, held to one instruction set where it has several.
class Peer {
public:
    virtual ~Peer() = default;

    virtual std::string library() const = 0;  ///< "embree3"
    virtual std::string name() const = 0;     ///< "embree3 avx2"
    virtual std::vector<Mode> modes() const { return {Mode::single}; }
    virtual std::vector<Quality> qualities() const {
        return {Quality::low, Quality::medium, Quality::high};
    }
    /// An empty accelerator that builds on that many threads. Not timed.
    virtual std::unique_ptr<Accelerator> make(int threads) const = 0;
};

/// On how many threads trees are built of which only the rays are timed. Not on one: for a device
/// of one thread the oneTBB that comes with Embree 4 keeps a second one spinning as long as the
/// device is there (its issue 1417), which disturbs whoever traces.
inline constexpr int kUntimedThreads = 2;

using Peers = std::vector<std::unique_ptr<Peer>>;

}  // namespace boxwood::bench

/// What a peer that is a module of its own exports: adds its peers to the list.
extern "C" __attribute__((visibility("default"))) void boxwood_bench_add_peers(
    boxwood::bench::Peers& peers);
