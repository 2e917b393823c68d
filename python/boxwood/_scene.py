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
from ._mesh import Mesh, of_trusted_arrays
from ._progress import Progress, reporting
from ._rays import Rays, rays
from ._results import (
    ClosestPoints,
    FirstHits,
    HitLists,
    Hits,
    SignedDistances,
    TriangleLists,
)

_ALL = 0xFFFFFFFF


class Instance:
    """A mesh that stands somewhere in the scene.

    mesh: the Mesh. One of several instances takes no memory for its triangles.
    transform: array (4, 4) or (3, 4), an affine map from the mesh to the scene; where it is,
    without. visibility: an integer of 32 bits; rays see it whose own visibility has a bit of it.

    >>> import boxwood as bw, numpy as np
    >>> ball = bw.generate("icosphere", 1280)
    >>> up = np.eye(4)
    >>> up[2, 3] = 3
    >>> scene = bw.Scene([ball, bw.Instance(ball, up)])
    >>> float(scene.closest_hit([0, 0, 9], [0, 0, -1]).t), len(scene.meshes)
    (5.0, 1)
    """

    def __init__(
        self, mesh: Mesh, transform: ArrayLike | None = None, visibility: int = _ALL
    ) -> None:
        if not isinstance(mesh, Mesh):
            raise TypeError(f"mesh: found {arguments.describe(mesh)}, expected a boxwood.Mesh")
        matrix = np.eye(4)
        if transform is not None:
            given = arguments.floats(transform, "transform")
            if given.shape not in ((4, 4), (3, 4)):
                raise ValueError(
                    f"transform: found {arguments.describe(given)}, expected shape (4, 4) or (3, 4)"
                )
            if given.shape == (4, 4) and not (given[3] == (0, 0, 0, 1)).all():
                raise ValueError(
                    f"transform: found the last row {given[3].tolist()}, expected 0, 0, 0, 1"
                )
            matrix[:3] = given[:3]
        self._mesh = mesh
        self._transform = matrix
        self._visibility = arguments.count(visibility, "visibility", 0, _ALL)

    @property
    def mesh(self) -> Mesh:
        """What stands there."""
        return self._mesh

    @property
    def transform(self) -> NDArray[np.float64]:
        """Array (4, 4). Whoever writes to it moves the instance at the next
        `Scene.set_instances`."""
        return self._transform

    @property
    def visibility(self) -> int:
        """The bits that rays see it by."""
        return self._visibility

    def __repr__(self) -> str:
        return f"<boxwood.Instance of {self.mesh!r}>"


