# SPDX-License-Identifier: Apache-2.0
"""boxwood.meshio with meshio's own meshes."""

from __future__ import annotations

import numpy as np
import pytest

import boxwood as bw
from boxwood.meshio import from_meshio, to_meshio

meshio = pytest.importorskip("meshio")

SQUARE = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]


def test_triangles_and_quads_become_triangles_with_the_values_of_their_cells():
    mesh = from_meshio(
        meshio.Mesh(
            [*SQUARE, [2, 0, 0]],
            [("quad", [[0, 1, 2, 3]]), ("triangle", [[1, 4, 2]])],
            point_data={"height": np.arange(5.0)},
            cell_data={"number": [[7], [8]]},
        )
    )
    assert mesh.faces.tolist() == [[0, 1, 2], [0, 2, 3], [1, 4, 2]]
    assert mesh.fields["number"].values.tolist() == [7, 7, 8]
    assert mesh.fields["number"].of == "faces"
    assert mesh.fields["height"].values.tolist() == [0, 1, 2, 3, 4]


def test_polygons_become_fans():
    pentagon = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 2, 0], [0, 1, 0]]
    mesh = from_meshio(meshio.Mesh(pentagon, [("polygon", [[0, 1, 2, 3, 4]])]))
    assert mesh.inspect()["area"] == 3


def test_points_in_the_plane_get_a_height_of_0():
    mesh = from_meshio(meshio.Mesh([[0, 0], [1, 0], [0, 1]], [("triangle", [[0, 1, 2]])]))
    assert mesh.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]


def test_other_cells_are_left_out_with_a_warning():
    cells = [("line", [[0, 1]]), ("triangle", [[0, 1, 2]])]
    given = meshio.Mesh(SQUARE, cells, cell_data={"number": [[1], [2]]})
    with pytest.warns(bw.MeshWarning, match="left out: line"):
        mesh = from_meshio(given)
    assert mesh.faces.tolist() == [[0, 1, 2]] and mesh.fields["number"].values.tolist() == [2]


def test_other_cells_alone_are_refused():
    with pytest.raises(ValueError, match="found tetra, expected triangle"):
        from_meshio(meshio.Mesh(SQUARE, [("tetra", [[0, 1, 2, 3]])]))


def test_a_field_of_faces_gives_way_to_one_of_vertices():
    triangle = [("triangle", [[0, 1, 2]])]
    mesh = from_meshio(
        meshio.Mesh(SQUARE[:3], triangle, point_data={"a": [1, 2, 3]}, cell_data={"a": [[4]]})
    )
    assert mesh.fields["a"].of == "vertices"
    assert mesh.fields["a of faces"].values.tolist() == [4]


def test_meshes_come_back_from_a_file(tmp_path):
    mesh = bw.generate("icosphere", 320)
    mesh.fields["height"] = bw.Attribute(mesh.vertices[:, 2])
    mesh.fields["number"] = bw.Attribute(np.arange(len(mesh.faces)), "faces")
    to_meshio(mesh).write(tmp_path / "ball.vtk")
    back = from_meshio(meshio.read(tmp_path / "ball.vtk"))
    assert (back.vertices == mesh.vertices).all() and (back.faces == mesh.faces).all()
    assert (back.fields["height"].values == mesh.vertices[:, 2]).all()
    assert (back.fields["number"].values == np.arange(len(mesh.faces))).all()


def test_no_cells_are_an_empty_mesh():
    assert len(from_meshio(meshio.Mesh(np.empty((0, 3)), [])).faces) == 0
