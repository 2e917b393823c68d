# SPDX-License-Identifier: Apache-2.0
"""What scenes say of points."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as arguments
from . import _core
from ._progress import Progress, reporting
from ._results import ClosestPoints, SignedDistances


class PointQueries:
    """The questions of a Scene about points."""

    _core: _core.Scene

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
        places, shape = arguments.points(points)
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
        places, shape = arguments.points(points)
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
        places, shape = arguments.points(points)
        numbers = np.empty(len(places))
        with reporting(progress, "winding numbers") as report:
            self._core.winding_number(places, _accuracy(accuracy), numbers, report)
        return numbers.reshape(shape)

    def is_sign_trustworthy(self, method: str = "pseudonormal") -> bool:
        """Whether the scene is what the method of `signed_distance` rests on: closed and, for
        pseudonormals, with all triangles facing the same way."""
        return bool(self._core.is_sign_trustworthy(arguments.text(method, "method")))


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
