// SPDX-License-Identifier: Apache-2.0
#include "differential/exceptions.h"

namespace boxwood {

namespace {

struct Exception {
    std::string_view file, difference, reason;
};

constexpr Exception kExceptions[] = {
    {"assimp/glTF/BoxTextured-glTF/BoxTextured.gltf", "only assimp reads it", "glTF 1.0"},
    {"assimp/glTF/TwoBoxes/TwoBoxes.gltf", "only assimp reads it", "glTF 1.0"},
    {"assimp/glTF/BoxTextured-glTF-Embedded/BoxTextured.gltf", "only assimp reads it", "glTF 1.0"},
    {"assimp/glTF/IncorrectVertexArrays/Cube_v1.gltf", "only assimp reads it", "glTF 1.0"},
    {"assimp/glTF/CesiumMilkTruck/CesiumMilkTruck.gltf", "only assimp reads it", "glTF 1.0"},
    {"assimp/glTF/BoxTextured-glTF-MaterialsCommon/BoxTextured.gltf", "only assimp reads it",
     "glTF 1.0"},
    {"assimp/glTF/BoxTextured-glTF-Binary/BoxTextured.glb", "neither reads it", "glTF 1.0"},
    {"assimp/OFF/invalid.off", "only assimp reads it", "has fewer lines than its header says"},
    {"assimp/invalid/empty.off", "neither reads it", "empty"},
    {"assimp/invalid/empty.ply", "neither reads it", "empty"},
    {"assimp/invalid/empty.obj", "neither reads it", "empty"},
    {"assimp/invalid/malformed.obj", "neither reads it", "broken on purpose"},
    {"assimp/invalid/OutOfMemory.off", "neither reads it",
     "counts beyond the file; assimp takes the memory and fails an assertion"},
    {"assimp/PLY/Wuson.ply", "only assimp reads it", "a line of the header lacks the word comment"},
    {"assimp/PLY/pond.0.ply", "only assimp reads it", "69 bytes short of what its header says"},
    {"assimp/PLY/issue623.ply", "only assimp reads it",
     "no line says that the faces begin; assimp guesses"},
    {"assimp/glTF2/draco/2CylinderEngine.gltf", "only assimp reads it", "requires Draco"},
    {"assimp/glTF2/BoxTextured-glTF-techniqueWebGL/BoxTextured.gltf", "only assimp reads it",
     "requires shaders; assimp ignores what is required"},
    {"assimp/glTF2/TestNoRootNode/NoScene.gltf", "neither reads it", "no meshes"},
    {"assimp/glTF2/SchemaFailures/sceneWrongType.gltf", "neither reads it",
     "a scene that is no number"},
    {"assimp/glTF2/IndexOutOfRange/IndexOutOfRange.gltf", "only assimp reads it",
     "an index out of range; assimp drops the face"},
    {"assimp/glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf", "neither reads it",
     "indices out of range"},
    {"assimp/glTF2/issue_3269/texcoord_crash.gltf", "only Boxwood reads it",
     "texture coordinates 1 without 0, which triangles do not need"},
    {"assimp/glTF2/wrongTypes/badNumber.gltf", "only Boxwood reads it",
     "the wrong type is where triangles do not depend on it"},
    {"assimp/glTF2/wrongTypes/badExtension.gltf", "only Boxwood reads it",
     "the wrong type is where triangles do not depend on it"},
    {"assimp/glTF2/wrongTypes/badObject.gltf", "only Boxwood reads it",
     "the wrong type is where triangles do not depend on it"},
    {"assimp/glTF2/wrongTypes/badUint.gltf", "only Boxwood reads it",
     "the wrong type is where triangles do not depend on it"},
    {"assimp/glTF2/wrongTypes/badString.gltf", "only Boxwood reads it",
     "the wrong type is where triangles do not depend on it"},
    {"assimp/glTF2/wrongTypes/badArray.gltf", "neither reads it", "a wrong type"},
    {"assimp/glTF2/RecursiveNodes/RecursiveNodes.gltf", "neither reads it", "nodes in a circle"},
    {"assimp/glTF2/MissingBin/BoxTextured.gltf", "neither reads it", "its buffer is not there"},
    {"assimp/OBJ/number_formats.obj", "only assimp reads it",
     "3.1+e2 is no number; assimp takes 3.1"},
    {"assimp/OBJ/box_UTF16BE.obj", "only assimp reads it", "UTF-16"},
    {"cgal/prim.off", "triangles: 12 and 8", "assimp takes comments among the faces for faces"},
    {"cgal/mesh_with_colors.off", "only Boxwood reads it",
     "comments behind numbers and before the keyword"},
    {"cgal/mpi.off", "triangles: 180 and 148", "assimp drops polygons of more than nine corners"},
    {"cgal/cube4-shuffled.off", "triangles: 12 and 8",
     "assimp takes comments among the faces for faces"},
    {"cgal/cube_poly.off", "triangles: 12 and 10",
     "assimp takes comments among the faces for faces"},
    {"cgal/cube-shuffled.off", "triangles: 12 and 10",
     "assimp takes comments among the faces for faces"},
    {"cgal/mpi_triang.off", "triangles: 180 and 178",
     "assimp takes comments among the faces for faces"},
    {"cgal/oblong-shuffled.off", "triangles: 840 and 838",
     "assimp takes comments among the faces for faces"},
    {"cgal/sphere966.off", "triangles: 1848 and 1846",
     "assimp takes comments among the faces for faces"},
    {"cgal/blobby-shuffled.off", "triangles: 4050 and 4048",
     "assimp takes comments among the faces for faces"},
};

}  // namespace

std::string_view expected_difference(std::string_view file) {
    for (const Exception& exception : kExceptions)
        if (exception.file == file) return exception.difference;
    return "same";
}

}  // namespace boxwood
