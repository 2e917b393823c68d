# SPDX-License-Identifier: Apache-2.0
"""Meshes from and to meshio, which reads many formats of the finite-element world.

For example:

    from boxwood.meshio import from_meshio, to_meshio

    mesh = from_meshio(meshio.read("plate.msh"))
    to_meshio(mesh).write("plate.vtu")
"""

from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._adapters import add_fields, fields_of
from ._mesh import Mesh, MeshWarning

_PLANE = ("triangle", "quad", "polygon")


def from_meshio(mesh: Any) -> Mesh:
    """A Mesh of the triangles, quads and polygons of a meshio.Mesh. Quads and polygons are cut from
    their first corner on. Other cells are left out with a MeshWarning; points in the plane get
    z = 0. What has one number for each point or cell becomes a field.

    Raises ValueError where there are other cells alone.
    """
    points = np.asarray(mesh.points, dtype=np.float64)
    points = np.pad(points, ((0, 0), (0, 3 - points.shape[1])))
    chosen = [i for i, cells in enumerate(mesh.cells) if cells.type in _PLANE]
    others = sorted({cells.type for cells in mesh.cells if cells.type not in _PLANE})
    if others and not chosen:
        raise ValueError(f"cells: found {', '.join(others)}, expected {', '.join(_PLANE)}")
    if others:
        warnings.warn(f"cells left out: {', '.join(others)}", MeshWarning, stacklevel=2)
    blocks = [np.asarray(mesh.cells[i].data) for i in chosen]
    faces = [_triangles(block) for block in blocks]
    result = Mesh(points, np.concatenate([np.empty((0, 3), np.int64), *faces]))
    add_fields(result, "vertices", mesh.point_data)
    repeats = {i: block.shape[1] - 2 for i, block in zip(chosen, blocks, strict=True)}
    of_faces = {
        name: np.concatenate([np.repeat(values[i], repeats[i], axis=0) for i in chosen])
        for name, values in mesh.cell_data.items()
        if chosen
    }
    add_fields(result, "faces", of_faces)
    return result


def to_meshio(mesh: Mesh) -> Any:
    """A meshio.Mesh of a Mesh, with its fields of vertices and faces."""
    import meshio

    return meshio.Mesh(
        np.array(mesh.vertices),
        [("triangle", np.array(mesh.faces))],
        point_data=fields_of(mesh, "vertices"),
        cell_data={name: [values] for name, values in fields_of(mesh, "faces").items()},
    )


def _triangles(cells: NDArray[Any]) -> NDArray[np.int64]:
    """Cells (n, k) as (n (k - 2), 3) triangles, those of a cell one after another."""
    k = cells.shape[1]
    fan = [cells[:, [0, i, i + 1]] for i in range(1, k - 1)]
    return np.stack(fan, axis=1).reshape(-1, 3).astype(np.int64)
