// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nanobind/nanobind.h>

#include <atomic>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "arrays.h"
#include "boxwood/scene/scene.h"
#include "boxwood/scene/scene_sign.h"

namespace boxwood::python {

/// Lets any number of queries in, or one change: whoever comes at the wrong time is turned away.
/// Waiting would be a trap, as a query may call back into Python.
class Gate {
public:
    class Query {
    public:
        explicit Query(Gate& gate) : gate_(gate) {
            int queries = gate_.queries_.load();
            do {
                if (queries < 0)
                    throw std::runtime_error("the scene is being changed by another thread");
            } while (!gate_.queries_.compare_exchange_weak(queries, queries + 1));
        }
        ~Query() { --gate_.queries_; }
        Query(const Query&) = delete;
        Query& operator=(const Query&) = delete;

    private:
        Gate& gate_;
    };

    class Change {
    public:
        explicit Change(Gate& gate) : gate_(gate) {
            int queries = 0;
            if (!gate_.queries_.compare_exchange_strong(queries, kChanging))
                throw std::runtime_error("the scene can't be changed while queries run on it");
        }
        ~Change() { gate_.queries_ = 0; }
        Change(const Change&) = delete;
        Change& operator=(const Change&) = delete;

    private:
        Gate& gate_;
    };

private:
    static constexpr int kChanging = -1;
    std::atomic<int> queries_ = 0;
};

/// A scene with the arrays that it refers to, and what telling inside from outside took once.
class PyScene {
public:
    /// Vertices are arrays in double or in float, faces int32 that nobody else can write to.
    PyScene(const List& vertices, const List& faces, const std::vector<bool>& culls,
            const Values<std::uint32_t>& mesh_of_instance, const Transforms& transforms,
            const Values<std::uint32_t>& visibilities, const std::string& preset,
            const std::optional<std::string>& method, const std::string& cost, bool brute_force);
    /// One from a file.
    PyScene(const std::filesystem::path& path, bool trust);

    void save(const std::filesystem::path& path) const;
    std::vector<double> refit();
    void set_instances(const Values<std::uint32_t>& mesh_of_instance, const Transforms& transforms,
                       const Values<std::uint32_t>& visibilities);

    const Scene& scene() const { return *scene_; }
    /// Made when it is asked for first.
    const SceneSign& sign(const std::string& method, double accuracy) const;

    mutable Gate gate;

private:
    struct KeptSign {
        std::string method;
        double accuracy;
        SceneSign sign;
    };

    std::vector<nb::object> arrays_;
    std::unique_ptr<Scene> scene_;
    mutable std::mutex signs_mutex_;
    mutable std::vector<std::unique_ptr<KeptSign>> signs_;
};

// The queries; each writes into arrays with one place for each ray, point or shape.
void bind_hits(nb::module_& module, nb::class_<PyScene>& scene);
void bind_float_hits(nb::module_& module, nb::class_<PyScene>& scene);
void bind_distances(nb::class_<PyScene>& scene);
void bind_overlaps(nb::class_<PyScene>& scene);

}  // namespace boxwood::python
