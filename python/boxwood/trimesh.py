# SPDX-License-Identifier: Apache-2.0
"""Boxwood behind trimesh: a ray object that takes the place of trimesh's own.

For example:

    from boxwood.trimesh import RayMeshIntersector

    mesh.ray = RayMeshIntersector(mesh)
    mesh.ray.intersects_first(origins, directions)
    mesh.contains(points)
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._adapters import add_fields, colors_from_bytes, colors_to_bytes, fields_of, sign_method
from ._mesh import Mesh
from ._scene import Scene

Indices = NDArray[np.int64]
Points = NDArray[np.float64]


class RayMeshIntersector:
    """Answers what `trimesh.ray.ray_triangle.RayMeshIntersector` answers, exactly and in double.
    The tree is built by the first question, and again when the mesh has changed.

    geometry: a trimesh.Trimesh.
    scale_to_box: for Embree's sake; nothing here needs it.
    """

    def __init__(self, geometry: Any, scale_to_box: bool = True) -> None:
        self.mesh = geometry
        self._scene: Scene | None = None
        self._hash: int | None = None

    @property
    def scene(self) -> Scene:
        """The mesh as a boxwood.Scene, which can answer more."""
        now = hash(self.mesh)
        if self._scene is None or now != self._hash:
            self._scene = Scene(_geometry(self.mesh))
            self._hash = now
        return self._scene

    def intersects_id(
        self,
        ray_origins: ArrayLike,
        ray_directions: ArrayLike,
        multiple_hits: bool = True,
        max_hits: int | None = None,
        return_locations: bool = False,
        **_: Any,
    ) -> tuple[Indices, Indices] | tuple[Indices, Indices, Points]:
        """The hits of rays, in their order, and of one ray by distance: arrays of triangles (h,)
        and of rays (h,), and places (h, 3) if return_locations.

        ray_origins, ray_directions: arrays (n, 3).
        multiple_hits: all hits of each ray, one for each crossing of the surface, on edges too,
            or the first one.
        max_hits: at most so many of each ray.
        """
        triangle, ray, location = self._hits(ray_origins, ray_directions, multiple_hits, max_hits)
        return (triangle, ray, location) if return_locations else (triangle, ray)

    def intersects_location(
        self,
        ray_origins: ArrayLike,
        ray_directions: ArrayLike,
        multiple_hits: bool = True,
        max_hits: int | None = None,
        **_: Any,
    ) -> tuple[Points, Indices, Indices]:
        """The hits of `intersects_id` as places (h, 3), rays (h,) and triangles (h,)."""
        triangle, ray, location = self._hits(ray_origins, ray_directions, multiple_hits, max_hits)
        return location, ray, triangle

    def intersects_first(
        self, ray_origins: ArrayLike, ray_directions: ArrayLike, **_: Any
    ) -> Indices:
        """The first triangle (n,) that each ray hits; -1 for none."""
        origins, directions = _rays(ray_origins, ray_directions)
        return self.scene.closest_hit(origins, directions).triangle.astype(np.int64)

    def intersects_any(
        self, ray_origins: ArrayLike, ray_directions: ArrayLike, **_: Any
    ) -> NDArray[np.bool_]:
        """Whether each ray hits anything, (n,)."""
        return self.scene.any_hit(*_rays(ray_origins, ray_directions))

    def contains_points(self, points: ArrayLike) -> NDArray[np.bool_]:
        """Whether each point (n, 3) is inside, (n,): for a closed mesh whichever way its triangles
        face, for another by its winding numbers. On the surface either answer."""
        places = _rows(points, "points")
        scene = self.scene
        return scene.signed_distance(places, method=sign_method(scene)).distance < 0

    def _hits(
        self,
        ray_origins: ArrayLike,
        ray_directions: ArrayLike,
        multiple_hits: bool,
        max_hits: int | None,
    ) -> tuple[Indices, Indices, Points]:
        origins, directions = _rays(ray_origins, ray_directions)
        if multiple_hits:
            hits = self.scene.all_hits(origins, directions)
            ray, t, triangle = hits.ray, hits.t, hits.triangle
            if max_hits is not None:
                is_kept = np.arange(len(ray)) - hits.offsets[ray] < max_hits
                ray, t, triangle = ray[is_kept], t[is_kept], triangle[is_kept]
        else:
            first = self.scene.closest_hit(origins, directions)
            ray = np.flatnonzero(first.hit)
            t, triangle = first.t[ray].astype(np.float64), first.triangle[ray]
        location = origins[ray] + t[:, None] * directions[ray]
        return triangle.astype(np.int64), ray.astype(np.int64), location

    def __getstate__(self) -> dict[str, Any]:
        return {"mesh": self.mesh, "_scene": None, "_hash": None}


def from_trimesh(mesh: Any) -> Mesh:
    """A Mesh of a trimesh.Trimesh, with its colors and with what else has one number for each
    vertex or face. Its arrays are copied: trimesh wants to know who changes them."""
    result = _geometry(mesh)
    if mesh.visual.defined and mesh.visual.kind == "vertex":
        result.colors = colors_from_bytes(np.asarray(mesh.visual.vertex_colors), "vertices")
    if mesh.visual.defined and mesh.visual.kind == "face":
        result.colors = colors_from_bytes(np.asarray(mesh.visual.face_colors), "faces")
    add_fields(result, "vertices", mesh.vertex_attributes)
    add_fields(result, "faces", mesh.face_attributes)
    return result


def to_trimesh(mesh: Mesh) -> Any:
    """A trimesh.Trimesh of a Mesh, vertex for vertex and face for face, with colors and fields of
    vertices and faces."""
    import trimesh

    result = trimesh.Trimesh(
        vertices=np.array(mesh.vertices),
        faces=np.array(mesh.faces),
        vertex_attributes=fields_of(mesh, "vertices"),
        face_attributes=fields_of(mesh, "faces"),
        process=False,
    )
    if mesh.colors is not None and mesh.colors.of == "vertices":
        result.visual.vertex_colors = colors_to_bytes(mesh.colors)
    if mesh.colors is not None and mesh.colors.of == "faces":
        result.visual.face_colors = colors_to_bytes(mesh.colors)
    return result


def _geometry(mesh: Any) -> Mesh:
    # np.array makes plain arrays of trimesh's watched ones.
    return Mesh(np.array(mesh.vertices, dtype=np.float64), np.array(mesh.faces))


def _rows(value: ArrayLike, name: str) -> Points:
    rows = np.asarray(value, dtype=np.float64)
    if rows.size == 0 and rows.ndim == 1:
        rows = rows.reshape(0, 3)
    if rows.ndim != 2 or rows.shape[1] != 3:
        raise ValueError(f"{name}: found shape {rows.shape}, expected (n, 3)")
    return rows


def _rays(ray_origins: ArrayLike, ray_directions: ArrayLike) -> tuple[Points, Points]:
    origins, directions = (
        _rows(ray_origins, "ray_origins"),
        _rows(ray_directions, "ray_directions"),
    )
    if origins.shape != directions.shape:
        raise ValueError(
            f"ray_origins and ray_directions: found shapes {origins.shape} and "
            f"{directions.shape}, expected the same"
        )
    return origins, directions
