# SPDX-License-Identifier: Apache-2.0
"""Scenes: meshes and instances of them that can be asked."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core
from ._instance import Instance, instance_arrays, sorted_out
from ._mesh import Mesh, of_trusted_arrays
from ._overlap_queries import OverlapQueries
from ._point_queries import PointQueries
from ._ray_queries import RayQueries


class Scene(RayQueries, PointQueries, OverlapQueries):
    """Triangle meshes that can be asked what rays hit and what is near to points.

    meshes: a Mesh, or a sequence of Meshes and Instances. Vertices aren't copied: whoever moves
        them calls `refit`.
    preset: how long to build for how fast queries: "fast", "balanced", "compact" (half the memory)
        or "best".
    method: a builder in place of the preset, see `build`.
    cull_back_faces: whether rays go through triangles that they meet from behind; True, or one
        truth value for each distinct mesh.

    Origins, directions and points are arrays of shape (..., 3) that broadcast over each other;
    results have the shape (...). float32 rays give float32 answers, float64 rays certified float64
    ones. Directions need not have unit length. Any number of threads may ask one scene at once.

    Raises TypeError or ValueError for what isn't a mesh, and for transforms that flatten.

    >>> import boxwood as bw
    >>> scene = bw.Scene(bw.generate("icosphere", 1280))
    >>> hits = scene.closest_hit([[0, 0, 5], [0, 3, 5]], [0, 0, -1])
    >>> hits.hit.tolist(), hits.t.round(2).tolist()
    ([True, False], [4.0, inf])
    """

    def __init__(
        self,
        meshes: Mesh | Iterable[Mesh | Instance],
        *,
        preset: str = "balanced",
        method: str | None = None,
        cull_back_faces: bool | Sequence[bool] = False,
    ) -> None:
        distinct, instances = sorted_out(meshes)
        culls = _culls(cull_back_faces, len(distinct))
        self._take(
            _core.Scene(
                [mesh.vertices for mesh in distinct],
                [mesh.faces for mesh in distinct],
                culls,
                *instance_arrays(distinct, instances),
                arguments.text(preset, "preset"),
                None if method is None else arguments.text(method, "method"),
                "surface_area",
                False,
            ),
            distinct,
            instances,
        )
        self._culls: list[bool] = culls
        self._options: dict[str, str | None] = {"preset": preset, "method": method}

    def _take(self, core: Any, meshes: list[Mesh], instances: list[Instance]) -> None:
        self._core = core
        self._meshes = meshes
        self._instances = instances
        self._path: str | None = None

    def __repr__(self) -> str:
        triangles = sum(len(instance.mesh.faces) for instance in self._instances)
        return f"<boxwood.Scene: {len(self._instances)} instances, {triangles} triangles>"

    @property
    def meshes(self) -> list[Mesh]:
        """The distinct meshes."""
        return list(self._meshes)

    @property
    def instances(self) -> list[Instance]:
        """The instances, in the order of the numbers that results name."""
        return list(self._instances)

    @property
    def report(self) -> list[dict[str, NDArray[np.uint32]]]:
        """What is wrong with each mesh, though it can be borne: the triangles "not_finite", which
        no query finds, and those of "zero_area".

        >>> import boxwood as bw
        >>> flat = bw.Mesh([[0, 0, 0], [1, 0, 0], [2, 0, 0]], [[0, 1, 2]])
        >>> bw.Scene(flat).report[0]["zero_area"].tolist()
        [0]
        """
        return [
            {"not_finite": not_finite, "zero_area": zero_area}
            for not_finite, zero_area in self._core.report()
        ]

    @property
    def statistics(self) -> list[dict[str, Any]]:
        """Of each mesh's tree as queries walk it: width, instruction_set, bytes, is_compact, and
        cost, the nodes that a random line is expected to visit."""
        found: list[dict[str, Any]] = self._core.statistics()
        return found

    def geometric_normal(self, triangle: ArrayLike, instance: ArrayLike = 0) -> NDArray[np.float64]:
        """The normals (..., 3) of triangles as they stand in the scene, of unit length; zero for
        -1 and for triangles of zero area."""
        which = arguments.int32(triangle, "triangle", -1)
        shape = which.shape
        where = arguments.int32(instance, "instance", -1)
        normal = np.empty((which.size, 3))
        self._core.geometric_normal(
            which.reshape(-1),
            arguments.per_item(where, "instance", shape, np.int32),
            normal,
        )
        return normal.reshape(*shape, 3)

    def refit(self) -> NDArray[np.float64]:
        """Fits the trees to vertices that have moved, in the arrays `mesh.vertices` of the scene's
        meshes. Answers are then those of a new scene. Returns for each mesh how much dearer queries
        have become, 1 for as built: below 1.3 a new scene seldom pays. O(n). No query may run
        meanwhile: RuntimeError.

        >>> import boxwood as bw
        >>> mesh = bw.generate("icosphere", 1280)
        >>> scene = bw.Scene(mesh)
        >>> mesh.vertices[:] *= 2
        >>> scene.refit().round(3).tolist()
        [1.0]
        >>> float(scene.closest_hit([0, 0, 5], [0, 0, -1]).t)
        3.0
        """
        return np.array(self._core.refit())

    def set_instances(self, instances: Iterable[Mesh | Instance]) -> None:
        """Replaces the instances; they must be of the scene's meshes. Trees stay. No query may run
        meanwhile: RuntimeError."""
        distinct, chosen = sorted_out(instances)
        for mesh in distinct:
            if not any(mesh is own for own in self._meshes):
                raise ValueError("instances: found another mesh, expected those of the scene")
        self._core.set_instances(*instance_arrays(self._meshes, chosen))
        self._instances = chosen
        self._path = None

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes the scene with its trees to a file that `boxwood.open` maps into memory at once.
        Vertices come back in double."""
        self._core.save(arguments.path(path))

    def __reduce__(self) -> tuple[Any, ...]:
        if self._path is not None:
            return open_scene, (self._path,)
        return _rebuilt, (self._meshes, self._instances, self._culls, self._options)


