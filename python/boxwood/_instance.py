# SPDX-License-Identifier: Apache-2.0
"""Meshes that stand somewhere, and the arrays that the compiled part takes of them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from ._mesh import Mesh

_ALL = 0xFFFFFFFF


class Instance:
    """A mesh that stands somewhere in the scene.

    mesh: the Mesh. One of several instances takes no memory for its triangles.
    transform: array (4, 4) or (3, 4), an affine map from the mesh to the scene; where it is,
        without.
    visibility: an integer of 32 bits; rays see it whose own visibility has a bit of it.

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


def sorted_out(
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


def instance_arrays(meshes: list[Mesh], instances: list[Instance]) -> tuple[Any, Any, Any]:
    places = {id(mesh): i for i, mesh in enumerate(meshes)}
    transforms = np.empty((len(instances), 4, 4))
    for i, instance in enumerate(instances):
        transforms[i] = instance.transform
    return (
        np.array([places[id(instance.mesh)] for instance in instances], dtype=np.uint32),
        transforms,
        np.array([instance.visibility for instance in instances], dtype=np.uint32),
    )