class Scene:
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
        distinct, instances = _sorted_out(meshes)
        culls = _culls(cull_back_faces, len(distinct))
        self._take(
            _core.Scene(
                [mesh.vertices for mesh in distinct],
                [mesh.faces for mesh in distinct],
                culls,
                *_instance_arrays(distinct, instances),
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

    # ---------------------------------------------------------------- rays

    def closest_hit(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> Hits:
        """The first hit of each ray with t_min <= t <= t_max, from either side of the triangles.
        Equal distances go to the lowest (instance, triangle).

        t_min, t_max: one number, or one for each ray.
        skip_triangle, skip_instance: the triangle that a ray starts on and doesn't see, so that it
            needs no offset; -1 for none. The instance is 0 without.
        visibility: bits; a ray sees the instances that share one with it.
        progress: True for a bar by tqdm, or a function of the part that is done.

        About O(log n) for each ray, on all cores.

        >>> import boxwood as bw, numpy as np
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> hits = scene.closest_hit(np.zeros(3), np.eye(3))
        >>> hits.t.round(2).tolist(), hits.normal.round(1).diagonal().tolist()
        ([1.0, 1.0, 1.0], [1.0, 1.0, 1.0])
        """
        asked = rays(origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility)
        dtype = asked.dtype if isinstance(asked.core, _core.Raysf) else np.float64
        n = asked.size
        t = np.empty(n, dtype)
        triangle = np.empty(n, np.int32)
        instance = np.empty(n, np.int32)
        uv = np.empty((n, 2), dtype)
        normal = np.empty((n, 3), dtype)
        with reporting(progress, "closest hits") as report:
            self._core.closest_hit(asked.core, t, triangle, instance, uv, normal, report)
        shape, given = asked.shape, asked.dtype
        return Hits(
            t.reshape(shape).astype(given, copy=False),
            triangle.reshape(shape),
            instance.reshape(shape),
            uv.reshape(*shape, 2).astype(given, copy=False),
            normal.reshape(*shape, 3).astype(given, copy=False),
        )

    def any_hit(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> NDArray[np.bool_]:
        """Whether each ray hits anything with t_min <= t <= t_max: faster than `closest_hit`, whose
        arguments it takes. For what two points see of each other take directions from one to the
        other and t_max=1.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.any_hit([0, 0, 5], [[0, 0, -1], [0, 0, 1]]).tolist()
        [True, False]
        """
        asked = rays(origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility)
        results = np.empty(asked.size, np.bool_)
        with reporting(progress, "any hits") as report:
            self._core.any_hit(asked.core, results, report)
        return results.reshape(asked.shape)

    def all_hits(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> HitLists:
        """Every place where each ray goes through the surface, in the order of t: once for each
        crossing, on edges and vertices as well. Arguments as for `closest_hit`; always in double.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> hits = scene.all_hits([[0, 0, 5], [0, 3, 5]], [0, 0, -1])
        >>> hits.offsets.tolist(), hits.t[hits.of_ray(0)].round(2).tolist()
        ([0, 2, 2], [4.0, 6.0])
        """
        asked = self._in_double(
            origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility
        )
        with reporting(progress, "all hits") as report:
            found = self._core.all_hits(asked.core, report)
        return HitLists(
            found["offsets"].view(np.int64),
            found["t"],
            found["triangle"].view(np.int32),
            found["instance"].view(np.int32),
            np.stack([found["u"], found["v"]], axis=-1),
        )

    def count_hits(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> NDArray[np.int64]:
        """How many places `all_hits` would find for each ray; (...) int64.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.count_hits([[0, 0, 5], [0, 0, 0]], [0, 0, -1]).tolist()
        [2, 1]
        """
        asked = self._in_double(
            origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility
        )
        results = np.empty(asked.size, np.int64)
        with reporting(progress, "counting hits") as report:
            self._core.count_hits(asked.core, results, report)
        return results.reshape(asked.shape)

    def first_k_hits(
        self,
        origins: ArrayLike,
        directions: ArrayLike,
        k: int,
        *,
        t_min: ArrayLike = 0.0,
        t_max: ArrayLike = np.inf,
        skip_triangle: ArrayLike | None = None,
        skip_instance: ArrayLike | None = None,
        visibility: ArrayLike | None = None,
        progress: Progress = None,
    ) -> FirstHits:
        """The first k of the places that `all_hits` would find for each ray.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.first_k_hits([0, 0, 5], [0, 0, -1], 3).t.round(2).tolist()
        [4.0, 6.0, inf]
        """
        asked = self._in_double(
            origins, directions, t_min, t_max, skip_triangle, skip_instance, visibility
        )
        k = arguments.count(k, "k", 0, 2**20)
        n = asked.size * k
        t = np.empty(n)
        triangle = np.empty(n, np.int32)
        instance = np.empty(n, np.int32)
        uv = np.empty((n, 2))
        with reporting(progress, "first hits") as report:
            self._core.first_k_hits(asked.core, k, t, triangle, instance, uv, report)
        shape = (*asked.shape, k)
        return FirstHits(
            t.reshape(shape),
            triangle.reshape(shape),
            instance.reshape(shape),
            uv.reshape(*shape, 2),
        )

    @staticmethod
    def _in_double(*given: Any) -> Rays:
        return rays(*given, in_double=True)

    # -------------------------------------------------------------- points

    def closest_point(
        self,
        points: ArrayLike,
        *,
        max_radius: float = np.inf,
        progress: Progress = None,
    ) -> ClosestPoints:
        """The place on the surface that is nearest to each point, within max_radius. Equal
        distances go to the lowest (instance, triangle). About O(log n) for each, on all cores, in
        double.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.closest_point([[0, 0, 3], [0, 0, 0.5]]).distance.round(2).tolist()
        [2.0, 0.5]
        """
        places, shape = _points(points)
        radius = arguments.number(max_radius, "max_radius")
        distance, point, triangle, instance, uv = _places(len(places))
        with reporting(progress, "closest points") as report:
            self._core.closest_point(
                places, radius, distance, point, triangle, instance, uv, report
            )
        return ClosestPoints(
            distance.reshape(shape),
            point.reshape(*shape, 3),
            triangle.reshape(shape),
            instance.reshape(shape),
            uv.reshape(*shape, 2),
        )

    def signed_distance(
        self,
        points: ArrayLike,
        *,
        method: str = "pseudonormal",
        max_radius: float = np.inf,
        accuracy: float = 2.0,
        progress: Progress = None,
    ) -> SignedDistances:
        """The distance of each point to the surface, negative inside.

        method: how the inside is told: "pseudonormal", the fastest, for closed meshes that don't
            intersect themselves; "winding_number", which bears holes; or "ray_parity", which
            doesn't mind which way triangles face.
        accuracy: of winding numbers, see `winding_number`.

        The first question of a method takes O(n log n), others about O(log n).

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.signed_distance([[0, 0, 3], [0, 0, 0.5]]).distance.round(2).tolist()
        [2.0, -0.5]
        """
        places, shape = _points(points)
        radius = arguments.number(max_radius, "max_radius")
        distance, point, triangle, instance, uv = _places(len(places))
        is_undefined = np.empty(len(places), np.bool_)
        with reporting(progress, "signed distances") as report:
            self._core.signed_distance(
                places,
                arguments.text(method, "method"),
                _accuracy(accuracy),
                radius,
                distance,
                is_undefined,
                point,
                triangle,
                instance,
                uv,
                report,
            )
        return SignedDistances(
            distance.reshape(shape),
            is_undefined.reshape(shape),
            point.reshape(*shape, 3),
            triangle.reshape(shape),
            instance.reshape(shape),
            uv.reshape(*shape, 2),
        )

    def winding_number(
        self, points: ArrayLike, *, accuracy: float = 2.0, progress: Progress = None
    ) -> NDArray[np.float64]:
        """How often the meshes wind around each point: 1 inside a closed mesh and 0 outside, and
        something between for one with holes.

        accuracy: parts of a mesh are summed up as seen from so many times their radius away, at
            least 1: errors fall with its cube, time rises with its square.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> abs(scene.winding_number([[0, 0, 3], [0, 0, 0.5]]).round(1)).tolist()
        [0.0, 1.0]
        """
        places, shape = _points(points)
        numbers = np.empty(len(places))
        with reporting(progress, "winding numbers") as report:
            self._core.winding_number(places, _accuracy(accuracy), numbers, report)
        return numbers.reshape(shape)

    def is_sign_trustworthy(self, method: str = "pseudonormal") -> bool:
        """Whether the scene is what the method of `signed_distance` rests on: closed and, for
        pseudonormals, with all triangles facing the same way."""
        return bool(self._core.is_sign_trustworthy(arguments.text(method, "method")))

    # ------------------------------------------------------------ overlaps

    def box_overlap(
        self, lower: ArrayLike, upper: ArrayLike, *, progress: Progress = None
    ) -> TriangleLists:
        """The triangles that touch each box, in order.

        lower, upper: arrays (..., 3), the boxes' corners of least and greatest coordinates.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.box_overlap([[-2, -2, -2], [3, 3, 3]], [[2, 2, 2], [4, 4, 4]]).counts.tolist()
        [1280, 0]
        """
        lo, hi = arguments.vectors(lower, "lower"), arguments.vectors(upper, "upper")
        if lo.shape != hi.shape:
            raise ValueError(
                f"lower and upper: found shapes {lo.shape} and {hi.shape}, expected the same"
            )
        with reporting(progress, "box overlaps") as report:
            found = self._core.box_overlap(_points(lo)[0], _points(hi)[0], report)
        return TriangleLists(found["offsets"], found["triangle"], found["instance"])

    def sphere_overlap(
        self, centers: ArrayLike, radii: ArrayLike, *, progress: Progress = None
    ) -> TriangleLists:
        """The triangles no farther from each center (..., 3) than its radius, in order; one radius
        may do for all.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> scene.sphere_overlap([[0, 0, 0], [0, 0, 9]], [2, 1]).counts.tolist()
        [1280, 0]
        """
        places, shape = _points(centers, "centers")
        sizes = arguments.per_item(radii, "radii", shape, np.float64)
        with reporting(progress, "sphere overlaps") as report:
            found = self._core.sphere_overlap(places, sizes, report)
        return TriangleLists(found["offsets"], found["triangle"], found["instance"])

    def triangle_overlap(
        self, corners: ArrayLike, *, progress: Progress = None
    ) -> NDArray[np.bool_]:
        """Whether each triangle, (..., 3, 3) its corners, touches the scene.

        >>> import boxwood as bw
        >>> scene = bw.Scene(bw.generate("icosphere", 1280))
        >>> bool(scene.triangle_overlap([[0, 0, 0], [0, 0, 2], [0, 1, 2]]))
        True
        """
        given = arguments.vectors(corners, "corners")
        if given.ndim < 2 or given.shape[-2] != 3:
            raise ValueError(
                f"corners: found {arguments.describe(given)}, expected shape (..., 3, 3)"
            )
        shape = given.shape[:-2]
        results = np.empty(int(np.prod(shape, dtype=np.int64)), np.bool_)
        with reporting(progress, "triangle overlaps") as report:
            self._core.triangle_overlap(_points(given)[0], results, report)
        return results.reshape(shape)

    # --------------------------------------------------------------- other

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
        distinct, chosen = _sorted_out(instances)
        for mesh in distinct:
            if not any(mesh is own for own in self._meshes):
                raise ValueError("instances: found another mesh, expected those of the scene")
        self._core.set_instances(*_instance_arrays(self._meshes, chosen))
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


def _sorted_out(
    meshes: Mesh | Iterable[Mesh | Instance],
) -> tuple[list[Mesh], list[Instance]]:
    """The distinct meshes, and the instances."""
    if isinstance(meshes, (Mesh, Instance)):
        meshes = [meshes]
    try:
        given = list(meshes)
    except TypeError:
        raise TypeError(
            f"meshes: found {arguments.describe(meshes)}, expected a Mesh or a sequence of Meshes "
            "and Instances"
        ) from None
    distinct: dict[int, Mesh] = {}
    instances = []
    for item in given:
        if isinstance(item, Mesh):
            item = Instance(item)
        elif not isinstance(item, Instance):
            raise TypeError(
                f"meshes: found {arguments.describe(item)}, expected Meshes and Instances"
            )
        instances.append(item)
        distinct.setdefault(id(item.mesh), item.mesh)
    return list(distinct.values()), instances


def _instance_arrays(meshes: list[Mesh], instances: list[Instance]) -> tuple[Any, Any, Any]:
    places = {id(mesh): i for i, mesh in enumerate(meshes)}
    transforms = np.empty((len(instances), 4, 4))
    for i, instance in enumerate(instances):
        transforms[i] = instance.transform
    return (
        np.array([places[id(instance.mesh)] for instance in instances], dtype=np.uint32),
        transforms,
        np.array([instance.visibility for instance in instances], dtype=np.uint32),
    )


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


def _points(value: ArrayLike, name: str = "points") -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """The points as rows in double, and the shape of what is found for them."""
    given = arguments.vectors(value, name)
    rows = np.ascontiguousarray(given.reshape(-1, 3), dtype=np.float64)
    return rows, given.shape[:-1]


def _places(count: int) -> tuple[Any, Any, Any, Any, Any]:
    return (
        np.empty(count),
        np.empty((count, 3)),
        np.empty(count, np.int32),
        np.empty(count, np.int32),
        np.empty((count, 2)),
    )


def _accuracy(value: float) -> float:
    accuracy = arguments.number(value, "accuracy")
    if not 1 <= accuracy <= 1e6:
        raise ValueError(f"accuracy: found {accuracy}, expected a number from 1 to 1e6")
    return accuracy