def open_scene(path: str | os.PathLike[str], *, trust: bool = False) -> Scene:
    """A scene that `Scene.save` wrote. Its pages are read when a query needs them, and shared by
    all processes that open it. A pickle of it holds the path alone.

    trust: don't check the file, for one that nobody else can write to: opens at once.

    Raises OSError when it can't be read, ParseError when it is no such file, or truncated,
    corrupted, or of another kind of machine.

    >>> import boxwood as bw, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "ball.boxwood"
    >>> bw.Scene(bw.generate("icosphere", 1280)).save(path)
    >>> float(bw.open(path).closest_hit([0, 0, 5], [0, 0, -1]).t)
    4.0
    """
    name = arguments.path(path)
    core = _core.Scene(name, arguments.flag(trust, "trust"))
    meshes = [of_trusted_arrays(vertices, faces) for vertices, faces, _ in core.meshes()]
    instances = [
        Instance(meshes[mesh], np.reshape(transform, (4, 4)), visibility)
        for mesh, transform, visibility in core.instances()
    ]
    scene = Scene.__new__(Scene)
    scene._take(core, meshes, instances)
    scene._culls = [culls for _, _, culls in core.meshes()]
    scene._options = {}
    scene._path = os.path.abspath(name)
    return scene


def _rebuilt(
    meshes: list[Mesh], instances: list[Instance], culls: list[bool], options: dict[str, Any]
) -> Scene:
    # A scene knows its meshes in their order, those without an instance as well.
    scene = Scene(meshes, cull_back_faces=culls, **options)
    scene.set_instances(instances)
    return scene


def _culls(value: bool | Sequence[bool], meshes: int) -> list[bool]:
    if isinstance(value, (bool, np.bool_)):
        return [bool(value)] * meshes
    if isinstance(value, str) or not isinstance(value, (Sequence, np.ndarray)):
        raise TypeError(
            f"cull_back_faces: found {arguments.describe(value)}, expected True, False or a "
            "sequence of them"
        )
    result = [arguments.flag(item, "cull_back_faces") for item in value]
    if len(result) != meshes:
        raise ValueError(
            f"cull_back_faces: found {len(result)} values, expected one for each of {meshes} meshes"
        )
    return result
