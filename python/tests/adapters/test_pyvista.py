# SPDX-License-Identifier: Apache-2.0
"""boxwood.pyvista with PyVista's own meshes."""

from __future__ import annotations

import numpy as np
import pytest

import boxwood as bw
from boxwood.pyvista import from_polydata, to_polydata

pyvista = pytest.importorskip("pyvista", exc_type=ImportError)


def test_a_sphere_can_be_asked():
    sphere = pyvista.Sphere(radius=2.0)
    mesh = from_polydata(sphere)
    assert len(mesh.vertices) == sphere.n_points and len(mesh.faces) == sphere.n_cells
    assert mesh.vertices.dtype == np.float32 and mesh.normals is not None
    assert float(bw.Scene(mesh).closest_hit([0, 0.01, 9], [0, 0, -1]).t) == pytest.approx(
        7, abs=0.1
    )


def test_polygons_become_triangles_with_the_values_of_their_cells():
    cube = pyvista.Cube()
    cube.cell_data["number"] = np.arange(6)
    mesh = from_polydata(cube)
    assert len(mesh.faces) == 12
    assert sorted(mesh.fields["number"].values.tolist()) == sorted([*range(6), *range(6)])


@pytest.mark.filterwarnings("error")
def test_lines_are_left_out_with_their_values():
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], float)
    both = pyvista.PolyData(points, faces=[3, 0, 1, 2], lines=[2, 0, 1])
    both.cell_data["number"] = [7, 8]
    mesh = from_polydata(both)
    assert mesh.faces.tolist() == [[0, 1, 2]] and mesh.fields["number"].values.tolist() == [8]


@pytest.mark.filterwarnings("error")
def test_strips_become_triangles():
    sphere = pyvista.Sphere()
    mesh = from_polydata(sphere.strip())
    assert mesh.inspect()["closed"] and len(mesh.faces) == sphere.n_cells


def test_fields_and_colors_come_back():
    mesh = bw.generate("icosphere", 320)
    mesh.fields["height"] = bw.Attribute(mesh.vertices[:, 2])
    mesh.fields["number"] = bw.Attribute(np.arange(len(mesh.faces)), "faces")
    mesh.colors = bw.Attribute(np.tile([0.2, 0.4, 0.6, 1.0], (len(mesh.vertices), 1)))
    mesh.normals = bw.Attribute(mesh.vertices.astype(np.float32))
    polydata = to_polydata(mesh)
    assert polydata.is_all_triangles and polydata.point_data["RGBA"].dtype == np.uint8
    back = from_polydata(polydata)
    assert (back.vertices == mesh.vertices).all() and (back.faces == mesh.faces).all()
    assert (back.fields["height"].values == mesh.vertices[:, 2]).all()
    assert back.fields["number"].of == "faces"
    assert np.allclose(back.colors.values, mesh.colors.values)
    assert (back.normals.values == mesh.normals.values).all()


def test_colors_of_faces_come_back():
    mesh = bw.generate("icosphere", 320)
    mesh.colors = bw.Attribute(np.tile([0.2, 0.4, 0.6, 1.0], (len(mesh.faces), 1)), "faces")
    back = from_polydata(to_polydata(mesh))
    assert back.colors.of == "faces" and np.allclose(back.colors.values, mesh.colors.values)


def test_an_empty_mesh_stays_empty():
    assert len(from_polydata(pyvista.PolyData()).faces) == 0
