// SPDX-License-Identifier: Apache-2.0
#include "boxwood/mesh/repair.h"

namespace boxwood {

std::span<const Named<RepairStep>> repair_steps() {
    static constexpr Named<RepairStep> kSteps[] = {
        {"weld", RepairStep::weld},
        {"drop-degenerate", RepairStep::drop_degenerate},
        {"orient", RepairStep::orient},
    };
    return kSteps;
}

RepairReport repair(MeshData& mesh, std::span<const RepairStep> steps) {
    RepairReport report;
    for (const RepairStep step : steps) {
        switch (step) {
            case RepairStep::weld:
                report.welded_vertices += weld_vertices(mesh);
                break;
            case RepairStep::drop_degenerate:
                report.dropped_faces += drop_degenerate_faces(mesh);
                break;
            case RepairStep::orient: {
                const RepairReport turned = orient_faces(mesh);
                report.flipped_faces += turned.flipped_faces;
                report.unorientable_components = turned.unorientable_components;
                break;
            }
        }
    }
    return report;
}

}  // namespace boxwood
