// SPDX-License-Identifier: Apache-2.0
#include "cli/mesh_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <nlohmann/json.hpp>

#include "cli/mesh_repair.h"

namespace boxwood::cli {

namespace {

using Json = nlohmann::ordered_json;

std::array<double, 3> as_array(const Vec3d& v) { return {v.x(), v.y(), v.z()}; }

Json as_json(const Warnings& warnings) {
    Json json = Json::array();
    for (const Warning& warning : warnings.kinds())
        json.push_back({{"kind", warning.kind}, {"count", warning.count}});
    return json;
}

Json as_json(const RepairReport& repair) {
    return {{"welded_vertices", repair.welded_vertices},
            {"dropped_faces", repair.dropped_faces},
            {"flipped_faces", repair.flipped_faces},
            {"unorientable_components", repair.unorientable_components}};
}

template <class Value>
void print_line(const char* label, const Value& value) {
    fmt::print("{:<18}{}\n", label, value);
}

}  // namespace

Json as_json(const MeshInfo& info) {
    const MeshReport& mesh = info.report;
    Json json = {
        {"format", nullptr},
        {"vertices", mesh.vertices},
        {"faces", mesh.faces},
        {"bounds", nullptr},
        {"area", mesh.area},
        {"volume", nullptr},
        {"closed", mesh.closed},
        {"components", mesh.components},
        {"nonfinite_vertices", mesh.nonfinite_vertices},
        {"duplicate_vertices", mesh.duplicate_vertices},
        {"unreferenced_vertices", mesh.unreferenced_vertices},
        {"degenerate_faces", mesh.degenerate_faces},
        {"duplicate_faces", mesh.duplicate_faces},
        {"boundary_edges", mesh.boundary_edges},
        {"boundary_loops", mesh.boundary_loops},
        {"nonmanifold_edges", mesh.nonmanifold_edges},
        {"flipped_edges", mesh.flipped_edges},
        {"attributes", info.attributes},
        {"warnings", as_json(info.warnings)},
    };
    if (!info.format.empty()) json["format"] = info.format;
    if (!mesh.bounds.is_empty())
        json["bounds"] = {{"lo", as_array(mesh.bounds.lo)}, {"hi", as_array(mesh.bounds.hi)}};
    if (mesh.volume) json["volume"] = *mesh.volume;
    if (info.repair) json["repair"] = as_json(*info.repair);
    return json;
}

void print_text(const MeshInfo& info) {
    const MeshReport& mesh = info.report;
    if (!info.format.empty()) print_line("format", info.format);
    if (info.repair) print_line("repair", text_of(*info.repair));
    print_line("vertices", fmt::format("{}, {} duplicate, {} unreferenced, {} not finite",
                                       mesh.vertices, mesh.duplicate_vertices,
                                       mesh.unreferenced_vertices, mesh.nonfinite_vertices));
    print_line("faces", fmt::format("{}, {} degenerate, {} duplicate", mesh.faces,
                                    mesh.degenerate_faces, mesh.duplicate_faces));
    const Vec3d &lo = mesh.bounds.lo, &hi = mesh.bounds.hi;
    if (!mesh.bounds.is_empty())
        fmt::print("{:<18}[{:.6g}, {:.6g}, {:.6g}] to [{:.6g}, {:.6g}, {:.6g}]\n", "bounds", lo.x(),
                   lo.y(), lo.z(), hi.x(), hi.y(), hi.z());
    print_line("area", fmt::format("{:.6g}", mesh.area));
    print_line("volume", mesh.volume   ? fmt::format("{:.6g}", *mesh.volume)
                         : mesh.closed ? "none, as edges are flipped"
                                       : "none, as it isn't closed");
    print_line("closed", mesh.closed ? "yes"
                                     : fmt::format("no, {} boundary edges in {} loops and {} "
                                                   "non-manifold edges",
                                                   mesh.boundary_edges, mesh.boundary_loops,
                                                   mesh.nonmanifold_edges));
    print_line("flipped edges", mesh.flipped_edges);
    print_line("components", mesh.components);
    if (!info.attributes.empty())
        print_line("attributes", fmt::format("{}", fmt::join(info.attributes, ", ")));
}

}  // namespace boxwood::cli
