# SPDX-License-Identifier: Apache-2.0
"""Meshes from and to PyVista.

For example:

    from boxwood.pyvista import from_polydata, to_polydata

    scene = boxwood.Scene(from_polydata(pyvista.read("part.vtp")))
    to_polydata(mesh).plot(scalars="thickness")
"""

from __future__ import annotations

from typing import Any

import numpy as np

from ._adapters import add_fields, colors_from_bytes, colors_to_bytes, fields_of
from ._mesh import Attribute, Mesh

_COLORS = ("RGBA", "RGB")
_NORMALS = "Normals"


def from_polydata(polydata: Any) -> Mesh:
    """A Mesh of a pyvista.PolyData; of other data take `extract_surface()`. Polygons become
    triangles; lines and single points are left out. What has one number for each point or cell
    becomes a field, RGB and RGBA colors, and Normals of points normals."""
    triangles = _surface(polydata)
    if not triangles.is_all_triangles:
        triangles = triangles.triangulate()
    result = Mesh(np.array(triangles.points), np.array(triangles.regular_faces))
    points, cells = triangles.point_data, triangles.cell_data
    add_fields(result, "vertices", dict(points.items()))
    add_fields(result, "faces", dict(cells.items()))
    for name in _COLORS:
        if name in points:
            result.colors = colors_from_bytes(np.asarray(points[name]), "vertices")
        elif name in cells:
            result.colors = colors_from_bytes(np.asarray(cells[name]), "faces")
    if _NORMALS in points:
        result.normals = Attribute(np.array(points[_NORMALS]), "vertices")
    return result


def to_polydata(mesh: Mesh) -> Any:
    """A pyvista.PolyData of a Mesh: fields of vertices and faces, colors as RGBA, normals as
    Normals. What belongs to corners stays behind."""
    import pyvista

    result = pyvista.PolyData.from_regular_faces(np.array(mesh.vertices), np.array(mesh.faces))
    result.point_data.update(fields_of(mesh, "vertices"))
    result.cell_data.update(fields_of(mesh, "faces"))
    if mesh.colors is not None and mesh.colors.of != "corners":
        data = result.point_data if mesh.colors.of == "vertices" else result.cell_data
        data["RGBA"] = colors_to_bytes(mesh.colors)
    if mesh.normals is not None and mesh.normals.of == "vertices":
        result.point_data[_NORMALS] = np.asarray(mesh.normals.values)
    return result


def _surface(polydata: Any) -> Any:
    """The polygons and strips, which VTK counts after points and lines."""
    first = polydata.n_verts + polydata.n_lines
    if first == 0:
        return polydata
    result = type(polydata)()
    result.points = polydata.points
    result.faces, result.strips = polydata.faces, polydata.strips
    result.point_data.update(polydata.point_data)
    for name, values in polydata.cell_data.items():
        # PyVista would take a slice for the whole.
        result.cell_data[name] = np.array(values[first:])
    return result
