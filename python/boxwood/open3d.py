# SPDX-License-Identifier: Apache-2.0
"""Boxwood with the conventions of Open3D's `RaycastingScene`: rays of six numbers, and
dictionaries of arrays. Open3D itself is needed for `to_open3d` alone.

>>> import boxwood as bw
>>> from boxwood.open3d import RaycastingScene
>>> scene = RaycastingScene()
>>> scene.add_triangles(bw.generate("icosphere", 1280))
0
>>> scene.cast_rays([[0, 0, 5, 0, 0, -1], [0, 3, 5, 0, 0, -1]])["geometry_ids"].tolist()
[0, 4294967295]
"""

from __future__ import annotations

from contextlib import AbstractContextManager, nullcontext
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from ._adapters import colors_from_bytes, sign_method
from ._camera import PinholeCamera
from ._instance import Instance
from ._mesh import Mesh
from ._scene import Scene
from ._threads import thread_limit

Answers = dict[str, NDArray[Any]]
Floats = NDArray[np.floating[Any]]


class RaycastingScene:
    """Answers what `open3d.t.geometry.RaycastingScene` answers, by the same names, as arrays of
    numpy. Rays and points in float32 give float32, those in float64 certified float64; ids are
    uint32.

    nthreads: how many threads may work on a call, 0 for all.
    """

    #: The id of what isn't there.
    INVALID_ID = 0xFFFFFFFF

    def __init__(self, nthreads: int = 0) -> None:
        self._nthreads = nthreads
        self._meshes: list[Mesh] = []
        self._scene: Scene | None = None

    @property
    def scene(self) -> Scene:
        """What was added as a boxwood.Scene, which can answer more. Its instances have the
        geometry ids."""
        if self._scene is None:
            with _limit(self._nthreads):
                self._scene = Scene([Instance(mesh) for mesh in self._meshes])
        return self._scene

    def add_triangles(self, mesh: Any, triangle_indices: ArrayLike | None = None) -> int:
        """Adds a mesh and returns its geometry id: a boxwood.Mesh, one of Open3D, or vertices
        (n, 3) and triangles (m, 3). All but the first is copied."""
        if triangle_indices is not None:
            mesh = Mesh(np.array(arguments.array(mesh, "vertex_positions")), triangle_indices)
        elif not isinstance(mesh, Mesh):
            mesh = from_open3d(mesh)
        self._meshes.append(mesh)
        self._scene = None
        return len(self._meshes) - 1

    def cast_rays(self, rays: ArrayLike, nthreads: int = 0) -> Answers:
        """The first hits of rays (..., 6): t_hit (...), inf for a miss; geometry_ids and
        primitive_ids (...), INVALID_ID for a miss; primitive_uvs (..., 2) and primitive_normals
        (..., 3), zero for a miss."""
        origins, directions = _split(rays)
        with _limit(nthreads):
            hits = self.scene.closest_hit(origins, directions)
        return {
            "t_hit": hits.t,
            "geometry_ids": _ids(hits.instance),
            "primitive_ids": _ids(hits.triangle),
            "primitive_uvs": hits.uv,
            "primitive_normals": hits.normal,
        }

    def test_occlusions(
        self, rays: ArrayLike, tnear: float = 0.0, tfar: float = np.inf, nthreads: int = 0
    ) -> NDArray[np.bool_]:
        """Whether rays (..., 6) hit anything from tnear to tfar, (...)."""
        origins, directions = _split(rays)
        with _limit(nthreads):
            return self.scene.any_hit(origins, directions, t_min=tnear, t_max=tfar)

    def count_intersections(self, rays: ArrayLike, nthreads: int = 0) -> NDArray[np.int32]:
        """How often rays (..., 6) cross the surface, (...)."""
        with _limit(nthreads):
            return self.scene.count_hits(*_split(rays)).astype(np.int32)

    def list_intersections(self, rays: ArrayLike, nthreads: int = 0) -> Answers:
        """All hits of rays (..., 6), one after another: those of ray i stand from ray_splits[i] to
        ray_splits[i + 1] in ray_ids, t_hit, geometry_ids, primitive_ids and primitive_uvs."""
        origins, directions = _split(rays)
        with _limit(nthreads):
            hits = self.scene.all_hits(origins, directions)
        return {
            "ray_splits": hits.offsets.astype(np.uint32),
            "ray_ids": hits.ray.astype(np.uint32),
            "t_hit": hits.t.astype(origins.dtype),
            "geometry_ids": _ids(hits.instance),
            "primitive_ids": _ids(hits.triangle),
            "primitive_uvs": hits.uv.astype(origins.dtype),
        }

    def compute_closest_points(self, query_points: ArrayLike, nthreads: int = 0) -> Answers:
        """What of the surface is nearest to points (..., 3): points (..., 3), geometry_ids,
        primitive_ids (...), primitive_uvs (..., 2) and primitive_normals (..., 3)."""
        points = arguments.vectors(query_points, "query_points")
        with _limit(nthreads):
            found = self.scene.closest_point(points)
            normals = self.scene.geometric_normal(found.triangle, found.instance)
        return {
            "points": found.point.astype(points.dtype),
            "geometry_ids": _ids(found.instance),
            "primitive_ids": _ids(found.triangle),
            "primitive_uvs": found.uv.astype(points.dtype),
            "primitive_normals": normals.astype(points.dtype),
        }

    def compute_distance(self, query_points: ArrayLike, nthreads: int = 0) -> Floats:
        """The distances (...) of points (..., 3)."""
        points = arguments.vectors(query_points, "query_points")
        with _limit(nthreads):
            return self.scene.closest_point(points).distance.astype(points.dtype)

    def compute_signed_distance(
        self, query_points: ArrayLike, nthreads: int = 0, nsamples: int = 1
    ) -> Floats:
        """The distances (...) of points (..., 3), negative inside. What is open has an inside by
        its winding numbers. nsamples isn't needed: rays that meet edges don't mislead."""
        points = arguments.vectors(query_points, "query_points")
        with _limit(nthreads):
            found = self.scene.signed_distance(points, method=sign_method(self.scene))
        return found.distance.astype(points.dtype)

    def compute_occupancy(
        self, query_points: ArrayLike, nthreads: int = 0, nsamples: int = 1
    ) -> NDArray[np.float32]:
        """1 for points (..., 3) inside, 0 for others, (...)."""
        distance = self.compute_signed_distance(query_points, nthreads, nsamples)
        return (distance < 0).astype(np.float32)

    @staticmethod
    def create_rays_pinhole(
        fov_deg: float,
        center: ArrayLike,
        eye: ArrayLike,
        up: ArrayLike,
        width_px: int,
        height_px: int,
    ) -> NDArray[np.float32]:
        """Rays (height_px, width_px, 6) of a camera. fov_deg is the horizontal angle; directions
        have length 1 along the view, so that t_hit is a depth. As with Open3D the first row looks
        to the bottom and begins at the right."""
        half = np.tan(np.radians(fov_deg) / 2) * height_px / width_px
        camera = PinholeCamera(
            np.asarray(eye, np.float64),
            np.asarray(center, np.float64),
            np.asarray(up, np.float64),
            field_of_view=float(np.degrees(2 * np.arctan(half))),
            width=width_px,
            height=height_px,
        )
        origin, directions = camera.rays()
        directions = directions[::-1, ::-1]
        ahead = camera.target - camera.position
        directions = directions / (directions @ (ahead / np.linalg.norm(ahead)))[..., None]
        rays = np.concatenate([np.broadcast_to(origin, directions.shape), directions], axis=-1)
        return rays.astype(np.float32)


