// SPDX-License-Identifier: Apache-2.0
#include "read_obj.h"

#include <charconv>

#include "boxwood/core/error.h"
#include "boxwood/core/files.h"
#include "boxwood/mesh/text_scanner.h"

namespace boxwood::bench {

TriangleMesh read_obj(const std::filesystem::path& path) {
    const MappedFile file(path);
    TextScanner scanner(file.text());
    TriangleMesh mesh;
    std::vector<int> corners;
    for (; scanner.find_word(); scanner.finish_line()) {
        const std::string_view key = scanner.word();
        if (key == "v") {
            Vec3d vertex;
            for (double& coordinate : vertex) coordinate = scanner.number().value_or(0);
            mesh.vertices.push_back(vertex);
        } else if (key == "f") {
            corners.clear();
            while (!scanner.at_end_of_line()) {
                // "vertex/texture/normal", counted from 1, or from the last vertex when negative.
                const std::string_view word = scanner.word();
                int index = 0;
                std::from_chars(word.data(), word.data() + word.size(), index);
                const int count = static_cast<int>(mesh.vertices.size());
                corners.push_back(index < 0 ? count + index : index - 1);
                if (corners.back() < 0 || corners.back() >= count)
                    throw ParseError(path.string(), scanner.line(),
                                     "found the corner " + quoted(word) +
                                         ", expected the number of a vertex above");
            }
            for (std::size_t k = 2; k < corners.size(); ++k)
                mesh.faces.emplace_back(corners[0], corners[k - 1], corners[k]);
        }
    }
    return mesh;
}

}  // namespace boxwood::bench