def from_open3d(mesh: Any) -> Mesh:
    """A Mesh of an open3d.t.geometry.TriangleMesh or open3d.geometry.TriangleMesh, with the colors
    of its vertices."""
    if hasattr(mesh, "vertex"):
        vertices = np.array(mesh.vertex["positions"].cpu().numpy())
        faces = mesh.triangle["indices"].cpu().numpy()
        colors = mesh.vertex["colors"].cpu().numpy() if "colors" in mesh.vertex else None
    else:
        vertices, faces = np.array(mesh.vertices), np.array(mesh.triangles)
        colors = np.array(mesh.vertex_colors) if mesh.has_vertex_colors() else None
    result = Mesh(vertices, faces)
    if colors is not None:
        result.colors = colors_from_bytes(colors, "vertices")
    return result


def to_open3d(mesh: Mesh) -> Any:
    """An open3d.t.geometry.TriangleMesh of a Mesh, with the colors of its vertices. Positions are
    in float, as Open3D's scenes want them; `.to_legacy()` makes an open3d.geometry.TriangleMesh."""
    import open3d

    tensor = open3d.core.Tensor
    result = open3d.t.geometry.TriangleMesh(
        tensor(np.array(mesh.vertices, np.float32)), tensor(mesh.faces.astype(np.int64))
    )
    if mesh.colors is not None and mesh.colors.of == "vertices":
        rgb = np.array(mesh.colors.values, np.float32)[:, :3]
        result.vertex["colors"] = tensor(np.ascontiguousarray(rgb))
    return result


def _split(rays: ArrayLike) -> tuple[Floats, Floats]:
    given = arguments.floats(rays, "rays")
    if given.ndim == 0 or given.shape[-1] != 6:
        raise ValueError(f"rays: found {arguments.describe(given)}, expected shape (..., 6)")
    return given[..., :3], given[..., 3:]


def _ids(indices: NDArray[np.int32]) -> NDArray[np.uint32]:
    # -1 is INVALID_ID in 32 bits.
    return indices.view(np.uint32)


def _limit(nthreads: int) -> AbstractContextManager[None]:
    return thread_limit(nthreads) if nthreads else nullcontext()
